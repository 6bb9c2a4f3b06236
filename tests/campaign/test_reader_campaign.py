"""Files of measuring machines, damaged in a hundred thousand ways: a trace or a sentence, soon and in little memory."""

import hashlib
import io
import multiprocessing
import time
import zipfile
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from functools import partial

import numpy as np
import pytest
import trace_files
import x3pio
from extent import extent
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st
from peak import peak_memory

from nonhertz.errors import InputError
from nonhertz.files.traces import LARGEST_FILE, read_trace
from nonhertz.files.traces.line import MOST_POINTS
from nonhertz.measured import Trace, prepare

FILES = extent(100_000, 1_000)
"""Over all formats together."""
SLOWEST = 2.0
"""s of processor time, for any file of these, and for the steps after it."""
MEMORY, GROWTH, OF_GENERATOR = 500.0, 100.0, 0.01
"""MB, of a process that reads the largest files; by which one that reads thousands of small ones grows; and by which
the generator of the files does for each of them."""

Y = np.linspace(0.0, 10.0, 120)
UM = -12.0 * ((Y - 5.0) / 5.0) ** 2 + 0.2 * np.sin(40.0 * Y)
PAIRS = list(zip(Y.tolist(), UM.tolist(), strict=True))


SDF = "aBCR - 1.0\nNumPoints = 120\nNumProfiles = 1\nXscale = 8.4E-05\nYscale = 0\nZscale = 1.0e-6\n*\n"
PTB = "Profil a.pr\nX-len = 9996.0 X-resolution 11.9 points/scanline: 120\n"

heights = partial(trace_files.heights_alone, UM)
text, marwin = partial(trace_files.lines, PAIRS), partial(trace_files.marwin, PAIRS)
smd, prf, x3p = (partial(each, UM, 0.084) for each in (trace_files.smd, trace_files.prf, trace_files.x3p))


SEEDS: dict[str, list[bytes]] = {
    "columns": [
        text("{:.3f} {:.4f}"),
        text("{:.3f};{:.4f};", "y [mm];z [um]\n"),
        text("{:.3f}\t{:.4f}", "position\theight\nmm\tum\n").replace(b".", b","),
        text('"{:.3f}","{:.4f}"', "# made by hand\n"),
    ],
    "other columns": [
        text("7;{:.3f};0;{:.4f}", "n;y [mm];raw;drop [um]\n"),
        text("{:.3f} {:.4f}").decode().encode("utf-16"),
        text("{:.3f};{:.4f}", "Prüfer: Müller\r\n", "\r\n").decode().encode("latin-1"),
        text("{:.3f} nan") + text("{:.3f} {:.4f}"),
    ],
    "heads of columns": [
        text("{:.3f},{:.4f},", "X (mm),Z (um),Remark\n"),
        text("{:.3f}\t{:.4f}", "Y unit: um\nX unit: mm\n"),
        text("P;{:.3f};{:.4f};ok", "Point;X (mm);Z (um);Note\nCutoff (mm);none\n"),
        text("{:.3f} {:.4f} !", "Z (um)\nX (mm)\n"),
        text("{:.3f} No Data") + text("{:.3f} {:.4f}"),
    ],
    "heights alone": [
        heights(SDF) + b"*\n",
        heights(PTB, end="\r\n"),
        heights("SPACING_UM: 84.0\nNUMBER_OF_POINTS: 120\nPROFILE_UM:\n"),
        heights("84.000\n"),
        heights("Schrittweite: 0,084 mm\nZ [um]\n").replace(b".", b","),
    ],
    "marwin": [marwin()],
    "records": [smd(), prf()],
    "x3p": [x3p(storage=x3pio.DataStorage.BINARY), x3p(storage=x3pio.DataStorage.XML)],
    "description of x3p": [x3p(storage=x3pio.DataStorage.BINARY), x3p(storage=x3pio.DataStorage.XML)],
}
TOKENS = [
    b"", b"\0", b"\n", b"\r", b";", b",", b".", b" ", b"\t", b"-", b"e", b"nan", b"inf", b"*****", b"#", b'"', b"[",
    b"]", b"1e999", b"-1e308", b"1e-320", b"9" * 400, b"0x1p3", b"1_0", b"(um)", b"[s]", b"\xff\xfe", b"\xef\xbb\xbf",
    b"PK\3\4", b"PK\1\2", b"<", b"/>", b"<a>", b"&a;", b"<!DOCTYPE a>", b"<![CDATA[", b"CX", b"CZ", b"EOR", b"\x03",
    b"NO_POINTS=", b"=", b"SPACING CX", b"[PROFILE_VALUES]", b"depth", b"drop", b"\x80", "\u0663".encode(),
    "\U0001f600".encode(), b"I", b"D", b"PRF", b"SUR", b"PCL", b"A", b"L", b"F", b"<SizeX>99999999</SizeX>",
    b"um", b"X (mm)", b"Z unit: um", b"No Data", b"Spacing: 84 um", b"NumPoints = 7", b"Xscale = nan", b"e-400 m",
    b"encoding='utf-7'", b"encoding='klingon'",
]  # fmt: skip

