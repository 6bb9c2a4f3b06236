"""Maps: errors as sampled, exact derivatives, nothing out of contact, files, callers in C."""

import ctypes
import math
import pickle
import zipfile
from collections.abc import Iterator

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

import nonhertz as nh
from nonhertz.errors import AccuracyWarning, InputError
from nonhertz.maps import AT_APPROACH, AT_LOAD, MAXIMA, STRIP_LOADS, ContactMap, State
from nonhertz.maps.build import Building
from nonhertz.maps.spline import jumps, knot_count, polynomials_in_cells, rows
from nonhertz.maps.spread import spread
from nonhertz.maps.touch import Relief
from nonhertz.native import core

MOST, TILT, ACCURACY = 10e3, 1e-3, 2e-3
ROLLER = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000))
CONTACT = nh.Contact(ROLLER, nh.Plate())


@pytest.fixture(scope="module")
def made():
    """A rough map of a crowned roller: small enough to be made in the tests."""
    return nh.contact_map(CONTACT, load=(0.0, MOST), tilt=(-TILT, TILT), accuracy=ACCURACY, checks=40)


@pytest.fixture
def points(made):
    """Approaches and tilts of states in contact, well inside the range."""
    random = np.random.default_rng(7)
    load, tilt = MOST * random.uniform(0.02, 0.98, 30), TILT * random.uniform(-0.98, 0.98, 30)
    return made.under(load=load, tilt=tilt).approach, tilt


@pytest.mark.slow
def test_the_sampled_errors_are_those_of_points_that_the_map_has_not_seen(made):
    random = np.random.default_rng(11)
    load, tilt = MOST * random.uniform(0.001, 1.0, 40), TILT * random.uniform(-1.0, 1.0, 40)
    solved = nh.solve_many(CONTACT, load=load, tilt=tilt)
    found = made.at(approach=solved.approach, tilt=tilt)
    light, half = np.maximum(load, 0.01 * MOST), made.half_length
    sampled = made.sampled_error
    assert sampled.load <= ACCURACY
    assert sampled.moment <= ACCURACY
    assert np.all(np.abs(found.load - load) <= sampled.load * light)
    assert np.all(np.abs(found.moment - solved.moment) <= sampled.moment * light * half)
    stiffness, largest = solved.stiffness[:, 0, 0] * np.cbrt(light / load), 0.0
    for row, column in ((0, 0), (0, 1), (1, 1)):
        error = np.abs(found.stiffness[:, row, column] - solved.stiffness[:, row, column])
        largest = max(largest, np.max(error / (stiffness * half ** (row + column))))
    assert sampled.stiffness / 3.0 <= largest <= sampled.stiffness
    least = np.cbrt(0.01)
    for name, largest in (("max_pressure", sampled.max_pressure), ("max_half_width", sampled.max_half_width)):
        values = getattr(solved, name)
        error = np.abs(getattr(found, name) - values)
        assert np.all(error <= largest * np.maximum(values, least * values.max())), name
        assert np.any(3.0 * error >= largest * np.maximum(values, least * values.max())), name  # nor far below


def test_strip_loads_are_those_of_the_solver_and_sum_to_the_load(made):
    solution = nh.solve(CONTACT, load=6e3, tilt=5e-4)
    found = made.strip_loads(made.under(load=6e3, tilt=5e-4))
    # Strip by strip from the solver's own, cut at the stations.
    summed = np.concatenate([[0.0], np.cumsum(solution.line_load * solution.strip_width)])
    ours = np.diff(np.interp(made.stations, solution.edges, summed))
    assert_allclose(found, ours, atol=(made.sampled_error.strip_loads + 2e-3) * 6e3)
    assert_allclose(found.sum(), 6e3, rtol=1e-12)
    assert np.all(found >= 0.0)


