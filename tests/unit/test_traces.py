"""Files of measuring machines: every dialect gives the same line, every damaged file one sentence."""

import hashlib
import io
import re
import struct
import tracemalloc
import zipfile
import zlib
from collections.abc import Iterable, Sequence
from functools import partial
from pathlib import Path

import numpy as np
import pytest
import trace_files
import x3pio
from numpy.testing import assert_allclose, assert_array_equal

from nonhertz.errors import InputError
from nonhertz.files.traces import LARGEST_FILE, read_trace
from nonhertz.files.traces.line import MOST_POINTS
from nonhertz.measured import prepare

Y = np.array([0.0, 0.25, 0.5, 0.75, 1.0, 1.25])
UM = np.array([-3.125, -1.5, 0.0, -0.25, -1.75, -4.0])
PAIRS = list(zip(Y, UM, strict=True))


lines = partial(trace_files.lines, PAIRS)


def workbook_of(rows: Iterable[Sequence[object]]) -> bytes:
    import openpyxl

    book, stream = openpyxl.Workbook(), io.BytesIO()
    book.active.append(["made", "by", "hand"])
    sheet = book.create_sheet("Data")
    for row in rows:
        sheet.append(row)
    book.save(stream)
    return stream.getvalue()


def with_comma(data: bytes) -> bytes:
    return data.replace(b".", b",")


TEXTS = {
    "blanks": lines("{:.2f}  {:.3f}"),
    "tab": lines("{:.2f}\t{:.3f}"),
    "comma": lines("{:.2f},{:.3f}"),
    "comma and blank": lines("{:.2f}, {:.3f}"),
    "semicolon": lines("{:.2f};{:.3f}"),
    "bar": lines("{:.2f} | {:.3f}"),
    "semicolon at the end": lines("{:.2f};{:.3f};"),
    "decimal commas, semicolon": with_comma(lines("{:.2f};{:.3f}")),
    "decimal commas, tab": with_comma(lines("{:.2f}\t{:.3f}")),
    "decimal commas, blanks": with_comma(lines("{:.2f} {:.3f}")),
    "exponents": lines("{:.4E}\t{:.4E}"),
    "carriage returns": lines("{:.2f}\t{:.3f}", end="\r"),
    "both line ends": lines("{:.2f}\t{:.3f}", end="\r\n"),
    "hash comments": lines("{:.2f} {:.3f}  # point", "# made by hand\n"),
    "other comments": lines("{:.2f} {:.3f}", "% one\n// two\n' three\n"),
    "keys and values": lines("{:.2f}\t{:.3f}", "Instrument: MX 7\nPoints: 6\nOperator: N.N.\n\n"),
    "names": lines("{:.2f};{:.3f}", "position;height\n"),
    "UTF-8 with a mark": b"\xef\xbb\xbf" + lines("{:.2f};{:.3f}", "y;z\n"),
    "UTF-16": "\n".join(f"{y};{z}" for y, z in PAIRS).encode("utf-16"),
    "UTF-16 without a mark": "\n".join(f"{y};{z}" for y, z in PAIRS).encode("utf-16-le"),
    "Latin-1": "Prüfer: Müller\n".encode("latin-1") + lines("{:.2f};{:.3f}"),
    "end-of-file mark": lines("{:.2f} {:.3f}") + b"\x1a",
    "quotes": lines('"{:.2f}","{:.3f}"', '"y","z"\n'),
    "decimal commas below a head with points": b"Date;1.2.2024\nNo.;7.3\n" + with_comma(lines("{:.2f};{:.3f}")),
    "decimal commas and blanks below a head": b"Day 1.2.\nRun 7\nRun 8\n" + with_comma(lines("{:.2f} {:.3f}")),
}


@pytest.mark.parametrize("name", TEXTS)
def test_all_dialects_of_columns_are_the_same_line(name):
    trace = read_trace(TEXTS[name], "roller.txt", height_unit="um")
    assert_allclose(trace.y, Y, rtol=1e-12)
    assert_allclose(trace.height, 1e-3 * UM, rtol=1e-9)
    assert trace.gaps == ()
    assert "beside" not in " ".join(trace.notes)


