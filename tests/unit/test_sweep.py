"""Sweeps: rows are those of single solves, and survive being stopped."""

import contextlib
import os
import pickle
import sqlite3
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.amounts import display_units, mm
from nonhertz.figures.value import Bars, Contours, Line
from nonhertz.files.planfile import Plan
from nonhertz.plot.drawer import sheet_of
from nonhertz.show.sections import Table
from nonhertz.show.studies import sweep_sections
from nonhertz.study import Sampling, Sweep
from nonhertz.study.figures import axis_over, sweep_figures
from nonhertz.study.rows import Row, Work
from nonhertz.study.store import FILE, Store
from nonhertz.study.workers import LostError, Workers

ROLLER = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000), side_faces="none", depth="none")
PLATE = nh.Plate(side_faces="none", depth="none")
CASE = nh.Case(nh.Contact(ROLLER, PLATE), {"load": 20e3}, {"strips": 41})
OVER = {"load.load": "5 kN : 20 kN : 3", "body.a.profile.radius": [4e3, 8e3], "load.tilt": [0.0, 0.5e-3]}
NAMES = ("max_pressure", "approach", "error", "warnings")


def test_a_row_is_what_the_case_alone_gives():
    found = nh.sweep(CASE, over=OVER, quantities=NAMES)
    assert found.shape == (3, 2, 2)
    assert found.complete
    for index in np.ndindex(3, 2, 2):
        load, radius, tilt = (found[path][index] for path in OVER)
        assert (load, radius, tilt) == ((5e3, 12.5e3, 20e3)[index[0]], (4e3, 8e3)[index[1]], (0.0, 0.5e-3)[index[2]])
        roller = replace(ROLLER, profile=nh.profile.crown(radius=radius))
        with pytest.warns(nh.AccuracyWarning) if found["warnings"][index] else contextlib.nullcontext():
            alone = nh.solve(nh.Contact(roller, PLATE), load=load, tilt=tilt, strips=41)
        # Rows of one contact start from one another: equal to the tolerance of the equations.
        assert found["max_pressure"][index] == pytest.approx(alone.max_pressure, rel=1e-8)
        assert found["approach"][index] == pytest.approx(alone.approach, rel=1e-8)
        assert found["warnings"][index] == len(alone.warnings)
        assert found["error"][index] == pytest.approx(
            max(alone.error_estimate.approach, alone.error_estimate.load), rel=1e-3
        )


def test_no_load_is_a_row_of_zeros_and_not_a_failure():
    found = nh.sweep(
        CASE, over={"load.load": "0 : 2 N : 3", "load.tilt": [0.0, 1e-3]},
        quantities=("max_pressure", "approach", "max_half_width", "penetration", "load_by_approach"),
    )  # fmt: skip
    assert not found.failures
    for name in ("max_pressure", "max_half_width", "penetration"):
        assert (found[name][0] == 0.0).all()
    assert np.isnan(found["load_by_approach"][0]).all()
    # The circle of 4 m touches where its slope is the tilt, here nearly 4 mm from the middle.
    np.testing.assert_allclose(found["approach"][0], [0.0, -4000.0 * (np.sqrt(1.0 + 1e-6) - 1.0)], atol=1e-12)
    assert (found["approach"][1] > found["approach"][0]).all()
    assert (found["approach"][1] - found["approach"][0] < 5e-5).all()


def test_upright_rollers_have_no_moment_but_rounding():
    contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000)), PLATE)
    case = nh.Case(contact, {"load": 20e3}, {})
    found = nh.sweep(
        case, over={"load.load": [5e3, 2e4], "load.tilt": [0.0, 1e-4]}, quantities=("moment", "load_by_tilt")
    )
    assert found["moment"][:, 0].tolist() == found["load_by_tilt"][:, 0].tolist() == [0.0, 0.0]
    assert np.all(found["moment"][:, 1] > 1.0)


def test_no_load_bears_no_moment():
    case = nh.Case(nh.Contact(ROLLER, PLATE), {"load": 20e3, "moment": 100.0}, {"strips": 41})
    found = nh.sweep(case, over={"load.load": [0.0, 1e4]}, quantities=("approach",))
    assert list(found.failures) == [0]
    assert "moment" in found.failures[0]