def test_the_stiffness_is_the_derivative_of_load_and_moment(made, points):
    approach, tilt = points
    step = 1e-6, 1e-8
    at = made.at(approach=approach, tilt=tilt)
    for column, (by, turn) in enumerate(((step[0], 0.0), (0.0, step[1]))):
        high = made.at(approach=approach + by, tilt=tilt + turn)
        low = made.at(approach=approach - by, tilt=tilt - turn)
        # Central differences: their error is the third derivative times the step squared, below 1e-7 here.
        for row, name in enumerate(("load", "moment")):
            slope = (getattr(high, name) - getattr(low, name)) / (2.0 * (by + turn))
            scale = np.abs(at.stiffness[:, row, column]).max()
            assert_allclose(at.stiffness[:, row, column], slope, rtol=1e-7, atol=1e-7 * scale)
    assert_array_equal(at.stiffness[:, 0, 1], at.stiffness[:, 1, 0])


def test_load_and_stiffness_are_continuous_across_cells(made):
    """Between neighbouring points the stiffness changes by no more than a smooth function's would."""
    approach = np.linspace(1e-3, 0.9 * made.under(load=MOST).approach, 4001)
    stiffness = made.at(approach=approach, tilt=3e-4).stiffness
    changes = np.abs(np.diff(stiffness[:, 0, 0]))
    assert changes.max() < 5.0 * np.median(changes)


def test_out_of_contact_everything_is_exactly_zero(made):
    first = made.under(load=0.0, tilt=4e-4)
    for approach in (first.approach, first.approach - 1e-6, -1.0):
        found = made.at(approach=approach, tilt=4e-4)
        values = [found.load, found.moment, found.max_pressure, found.max_half_width, *found.stiffness.ravel()]
        assert values == [0.0] * 8
        assert_array_equal(made.strip_loads(found), 0.0)


def test_first_touch_is_where_the_profiles_say(made):
    """For a circular crown at a tilt the bodies first touch at y = R sin(gamma), closer by R (1 - cos(gamma))."""
    for tilt in (-8e-4, 0.0, 3e-4):
        first = 4000.0 * (1.0 - 1.0 / math.cos(math.atan(tilt)))
        assert_allclose(made.under(load=0.0, tilt=tilt).approach, first, atol=2e-6)


