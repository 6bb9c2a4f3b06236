"""What notebooks show of results: tables with the names and numbers of the terminal."""

import importlib
import inspect
import subprocess
import sys
from xml.etree import ElementTree

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.bearing.fits import Range
from nonhertz.cli import main
from nonhertz.result.brief import HasHtml
from nonhertz.show import notebook
from nonhertz.study import Front

EXTRAS = ("cyclopts", "pint", "rich", "matplotlib", "jinja2", "markupsafe", "tomli_w", "x3pio", "pandas", "polars")
CONTACT = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(2000)), nh.Ring(diameter=80))
HOSTILE = "</strong><script>alert(\"1\")</script> & 'roller'"


def shown(result):
    """Return the element of a result; raises if what notebooks are shown is not well-formed."""
    return ElementTree.fromstring(result._repr_html_())


def rows_of(element):
    """Return the cells of all rows, without the blank ones."""
    cells = (["".join(cell.itertext()) for cell in row] for row in element.iter("tr"))
    return [[text for text in row if text] for row in cells]


def row_named(result, name):
    (row,) = (row[1:] for row in rows_of(shown(result)) if row[0] == name)
    return row


def paragraphs(element):
    return ["".join(paragraph.itertext()) for paragraph in element.iter("p")]


def assert_in_lines(rows, lines):
    """Every row is one line of a terminal: the same words in the same order."""
    words = [line.split() for line in lines]
    missing = [row for row in rows if " ".join(row).split() not in words]
    assert not missing


@pytest.fixture(scope="module")
def solved():
    return nh.solve(CONTACT, load=5e3, tilt=0.2e-3)


@pytest.fixture(scope="module")
def bearing():
    return nh.new_bearing()


@pytest.mark.parametrize("command", ["solve", "bearing"])
def test_a_result_has_the_rows_of_the_terminal(command, tmp_path, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "400")
    case = nh.new_case() if command == "solve" else nh.new_bearing()
    case.write(tmp_path / "case.toml")
    main([command, str(tmp_path / "case.toml")])
    case = (nh.read_case if command == "solve" else nh.read_bearing)(tmp_path / "case.toml")
    element = shown(nh.Result(case, case.solve()))
    rows = rows_of(element)
    assert len(rows) > 15
    assert_in_lines(rows, capsys.readouterr().out.splitlines())
    assert "".join(element[0].itertext()) == f"Result {case.title}"


def test_a_sweep_has_the_rows_of_the_terminal(tmp_path, capsys):
    case = nh.new_case(changes={"solver.strips": 21})
    case.write(tmp_path / "case.toml")
    main(["sweep", str(tmp_path / "case.toml"), "--over", "load.load=5 kN : 20 kN : 4", "--out", str(tmp_path / "out")])
    rows = rows_of(shown(nh.sweep(case, over={"load.load": "5 kN : 20 kN : 4"})))
    assert ["row", "0", "1", "2", "3"] in rows
    assert_in_lines(rows, capsys.readouterr().out.splitlines())


def test_the_pressure_of_a_contact_is_drawn_above_its_rows(solved):
    element = shown(solved)
    assert [child.tag for child in element] == ["div", "svg", "table"]
    points = element.find("svg/polyline").get("points").split()
    assert len(points) == solved.strips
    heights = [float(point.partition(",")[2]) for point in points]
    assert heights[int(solved.centre_pressure.argmax())] == min(heights) < 20.0
    assert heights[0] == max(heights)
    assert row_named(solved, "load") == ["5.0000 kN"]
    assert row_named(solved, "approach")[0] == f"{1e3 * solved.approach:.3f} µm"


def test_a_plane_grid_has_the_rows_of_strips_but_stiffness(solved):
    patch = nh.patch.solve(CONTACT, load=5e3, tilt=0.2e-3, cells=(32, 64))
    names = [row[0] for row in rows_of(shown(patch)) if not row[0].startswith("at y")]
    of_strips = [row[0] for row in rows_of(shown(solved))]
    assert {"maximum pressure", "contact along y", "load", "approach"} <= {*names}
    assert {*names} - {*of_strips} == {"plane grid", "convolutions"}
    assert not any(name.startswith("d load") for name in names)
    assert row_named(patch, "plane grid") == ["32 x 64 cells"]


def test_few_solutions_are_listed_and_many_by_their_extremes():
    few = nh.solve_many(CONTACT, approach=[5e-3, -1.0, 6e-3], strips=61)
    element = shown(few)
    assert paragraphs(element)[0] == "2 of 3 cases converged"
    assert paragraphs(element)[1].startswith("Case 1: approach = -1.0")
    assert row_named(few, "approach") == ["5.0000", "6.0000", "µm"]
    assert not any(row[0] == "tilt" for row in rows_of(element))
    many = nh.solve_many(CONTACT, load=np.linspace(1e3, 9e3, 17), strips=61)
    assert row_named(many, "load") == ["1.0000", "9.0000", "kN"]