def test_rows_that_fail_say_why_and_stop_no_others():
    loads = [20e3, 1e12]
    found = nh.sweep(CASE, over={"load.load": loads, "body.a.length": ["20 mm", "10 mm"]}, quantities=("approach",))
    assert np.isfinite(found["approach"][0]).all()
    assert np.isnan(found["approach"][1]).all()
    assert sorted(found.failures) == [2, 3]
    assert found.failed == 2
    assert sum(times for _, times, _ in found.reasons()) == 2
    assert "failed" in repr(found)


def test_of_rows_solved_together_only_the_bad_ones_fail():
    work = Work(Plan(CASE).template, {}, ("approach",))
    good, bad, alone = work.rows(["load.load", "load.tilt"], [(1e3, 0.0), (-1.0, 0.0), (1e3, 0.0)])
    assert good == alone
    assert good.failure is None
    assert bad.failure == "load.load = -1.0 must be positive: give the force in N that presses the bodies together."


def test_files_that_a_case_names_go_with_it_to_machines_that_lack_them(tmp_path):
    (tmp_path / "points.csv").write_text("-10, 0.01\n0, 0\n10, 0.01\n", encoding="utf-8")
    text = """
[body.a]
diameter = 20.0
length = 20.0
profile = [{ kind = "tabulated", file = "points.csv" }]
[body.b]
[load]
load = "5 kN"
"""
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    plan = Plan(nh.read_case(tmp_path / "case.toml"))
    work = Work(plan.template, dict(plan.case.attachments), ("approach",))
    (here,) = work.rows(["load.load"], [(6e3,)])
    (tmp_path / "points.csv").unlink()
    (there,) = work.rows(["load.load"], [(6e3,)])
    assert here.failure is None
    assert here == there


def test_rows_that_were_solved_here_can_still_be_sent_to_other_processes():
    work = Work(Plan(CASE).template, {}, ("approach", "error"))
    here = work.rows(["load.load"], [(6e3,)])
    assert pickle.loads(pickle.dumps(work)).rows(["load.load"], [(6e3,)]) == here


def test_samples_are_drawn_together(tmp_path):
    over = {"body.a.diameter": "normal(20 mm, 10 um)", "load.load": "uniform(10 kN, 20 kN)", "load.tilt": [0.0, 1e-4]}
    found = nh.sweep(CASE, over=over, samples=Sampling(8, "sobol", 1), quantities=("max_pressure",), out=tmp_path)
    assert found.shape == (2, 8)
    np.testing.assert_array_equal(found["body.a.diameter"][0], found["body.a.diameter"][1])
    assert len(set(found["load.load"][0].tolist())) == 8
    assert np.all((found["load.load"] >= 10e3) & (found["load.load"] <= 20e3))


def test_a_sweep_goes_on_where_it_was_stopped(tmp_path):
    seen = []

    def stop(progress):
        seen.append(progress.done)
        if len(seen) == 2:
            raise KeyboardInterrupt

    over = {"load.load": np.linspace(5e3, 20e3, 130)}
    with pytest.raises(nh.Interrupted, match="Stopped after 3 of 130 rows, which are kept") as caught:
        nh.sweep(CASE, over=over, quantities=("approach",), out=tmp_path, callback=stop, workers=1)
    assert isinstance(caught.value.solutions, Sweep)
    assert caught.value.solutions["approach"].shape == (3,)
    assert seen == [0, 3]
    begun = []
    whole = nh.sweep(CASE, over=over, quantities=("approach",), out=tmp_path, callback=begun.append, workers=1)
    assert (begun[0].done, begun[0].resumed) == (3, 3)
    assert begun[0].seconds > 0.0
    assert {each.seconds for each in begun[1:]} == {None}
    assert (begun[-1].done, begun[-1].total) == (130, 130)
    again = nh.sweep(CASE, over=over, quantities=("approach",))
    np.testing.assert_array_equal(whole["approach"], again["approach"])
    np.testing.assert_array_equal(whole["load.load"], np.linspace(5e3, 20e3, 130))