@pytest.mark.parametrize(
    ("head", "position", "height"),
    [
        ("y [mm];z [um]", 1.0, 1e-3),
        ("y (mm);z (µm)", 1.0, 1e-3),
        ("y / um;z / nm", 1e-3, 1e-6),
        ("y_mm;z_um", 1.0, 1e-3),
        ("x in mm;z in μm", 1.0, 1e-3),
        ("y;z\nmm;um", 1.0, 1e-3),
        ("y [m];z [in]", 1e3, 25.4),
        ("y [mm] z [um]", 1.0, 1e-3),
        ("y_axis;z_axis [um]", 1.0, 1e-3),
        ("X [MM];Z [UM]", 1.0, 1e-3),
        ("# y [mm] z [um]", 1.0, 1e-3),
        ("# measured with care [twice]\n# y [mm]; z [um]\n#", 1.0, 1e-3),
        ("X um;Z um", 1e-3, 1e-3),
        ("Lateral um;Raw Micrometer;", 1e-3, 1e-3),
        ('"X, mm";"Z, um"', 1.0, 1e-3),
        ("X: um;Z: um.", 1e-3, 1e-3),
        ("µm;µm", 1e-3, 1e-3),
        ("um;um\nX;Z", 1e-3, 1e-3),
        ("# X mm, Z um", 1.0, 1e-3),
        ("X mm Z um", 1.0, 1e-3),
        ("X (mu m);Z (1e-6 m)", 1e-3, 1e-3),
        ("X (10⁻⁶ m);Z (10^-9 m)", 1e-3, 1e-6),
        ("X mm;Z angstrom", 1.0, 1e-7),
        ("X (mm);Z (Å)", 1.0, 1e-7),
        ("X мм;Z мкм", 1.0, 1e-3),
        ("X [毫米];Z [µ]", 1.0, 1e-3),
        ("X Millimeter;Z Mikrometer", 1.0, 1e-3),
        ("X in;Z mils", 25.4, 0.0254),
        ("Z..um.;Z..um.", 1e-3, 1e-3),
        ("X uin;Z microinches", 25.4e-6, 25.4e-6),
        ("Units: mm, um", 1.0, 1e-3),
        ("Units: um, nm", 1e-3, 1e-6),
        ("X unit = mm\nZ unit = um\nX;Z", 1.0, 1e-3),
        ("X mm;Z um\nLength;10 cm", 1.0, 1e-3),
        ("X unit: mm\nZ unit: um", 1.0, 1e-3),
        ("Z unit: um\nX unit: mm", 1.0, 1e-3),
        ("Y unit: um\nX unit: mm", 1.0, 1e-3),
        ("z unit: nm\ny unit: mm", 1.0, 1e-6),
        ("# Y unit: um\n# X unit: mm", 1.0, 1e-3),
        ("Y_Unit_Label\tum\nX0\t0.0\nDelta_X\t0.25", 1.0, 1e-3),
        ("Z (um)\nX (mm)", 1.0, 1e-3),
        ("Unit-Z;um\nUnit-X;mm", 1.0, 1e-3),
        ("Vertical units: um\nHorizontal units: mm", 1.0, 1e-3),
        ("ZUnit=um, XUnit=mm", 1.0, 1e-3),
        ("X (mm);Z (um)\nFilter;none\nSpeed;0.5 mm/s\nTip radius (um);2", 1.0, 1e-3),
        ("X (mm);Z (um)\nCutoff (mm);none", 1.0, 1e-3),
        ("X (um);Z (nm);Remark", 1e-3, 1e-6),
        ("X (um),Z (nm),Remark,Flag", 1e-3, 1e-6),
        ("X (um) Z (nm) Remark", 1e-3, 1e-6),
    ],
)
def test_units_are_taken_from_the_head(head, position, height):
    trace = read_trace((head + "\n").encode() + lines("{};{}"))
    assert_allclose(trace.y, position * Y, rtol=1e-12)
    assert_allclose(trace.height, height * UM, rtol=1e-12)


@pytest.mark.parametrize(
    "head", ["all values in um", "[um]", "X [?m];Z [?m]", "X ?m;Z ?m", "X (A);Z (A)", "# um", "Unit: um", "Y unit: um"]
)
def test_a_unit_that_belongs_to_no_column_or_is_none_of_length_is_asked_for(head):
    text = (head + "\n").encode() + lines("{};{}")
    with pytest.raises(InputError, match=r"must state (the|a) unit of .*give position_unit and height_unit"):
        read_trace(text)
    assert_allclose(read_trace(text, position_unit="um", height_unit="um").height, 1e-3 * UM, rtol=1e-12)


def test_a_line_of_metres_is_taken_for_micrometres_that_were_not_stated():
    text = b"\n".join(b"%g %g" % (1e4 * y, 1e-3 * z) for y, z in PAIRS)
    with pytest.raises(
        InputError, match=r"state the unit of its positions \(in mm the line would be 1\.25e\+04 long\)"
    ):
        read_trace(text)
    assert_allclose(read_trace(text, position_unit="um").y, 10.0 * Y, rtol=1e-12)


def test_stated_units_go_before_those_of_the_head():
    trace = read_trace(b"y [mm];z [um]\n" + lines("{};{}"), height_unit="nm")
    assert_allclose(trace.height, 1e-6 * UM, rtol=1e-12)


def test_a_unit_that_is_taken_for_granted_is_noted():
    flat = b"".join(b"%d 0.00%d\n" % (k, k % 3) for k in range(8))
    taken = "The file states no unit for its {}; they were taken as mm."
    assert read_trace(flat).notes == (taken.format("positions and heights"),)
    assert read_trace(flat, height_unit="mm").notes == (taken.format("positions"),)
    assert read_trace(flat, position_unit="mm", height_unit="mm").notes == ()


def test_micrometres_without_a_unit_are_not_taken_for_millimetres():
    with pytest.raises(
        InputError, match=r"state the unit of its heights \(in mm they would differ by 4 on a length of"
    ):
        read_trace(lines("{} {}"), "roller.txt")


def test_a_flat_line_in_micrometres_is_given_away_by_its_roughness():
    """In mm it would have half a millimetre on ten, which a body may have, but from one point to the next."""
    y = np.linspace(0.0, 10.0, 1001)
    height = 0.1 * np.random.default_rng(1).standard_normal(1001)
    text = "\n".join(f"{a:.3f} {b:.4f}" for a, b in zip(y, height, strict=True)).encode()
    assert np.ptp(height) < 1.0
    with pytest.raises(InputError, match=r"in mm they would rise and fall by .* in a mm from point to point"):
        read_trace(text)


def test_columns_that_are_swapped_are_refused_until_they_are_chosen():
    swapped = lines("{1};{0}", "z [um];y [mm]\n")
    with pytest.raises(InputError, match=r"in the first column \(it reverses in 2 places and the second in"):
        read_trace(swapped)
    assert_allclose(read_trace(swapped, position_column=2).height, 1e-3 * UM, rtol=1e-12)


def test_order_and_repetition_are_put_right_and_noted():
    down = read_trace(b"\n".join(b"%g %g" % pair for pair in reversed(PAIRS)), height_unit="um")
    assert_allclose(down.y, Y, rtol=1e-12)
    assert "order was reversed" in " ".join(down.notes)
    mixed = [PAIRS[k] for k in (2, 0, 1, 3, 5, 4)] + [(0.5, 1.0)]
    sorted_ = read_trace(b"\n".join(b"%g %g" % pair for pair in mixed), height_unit="um")
    assert_allclose(sorted_.y, Y, rtol=1e-12)
    assert_allclose(sorted_.height[2], 0.5e-3, rtol=1e-12)
    assert "sorted" in " ".join(sorted_.notes)
    assert "averaged" in " ".join(sorted_.notes)


