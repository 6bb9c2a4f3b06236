"""Solutions as tables: of one contact along y, of many as pandas and xarray have them."""

import importlib

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.result.quantities import QUANTITIES

CROWNED = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(1000)), nh.Plate())


@pytest.fixture(scope="module")
def sweep():
    return nh.solve_many(CROWNED, load=[2e3, 3e3, 5e3], tilt=1e-4, strips=61)


@pytest.fixture(scope="module")
def chart():
    return nh.solve_many(CROWNED, load=np.array([2e3, 3e3])[:, None], tilt=[0.0, 1e-4, 2e-4], strips=61)


@pytest.mark.parametrize("name", QUANTITIES)
def test_a_column_is_what_the_solutions_say(chart, name):
    column = chart.column(name)
    assert column.shape == (2, 3)
    for at in np.ndindex(2, 3):
        assert column[at] == pytest.approx(QUANTITIES[name].get(chart[at]), rel=1e-12, abs=1e-9)


def test_no_other_column_is_known(sweep):
    with pytest.raises(nh.InputError, match="name = 'aproach' must be one of approach, penetration, tilt"):
        sweep.column("aproach")


def test_a_row_a_case_is_indexed_by_what_varies(sweep):
    frame = sweep.to_dataframe()
    assert frame.index.name == "load"
    assert list(frame.columns) == [*(name for name in QUANTITIES if name != "load"), "singular", "converged"]
    np.testing.assert_array_equal(frame["max_pressure"], sweep.max_pressure)
    assert frame.attrs["units"]["approach"] == "mm"
    assert frame.index[-1] == 5e3


def test_a_map_has_a_level_and_a_dimension_an_axis(chart):
    frame, found = chart.to_dataframe(), chart.to_xarray()
    assert frame.index.names == ["load", "tilt"]
    assert frame.loc[(3e3, 2e-4), "moment"] == chart.moment[1, 2]
    assert dict(found.sizes) == {"load": 2, "tilt": 3}
    assert float(found["moment"].sel(load=3e3, tilt=2e-4)) == chart.moment[1, 2]
    assert found["approach"].attrs == {"units": "mm", "long_name": "approach"}
    assert found["load"].attrs["units"] == "N"
    assert frame.reset_index()["tilt"].tolist() == [0.0, 1e-4, 2e-4] * 2


def test_axes_along_which_no_input_varies_alone_are_numbered():
    load, tilt = np.linspace(2e3, 3e3, 3), np.linspace(0.0, 1e-4, 3)
    assert nh.solve_many(CROWNED, load=load, tilt=tilt, strips=41).to_dataframe().index.name == "case"
    grid = nh.solve_many(CROWNED, load=load + np.array([[0.0], [1.0]]), tilt=tilt[:2, None], strips=41)
    assert list(grid.to_xarray().sizes) == ["case_0", "case_1"]
    other = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=3000)), nh.Plate())
    assert nh.solve_many([CROWNED, other], load=5e3, strips=41).to_dataframe().index.name == "contact"


def test_cases_without_a_solution_have_no_numbers():
    many = nh.solve_many(CROWNED, approach=[0.01, -0.5], strips=81)
    frame = many.to_dataframe()
    assert frame["converged"].tolist() == [True, False]
    assert np.isnan(frame["contact_length"].iloc[1])


@pytest.mark.parametrize(("library", "verb"), [("pandas", "to_dataframe"), ("xarray", "to_xarray")])
def test_a_library_that_is_missing_is_named(sweep, monkeypatch, library, verb):
    def missing(name, *_):
        raise ImportError(name)

    monkeypatch.setattr(importlib, "import_module", missing)
    with pytest.raises(ImportError, match=f"{verb} needs {library}: install it, or nonhertz with the extra 'data'"):
        getattr(sweep, verb)()


# Pressure anywhere


SHAPES = {
    "runs out": (nh.profile.crown(1000), {"load": 3e3, "tilt": 2e-4}),
    "sharp ends": (nh.profile.straight(), {"load": 20e3}),
    "two intervals": (nh.profile.crown(-40000), {"load": 200.0}),
}


@pytest.fixture(params=SHAPES)
def solution(request):
    profile, given = SHAPES[request.param]
    return nh.solve(nh.Contact(nh.Roller(diameter=20, length=20, profile=profile), nh.Ring(diameter=80)), **given)


def test_the_pressure_over_the_surface_is_the_load(solution):
    x = solution.half_width.max() * np.sin(np.linspace(-0.5 * np.pi, 0.5 * np.pi, 401))
    y = np.unique(np.concatenate([solution.edges, solution.y, np.ravel(solution.contact_y)]))
    y = np.interp(np.arange(10 * y.size - 9) / 10.0, np.arange(y.size), y)
    total = np.trapezoid(np.trapezoid(solution.pressure(x[:, None], y), x, axis=0), y)
    assert total == pytest.approx(solution.load, rel=3e-3)


def test_off_contact_there_is_no_pressure(solution):
    (low, _), (_, high) = solution.contact_y[0], solution.contact_y[-1]
    assert solution.pressure(0.0, [low - 0.1, high + 0.1]).tolist() == [0.0, 0.0]
    assert solution.pressure(1.01 * solution.half_width.max(), solution.y).max() == 0.0
    if len(solution.contact_y) == 2:
        assert solution.pressure(0.0, 0.0) == 0.0


def test_the_pressure_falls_to_where_the_contact_runs_out():
    profile, given = SHAPES["runs out"]
    found = nh.solve(nh.Contact(nh.Roller(diameter=20, length=20, profile=profile), nh.Plate()), **given)
    end = found.contact_y[-1][1]
    last = found.y[found.line_load > 0.0][-1]
    y = np.linspace(last, end, 11)
    falling = found.pressure(0.0, y)
    assert np.all(np.diff(falling) < 0.0)
    assert falling[-1] == 0.0