def test_a_portion_that_is_kept_twice_is_there_once(tmp_path):
    store = Store(tmp_path, {}, ("load.load",), ("approach",))
    for value in (1.0, 2.0):
        store.add(0, [0], [(5e3,)], [Row((value,))])
    assert store.column("approach").tolist() == [1.0]


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ({"over": {"load.load": [5e3, 7e3]}}, r"over\.load\.load was \[5000\.0, 6000\.0\], is \[5000\.0, 7000\.0\]"),
        ({"quantities": ("load",)}, "quantities was"),
        ({"plan": nh.Case(CASE.contact, {"load": 20e3}, {"strips": 31})}, r"case\.solver\.strips was 41, is 31"),
    ],
)
def test_a_plan_that_has_changed_is_refused_with_what_differs(tmp_path, change, what):
    given = {"plan": CASE, "over": {"load.load": [5e3, 6e3]}, "quantities": ("approach",), "out": tmp_path}
    nh.sweep(**given)
    with pytest.raises(nh.InputError, match=what):
        nh.sweep(**given | change)


def test_of_long_lists_no_digests_are_told(tmp_path):
    values = [5e3 + k for k in range(9)]
    nh.sweep(CASE, over={"load.load": values}, quantities=("approach",), out=tmp_path)
    with pytest.raises(nh.InputError, match=r"same plan, but over\.load\.load has other contents: choose"):
        nh.sweep(CASE, over={"load.load": [*values[:4], 5003.5, *values[5:]]}, quantities=("approach",), out=tmp_path)


@pytest.mark.slow
def test_a_directory_in_use_is_refused(tmp_path):
    tried = []

    def meanwhile(_):
        with pytest.raises(nh.InputError, match="a running study uses it") as caught:
            nh.sweep(CASE, over={"load.load": [5e3, 6e3]}, quantities=("approach",), out=tmp_path)
        tried.append(caught.value)

    nh.sweep(CASE, over={"load.load": [5e3, 6e3]}, quantities=("approach",), out=tmp_path, callback=meanwhile)
    assert tried


def test_a_full_disk_is_said_and_the_rows_before_are_kept(tmp_path, monkeypatch):
    """SQLite reports a file that may not grow as it reports a full disk."""

    def connect(*given, opened=sqlite3.connect, **options):
        rows = opened(*given, **options)
        rows.execute("pragma max_page_count = 8")
        return rows

    monkeypatch.setattr(sqlite3, "connect", connect)
    store = Store(tmp_path, {}, ("load.load",), ("approach",))
    store.add(0, range(2), [(5e3,)] * 2, [Row((1.0,))] * 2)
    with pytest.raises(nh.InputError, match=r"with space for more rows \(no space left on device\): free some space"):
        store.add(9, range(2, 2000), [(5e3,)] * 1998, [Row((1.0,))] * 1998)
    assert len(store) == 2


@pytest.mark.parametrize(
    "damage",
    [
        lambda data: data[:9000],
        lambda data: b"\xff" + data[1:],
        lambda data: data.replace(b"load.load", b"load.l\xffad"),
        lambda data: data.replace(b"TABLE rows", b"TABLE r\xffws"),
        lambda data: data.replace(b"n0 real", b"n1 real"),
        lambda data: data[:4196] + bytes(4000) + data[8196:],
    ],
    ids=["cut off", "head", "text", "schema", "column", "page"],
)
def test_a_damaged_store_is_called_so(tmp_path, damage):
    given = {"plan": CASE, "over": {"load.load": [5e3, 6e3]}, "quantities": ("approach",), "out": tmp_path}
    nh.sweep(**given)
    (tmp_path / FILE).write_bytes(damage((tmp_path / FILE).read_bytes()))
    with pytest.raises(nh.InputError, match=r"the store is damaged: .*\): delete rows\.sqlite3 to solve"):
        nh.sweep(**given)