FOOTERS = ["END", "Ra;0.12;um", "</data>", "*** end ***", "point.end\nspline.end", "\n6 points", "Rz 0.5 um\n0.7"]


@pytest.mark.parametrize("footer", FOOTERS)
def test_what_stands_below_the_points_is_left_out_with_a_note(footer):
    trace = read_trace(lines("{};{}") + footer.encode(), height_unit="um")
    assert_allclose(trace.height, 1e-3 * UM, rtol=1e-12)
    assert "The text below the points was ignored, from line " in " ".join(trace.notes)


@pytest.mark.parametrize("where", [(2, 4), (0, 1), (4, 5)], ids=["inside", "first", "last"])
@pytest.mark.parametrize(
    "mark",
    ["{} *", "* {}", "{};*", "{}*", "{}!", "{};#", "{}#", "> {}", "{};x", "{};see note 3", '" {}', '"{}"', "{} # a"],
)
def test_marks_and_words_beside_numbers_are_left_out(mark, where):
    rows = [f"{y};{z}" for y, z in PAIRS]
    for row in where:
        rows[row] = mark.format(rows[row])
    trace = read_trace(("y;z\n" + "\n".join(rows)).encode(), height_unit="um")
    assert_allclose(trace.height, 1e-3 * UM, rtol=1e-12)
    # A star in a cell of its own is a missing value, and a comment is one.
    noted = mark not in {"{};*", "{};#", "{} # a", '" {}', '"{}"'}
    assert ("2 lines have a mark or text beside" in " ".join(trace.notes)) == noted


def test_a_word_beside_the_first_points_between_blanks_is_asked_about():
    """It may be a setting."""
    with pytest.raises(InputError, match=r"must hold 2 columns in line 2 as elsewhere \(there are 3: '0.0 -3.125 x'\)"):
        read_trace(lines("{} {}", "y z\n").replace(b"-3.125", b"-3.125 x"), height_unit="um")


def test_lines_of_numbers_that_are_comments_are_counted():
    trace = read_trace(b"! 7.0 1\n# 8.0 2\n" + lines("{} {}"), height_unit="um")
    assert "2 lines of numbers above or between the points are comments and were left out." in trace.notes


TEXT_COLUMNS = {
    "empty": "X (mm),Z (um),Remark\n" + "".join(f"{y},{z},\n" for y, z in PAIRS),
    "some": "X (mm),Z (um),Remark\n"
    + "".join(f"{y},{z},{'bump, 3' if y == 0.5 else ''}\n" for y, z in PAIRS).replace("bump, 3", '"bump, 3"'),
    "first": "X (mm),Z (um),Remark\n" + "".join(f"{y},{z},{'begin' if y == 0.0 else ''}\n" for y, z in PAIRS),
    "in front": "Point;X (mm);Z (um)\n" + "".join(f"P{k};{y};{z}\n" for k, (y, z) in enumerate(PAIRS)),
    "between, decimal commas": "X (mm);at;Z (um)\n" + "".join(f"{y};10:12.5;{z}\n".replace(".", ",") for y, z in PAIRS),
    "a number in the remarks": "X (mm);Z (um);Note\n"
    + "".join(f"{y};{z};\n" for y, z in PAIRS * 4).replace("-4.0;", "-4.0;7", 1),
}


@pytest.mark.parametrize("name", TEXT_COLUMNS)
def test_columns_of_text_are_not_needed(name):
    trace = read_trace(TEXT_COLUMNS[name].encode())
    assert_allclose(trace.y, Y, rtol=1e-12)
    assert_allclose(trace.height, 1e-3 * UM, rtol=1e-12)


def test_a_column_of_text_cannot_be_chosen():
    with pytest.raises(InputError, match=r"must hold a number in line 2, column 1 \(there is 'P0'\)"):
        read_trace(TEXT_COLUMNS["in front"].encode(), position_column=1, height_column=3)


MISSING = ["", "NaN", "*****", "BAD", "-", "n/a", "1.#QNAN", "1.#QNAN00", "-1.#IND", "1.#INF", "1.#J", "1,#QNAN"]
MISSING += [
    "-nan(ind)",
    "-nan",
    "nan(0x8000)",
    "NaNQ",
    "Infinity",
    "No Data",
    "NoData",
    "---",
    "not measured",
    "#N/A",
    "#NV",
    "#DIV/0!",
    "#####",
    "<NA>",
    "\u221e",
]


@pytest.mark.parametrize("cell", MISSING)
def test_points_that_were_not_measured_are_gaps(cell):
    rows = [f"{y};{z}" for y, z in PAIRS]
    rows[2] = f"{PAIRS[2][0]};{cell}"
    rows[3] = f"{cell};{PAIRS[3][1]}"
    trace = read_trace("\n".join(rows).encode() + b"\n1.5;-5\n", height_unit="um")
    assert trace.gaps == ((0.25, 1.0),)
    assert "2 of 7 points have no value" in " ".join(trace.notes)
    begun = read_trace(
        f"y;z\n{cell};{cell}x\n".replace("x", "" if cell else "nan").encode() + lines("{};{}"), height_unit="um"
    )
    assert "1 of 7 points have no value" in " ".join(begun.notes) or not any(map(str.isalnum, cell))