def test_a_contact_at_one_end_only_bears_its_load_there(made):
    found = made.under(load=50.0, tilt=TILT)
    strips = made.strip_loads(found)
    assert_allclose(found.moment / found.load, 4.0, atol=0.2)  # y = R gamma
    assert strips[: strips.size // 2].sum() == 0.0


def test_at_and_under_are_inverse(made, points):
    approach, tilt = points
    at = made.at(approach=approach, tilt=tilt)
    under = made.under(load=at.load, tilt=tilt)
    for name in ("approach", "moment", "stiffness", "max_pressure", "max_half_width"):
        assert_allclose(getattr(under, name), getattr(at, name), rtol=1e-7, atol=1e-12, err_msg=name)


def test_scalars_give_floats_and_arrays_their_shape(made):
    assert isinstance(made.at(approach=1e-3).load, float)
    found = made.at(approach=np.full((3, 1), 1e-3), tilt=np.zeros(4))
    assert found.moment.shape == (3, 4)
    assert found.stiffness.shape == (3, 4, 2, 2)
    assert made.strip_loads(found).shape == (3, 4, 21)
    assert made.strip_loads(found, [-10.0, 0.0, 10.0]).shape == (3, 4, 2)


def written(function, made, first, tilt, count=8):
    """What a C function writes."""
    found = np.full(count, np.nan)
    assert function(made.table.ctypes, first, tilt, found.ctypes) is None
    return found


def state(function, made, first, tilt):
    return State(*written(function, made, first, tilt).tolist())


def test_c_functions_agree_with_the_methods(made):
    at, found = state(AT_APPROACH, made, 5e-3, 2e-4), made.at(approach=5e-3, tilt=2e-4)
    assert at[:4] == (found.approach, found.tilt, found.load, found.moment)
    assert [at.load_by_approach, at.load_by_tilt, at.load_by_tilt, at.moment_by_tilt] == [*found.stiffness.ravel()]
    assert at.inside == 1.0
    assert tuple(written(MAXIMA, made, at.load, 2e-4, 2)) == (found.max_pressure, found.max_half_width)
    strips = np.empty(made.stations.size - 1)
    STRIP_LOADS(made.table.ctypes, at.load, 2e-4, strips.size, made.stations.ctypes, strips.ctypes)
    assert_array_equal(strips, made.strip_loads(found))
    under = state(AT_LOAD, made, at.load, 2e-4)
    assert_allclose(under.approach, 5e-3, rtol=1e-9)
    assert under[2:] == pytest.approx(at[2:], rel=1e-9)


def test_a_map_is_called_by_the_address_of_a_function(made):
    address = ctypes.cast(AT_APPROACH, ctypes.c_void_p).value
    numbers = ctypes.POINTER(ctypes.c_double)
    function = ctypes.CFUNCTYPE(None, numbers, ctypes.c_double, ctypes.c_double, numbers)(address)
    found = np.empty(8)
    function(*(each.ctypes.data_as(numbers) if np.ndim(each) else each for each in (made.table, 0.01, 3e-4, found)))
    assert found[2] == made.at(approach=0.01, tilt=3e-4).load


@pytest.mark.parametrize("tilt", [0.0, 9e-4, 1.5e-3, -0.1])
def test_outside_c_functions_continue_without_a_step_and_say_so(made, tilt):
    within = min(max(tilt, -TILT), TILT)
    last = state(AT_LOAD, made, MOST, within).approach
    for approach in (last + 1e-9, 2.0 * last, 10.0, -10.0, 0.5 * last):
        found = state(AT_APPROACH, made, approach, tilt)
        assert all(math.isfinite(value) for value in found)
        assert found.load >= 0.0
        if tilt != within:
            assert not found.inside
    edge, beyond = (state(AT_APPROACH, made, approach, within) for approach in (last, last + 1e-9))
    assert_allclose(beyond.load, edge.load, rtol=1e-5)
    assert not beyond.inside


OUTSIDE = [
    ({"approach": 1.0}, r"^approach = 1.0 must not exceed 0.0.* mm at a tilt of 0 rad, where the map"),
    ({"load": 20e3}, r"^load = 20000.0 must lie in the range of the map, 0 to 10 kN: make a map"),
    ({"load": -1.0}, r"^load = -1.0 must lie in the range"),
    (
        {"approach": [0.0, 1e-3], "tilt": [0.0, 2e-3]},
        r"^tilt = 0.002 must lie in the range of the map, -0.001 to 0.001",
    ),
    ({"approach": math.nan}, "must be finite"),
]


def test_outside_the_methods_refuse(made):
    for given, sentence in OUTSIDE:
        with pytest.raises(InputError, match=sentence):
            (made.at if "approach" in given else made.under)(**given)
    with pytest.raises(InputError, match="stations"):
        made.strip_loads(made.under(load=1.0), [3.0, 1.0])


def test_a_saved_map_is_the_same_to_the_last_bit(made, tmp_path):
    made.save(tmp_path / "k.npz")
    again = ContactMap.read(tmp_path / "k.npz")
    assert repr(again) == repr(made)
    assert again.sampled_error == made.sampled_error
    for name in ("numbers", "breaks", "mean_approach", "others", "stations"):
        assert_array_equal(getattr(again, name), getattr(made, name))
    assert_array_equal(again.table, made.table)
    assert again.at(approach=4e-3, tilt=1e-4).load == made.at(approach=4e-3, tilt=1e-4).load
    assert repr(pickle.loads(pickle.dumps(made))) == repr(made)
    with pytest.raises(ValueError, match="read-only"):
        again.mean_approach[0, 0] = 1.0


def _damaged(entries: dict[str, np.ndarray]) -> Iterator[tuple[str, dict[str, np.ndarray]]]:
    yield "hold a map of nonhertz", {**entries, "kind": np.asarray("another")}
    yield "hold a map of version 1", {**entries, "version": np.asarray(99)}
    for name in entries:
        if name not in {"kind", "version"}:
            yield "hold an undamaged map", {key: value for key, value in entries.items() if key != name}
    for name in ("mean_approach", "breaks", "numbers", "sampled_error", "stations"):
        yield "hold an undamaged map", {**entries, name: entries[name][:-1]}
        yield "hold an undamaged map", {**entries, name: np.full_like(entries[name], np.nan)}
    yield "hold an undamaged map", {**entries, "breaks": entries["breaks"][::-1].copy()}
    yield "hold an undamaged map", {**entries, "given": np.asarray("moment")}
    yield "hold an undamaged map", {**entries, "others": entries["others"].astype(complex)}


def test_files_that_hold_no_whole_map_are_refused_in_one_sentence(made, tmp_path):
    made.save(tmp_path / "k.npz")
    with np.load(tmp_path / "k.npz", allow_pickle=False) as archive:
        entries = dict(archive)
    for condition, content in _damaged(entries):
        np.savez(tmp_path / "other.npz", **content)
        with pytest.raises(InputError, match=condition) as refused:
            ContactMap.read(tmp_path / "other.npz")
        assert str(refused.value).count("\n") == 0
    whole = (tmp_path / "k.npz").read_bytes()
    for name, data in (("text", b"approach,load\n"), ("cut", whole[: len(whole) // 2]), ("none", b"")):
        (tmp_path / name).write_bytes(data)
        with pytest.raises(InputError, match="must hold a map of nonhertz"):
            ContactMap.read(tmp_path / name)
    with zipfile.ZipFile(tmp_path / "pickle.npz", "w") as archive:
        archive.writestr("kind.npy", pickle.dumps(np.asarray("nonhertz map")))
    with pytest.raises(InputError, match="must hold a map of nonhertz"):
        ContactMap.read(tmp_path / "pickle.npz")
    with pytest.raises(InputError, match="must be a file that can be read"):
        ContactMap.read(tmp_path / "nowhere.npz")


def test_a_table_for_other_programs_holds_the_map(made):
    grid = made.grid(5, 3)
    assert grid.load.shape == (5, 3)
    head, *lines = made.csv(grid).splitlines()
    assert head.startswith("approach [mm],tilt [rad],load [N],moment [N mm],load_by_approach [N/mm]")
    values = np.array([[float(value) for value in line.split(",")] for line in lines])
    assert_allclose(values[:, 2], grid.load.ravel(), rtol=1e-9)
    assert_allclose(values[:, 7], grid.moment_by_tilt.ravel(), rtol=1e-9)
    with pytest.raises(InputError, match="must be points of a map"):
        made.csv(3.0)
    assert made.grid(3, 1).tilt.tolist() == [[0.0]] * 3
    with pytest.raises(InputError, match="rows = 0 must be a whole number of at least 1"):
        made.grid(0)


def test_a_range_of_approaches_includes_lift_off(tmp_path):
    made = nh.contact_map(CONTACT, approach=(-5e-3, 8e-3), tilt=3e-4, accuracy=1e-2, checks=20, stations=1)
    grid = made.grid()
    assert grid.load.shape == (41, 21)
    assert np.all(np.isfinite(grid.load))
    assert grid.load[0].max() == 0.0
    solution = nh.solve(CONTACT, approach=8e-3, tilt=3e-4)
    point = made.at(approach=8e-3, tilt=3e-4)
    assert_allclose(point.load, solution.load, rtol=made.sampled_error.load)
    # One strip bears it all, also of a map that was saved; one edge is none.
    made.save(tmp_path / "one.npz")
    assert_allclose(ContactMap.read(tmp_path / "one.npz").strip_loads(point), [point.load], rtol=1e-12)
    with pytest.raises(InputError, match=r"stations = .* must be ascending"):
        made.strip_loads(point, [0.0])


@pytest.mark.slow
def test_a_straight_roller_that_tips_over_its_ends_is_mapped():
    """Its first touch jumps from one end to the other: the hardest case for anything smooth."""
    contact = nh.Contact(nh.Roller(diameter=20, length=20), nh.Plate())
    with pytest.warns(AccuracyWarning, match="Errors of the map exceed 2 %: "):
        made = nh.contact_map(contact, load=(0, 40e3), tilt=(-2e-3, 2e-3), accuracy=5e-3, checks=60)
    random = np.random.default_rng(3)
    load, tilt = 40e3 * random.uniform(0.01, 1.0, 60), 2e-3 * random.uniform(-1.0, 1.0, 60)
    with pytest.warns(AccuracyWarning):
        solved = nh.solve_many(contact, load=load, tilt=tilt)
    found = made.at(approach=solved.approach, tilt=tilt)
    assert np.all(np.abs(found.load - load) <= 1.5 * 5e-3 * load)
    assert np.all(np.isfinite(made.grid().stiffness))
    assert made.at(approach=-0.01, tilt=0.0).load == 0.0
    assert made.at(approach=-0.01, tilt=2e-3).load > 0.0


@pytest.mark.slow
def test_an_accuracy_out_of_reach_is_warned_of():
    """The scatter of the solutions is above 1e-6."""
    contact = nh.Contact(nh.Roller(diameter=10, length=5, profile=nh.profile.crown(radius=50)), nh.Plate())
    with pytest.warns(AccuracyWarning, match="not to the requested 1e-06; see its sampled_error"):
        made = nh.contact_map(contact, load=(0, 100.0), accuracy=1e-6, checks=20)
    assert made.sampled_error.load > 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("mirror", [1, -1])
def test_loads_on_strips_between_two_crowns_are_warned_of(mirror):
    """Where two stretches bear, places up to which shares are borne jump from one to the other."""
    relief = 4e-3 * np.array([6.0, 1.2, 0.0, 1.5, 2.2, 1.5, 0.0, 1.2, 6.0])
    profile = nh.profile.tabulated(np.linspace(-10.0, 10.0, 9), relief)
    contact = nh.Contact(nh.Roller(diameter=20, length=20, corner_radius=0.8, profile=profile), nh.Plate())
    with pytest.warns(AccuracyWarning, match=r"exceed 5 %: .*\d+ % of the load on each of 20 strips\.$"):
        made = nh.contact_map(contact, load=(0.0, 1.5e3), tilt=mirror * 1e-4, stations=20, accuracy=5e-2, checks=40)
    solution = nh.solve(contact, load=800.0, tilt=mirror * 1e-4)
    summed = np.concatenate([[0.0], np.cumsum(solution.line_load * solution.strip_width)])
    error = made.strip_loads(made.under(load=800.0, tilt=mirror * 1e-4)) - np.diff(
        np.interp(made.stations, solution.edges, summed)
    )
    assert 0.05 < np.abs(error).max() / 800.0 < made.sampled_error.strip_loads


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        ({}, "load must be given where approach is not"),
        ({"load": (0, 1.0), "approach": (0, 1.0)}, "load = .* must be given where approach is not"),
        ({"load": 5.0}, "load = 5.0 must be two ascending numbers"),
        ({"load": (-5.0, 1.0)}, "must not begin below zero"),
        ({"load": (0.0, 1e30)}, "must leave the contact narrower than the bodies"),
        ({"approach": (-2.0, -1.0)}, "approach = -1.0 must exceed"),
        ({"load": (0, 1.0), "tilt": (0.0, 1.0)}, "tilt = .* must hold small angles"),
        ({"load": (0, 1.0), "accuracy": 1e-9}, "accuracy = 1e-09 must lie between 1e-06 and 0.1"),
        ({"load": (0, 1.0), "stations": [0.0, 1.0]}, "stations = .* must reach from -10 to 10 mm"),
        ({"load": (0, 1.0), "stations": [1.0, 0.0]}, "stations = .* must be ascending"),
    ],
    ids=range(10),
)
def test_nonsense_is_refused_in_one_sentence(arguments, sentence):
    with pytest.raises(InputError, match=sentence) as refused:
        nh.contact_map(CONTACT, **arguments)
    assert "\n" not in str(refused.value)


def test_the_tilt_coordinate_has_the_derivatives_that_it_returns():
    numbers = np.array([1.0, -2e-3, 1e-3, 1e-4, 3e-5, 2e-3, 0.0, 0.0, 0.0, 1.0, 1.0])
    x, tilt, by, turn = 0.6, 4e-4, 1e-4, 1e-7

    def coordinate(x: float, tilt: float) -> np.ndarray:
        return core.map_tilt_coordinates(numbers, np.array([x]), np.array([tilt]))[0]

    def z(x: float, tilt: float) -> float:
        return coordinate(x, tilt)[0]

    expected = (
        (z(x + by, tilt) - z(x - by, tilt)) / (2 * by),
        (z(x, tilt + turn) - z(x, tilt - turn)) / (2 * turn),
        (z(x + by, tilt) - 2 * z(x, tilt) + z(x - by, tilt)) / by**2,
        (z(x + by, tilt + turn) - z(x - by, tilt + turn) - z(x + by, tilt - turn) + z(x - by, tilt - turn))
        / (4 * by * turn),
        (z(x, tilt + turn) - 2 * z(x, tilt) + z(x, tilt - turn)) / turn**2,
    )
    # Differences of second order at these steps are off by a few 1e-6.
    assert_allclose(coordinate(x, tilt)[1:], expected, rtol=2e-4)
    assert (z(x, -2e-3), z(x, 1e-3)) == (0.0, 1.0)


def test_polynomials_of_cells_are_the_spline_and_its_derivatives():
    """On uneven cells, against the basis functions themselves."""
    breaks = np.array([0.0, 0.1, 0.4, 1.0]), np.array([0.0, 0.7, 1.0])
    coefficients = np.random.default_rng(5).normal(size=(knot_count(breaks[0]), knot_count(breaks[1])))
    places = np.array([0.05, 0.35, 0.9]), np.array([0.2, 0.8, 0.7])
    i, j = np.array([0, 1, 2]), np.array([0, 1, 1])
    found = polynomials_in_cells(breaks, coefficients)[i, j]
    for orders in ((0, 0), (1, 0), (0, 2), (1, 1)):
        powers = [
            np.polynomial.polynomial.polyvander((place - each[k]) / (each[k + 1] - each[k]), 5)
            for each, place, k in zip(breaks, places, (i, j), strict=True)
        ]
        expected = rows(breaks, places, orders) @ coefficients.ravel()
        widths = [(each[k + 1] - each[k]) ** -order for each, k, order in zip(breaks, (i, j), orders, strict=True)]
        derived = found
        for axis, order in enumerate(orders, start=1):
            derived = np.polynomial.polynomial.polyder(derived, order, axis=axis)
        first, second = (each[:, : 6 - order] for each, order in zip(powers, orders, strict=True))
        by_hand = widths[0] * widths[1] * np.einsum("np,npq,nq->n", first, derived, second)
        assert_allclose(by_hand, expected, rtol=1e-10)


def test_jumps_are_those_of_either_sign_and_none_within_one_polynomial():
    breaks = np.array([0.0, 0.1, 0.4, 1.0]), np.array([0.0, 0.7, 1.0])
    coefficients = np.random.default_rng(5).normal(size=(knot_count(breaks[0]), knot_count(breaks[1])))
    places = np.array([0.05, 0.35, 0.9]), np.array([0.2, 0.8, 0.7])
    one, other = jumps(breaks, coefficients, places), jumps(breaks, -coefficients, places)
    assert_array_equal(one, other)
    assert np.min(one) > 0.0
    assert_allclose(jumps(breaks, np.ones_like(coefficients), places), 0.0, atol=1e-9)


def test_a_straight_length_tips_over_and_a_crown_rolls():
    straight = Relief.between(nh.Contact(nh.Roller(diameter=20, length=20), nh.Plate()), -10.0, 10.0)
    assert_allclose(straight.tipping(-1e-3, 2e-3)[:2], (0.0, 20.0), atol=1e-9)
    conical = nh.Roller(diameter=20, length=20, profile=nh.profile.tabulated([-10, 10], [0, 0.01]))
    inclined = Relief.between(nh.Contact(conical, nh.Plate()), -10.0, 10.0)
    assert_allclose(inclined.tipping(-1e-3, 2e-3)[0], 5e-4, atol=1e-9)
    crowned = Relief.between(CONTACT, -10.0, 10.0)
    assert crowned.tipping(-1e-3, 1e-3)[1] == 0.0
    # At y = 0, at y = 4, and at the end of the roller.
    assert_allclose(crowned.touched(np.array([0.0, 1e-3, -5e-3])), [0.0, -2e-3, 0.0125 - 0.05], atol=1e-7)


def test_the_load_of_a_point_contact_spreads_as_hertz_says():
    """Of an ellipsoid of pressure the share t of the semi-axis bears 1/2 + 3 t / 4 - t^3 / 4 up to there."""
    contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=400)), nh.Plate())
    solution = nh.solve(contact, load=1e3)
    t = np.linspace(-1.0, 1.0, 2001)
    expected = np.interp(np.sin(np.arange(25) * np.pi / 48) ** 2, 0.5 + 0.75 * t - 0.25 * t**3, t)
    along = nh.hertz.point_contact(radius_x=10.0, radius_y=400.0, compliance=contact.compliance, load=1e3).half_length
    places, loads = spread(contact, solution.edges, solution.line_load, solution.edges[[0, -1]])
    assert_allclose(places, along * expected, atol=0.002 * along)
    assert_allclose(loads, [1e3], rtol=1e-9)
    # Of even strips the last ones in contact reach beyond it, by 0.016 of its half-length.
    even = nh.solve(contact, load=1e3, strips=300)
    places, _ = spread(contact, even.edges, even.line_load, even.edges)
    assert_allclose(places[[0, -1]], [-along, along], atol=0.008 * along)