def test_rows_are_written_to_the_last_bit(tmp_path):
    import polars

    found = nh.sweep(CASE, over={"load.load": [5e3, 1e12], "load.tilt": [0.0]}, quantities=("approach",))
    found.save(tmp_path)
    lines = (tmp_path / "rows.csv").read_text(encoding="utf-8").splitlines()
    assert lines[0] == "row,load.load [N],load.tilt [rad],approach [mm],failure"
    assert float(lines[1].split(",")[3]) == found["approach"][0, 0]
    assert lines[2].startswith("1,1000000000000.0,0.0,,")
    frame = polars.read_parquet(tmp_path / "rows.parquet")
    assert frame["approach [mm]"].to_list() == [found["approach"][0, 0], None]


def test_a_data_frame_is_indexed_by_what_was_swept():
    found = nh.sweep(CASE, over={"load.load": [5e3, 1e12], "load.tilt": [0.0]}, quantities=("approach",))
    frame = found.to_dataframe()
    assert frame.index.names == ["load.load", "load.tilt"]
    assert list(frame.columns) == ["approach", "failure"]
    assert frame.loc[(5e3, 0.0), "approach"] == found["approach"][0, 0]
    assert frame.loc[(1e12, 0.0), "failure"] == found.failures[1]
    assert frame.attrs["units"] == {"load.load": "N", "load.tilt": "rad", "approach": "mm"}
    words = nh.sweep(CASE, over={"body.a.side_faces": ["none", "free"]}, quantities=("approach",)).to_dataframe()
    assert words.index.name == "body.a.side_faces"
    assert words.index.tolist() == ["none", "free"]


def test_samples_are_numbered_in_a_data_frame_and_their_values_are_columns():
    over = {"body.a.diameter": "normal(20 mm, 5 um)", "load.load": [5e3, 8e3]}
    found = nh.sweep(CASE, over=over, samples=3, quantities=("approach",))
    frame = found.to_dataframe()
    assert frame.index.names == ["load.load", "sample"]
    assert frame.index.tolist() == [(load, number) for load in (5e3, 8e3) for number in range(3)]
    assert list(frame.columns) == ["body.a.diameter", "approach", "failure"]
    assert frame.loc[(8e3, 2), "body.a.diameter"] == found["body.a.diameter"][1, 2]
    assert frame.loc[8e3, "body.a.diameter"].tolist() == frame.loc[5e3, "body.a.diameter"].tolist()


def test_a_data_frame_of_a_sweep_that_was_stopped_has_the_rows_that_are_solved():
    def stop(progress):
        if progress.done:
            raise KeyboardInterrupt

    # Loads change fastest where rows are solved, diameters where they are numbered: the first three are 0, 2 and 4.
    over = {"load.load": [5e3, 1e12, 6e3, *range(7000, 7063)], "body.a.diameter": [20.0, 22.0]}
    with pytest.raises(nh.Interrupted) as stopped:
        nh.sweep(CASE, over=over, quantities=("approach",), workers=1, callback=stop)
    study = stopped.value.solutions
    frame = study.to_dataframe()
    assert frame.index.tolist() == [(5e3, 20.0), (1e12, 20.0), (6e3, 20.0)]
    assert frame["failure"].tolist() == ["", study.failures[2], ""]
    assert frame["approach"].notna().tolist() == [True, False, True]


def test_a_bearing_is_swept_too():
    from nonhertz.files.planfile import parse_case_or_bearing
    from nonhertz.files.starting import starting_bearing
    from nonhertz.files.toml import parse

    text = starting_bearing()
    case = parse_case_or_bearing(parse(text, "bearing"), Path("bearing.toml"), text)
    over = {"load.radial": ["5 kN", "10 kN", "22 kN"], "solver.method": ["slices"]}
    found = nh.sweep(case, over=over, quantities=("max_load", "reference_life", "max_pressure", "warnings"))
    # Beyond half of C, 20.2 kN, the life has a finding.
    assert found["warnings"].ravel().tolist() == [0, 0, 1]
    for number, radial in enumerate((5e3, 10e3, 22e3)):
        alone = nh.bearing.solve(case.mounted, **case.prescribed.keywords | {"radial": radial}, method="slices")
        assert found["max_load"][number, 0] == alone.load.max()
        assert found["reference_life"][number, 0] == case.assess(alone).reference_life
    assert found["solver.method"].ravel().tolist() == ["slices"] * 3
    assert np.isnan(found["max_pressure"]).all()