@pytest.mark.parametrize("separator", [";", " ", "\t"])
@pytest.mark.parametrize("words", ["No Data", "lost contact", "dropout", "n.a."])
def test_words_in_place_of_a_height_are_a_gap(words, separator):
    rows = [f"{y}{separator}{z}" for y, z in PAIRS]
    rows[2] = f"{PAIRS[2][0]}{separator}{words}"
    trace = read_trace("\n".join(rows).encode(), height_unit="um")
    assert trace.gaps == ((0.25, 0.75),)
    assert "1 of 6 points have no value" in " ".join(trace.notes)
    with pytest.raises(InputError, match=r"must hold .* in line 3"):
        read_trace("\n".join(rows).replace(words, "x7").encode(), height_unit="um")


SDF = "aBCR - 1.0\nManufacID = a 2\nNumPoints = 6\nNumProfiles = 1\nXscale = 2.5E-04\nYscale = 0\nZscale = 1.0e-7\n*\n"
PTB = "Profil a.pr\r\nX-{} = 1250.0 X-{} 4.0 {}: 6\r\n"
ALONE = {
    "SDF": trace_files.heights_alone(10.0 * UM, SDF) + b"*\nTrimmedLength = 10\n*\n",
    "SDF of ISO 25178-71": trace_files.heights_alone(10.0 * UM, SDF.replace("aBCR - 1.0", "aISO-1.0"), "{!r}"),
    "PTB": trace_files.heights_alone(UM, PTB.format("len", "resolution", "points/scanline"), end="\r\n"),
    "PTB in German": PTB.format("Maß", "Auflösung", "Punkte/Zeile ").encode("cp850") + trace_files.heights_alone(UM),
    "SigmaSurf": trace_files.heights_alone(
        UM, "SigmaSurf_Data 1.0\nSPACING_UM: 250.0\nNUMBER_OF_POINTS: 6\nPROFILE_UM:\n"
    ),
    "softgauge": trace_files.heights_alone(UM, "250.000\r\n", end="\r\n"),
    "number and step": trace_files.heights_alone(UM, "Spacing: 0.25 mm\nz [um]\n6\n"),
    "step in words": trace_files.heights_alone(
        UM, "Sampling interval [um];250\nY spacing;1 mm\nStep height: 5 um\nHeight [um]\n"
    ),
    "step as a comment": trace_files.heights_alone(UM, "# dx = 0.25 mm\n# unit: um\n"),
    "decimal commas": with_comma(trace_files.heights_alone(UM, "Schrittweite: 0,25 mm\nZ [µm]\n")),
    "semicolons": trace_files.heights_alone(UM, "Delta X (mm): 0.25\nZ unit: um\nX unit: mm\n", "{:.6f};"),
    "marks": trace_files.heights_alone(UM, "increment = 250 um\nz um\n").replace(b"-1.500000", b"-1.5 *"),
    "workbook": workbook_of([["Spacing (um)", 250], ["Z (um)"], *([z] for z in UM.tolist())]),
}


@pytest.mark.parametrize("name", ALONE)
def test_heights_alone_have_the_step_that_the_file_states(name):
    trace = read_trace(ALONE[name], "roller")
    assert_allclose(trace.y, Y, rtol=1e-12)
    assert_allclose(trace.height, 1e-3 * UM, rtol=1e-9)
    assert "Heights alone, 250 um apart: positions count from the first." in trace.notes


@pytest.mark.parametrize("step", [0.25, "250 um", "0.25mm"])
@pytest.mark.parametrize("text", ["", "made by hand\n", "250.000\n"])
def test_heights_alone_have_the_step_that_is_given(text, step):
    """Which may stand before them too."""
    for data in (trace_files.heights_alone(UM, text), with_comma(trace_files.heights_alone(UM, text))):
        trace = read_trace(data, step=step, height_unit="um")
        assert_allclose(trace.y, Y, rtol=1e-12)
        assert_allclose(trace.height, 1e-3 * UM, rtol=1e-12)


def test_a_height_that_was_not_measured_is_a_gap_of_heights_alone():
    data = trace_files.heights_alone(UM, "spacing 0.25 mm\nz (um)\n").replace(b"-0.250000", b"No Data")
    assert read_trace(data).gaps == ((0.5, 1.0),)


def test_the_step_goes_with_numbers_of_points_and_with_no_positions():
    counted = trace_files.lines(list(enumerate(UM)), "{};{}", "n;z (um)\n")
    assert_allclose(read_trace(counted, step="250 um").y, Y, rtol=1e-12)
    with pytest.raises(InputError, match=r"step = 0\.25 must not be given for a file that has positions"):
        read_trace(lines("{};{}"), step=0.25, height_unit="um")


ASKED_OF_HEIGHTS = {
    "no step": ("z (um)\n", r"must state the spacing of its points .*: give step, such as"),
    "a first number that may be it": (
        "z (um)\n900\n",
        r"must state .* \(there is one number .*; the first, 900, may be it\)",
    ),
    "step without a unit": ("spacing: 250\nz (um)\n", r"must state the unit of its positions \(in mm the line"),
    "cut off": ("Number of points: 7\nspacing: 250 um\nz (um)\n", r"must hold the 7 heights stated"),
    "an area": (SDF.replace("les = 1", "les = 3"), r"must hold one profile \(it states 3"),
    "text": ("spacing: 250 um\nz (um)\n1.0\na7\n", r"must hold one number in line 4 as elsewhere \(there is 'a7'\)"),
}


@pytest.mark.parametrize("name", ASKED_OF_HEIGHTS)
def test_heights_alone_without_what_is_needed_are_asked_about(name):
    head, sentence = ASKED_OF_HEIGHTS[name]
    with pytest.raises(InputError, match=sentence):
        read_trace(trace_files.heights_alone(UM, head))


def written(y: np.ndarray, height: np.ndarray) -> bytes:
    """Return a text of positions and heights [mm]."""
    return "\n".join(f"{a!r} {b!r}" for a, b in zip(y.tolist(), height.tolist(), strict=True)).encode()


def crown(count: int = 1001) -> tuple[np.ndarray, np.ndarray]:
    y = np.round(np.linspace(0.0, 10.0, count), 6)
    return y, -((y - 5.0) ** 2) / 400.0