OPTIONS: list[dict[str, object]] = [
    {}, {"height_unit": "um"}, {"height_unit": "mm"}, {"position_column": 2, "height_column": 4}, {"sense": "drop"},
    {"step": "84 um"}, {"step": 1e-300},
]  # fmt: skip

places = st.floats(0.0, 1.0)
changes = st.one_of(
    st.tuples(st.just("put"), places, st.sampled_from(TOKENS)),
    st.tuples(st.just("put"), places, st.binary(min_size=1, max_size=4)),
    st.tuples(st.just("replace"), places, st.sampled_from(TOKENS)),
    st.tuples(st.just("replace"), places, st.binary(min_size=1, max_size=2)),
    st.tuples(st.just("cut"), places, places),
    st.tuples(st.just("keep"), places, places),
    st.tuples(st.just("double"), places, places),
    st.tuples(st.just("turn"), places, places),
    st.tuples(st.just("lines"), places, places),
)


def changed(data: bytes, change: tuple[str, float, bytes | float]) -> bytes:
    """Return data with one change; all places are shares of its length."""
    kind, place, other = change
    begin = int(place * len(data))
    if isinstance(other, bytes):
        return data[:begin] + other + data[begin + (len(other) if kind == "replace" else 0) :]
    if kind == "lines":
        lines = data.splitlines(keepends=True)
        a, b = (min(int(share * len(lines)), len(lines) - 1) for share in (place, other))
        if lines:
            lines[a], lines[b] = lines[b], lines[a]
        return b"".join(lines)
    begin, end = sorted((begin, int(other * len(data))))
    return {
        "cut": data[:begin] + data[end:],
        "keep": data[begin:end],
        "double": data[:end] + data[begin:end] + data[end:],
        "turn": data[:begin] + data[begin:end][::-1] + data[end:],
    }[kind]


def with_description(data: bytes, change: Callable[[bytes], bytes]) -> bytes:
    """Return a container whose description is changed, with a checksum that fits it."""
    stream = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as new:
        description = change(old.read("main.xml"))
        for name in old.namelist():
            content = description if name == "main.xml" else old.read(name)
            digest = hashlib.md5(description).hexdigest()
            new.writestr(name, f"{digest} *main.xml\n" if name == "md5checksum.hex" else content)
    return stream.getvalue()


def outcome(data: bytes, **options: object) -> str:
    """Return what is said of a file, "" if it is read and prepared."""
    began = time.process_time()
    try:
        trace = read_trace(data, "fuzz", **options)  # type: ignore[arg-type]
        assert np.all(np.isfinite(trace.height))
        assert np.all(np.diff(trace.y) > 0.0)
        measured = prepare(trace)
        assert np.all(np.isfinite(measured.relief))
        said = "".join(sentence for sentence in measured.warnings if "\n" in sentence)
    except InputError as error:
        said = str(error)
    assert time.process_time() - began < SLOWEST
    return said


@pytest.mark.campaign
@pytest.mark.parametrize("name", SEEDS)
def test_a_damaged_file_is_a_trace_or_one_sentence(name):
    @settings(
        max_examples=FILES // len(SEEDS),
        deadline=None,
        database=None,
        phases=[Phase.generate, Phase.shrink],
        suppress_health_check=list(HealthCheck),
    )
    @given(st.sampled_from(SEEDS[name]), st.lists(changes, min_size=1, max_size=6), st.sampled_from(OPTIONS))
    def check(seed: bytes, made: list[tuple[str, float, bytes | float]], options: dict[str, object]) -> None:
        def change(data: bytes) -> bytes:
            for each in made:
                data = changed(data, each)
            return data

        data = with_description(seed, change) if name == "description of x3p" else change(seed)
        said = outcome(data, **options if name.endswith(("columns", "alone")) else {})
        assert "\n" not in said
        assert len(said) < 500

    before = peak_memory()
    check()
    assert peak_memory() - before < GROWTH + OF_GENERATOR * FILES // len(SEEDS)