@pytest.mark.parametrize(
    ("over", "below", "lines"),
    [
        ({"load.tilt": [0.0, 2e-4], "load.load": [20e3], "body.a.diameter": [20.0]}, "Tilt [mrad]", 1),
        ({"load.load": [5e3, 20e3], "load.tilt": [0.0, 2e-4, 4e-4]}, "Tilt [mrad]", ["5 kN", "20 kN"]),
        ({"load.load": [5e3, 20e3], "body.a.side_faces": ["none", "free"]}, "Load [kN]", ["none", "free"]),
    ],
)
def test_a_picture_has_a_line_for_each_of_few_values_or_words(over, below, lines):
    found = nh.sweep(replace(CASE, solver={"strips": 11}), over=over, quantities=("load_by_approach",), workers=1)
    figure = sweep_figures(found)["sweep"]
    numbers = np.concatenate([mark.y for mark in figure.panels[0].marks if isinstance(mark, Line)])
    assert sorted(numbers) == sorted(found["load_by_approach"].ravel())
    (axes,) = sheet_of(figure).axes
    assert (axes.get_xlabel(), axes.get_ylabel()) == (below, "d load / d approach [N/µm]")
    legend = axes.get_legend()
    assert lines == ([text.get_text() for text in legend.get_texts()] if legend else len(axes.lines))


def test_samples_are_drawn_as_a_histogram_where_nothing_else_varies():
    over = {"load.load": "normal(20 kN, 1 kN)"}
    found = nh.sweep(CASE, over=over, samples=Sampling(20), quantities=("approach",), workers=1)
    (panel,) = sweep_figures(found)["sweep"].panels
    (bars,) = (mark for mark in panel.marks if isinstance(mark, Bars))
    assert bars.y.sum() == 20


def test_many_values_of_two_paths_are_a_map_with_its_numbers_as_csv():
    over = {"load.load": "5 kN : 20 kN : 8", "load.tilt": "0 : 0.4 mrad : 7"}
    found = nh.sweep(replace(CASE, solver={"strips": 11}), over=over, quantities=("max_pressure",), workers=1)
    figure = sweep_figures(found)["sweep"]
    (contours,) = figure.panels[0].marks
    assert isinstance(contours, Contours)
    np.testing.assert_array_equal(contours.values, found["max_pressure"])
    head, first, *_ = figure.to_csv().splitlines()
    assert head == "panel,line,load.load [N],load.tilt [rad],value,unit"
    assert first == f"max_pressure,max_pressure,5000.0,0.0,{found['max_pressure'][0, 0]},MPa"
    axes, bar = sheet_of(figure).axes
    assert (axes.get_xlabel(), axes.get_ylabel(), bar.get_ylabel()) == (
        "Load [kN]", "Tilt [mrad]", "Maximum pressure [MPa]"
    )  # fmt: skip
    assert axes.texts


def test_small_lengths_are_shown_in_micrometres():
    assert axis_over("drop", "mm", np.array([0.01, 0.02]))[0].title() == "Drop [µm]"
    assert axis_over("length", "mm", np.array([10.0]))[0].title() == "Length [mm]"


def test_the_last_of_three_drawings_has_the_whole_width():
    quantities = ("approach", "max_pressure", "max_half_width")
    found = nh.sweep(CASE, over={"load.load": [5e3, 20e3]}, quantities=quantities, workers=1)
    sheet = sheet_of(sweep_figures(found)["sweep"])
    sheet.draw_without_rendering()
    first, second, last = sheet.axes
    assert last.get_position().x0 == pytest.approx(first.get_position().x0, abs=0.02)
    assert last.get_position().x1 == pytest.approx(second.get_position().x1, abs=0.02)