@pytest.mark.parametrize("seed", range(4))
def test_the_order_of_the_lines_does_not_matter(seed):
    """Gaps included: a line whose height is nan has a position, and its neighbours are those of the sorted line."""
    rng = np.random.default_rng(seed)
    y, height = crown()
    height[rng.integers(0, 1001, 40)] = np.nan
    height[500:530] = np.nan
    in_order = read_trace(written(y, height), height_unit="mm")
    assert (4.99, 5.3) in in_order.gaps
    again = rng.integers(0, 1001, 10)
    y, height = np.concatenate([y, y[again]]), np.concatenate([height, height[again]])
    shuffled = rng.permutation(len(y))
    other = read_trace(written(y[shuffled], height[shuffled]), height_unit="mm")
    assert_array_equal(other.y, in_order.y)
    assert_allclose(other.height, in_order.height, rtol=1e-15)
    assert other.gaps == in_order.gaps


@pytest.mark.parametrize("offset", [0.0, 0.003])
def test_what_one_stroke_lost_another_has_measured(offset):
    y, height = crown()
    there, back = height.copy(), height[::-1].copy()
    there[300:350], back[200:240] = np.nan, np.nan
    trace = read_trace(written(np.concatenate([y, y[::-1] + offset]), np.concatenate([there, back])), height_unit="mm")
    assert trace.gaps == ()
    assert_allclose(prepare(trace, smooth=False, align=False).relief.max(), 25.0 / 400.0, rtol=2e-3)


def test_a_gap_between_two_strokes_that_overlap_is_found():
    """Their points lie at two distances where they overlap, and still as far apart at most as those of one stroke."""
    y, height = crown()
    low, high = (y < 6.0) & ~((y > 1.0) & (y < 1.5)), y > 4.0
    both = np.concatenate([y[low], y[high] + 0.003])
    trace = read_trace(written(both, np.concatenate([height[low], height[high]])), height_unit="mm")
    assert trace.gaps == ((1.0, 1.5),)


def test_points_without_a_position_are_a_gap_only_between_neighbours():
    """In a file without order they lie anywhere; between points that others separate, nothing was lost."""
    y, height = crown()
    nowhere = y.copy()
    nowhere[300:303] = np.nan
    assert read_trace(written(nowhere, height), height_unit="mm").gaps == ((2.99, 3.03),)
    assert read_trace(written(np.r_[nowhere, y[::-1]], np.r_[height, height[::-1]]), height_unit="mm").gaps == ()
    order = np.random.default_rng(1).permutation(1001)
    assert read_trace(written(nowhere[order], height[order]), height_unit="mm").gaps == ((2.99, 3.03),)


@pytest.mark.parametrize("lost", [slice(1, None, 2), slice(0, None, 3)])
def test_points_lost_at_every_turn_leave_a_coarser_line(lost):
    """No gap at all: every step is as long as the others, or nearly."""
    y, height = crown()
    height[lost] = np.nan
    trace = read_trace(written(y, height), height_unit="mm")
    assert trace.gaps == ()
    assert_allclose(prepare(trace).relief.max(), 25.0 / 400.0, rtol=5e-3)


def test_columns_are_chosen_by_number_or_name():
    text = b"n;y [mm];raw;z [um]\n" + b"".join(b"%d;%g;0;%g\n" % (k, *pair) for k, pair in enumerate(PAIRS))
    for chosen in ((2, 4), ("2", "4"), ("y", "z"), ("Y [MM]", "z")):
        trace = read_trace(text, position_column=chosen[0], height_column=chosen[1])
        assert_allclose(trace.height, 1e-3 * UM, rtol=1e-12)
    whole = b"n,z,y\n" + b"".join(b"%d,%d,%d\n" % (k, z, 10 * k) for k, z in enumerate((3, 1, 4, 1, 5)))
    assert_allclose(read_trace(whole, position_column=3, height_column=2, height_unit="um").y, [0, 10, 20, 30, 40])
    two = read_trace(lines("{1};{0}"), height_column=1, height_unit="um")
    assert_allclose(two.height, 1e-3 * UM, rtol=1e-12)


def test_material_taken_away_turns_the_sign():
    drop = read_trace(lines("{};{}"), height_unit="um", sense="drop")
    assert_allclose(drop.height, -1e-3 * UM, rtol=1e-12)
    named = read_trace(b"y [mm];relief [um]\n" + lines("{};{}"))
    assert_allclose(named.height, -1e-3 * UM, rtol=1e-12)
    told = read_trace(b"y [mm];relief [um]\n" + lines("{};{}"), sense="height")
    assert_allclose(told.height, 1e-3 * UM, rtol=1e-12)
    remarked = read_trace(b"# y,relief\n" + lines("{},{}"), height_unit="um")
    assert_allclose(remarked.height, -1e-3 * UM, rtol=1e-12)
    depth = read_trace(b"y [mm];depth [um]\n" + lines("{};{}"), sense="drop")
    assert_allclose(depth.height, -1e-3 * UM, rtol=1e-12)


smd, prf, x3p = (partial(each, UM, 0.25) for each in (trace_files.smd, trace_files.prf, trace_files.x3p))
marwin = partial(trace_files.marwin, PAIRS)


def simpack(kind: int = 0, factor: float = 1e3) -> bytes:
    head = f"! SIMPACK\n  header.begin\n type = {kind} ! 0=rail, 1=wheel\n  header.end\n  spline.begin\n"
    head += f"    units.len.f = {factor:+.15e} ! unit\n    point.begin\n! y value (lengths unit)  z value  weight\n"
    sign = -1e-3 if kind == 0 else 1e-3
    return (
        lines_of(head, lambda y, z: f"{y * factor / 1e3} {sign * z * factor / 1e3} 1.0")
        + b"    point.end\n  spline.end\n"
    )