def test_states_of_a_bearing_are_listed(bearing):
    many = nh.bearing.solve_many(bearing.bearing, radial=[1e3, 2e3], method="slices")
    assert row_named(many, "force y") == ["1.0000", "2.0000", "kN"]
    assert row_named(many, "largest load of a contact")[-1] == "N"
    frame = many.to_dataframe()
    written = [float(text) for text in row_named(many, "displacement y")[:2]]
    np.testing.assert_allclose(written, 1e3 * frame["displacement_y"], rtol=1e-4)


def test_a_bearing_and_its_life_are_shown_without_a_case(bearing):
    solution = bearing.solve("slices")
    assert row_named(solution, "rollers") == ["13, 9 x 10 mm", "pitch circle 46.5 mm"]
    life = bearing.assess(solution)
    assert row_named(life, "static safety") == [f"S0 = {life.static_safety:.2f}"]
    assert row_named(bearing.kinematics, "cage")[0] == f"{bearing.kinematics.cage_speed:.1f} 1/min"


def test_a_bearing_by_classes_has_its_clearances_and_ratings():
    case = nh.new_bearing(changes={"bearing.clearance": "CN", "bearing.bore": 30, "solver.method": "slices"})
    tolerances = case.tolerances(case.solve(), None)
    least, likely, greatest = (1e3 * tolerances.clearance.operating.at(which) for which in Range.AT)
    expected = [f"{least:.2f}", f"{likely:.2f}", f"{greatest:.2f}"]
    assert row_named(tolerances, "radial clearance in operation [µm]")[:3] == expected
    rating = nh.bearing.rating(case.bearing)
    assert (
        row_named(rating, "load ratings")[0] == f"C = {rating.dynamic / 1e3:.2f} kN, C0 = {rating.static / 1e3:.2f} kN"
    )


def test_strength_has_a_row_for_each_check(solved):
    strength = nh.strength.assess(solved)
    rows = rows_of(shown(strength))
    assert [[check.name, str(check.verdict), check.sentence] for check in strength.checks] == rows[
        : len(strength.checks)
    ]
    named = {row[0].strip(): row[1:] for row in rows_of(shown(strength.largest))}
    assert named["maximum shear"][0] == f"{strength.largest.shear.max:.2f}"


def test_a_front_has_a_row_for_each_point():
    path = "body.a.profile.radius"
    front = Front(({path: 4e3}, {path: 5e3}), (2100.0, 2000.0), (2200.0, 2300.0), (), (), {path: "mm"})
    head, *rows = rows_of(shown(front))
    assert head[1:] == ["maximum pressure under the first loads [MPa]", "maximum pressure under the second loads [MPa]",
                        f"{path} [mm]"]  # fmt: skip
    assert rows == [["1", "2100.0", "2200.0", "4000.0"], ["2", "2000.0", "2300.0", "5000.0"]]


def test_titles_are_text_and_not_markup():
    case = nh.new_case(changes={"title": HOSTILE, "solver.strips": 21})
    for result in (nh.Result(case, case.solve()), nh.sweep(case, over={"load.load": [5e3, 6e3]})):
        element = shown(result)
        assert "".join(element[0].itertext()) == f"{type(result).__name__} {HOSTILE}"
        assert element.find(".//script") is None


def test_long_tables_end_with_how_many_rows_more_there_are(solved, monkeypatch):
    rows = rows_of(shown(solved))
    monkeypatch.setattr(notebook, "MOST_ROWS", 5)
    element = shown(solved)
    assert rows_of(element) == rows[:5]
    assert paragraphs(element)[0] == f"and {len(rows) - 5} more rows"


def test_of_many_warnings_some_are_shown(monkeypatch):
    with pytest.warns(nh.AccuracyWarning):
        sharp = nh.solve(nh.Contact(nh.Roller(diameter=20, length=20), nh.Plate()), load=5e3, strips=21)
    monkeypatch.setattr(notebook, "MOST_WARNINGS", 1)
    assert len(sharp.warnings) > 1
    assert paragraphs(shown(sharp)) == [f"warning: {sharp.warnings[0]}", f"and {len(sharp.warnings) - 1} more warnings"]


def test_every_public_result_has_its_layout():
    modules = [nh, *(importlib.import_module(name) for name in nh._MODULES.values())]
    public = [getattr(module, name) for module in modules for name in dir(module)]
    results = {value.__name__ for value in public if inspect.isclass(value) and issubclass(value, HasHtml)}
    assert results == {*notebook.LAYOUTS}
    for layout in notebook.LAYOUTS.values():
        module, _, function = layout.partition(".")
        assert callable(getattr(importlib.import_module(f"nonhertz.show.{module}"), function))


def test_tables_need_no_more_than_solving_does():
    program = f"""
import sys
for name in {EXTRAS!r}:
    sys.modules[name] = None
import nonhertz as nh
roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000))
solution = nh.solve(nh.Contact(roller, nh.Plate()), load=5e3)
assert "<table>" in solution._repr_html_()
assert "nonhertz.bearing" not in sys.modules
rings = {{"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}}
bearing = nh.bearing.CylindricalRollerBearing(roller=nh.Roller(diameter=9, length=10), **rings, rollers=13)
assert "<table>" in nh.bearing.solve(bearing, radial=5e3, method="slices")._repr_html_()
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
