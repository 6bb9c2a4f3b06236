"""Pressures and forces at the nodes of a finite element mesh, from Python and from the command line."""

import csv
import io
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings
from nonhertz.files.nodes import read_nodes
from nonhertz.files.schemas import schema_of

EXAMPLES = Path(__file__).parents[2] / "examples"
CASE = str(EXAMPLES / "roller-15x20.toml")
LOAD = 15000.0


@pytest.fixture(scope="module")
def solution():
    case = nh.read_case(CASE, {"load.tilt": "0.3 mrad"})
    with without_accuracy_warnings():
        return case.solve()


def grid(across: int, along: int, half: float = 0.6, length: float = 10.0) -> tuple[np.ndarray, np.ndarray]:
    x, y = np.meshgrid(np.linspace(-half, half, across), np.linspace(-length, length, along))
    return x.ravel(), y.ravel()


@pytest.mark.parametrize("size", [(7, 9), (25, 40), (80, 120)])
def test_forces_have_load_and_moments_of_the_contact_on_any_mesh(solution, size):
    x, y = grid(*size)
    found = solution.at_nodes(x, y)
    assert found.outside == 0.0
    assert found.force.sum() == pytest.approx(solution.load, rel=1e-9)
    assert found.force @ y == pytest.approx(solution.moment, rel=1e-6)
    assert abs(found.force @ x) < 1e-9 * solution.load
    assert np.all(found.force >= -1e-9)
    np.testing.assert_array_equal(found.pressure, solution.pressure(x, y))
    assert found.area.sum() == pytest.approx(1.2 * 20.0, rel=1e-9)


@pytest.mark.slow
def test_the_interpolated_load_tends_to_the_load_as_the_mesh_is_refined(solution):
    errors = [abs(solution.at_nodes(*grid(n, 2 * n)).interpolated_load / solution.load - 1.0) for n in (10, 40, 160)]
    assert errors[0] > 0.01
    # What the pressure between strips adds or takes: see Solution.pressure.
    assert errors[1] < 2e-3
    assert errors[2] < 2e-3


def test_force_over_area_is_the_pressure_where_the_mesh_is_fine(solution):
    x, y = grid(161, 161)
    found = solution.at_nodes(x, y)
    inside = (found.pressure > 0.5 * solution.max_pressure) & (np.abs(y) < 7.0)
    assert np.count_nonzero(inside) > 1000
    ratio = found.force[inside] / found.area[inside] / found.pressure[inside]
    # Triangles of Delaunay cut the squares of such a mesh along either diagonal.
    assert abs(np.mean(ratio) - 1.0) < 0.005
    assert np.std(ratio) < 0.02
    assert np.max(np.abs(ratio - 1.0)) < 0.1


def test_load_outside_of_the_nodes_is_counted(solution):
    x, y = grid(30, 30)
    half = solution.at_nodes(x[y >= 0.0], y[y >= 0.0])
    assert half.outside > 0.2 * solution.load
    assert half.force.sum() + half.outside == pytest.approx(solution.load, rel=1e-9)


def test_nodes_on_a_line_have_pressures_and_no_forces(solution):
    found = solution.at_nodes(np.zeros(21), np.linspace(-10.0, 10.0, 21))
    assert np.all(np.isnan(found.force))
    assert found.pressure.max() > 1000.0
    assert found.outside == pytest.approx(solution.load, rel=1e-9)


def written(name: str, text: str) -> Path:
    Path(name).write_text(text, encoding="utf-8")
    return Path(name)


@pytest.mark.parametrize(
    "text",
    [
        "x [mm], y [mm], z [mm]\n0.1, -2.5, 7\n0, 3, 8\n",
        "node; X [um]; Y (cm)\n7; 100; -0,25\n9; 0,0; 0,3\n",
        "x\ty\n0.1\t-2.5\n\n0\t3\n",
        "id x [m] y [mm]\n1 1e-4 -2.5\n2 0 3\n",
        "y,x\n-2.5,0.1\n3,0\n",
    ],
)
@pytest.mark.usefixtures("folder")
def test_heads_say_which_column_is_what_in_which_unit(text):
    found = read_nodes(written("nodes.csv", text))
    np.testing.assert_allclose(found.x, [0.1, 0.0], rtol=1e-15)
    np.testing.assert_allclose(found.y, [-2.5, 3.0], rtol=1e-15)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("1, 2\n3, 4\n", "must have one column x in its head"),
        ("x, x, y\n1, 2, 3\n", "must have one column x"),
        ("x [kg], y\n1, 2\n", "unit of length"),
        ("x, y\n1, 2, 3\n", "as many columns in line 2"),
        ("x, y\n1, here\n", "number as y in line 2, not 'here'"),
        ("x, y\n", "must hold nodes below its head"),
        ("", "must hold nodes"),
    ],
)
@pytest.mark.usefixtures("folder")
def test_what_is_wrong_with_a_file_of_nodes_is_said(text, expected, run):
    assert expected in run("nodes", CASE, str(written("nodes.csv", text)), code=2).err
    assert not Path("nodes-pressure.csv").exists()


@pytest.mark.usefixtures("folder")
def test_the_command_writes_a_table_and_says_what_the_sums_are(run):
    x, y = grid(25, 41)
    lines = [f"{k}; {1e3 * a!r}; {b!r}; 0" for k, (a, b) in enumerate(zip(x.tolist(), y.tolist(), strict=True))]
    written("surface.csv", "\n".join(["node; x [um]; y [mm]; z", *lines]))
    printed = run("nodes", CASE, "surface.csv").out
    assert "The forces add up to 15.000 kN of the load of 15.000 kN." in printed
    assert "outside" not in printed
    assert "interpolated linearly between the nodes, integrate to" in printed
    table = list(csv.DictReader(io.StringIO(Path("surface-pressure.csv").read_text(encoding="utf-8"))))
    assert [row["node"] for row in table] == [str(k) for k in range(len(x))]
    solution = nh.read_case(CASE).solve()
    np.testing.assert_allclose([float(row["pressure [MPa]"]) for row in table], solution.pressure(x, y), rtol=1e-9)
    assert sum(float(row["force [N]"]) for row in table) == pytest.approx(LOAD, rel=1e-9)
    found = run("nodes", CASE, "surface.csv", "--set", "load.load=6kN", "--out", "other.csv", "--json").json
    jsonschema.validate(found, schema_of("nodes"))
    assert found["force_sum"] == pytest.approx(6000.0, rel=1e-9)
    assert len(found["pressure"]) == x.size
    assert Path("other.csv").exists()


@pytest.mark.usefixtures("folder")
def test_the_file_of_the_nodes_is_not_overwritten(run):
    written("nodes.csv", "x, y\n0, 0\n")
    assert "other than that of the nodes" in run("nodes", CASE, "nodes.csv", "--out", "nodes.csv", code=2).err
    assert Path("nodes.csv").read_text(encoding="utf-8") == "x, y\n0, 0\n"