def miniprof() -> bytes:
    head = "Filename=R1.ban\nXYPoints=6\nTilt=\nColumnDef=X,Y,A\n\n"
    return lines_of(head, lambda y, z: ('" ' if z else "  ") + f"{y:.7E}\t{1e-3 * z:.7E}\t0.5")


def workbook(*rows: object) -> bytes:
    whole = (["Instrument", 7], [], *(rows or ([None, "X (mm)", "Z (µm)"], *([None, *pair] for pair in PAIRS))))
    return workbook_of(whole)


def lines_of(head: str, form) -> bytes:
    return (head + "\n".join(form(y, z) for y, z in PAIRS) + "\n").encode()


FORMATS = {
    "Simpack rail": simpack(),
    "Simpack wheel in metres": simpack(kind=1, factor=1.0),
    "MiniProf": miniprof(),
    "workbook": workbook(),
    "workbook with a column of remarks": workbook(
        ["X (mm)", "Z (µm)", "Remark"], *([*pair, "!" if k == 0 else None] for k, pair in enumerate(PAIRS))
    ),
    "workbook of text": workbook(["X um", "Z nm"], *([f"{1e3 * y:.1f}", f"{1e3 * z:.0f}"] for y, z in PAIRS)),
    "smd": smd(),
    "prf": prf(),
    "marwin": marwin(),
    "marwin along Y": marwin(along="7.5 {0:.9f} {1:.9f}"),
    "x3p": x3p(),
}


@pytest.mark.parametrize("name", FORMATS)
def test_formats_that_state_their_units_are_the_same_line(name):
    trace = read_trace(FORMATS[name], "roller")
    assert_allclose(trace.y, Y, atol=1e-12)
    assert_allclose(trace.height, 1e-3 * UM, atol=1e-9)


@pytest.mark.parametrize("name", ["smd", "marwin", "x3p"])
def test_units_beside_a_file_that_states_them_are_refused(name):
    with pytest.raises(InputError, match="height_unit = 'um' must not be given for"):
        read_trace(FORMATS[name], height_unit="um")


def test_invalid_points_of_x3p_are_a_gap():
    heights = np.where(np.arange(6) == 3, np.nan, UM)
    assert_allclose(read_trace(trace_files.x3p(heights, 0.25)).gaps, [(0.5, 1.0)], rtol=1e-9)


def test_invalid_points_of_smd_are_a_gap():
    trace = read_trace(smd(heights="\r\n".join(["-3", "-1", "BAD", "0", "-1", "-4"])))
    assert trace.gaps == ((0.25, 0.75),)


def altered(data: bytes, name: str, change: bytes | None = None) -> bytes:
    """Return a zip archive with one member changed."""
    stream = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(stream, "w") as new:
        for member in old.infolist():
            content = old.read(member)
            if member.filename.endswith(name):
                content = bytes([content[0] ^ 1]) + content[1:] if change is None else change
            new.writestr(member.filename, content)
    return stream.getvalue()


def surface() -> bytes:
    stream = io.BytesIO()
    x3pio.write(stream, np.zeros((3, 4)), x_scale=1e-6, y_scale=1e-6)
    return stream.getvalue()