def test_a_range_whose_end_cannot_be_solved_is_refused_with_the_reason():
    """The contact would be wider than the roller is round."""
    contact = nh.Contact(nh.Roller(diameter=1, length=20, profile=nh.profile.crown(radius=400)), nh.Plate())
    with pytest.raises(InputError, match=r"^load = 1000000.0 must leave the half-width, .* reduce it") as refused:
        nh.contact_map(contact, load=(0, 1e6), accuracy=0.1, checks=20)
    assert "\n" not in str(refused.value)
    # Of a round in which no case has a solution nothing is kept.
    none = Building(contact, nh.SEMI_ELLIPTIC, None, np.array([-10.0, 0.0, 10.0]), 20).sample(
        np.array([1e6]), np.zeros(1)
    )
    assert (none.load.shape, none.places.shape, none.strip_loads.shape) == ((0,), (0, 25), (0, 2))


def test_a_range_in_which_hardly_anything_is_solved_is_refused(monkeypatch):
    solved = Building.sample
    monkeypatch.setattr(Building, "sample", lambda self, load, tilt: solved(self, load[:3], tilt[:3]))
    with pytest.raises(InputError, match="cases without a solution = 15 must not exceed the number of cases with one"):
        nh.contact_map(CONTACT, load=(0, 1e3), accuracy=0.1, checks=20)