def test_unknown_quantities_are_refused_with_the_nearest():
    with pytest.raises(nh.InputError, match="did you mean 'max_pressure'"):
        nh.sweep(CASE, over={"load.load": [5e3]}, quantities=("max_presure",))


def test_a_column_that_is_not_there_is_refused_with_the_nearest():
    swept = nh.sweep(CASE, over={"load.load": [1e4]}, quantities=("max_pressure",), workers=1)
    with pytest.raises(KeyError, match=r"Unknown column max_presure\. Did you mean max_pressure\?"):
        swept["max_presure"]


def test_nothing_varied_is_refused():
    with pytest.raises(nh.InputError, match="must vary something"):
        nh.sweep(CASE)
    with pytest.raises(nh.InputError, match="10000000 rows at most"):
        nh.sweep(CASE, over={"load.load": "1 kN : 2 kN : 9000", "load.tilt": np.linspace(0.0, 1e-3, 9000)})


def _length(number):
    return f"{mm(25.4 * number):g}"


def _ends_at_three(number):
    if number == 3:
        os._exit(9)
    return number**2


@pytest.mark.slow
def test_processes_find_all_in_any_order_and_say_it_in_the_units_that_are_read():
    with display_units("us"):
        assert sorted(Workers().portions(_length, range(20), 2)) == [(number, f"{number} in") for number in range(20)]


@pytest.mark.slow
def test_what_ends_its_process_is_given_up_and_nothing_else_is_lost():
    found = dict(Workers().portions(_ends_at_three, range(8), 2))
    assert isinstance(found.pop(3), LostError)
    assert found == {number: number**2 for number in (0, 1, 2, 4, 5, 6, 7)}


@pytest.mark.slow
def test_a_script_needs_no_guard_against_processes_that_start(tmp_path):
    script = tmp_path / "script.py"
    script.write_text(
        "import nonhertz as nh\n"
        "roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000))\n"
        "case = nh.Case(nh.Contact(roller, nh.Plate()), {'load': 20e3}, {'strips': 21})\n"
        "found = nh.sweep(case, over={'load.load': '1 kN : 20 kN : 300'}, quantities=('approach',), workers=2)\n"
        "print(found.complete, found.failed)\n",
        encoding="utf-8",
    )
    ended = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=120, check=True)
    assert ended.stdout == "True 0\n"
    assert ended.stderr == ""


def test_few_rows_are_listed_and_many_between_their_extremes():
    found = nh.sweep(CASE, over={"load.load": [5e3, 2e4, 1e4]}, quantities=("load", "approach", "max_pressure"))
    (table,) = (block for block in sweep_sections(found)[-1].blocks if isinstance(block, Table))
    assert table.heads == ("row", "0", "1", "2", "")
    assert table.rows[0] == ("load.load", "5", "20", "10", "kN")
    assert [row[0] for row in table.rows[1:]] == ["approach", "maximum pressure"]
    listed = [float(text) for text in table.rows[2][1:-1]]
    np.testing.assert_allclose(listed, found["max_pressure"], rtol=1e-4)
    many = nh.sweep(CASE, over={"load.load": "5 kN : 20 kN : 13"}, quantities=("approach",))
    (table,) = (block for block in sweep_sections(many)[-1].blocks if isinstance(block, Table))
    assert table.heads == ("", "smallest", "largest", "")


def test_a_row_that_fails_is_listed_blank(tmp_path):
    over = {"load.load": [5e3, 6e3], "body.a.material": ["steel", "aluminium"]}
    found = nh.sweep(CASE, over=over, quantities=("approach",), out=tmp_path)
    with contextlib.closing(sqlite3.connect(tmp_path / FILE)) as rows, rows:
        rows.execute("update rows set n0 = null, failure = 'No.' where number = 2")
    (table,) = (block for block in sweep_sections(found)[-1].blocks if isinstance(block, Table))
    assert table.rows[1] == ("body.a.material", "steel", "aluminium", "steel", "aluminium", "")
    assert [bool(cell) for cell in table.rows[2]] == [True, True, True, False, True, True]