def container(description: bytes, packing: int = zipfile.ZIP_DEFLATED, name: str = "main.xml") -> bytes:
    """Return a zip archive of a description, and the same once more."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", packing) as archive:
        archive.writestr(name, description)
        archive.writestr("more.xml", description)
    return stream.getvalue()


def in_directory(data: bytes, offset: int, change: bytes) -> bytes:
    """Return a zip archive with the first entry of its directory changed."""
    place = data.index(b"PK\x01\x02") + offset
    return data[:place] + change + data[place + len(change) :]


def understated(description: bytes, declared: int) -> bytes:
    """Return an archive that declares the beginning of a description, with its checksum, and holds all of it."""
    data = bytearray(container(description))
    crc, size = struct.pack("<L", zlib.crc32(description[:declared])), struct.pack("<L", declared)
    entry = data.index(b"PK\x01\x02")
    for place, change in ((14, crc), (22, size), (entry + 16, crc), (entry + 24, size)):
        data[place : place + 4] = change
    return bytes(data)


def with_entities() -> bytes:
    """Return an X3P whose description would unfold to a billion letters, with a checksum that fits it."""
    bomb = b'<?xml version="1.0"?><!DOCTYPE b [<!ENTITY a "aaaaaaaaaa">' + b"".join(
        b'<!ENTITY a%d "%s">' % (k, (b"&a%d;" % (k - 1) if k else b"&a;") * 10) for k in range(9)
    )
    bomb += b"]><b>&a8;</b>"
    data = altered(x3p(), "main.xml", bomb)
    return altered(data, "md5checksum.hex", hashlib.md5(bomb).hexdigest().encode() + b" *main.xml")


DAMAGED = {
    "empty": (b"", r"must not be empty"),
    "blank": (b" \r\n\t\n", r"must not be empty"),
    "only a head": (b"y [mm];z [um]\n", r"must hold two columns of numbers \(no line has any\)"),
    "one point": (b"0 1\n", r"must hold at least 5 positions \(there is only one\)"),
    "text in a cell": (lines("{} {}") + b"1.5 x7\n", r"must hold a number in line 7, column 2 \(there is 'x7'\)"),
    "text between": (lines("{} {}") + b"end of data\n1.5 -3\n", r"must hold 2 columns in line 7 as elsewhere \(there"),
    "a row of one": (lines("{} {}") + b"1.5\n", r"must hold 2 columns in line 7 as elsewhere \(there are 1: '1\.5'\)"),
    "an old workbook": (b"\xd0\xcf\x11\xe0" + bytes(99), r"must be a file that can be read \(this is a workbook\)"),
    "workbook cut off": (workbook()[:-99], r"must be an intact workbook \(file is not a zip file\): save it as CSV"),
    "workbook of words": (workbook(["a", "b"]), r"must hold two columns of numbers"),
    "three columns": (lines("{0};{1};0"), r"must hold two columns, or have two of its 3 chosen: give"),
    "one column": (b"1\n2\n3\n4\n5\n6\n", r"must state the spacing of its points \(there is one number per line"),
    "nothing measured": (b"nan nan\n" * 9, r"must hold two columns of numbers"),
    "no height measured": (b"".join(b"%d nan\n" % k for k in range(9)), r"must hold measured points"),
    "one position": (b"1 2\n1 3\n1 4\n1 5\n1 6\n", r"must hold at least 5 positions \(there is only one\)"),
    "a number for nothing": (lines("{} {}") + b"1.5 3.4e38\n", r"must hold .* within a kilometre \(there is one of 3"),
    "no length": (b"".join(b"%de-9 0.%d\n" % (k, k) for k in range(7)), r"must hold positions that are further apart"),
    "binary": (bytes(range(256)) * 4, r"must be text in columns, a MarWin text export, .smd, .prf, .x3p or .xlsx"),
    "unit of time": (b"y [mm];z [s]\n" + lines("{};{}"), r"must state a unit of length for each column"),
    "no unit": (b"y [mm];z [apples]\n" + lines("{};{}"), r"must state a unit of length for each column"),
    "commas of both kinds": (b"0,001,-13,5\n0,002,-13,6\n" * 4, r"must distinguish decimal commas from commas between"),
    "digits behind a comma": (b"0,001\n0,002\n0,003\n", r"must distinguish decimal commas from commas between columns"),
    "commas between thousands": (
        b"0;1\n500;2\n1,000;3\n1,500;2\n2,000;1\n2,500;0\n",
        r"must distinguish decimal commas from thousands separators \(line 3",
    ),
    "minus signs of print": (
        lines("{} {}").replace(b"-", "\u2212".encode()),
        r"must hold a number in line 4, column 2 \(there is '\u22120\.25'\)",
    ),
    "a web page": (b"<td>1</td>", r"must hold two columns of numbers \(line 1 is '<td>1</td>'\)"),
    "hundreds of columns": (
        b";".join(b"c%d" % k for k in range(300)) + b"\n" + b";".join([b"1"] * 300),
        r"must hold two columns, or have two of its 300 chosen \('c0', 'c1', 'c2', .*, \.\.\.\): give",
    ),
    "sign not known": (b"y [mm];depth [um]\n" + lines("{};{}"), r"must say which way its column 'depth \[um\]' is"),
    "smd of a negative factor": (
        smd().replace(b"um\0 1.0e0", b"um\0 -1.0e0"), r"must state a positive factor for its axis CZ \(it is -1"
    ),
    "smd cut off": (smd(count=8), r"must hold the 8 heights stated in its header \(there are 6\)"),
    "prf cut off": (prf(count=9), r"must hold the 9 heights stated in its header \(there are 6\)"),
    "prf without a step": (prf(spacing=""), r"must state the step of its points \(SPACING CX is missing\)"),
    "smd of positions": (smd(kind="A"), r"must have evenly spaced points \(its axis CX is of kind A\)"),
    "smd with text": (smd(heights="\r\n".join("123x56")), r"must hold a height in line 12 \(there is 'x'\)"),
    "marwin cut off": (marwin(count=7), r"must hold the 7 points stated in its header \(there are 6\)"),
    "marwin of too many": (marwin(count=10**30), r"must hold the 10000000000000000000 points"),
    "marwin with text": (marwin(along="x y z"), r"must hold a number in line 8, column 1 \(there is 'x'\)"),
    "zip cut off": (x3p()[:-60], r"must be an intact X3P file"),
    "zip of something": (altered(x3p(), "main.xml", b"<a/>"), r"must be an intact X3P file"),
    "checksum of points": (altered(x3p(), "data.bin"), r"must match its checksum"),
    "checksum of the description": (
        altered(x3p(), "md5checksum.hex", b"0" * 32 + b" *main.xml"), r"must match its checksum"
    ),
    "an area": (surface(), r"must hold a profile \(feature type PRF\), not an area: extract one line"),
    "xml that unfolds": (with_entities(), r"must have a description without definitions of its own \(DOCTYPE\)"),
    "unknown encoding": (
        container(b'<?xml version="1.0" encoding="klingon-8"?><a/>'), r"must be an intact X3P file \(unknown encoding"
    ),
    "version of zip": (in_directory(x3p(), 6, b"\x7d"), r"must be an intact X3P file \(zip file version 12\.5\)"),
    "no name in zip": (in_directory(container(b"<a/>", name="x"), 28, b"\0\0\1\0"), r"must be an intact X3P file"),
    "packed otherwise": (container(b"<a/>", zipfile.ZIP_LZMA), r"must be compressed by deflate"),
    "many elements": (container(b"<r>" + b"<a/>" * 100_000 + b"</r>"), r"must have .* no more than 100,000 elements"),
    "long description": (container(b" " * 8_000_001), r"must have a description of no more than 8 MB"),
    "deep elements": (container(b"<a>" * 51), r"must have a description nested no deeper than 50 elements"),
    "long text": (container(b"<a>" + b"x" * 100_001), r"must have a description whose texts are no longer than"),
    "long name": (container(b"<" + b"x" * 100_001 + b"/>"), r"must have a description with shorter names and"),
    "many files": (b"PK" + b"PK\x01\x02" * 1001, r"must hold no more than 1,000 files"),
    "one long line": (b"1 " * 2501, r"must have lines of no more than 5,000 characters \(line 1 has 5,002\)"),
    "smd of a long line": (smd(heights="1" * 5001), r"must have lines of no more than 5,000 characters"),
    "head without end": (b"9 a\n" * 1001 + lines("{} {}"), r"must hold two columns of numbers \(line 1 is '9 a'\)"),
    "parted digits": (lines("{} {}") + b"1_5 2\n", r"must hold a number in line 7, column 1 \(there is '1_5'\)"),
    "smd of parted digits": (smd(heights="1_5\r\n" * 5 + "2"), r"must hold a height in line \d+ \(there is '1_5'\)"),
    "marwin of parted digits": (marwin(along="1_5 0 0"), r"must hold a number in line 8, column 1 \(there is '1_5'\)"),
    "marwin with a bad line": (marwin().replace(b"3=0.75", b"3=0,75x"), r"must hold a number in line 11, column 1"),
}  # fmt: skip


@pytest.mark.parametrize("name", DAMAGED)
def test_a_damaged_file_ends_in_one_sentence(name):
    data, sentence = DAMAGED[name]
    with pytest.raises(InputError, match=r"file = 'roller\.dat' " + sentence) as caught:
        read_trace(data, "roller.dat")
    assert "\n" not in str(caught.value)
    assert str(caught.value).count(". ") == 0
    assert len(str(caught.value)) < 400


def test_more_numbers_than_fit_into_memory_are_refused(monkeypatch):
    monkeypatch.setattr("nonhertz.files.traces.columns._MOST_CELLS", 2_000)
    with pytest.raises(InputError, match=r"must hold no more than 2,000 numbers \(there are 6 lines of 402\)"):
        read_trace((b"1;" * 401 + b"\n") * 6)


def test_a_zip_that_unpacks_to_too_much_is_refused(monkeypatch):
    """By what it declares, so that nothing is unpacked to find out."""
    monkeypatch.setattr("nonhertz.files.traces.x3p._LARGEST_UNPACKED", 2_000_000)
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("main.xml", b"0" * 2_000_001)
    assert len(stream.getvalue()) < 10_000
    with pytest.raises(InputError, match="must unpack to no more than 2 MB"):
        read_trace(stream.getvalue())


def test_what_an_archive_declares_is_not_relied_on():
    """It is unpacked piece by piece: 20 MB behind a size of 10 bytes are never in memory."""
    data = understated(b"<r>" + b" " * 20_000_000, 10)
    tracemalloc.start()
    with pytest.raises(InputError, match="must be an intact X3P file"):
        read_trace(data)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert most < 5_000_000


def test_a_bomb_of_elements_is_refused_before_there_is_a_tree_of_them():
    data = container(b"<r>" + b"<a/>" * 1_000_000 + b"</r>")
    tracemalloc.start()
    with pytest.raises(InputError, match="no more than 100,000 elements"):
        read_trace(data)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert len(data) < 10_000
    # The description in pieces, as a whole, and in the new archive.
    assert most < 30_000_000


def test_an_x3p_of_too_many_points_is_refused_by_its_description(monkeypatch):
    monkeypatch.setattr("nonhertz.files.traces.x3p.MOST_POINTS", 5)
    with pytest.raises(InputError, match="must hold no more than 5 points"):
        read_trace(x3p())


def test_a_binary_profile_of_mahr_is_told_by_its_name():
    with pytest.raises(InputError, match=r"Mahr's .pcd is binary"):
        read_trace(bytes(range(256)), "P000_123.PCD")


def test_what_is_no_file_is_refused(tmp_path):
    for path in (tmp_path / "none.txt", tmp_path, Path("a\0b")):
        with pytest.raises(InputError, match="must be a file that can be read"):
            read_trace(path)


def test_an_empty_or_too_large_file_is_refused_in_one_sentence(tmp_path, monkeypatch):
    monkeypatch.setattr("nonhertz.files.traces.LARGEST_FILE", 10)
    for content, reason in ((b"", "not be empty"), (b"0 1\n" * 3, "be no larger than 0 MB")):
        path = tmp_path / "roller.txt"
        path.write_bytes(content)
        with pytest.raises(InputError) as caught:
            read_trace(path)
        assert str(caught.value).startswith(f"file = 'roller.txt' must {reason}: ")


def test_a_file_is_called_by_its_name(tmp_path):
    path = tmp_path / "roller 7.txt"
    path.write_bytes(lines("{} {}"))
    assert read_trace(path, height_unit="um").name == "roller 7.txt"
    assert read_trace(str(path), "mine", height_unit="um").name == "mine"


def test_large_files_are_refused():
    with pytest.raises(InputError, match="must be no larger than 20 MB"):
        read_trace(b"0" * (LARGEST_FILE + 1))
    with pytest.raises(InputError, match=re.escape(f"must hold no more than {MOST_POINTS:,} points")):
        read_trace(b"0 0\n" * (MOST_POINTS + 1001))


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"height_unit": "furlong per day"}, "height_unit = 'furlong per day' must be a unit of length"),
        ({"position_column": 3}, "position_column = 3 must be a column from 1 to 2"),
        ({"height_column": "roughness"}, "height_column = 'roughness' must be the name of a column"),
        ({"sense": "down"}, "sense = 'down' must be one of 'height', 'drop'"),
        ({"position_column": "\u00b2"}, "position_column = '\u00b2' must be the name of a column"),
        ({"position_column": 1.5}, r"position_column = 1\.5 must be the name of a column"),
        ({"height_column": 0}, "height_column = 0 must be a column from 1 to 2"),
        ({"height_column": -1}, "height_column = -1 must be a column from 1 to 2"),
        ({"height_column": "9" * 5000}, "must be a column from 1 to 2"),
        ({"position_column": 2, "height_column": 2}, "height_column = 2 must differ from position_column"),
    ],
    ids=range(10),
)
def test_an_option_that_means_nothing_is_refused(options, sentence):
    with pytest.raises(InputError, match=sentence):
        read_trace(lines("{};{}"), **options)