def packed(description: bytes) -> bytes:
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("main.xml", description)
    return stream.getvalue()


def filled(line: bytes, head: bytes = b"") -> bytes:
    """Return a file as large as may be of one line again and again."""
    return head + line * ((LARGEST_FILE - len(head)) // len(line))


LARGE: dict[str, Callable[[], bytes]] = {
    "one line": lambda: filled(b"1 "),
    "one cell": lambda: filled(b"1"),
    "empty lines": lambda: filled(b"\n", b"0 1"),
    "short lines": lambda: filled(b"a\n"),
    "comments": lambda: filled(b"# 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18\n"),
    "wide characters": lambda: filled(b"1 2 3 4 5 6 7 8 9\n", "\U0001f600\n".encode()),
    "wide characters of UTF-16": lambda: filled("1 \U0001f600 2 3 4 5 6 7 8\n".encode("utf-16-le"), b"\xff\xfe"),
    "many columns": lambda: filled(b"1;" * 400 + b"\n"),
    "many columns without numbers": lambda: filled(b"1;" * 400 + b"a\n"),
    "brackets": lambda: filled(b"[" * 4000 + b"\n"),
    "commas": lambda: filled(b"1,2,3,4,5,6,7,8,9,10,11,12,13,14,15\n"),
    "missing": lambda: b"".join(b"%d.%03d ***\n" % divmod(k, 1000) for k in range(MOST_POINTS)),
    "all points": lambda: b"".join(
        b"%d.%03d 0.%06d\n" % (*divmod(k, 1000), k * 7919 % 1000) for k in range(MOST_POINTS)
    ),
    "heights": lambda: filled(b"0.001\n", b"spacing: 0.1 um\n"),
    "all heights": lambda: b"spacing: 2 um\n" + b"".join(b"0.%06d\n" % (k * 7919 % 1000) for k in range(MOST_POINTS)),
    "words": lambda: b"".join(b"%d.%03d no data\n" % divmod(k, 1000) for k in range(MOST_POINTS)),
    "marks": lambda: b"".join(b"%d.%03d 0.1 !\n" % divmod(k, 1000) for k in range(MOST_POINTS)),
    "marwin": lambda: b"[PROFILE_VALUES]\n" + b"".join(b"%d=%d 0 0.1 0 0\n" % (k, k) for k in range(MOST_POINTS)),
    "records": lambda: filled(b"1\r\n", smd()[:200]),
    "elements": lambda: packed(b"<r>" + b"<a/>" * 1_900_000 + b"</r>"),
    "more elements": lambda: packed(b"<r>" + b"<a/>" * 14_000_000 + b"</r>"),
    "attributes": lambda: packed(b"<a " + b" ".join(b"a%d='1'" % k for k in range(600_000)) + b"/>"),
    "deep elements": lambda: packed(b"<a>" * 2_000_000),
    "text": lambda: packed(b"<a>" + b"x" * 7_900_000 + b"</a>"),
    "remarks": lambda: packed(b"<a>" + b"<!---->" * 1_100_000 + b"</a>"),
}


def read_large(name: str) -> tuple[str, float]:
    """Return what is said of a large file, and the most memory that the process has had [MB]."""
    data = LARGE[name]()
    began = time.process_time()
    try:
        assert isinstance(read_trace(data, "large"), Trace)
        said = "read"
    except InputError as error:
        said = str(error)
    print(
        f"{name}: {len(data) / 1e6:.2f} MB, {time.process_time() - began:.1f} s, {peak_memory():.0f} MB: {said[:100]}"
    )
    return said, peak_memory()


@pytest.fixture(scope="module")
def reader():
    """One process of its own, whose memory is what the worst of the files took."""
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as process:
        yield process


@pytest.mark.campaign
@pytest.mark.parametrize("name", LARGE)
def test_the_largest_files_fit_into_memory(reader, name):
    said, most = reader.submit(read_large, name).result()
    assert "\n" not in said
    assert most < MEMORY
