"""VTK files, read back by meshio: coordinates, numbers and the area of the cells."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import meshio
import numpy as np
import pytest

import nonhertz as nh
from nonhertz import subsurface
from nonhertz.cli import main
from nonhertz.io.vtk import write_field, write_surface

EXAMPLES = Path(__file__).parents[2] / "examples"
CASE = str(EXAMPLES / "roller-15x20.toml")


@pytest.fixture(scope="module")
def solution() -> nh.Solution:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        return nh.read_case(CASE).solve()


def areas(mesh: Any) -> np.ndarray:
    """Return the signed areas of quadrilaterals by their diagonals, twice along the normal of z."""
    a, b, c, d = (mesh.points[mesh.cells_dict["quad"][:, k]] for k in range(4))
    return 0.5 * np.linalg.norm(np.cross(c - a, d - b), axis=1)


def volumes(mesh: Any) -> np.ndarray:
    """Return the signed volumes of boxes: positive if the corners are in the order of VTK."""
    corners = mesh.points[mesh.cells_dict["hexahedron"]]
    sides = (corners[:, k] - corners[:, 0] for k in (1, 3, 4))
    first, second, third = sides
    return np.einsum("ni,ni->n", np.cross(first, second), third)


def test_the_surface_holds_the_pressure_and_all_of_the_load(solution: nh.Solution, tmp_path: Path) -> None:
    path = write_surface(tmp_path / "surface.vtu", solution)
    mesh = meshio.read(path)
    x, y, z = mesh.points.T
    assert np.all(z == 0.0)
    assert set(np.round(y, 9)) == set(np.round(solution.y, 9))
    pressure = mesh.point_data["pressure [MPa]"]
    np.testing.assert_array_equal(pressure, solution.pressure(x, y))
    assert pressure.max() == pytest.approx(solution.max_pressure, rel=1e-9)
    middle = x == 0.0
    np.testing.assert_array_equal(mesh.point_data["half_width [mm]"][middle], solution.half_width)
    np.testing.assert_array_equal(mesh.point_data["gap_on_centre_line [mm]"][middle], solution.gap)
    cells = mesh.cells_dict["quad"]
    carried = float(np.mean(pressure[cells], axis=1) @ areas(mesh))
    assert carried == pytest.approx(solution.load, rel=5e-3)
    assert np.sum(areas(mesh)) == pytest.approx(np.ptp(x) * np.ptp(y), rel=1e-9)


def test_planes_and_volumes_of_stress(solution: nh.Solution, tmp_path: Path) -> None:
    b = solution.max_half_width
    section = subsurface.cross_section(solution, 0.0, b * np.linspace(-2, 2, 9), b * np.linspace(0.1, 2, 5))
    mesh = meshio.read(write_field(tmp_path / "section.vtu", section))
    assert mesh.cells_dict["quad"].shape == (8 * 4, 4)
    np.testing.assert_array_equal(
        mesh.points, np.column_stack([section.x.ravel(), section.y.ravel(), section.z.ravel()])
    )
    for name in ("sigma_x", "tau_xz", "von_mises", "max_shear"):
        np.testing.assert_array_equal(mesh.point_data[f"{name} [MPa]"], getattr(section, name).ravel())
    assert np.sum(areas(mesh)) == pytest.approx(4 * b * 1.9 * b, rel=1e-9)
    box = subsurface.volume(solution, b * np.linspace(-1, 1, 4), [0.0, 1.0, 2.0], b * np.linspace(0.2, 1, 5))
    mesh = meshio.read(write_field(str(tmp_path / "new" / "box.vtu"), box))
    assert mesh.cells_dict["hexahedron"].shape == (3 * 2 * 4, 8)
    assert np.sum(volumes(mesh)) == pytest.approx(2 * b * 2.0 * 0.8 * b, rel=1e-9)
    assert np.all(volumes(mesh) > 0.0)
    np.testing.assert_array_equal(mesh.point_data["sigma_z [MPa]"], box.sigma_z.ravel())


def test_what_is_no_surface_or_field_is_refused(solution: nh.Solution, tmp_path: Path) -> None:
    for call, words in (
        (lambda: write_surface(tmp_path / "a.vtk", solution), "must end in .vtu"),
        (lambda: write_surface(3, solution), "must be the name of a file"),
        (lambda: write_surface(tmp_path / "a.vtu", "solution"), "must be a Solution"),
        (lambda: write_field(tmp_path / "a.vtu", solution), "must be a Field"),
        (lambda: write_field(tmp_path / "a.vtu", subsurface.stress(solution, 0.0, 0.0, [0.1, 0.2])), "two or three"),
    ):
        with pytest.raises(nh.InputError, match=words):
            call()
    assert not list(tmp_path.iterdir())


@pytest.mark.slow
def test_the_command_writes_them_beside_its_tables(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["stress", CASE, "--vtk"]) == 2
    assert "--vtk" in capsys.readouterr().err
    assert main(["stress", CASE, "--out", "found", "--vtk"]) == 0
    assert {path.stem for path in Path("found").glob("*.vtu")} == {"surface", "axial-plane", "cross-section"}
    table = np.genfromtxt("found/cross-section.csv", delimiter=",", names=True, deletechars="")
    mesh = meshio.read("found/cross-section.vtu")
    np.testing.assert_allclose(mesh.point_data["von_mises [MPa]"], table["von_mises_[MPa]"], rtol=1e-6)
