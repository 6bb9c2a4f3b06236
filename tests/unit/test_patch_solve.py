"""`nonhertz.patch.solve`: what it refuses, what it warns of, and what its solution says of itself."""

import errno
import math
import os
import pickle
import tracemalloc
import warnings

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.patch import Dent, PatchSolution, Waviness, memory, resources, undeformed_gap
from nonhertz.patch.resources import refuse_excess

HALF_SPACE = {"side_faces": "none", "depth": "none"}
CROWNED = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(1000), **HALF_SPACE), nh.Plate())
STRAIGHT = nh.Contact(nh.Roller(diameter=20, length=20, **HALF_SPACE), nh.Plate())
SMALL = (32, 64)


BODIES_AS_THEY_COME = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(1000)), nh.Plate())
REGION = ((-0.3, 0.3), (-5.0, 5.0))


@pytest.fixture(scope="module")
def solution():
    return nh.patch.solve(CROWNED, load=3e3, tilt=2e-4, cells=SMALL)


def flat(x, y):
    return 0.0 * x * y


def everywhere(value):
    return lambda x, y: np.full(np.broadcast_shapes(x.shape, y.shape), value)


REFUSED = [
    (CROWNED, {"load": 1e3, "approach": 0.01}, "approach = 0.01 must not be given together with load"),
    (CROWNED, {"load": 1e3, "moment": 1.1e4}, "moment = 11000.0 must keep moment / load between -10 and 10 mm"),
    (CROWNED, {"load": 1e3, "cells": (64, 3)}, "cells = (64, 3) must be whole numbers of at least 4"),
    (CROWNED, {"load": 1e3, "cells": (10**7, 10**7)}, "cells = (10000000, 10000000) must need less than"),
    (CROWNED, {"load": 1e3, "region": (1.0, 2.0)}, "region = (1.0, 2.0) must be two pairs of ends"),
    (CROWNED, {"load": 1e3, "region": ((0.0, 1.0), (11.0, 12.0))}, "region = ((0.0, 1.0), (11.0, 12.0)) must ascend"),
    (
        CROWNED,
        {"load": 1e3, "region": ((0.0, math.nan), (0.0, 1.0))},
        "region = ((0.0, nan), (0.0, 1.0)) must be finite",
    ),
    (
        CROWNED,
        {"load": 1e3, "features": [Dent]},
        "features[0] = <class 'nonhertz.patch.features.Dent'> must be callable",
    ),
    (CROWNED, {"load": 1e3, "features": [math.sin]}, "features[0] = <built-in function sin> must be callable with x"),
    # A gap that is none.
    (CROWNED, {"load": 1e3, "gap": everywhere(math.nan)}, "must return a number everywhere"),
    (CROWNED, {"load": 1e3, "gap": everywhere(math.inf)}, "must be finite somewhere"),
    (CROWNED, {"load": 1e3, "gap": lambda x, y: np.zeros((2, 3))}, "must return the broadcast shape"),
    (CROWNED, {"load": 1e3, "gap": lambda x, y: (x > 0.0) | (y > 0.0)}, "must return real numbers, not bool"),
    (CROWNED, {"load": 1e3, "gap": lambda x, y: None}, "must return real numbers"),
    # Nothing touches. y^2 / 2000 - 0.002 y is least at y = 2, by 0.002.
    *(
        (contact, {"approach": approach, **more}, f"approach = {approach} must exceed 0 mm, where the bodies begin")
        for contact, more in ((BODIES_AS_THEY_COME, {}), (CROWNED, {"moment": 0.0}), (CROWNED, {"region": REGION}))
        for approach in (-1.0, 0.0)
    ),
    (BODIES_AS_THEY_COME, {"approach": -0.01, "tilt": 2e-3}, "approach = -0.01 must exceed -0.002 mm"),
    (BODIES_AS_THEY_COME, {"approach": 1e-3, "features": lambda x, y: 3e-3}, "approach = 0.001 must exceed 0.003 mm"),
    (
        CROWNED,
        {"approach": 1e-6, "cells": (8, 8), "region": ((-1.0, 1.0), (-9.0, 9.0))},
        "put the centre of a cell",
    ),
    (
        CROWNED,
        {"load": 3e3, "moment": 1.5e4, "cells": (24, 32), "region": ((-0.3, 0.3), (-1.0, 1.0))},
        "moment = 15000.0 must keep moment / load = 5 mm between -0.96875 and",
    ),
    # A body thinner than its contact, and contacts that nothing ends.
    (BODIES_AS_THEY_COME, {"load": 1e9}, "must leave the half-width, about"),
    (BODIES_AS_THEY_COME, {"approach": 100.0}, "must leave the half-width, about"),
    (BODIES_AS_THEY_COME, {"load": 3e3, "gap": flat}, "below the 20 mm of body a"),
    (nh.Contact(nh.Body(diameter=10), nh.Plate()), {"load": 100.0}, "length must be given where nothing"),
    (
        CROWNED,
        {"load": 1e300},
        "load = 1e+300 must leave the contact narrower than the bodies: check its unit, or reduce it.",
    ),
    (CROWNED, {"load": 1e13}, "load = 10000000000000.0 must keep the contact narrower than 30 radii"),
    (CROWNED, {"approach": 1e6}, "approach = 1000000.0 must keep the contact narrower than 30 radii"),
    (CROWNED, {"load": 3e3, "gap": flat}, "must rise away from the contact"),
    (CROWNED, {"load": 3e3, "gap": lambda x, y: y**2 - x**2}, "must rise away from the contact"),
]


@pytest.mark.parametrize(("contact", "given", "sentence"), REFUSED, ids=range(len(REFUSED)))
def test_what_is_refused(contact, given, sentence):
    with pytest.raises(nh.InputError) as caught:
        nh.patch.solve(contact, **{"cells": SMALL, **given})
    assert sentence in str(caught.value)


def test_a_wrong_return_is_said_of_the_function_that_made_it():
    def wrong(x, y):
        return 1e-3j * (x + y)

    with pytest.raises(nh.InputError) as caught:
        nh.patch.solve(CROWNED, load=1e3, features=[Dent(depth=0.001, diameter=3.0), wrong], cells=SMALL)
    assert (caught.value.field, caught.value.value) == ("features[1]", wrong)


def test_a_feature_that_works_in_place_cannot_move_the_cells():
    def careless(x, y):
        x *= 0.0
        return x + 0.0 * y

    with pytest.raises(ValueError, match="read-only"):
        nh.patch.solve(CROWNED, load=3e3, features=[careless], cells=SMALL)


# Where the contact is


def test_bodies_that_only_touch_where_they_are_tilted_do():
    assert nh.patch.solve(BODIES_AS_THEY_COME, approach=-0.0019, tilt=2e-3, cells=SMALL).load > 0.0


@pytest.mark.filterwarnings(
    "ignore:The bodies overlap by .* between cell centres", "ignore:The estimated error of the maximum"
)
@pytest.mark.parametrize("cells_away", [1.0, 1.5])
def test_a_bump_within_two_cells_of_the_region_is_found(cells_away):
    # Half the approach high, where the bodies' own gap is far less: it overlaps, but no cell of the region sees it.
    def bowl(x, y):
        return x**2 / 40.0 + y**2 / 100.0

    body = nh.Contact(nh.Body(diameter=20.0), nh.Plate())
    without = nh.patch.solve(body, gap=bowl, load=300.0, cells=(32, 32))
    place, width = float(without.y[-1]) + (0.5 + cells_away) * without.dy, 0.3 * without.dy
    found = nh.patch.solve(
        body,
        gap=lambda x, y: bowl(x, y) - 0.5 * without.approach * np.exp(-(x**2 + (y - place) ** 2) / width**2),
        load=300.0,
        cells=(32, 32),
    )
    assert without.y[-1] < place < found.y[-1]


def burr(x_at, y_at):
    """A bump 0.07 mm high and 0.2 mm across."""
    return lambda x, y: -0.07 * np.exp(-((x - x_at) ** 2 + (y - y_at) ** 2) / 0.02)


@pytest.mark.parametrize("at", [(1.0, 0.0), (-0.7, -6.0)])
@pytest.mark.slow
def test_a_burr_beyond_the_region_is_taken_in_or_warned_of(at):
    # A cell or two along are few for it, which is said, too.
    with warnings.catch_warnings(record=True, action="always") as caught:
        found = nh.patch.solve(CROWNED, load=3e3, features=burr(*at), cells=(96, 128))
    assert "between cell centres" in str(caught[0].message)
    np.testing.assert_allclose((found.max_pressure_x, found.max_pressure_y), at, rtol=0.0, atol=0.1)
    region = ((-0.4, 0.4), (-5.0, 5.0))
    with warnings.catch_warnings(record=True, action="always") as caught:
        nh.patch.solve(CROWNED, load=3e3, features=burr(*at), cells=(96, 128), region=region)
    assert any(" mm outside the region, at x = " in str(each.message) for each in caught)


def test_an_infinite_gap_keeps_cells_out():
    def half(x, y):
        return np.where(y > 0.0, math.inf, x**2 / 20.0 + y**2 / 2000.0)

    solution = nh.patch.solve(CROWNED, load=1e3, gap=half, cells=SMALL, region=((-0.3, 0.3), (-4.0, 4.0)))
    assert not solution.footprint[:, solution.y > 0.0].any()
    assert solution.load == pytest.approx(1e3, rel=1e-9)


# Gap


def test_the_gap_is_that_of_the_bodies():
    taper = nh.Roller(diameter=nh.TabulatedDiameter((-10.0, 10.0), (18.0, 22.0)), length=20, depth="none")
    contact = nh.Contact(taper, nh.Ring(diameter=60))
    # 1/rho = 2/20.8 + 2/60 at y = 4.
    found = undeformed_gap(contact, np.array([[0.0], [0.3]]), np.array([4.0]))
    np.testing.assert_allclose(found[:, 0], [0.0, 0.045 * (2.0 / 20.8 + 2.0 / 60.0)], rtol=1e-14, atol=0.0)


def test_a_feature_may_return_a_whole_number_for_all_places():
    plain, same = (nh.patch.solve(CROWNED, load=3e3, cells=SMALL, features=f) for f in ((), lambda x, y: 0))
    assert same.approach == plain.approach


def test_features_add_up():
    dents = [Dent(x=0.1, y=1.0, depth=0.001, diameter=1.4), Dent(x=-0.1, y=-1.0, depth=0.002, diameter=1.4)]

    def whole(x, y):
        return undeformed_gap(CROWNED, x, y) + dents[0](x, y) + dents[1](x, y)

    of_features = nh.patch.solve(CROWNED, load=3e3, features=dents, cells=SMALL)
    one = nh.patch.solve(CROWNED, load=3e3, features=dents[0], cells=SMALL)  # needs no list
    assert not np.array_equal(one.pressure, of_features.pressure)
    of_gap = nh.patch.solve(CROWNED, load=3e3, gap=whole, cells=SMALL)
    # The same numbers added in another order.
    np.testing.assert_allclose(of_features.pressure, of_gap.pressure, rtol=0.0, atol=1e-5 * of_gap.max_pressure)


# Solution


def test_it_says_how_it_ended_and_what_its_pressures_bear(solution):
    assert isinstance(solution, PatchSolution)
    assert solution.status is nh.Status.CONVERGED
    assert solution.residual <= 1e-8
    assert 0 < solution.iterations < 60
    assert solution.warnings == ()
    assert solution.cells == solution.gap.shape == solution.footprint.shape == SMALL
    assert solution.half_width.shape == solution.centre_pressure.shape == SMALL[1:]
    steps = np.concatenate([np.diff(solution.x) / solution.dx, np.diff(solution.y) / solution.dy])
    np.testing.assert_allclose(steps, 1.0, rtol=1e-12)
    # Rounding of sums in another order.
    np.testing.assert_allclose(solution.line_load.sum() * solution.dy, solution.load, rtol=1e-12, atol=0.0)
    area = solution.dx * solution.dy
    np.testing.assert_allclose(solution.contact_area, area * (solution.pressure > 0).sum(), rtol=1e-12, atol=0.0)
    at = solution.x == solution.max_pressure_x, solution.y == solution.max_pressure_y
    assert solution.pressure[at] == solution.max_pressure


def test_a_station_across(solution):
    j = SMALL[1] // 2
    x, pressure = solution.across(float(solution.y[j]))
    assert np.array_equal(x, solution.x)
    np.testing.assert_allclose(pressure, solution.pressure[:, j], rtol=1e-12, atol=1e-9)
    _, between = solution.across(float(solution.y[j]) + 0.5 * solution.dy)
    np.testing.assert_allclose(between, 0.5 * (solution.pressure[:, j] + solution.pressure[:, j + 1]), rtol=1e-9)
    with pytest.raises(nh.InputError, match=r"y = 11\.0 must lie between"):
        solution.across(11.0)


def test_arrays_are_read_only_and_stay_so_in_a_pickle(solution):
    for each in (solution, pickle.loads(pickle.dumps(solution))):
        for name in ("x", "y", "pressure", "gap", "footprint", "line_load", "half_width", "centre_pressure"):
            assert not getattr(each, name).flags.writeable
    assert np.array_equal(pickle.loads(pickle.dumps(solution)).pressure, solution.pressure)


@pytest.mark.slow
def test_threads_change_nothing():
    one, three = (nh.patch.solve(CROWNED, load=3e3, cells=(256, 256), tolerance=1e-4, threads=n) for n in (1, 3))
    assert np.array_equal(one.pressure, three.pressure)


def test_running_out_of_iterations_carries_the_state(monkeypatch):
    monkeypatch.setattr("nonhertz.patch.settle.MOST_CHANGES", 1)
    monkeypatch.setattr("nonhertz.patch.settle.MOST_MOTIONS", 1)
    with pytest.raises(nh.ConvergenceError) as caught:
        nh.patch.solve(CROWNED, load=3e3, cells=SMALL, region=((-0.3, 0.3), (-5.0, 5.0)))
    assert caught.value.solution.status is nh.Status.ITERATION_LIMIT
    assert caught.value.solution.error_estimate.approach == math.inf
    assert f"The residual is {caught.value.solution.residual:.2g}, not 1e-08; likely causes are" in str(caught.value)


# Region


def test_a_contact_up_to_the_ends_has_them_on_edges_of_cells():
    solution = nh.patch.solve(STRAIGHT, load=5e3, cells=SMALL)
    beyond = nh.patch.solve(STRAIGHT, load=5e3, cells=SMALL, region=((-0.3, 0.3), (-30.0, 30.0)))
    np.testing.assert_allclose(
        [solution.edges[0], solution.edges[-1], beyond.edges[-1]], [-10.0, 10.0, 10.0], rtol=1e-12
    )
    assert len(solution.warnings) == 2
    assert "sharp end at y = -10 mm" in solution.warnings[0]
    assert [end.y for end in solution.singular_ends] == [-10.0, 10.0]
    # Cells longer than the half-width say nothing of the pressure that far from the end.
    assert solution.error_estimate.max_pressure == math.inf
    assert "cells are about as long as the half-width; give more cells along" in solution.warnings[0]


def test_a_half_width_from_sharp_ends_the_maximum_is_that_of_strips():
    short = nh.Contact(nh.Roller(diameter=20, length=4), nh.Ring(diameter=80))
    solution, of_strips = nh.patch.solve(short, load=4e3, cells=(32, 48)), nh.solve(short, load=4e3)
    assert [end.y for end in solution.singular_ends] == [-2.0, 2.0]
    assert solution.error_estimate.max_pressure < 0.05
    assert solution.max_pressure == pytest.approx(of_strips.max_pressure, rel=5e-3)


def test_the_contact_fills_the_region_that_is_found(solution):
    # At most a cell or two of the coarse search, of 18 at least, on either side.
    for axis in (0, 1):
        filled = solution.footprint.any(axis=axis)
        assert 0.75 < filled.mean() < 1.0
        assert not filled[0]
        assert not filled[-1]


def test_the_region_is_found_far_from_where_it_is_looked_for():
    # The profile's summit lies 300 mm off, the contact is tiny, and neither body ends.
    def gap(x, y):
        return ((x - 2.0) ** 2 + (y - 300.0) ** 2) / 20.0

    found = nh.patch.solve(nh.Contact(nh.Body(diameter=20), nh.Plate()), load=10.0, gap=gap, cells=(48, 48))
    exact = nh.hertz.point_contact(load=10.0, radius_x=10, radius_y=10, compliance=found.contact.compliance)
    np.testing.assert_allclose(
        (found.max_pressure_x, found.max_pressure_y), (2.0, 300.0), rtol=0.0, atol=0.1 * exact.half_width
    )
    np.testing.assert_allclose(found.approach, exact.approach, rtol=1e-3, atol=0.0)  # 40 cells across the circle


@pytest.mark.parametrize(
    ("region", "ends"),
    [
        (((-0.05, 0.3), (-5.0, 5.0)), ["x = -0.05 mm"]),
        (((-0.8, 0.8), (-1.0, 1.0)), ["y = -1 mm", "y = 1 mm"]),
    ],
)
def test_a_region_that_cuts_the_contact_is_warned_of(region, ends):
    with pytest.warns(nh.AccuracyWarning) as caught:
        solution = nh.patch.solve(CROWNED, load=3e3, cells=SMALL, region=region)
    assert [str(warning.message) for warning in caught] == list(solution.warnings)
    for end, sentence in zip(ends, solution.warnings, strict=True):
        assert sentence.startswith(f"The region ends at {end} while the contact continues")


# Strains


def test_thin_bodies_heavy_images_and_wide_contacts_are_warned_of():
    soft = nh.Material(modulus=1000.0, poisson=0.3)
    thin = nh.Roller(diameter=20, length=20, material=soft, depth=4.0, side_faces=2.0)
    with pytest.warns(nh.AccuracyWarning) as caught:
        nh.patch.solve(nh.Contact(thin, nh.Plate()), load=20e3, cells=SMALL)
    said = " ".join(str(warning.message) for warning in caught)
    assert "would have a total weight of 1.99" in said
    assert "of the smaller radius of curvature, over 0.3" in said
    assert "The depth of body a is only" in said


FEW_CELLS = [
    (Dent(depth=0.001, diameter=0.5), "The diameter of a dent of 0.5 mm is only"),
    (Dent(depth=0.001, diameter=1.0, shoulder=1e-4, shoulder_diameter=1.2), "The shoulder of a dent of 0.1 mm is"),
    (Waviness(amplitude=1e-4, wavelength=0.4, direction="along"), "The wavelength of 0.4 mm is only"),
    (Waviness(amplitude=1e-4, wavelength=0.05), "The wavelength of 0.05 mm is only"),
]


@pytest.mark.parametrize(("feature", "sentence"), FEW_CELLS, ids=str)
def test_features_of_a_few_cells_are_warned_of(feature, sentence):
    with pytest.warns(nh.AccuracyWarning) as caught:
        nh.patch.solve(CROWNED, load=3e3, features=feature, cells=SMALL)
    said = [str(warning.message) for warning in caught]
    assert sum(each.startswith(sentence) for each in said) == 1
    # What is said beside it is of the error that comes of it.
    assert all(each.startswith((sentence, "The bodies overlap", "The estimated error of the")) for each in said)


def test_waves_along_are_not_measured_across():
    wide = Waviness(amplitude=1e-4, wavelength=0.3)  # 2 cells along, 15 across
    assert nh.patch.solve(CROWNED, load=3e3, features=wide, cells=SMALL).warnings == ()


# Memory


MIRRORED = {"diameter": 20, "length": 20, "profile": nh.profile.crown(1000), "side_faces": "mirror"}
TAKEN = {
    "half-spaces": (CROWNED, (256, 256)),
    "faces and depth": (nh.Contact(nh.Roller(**MIRRORED), nh.Plate()), (96, 512)),
    "images": (nh.Contact(nh.Roller(**MIRRORED, images=3), nh.Plate()), (192, 192)),
    "free": (nh.Contact(nh.Roller(diameter=20, length=20, side_faces="free", depth="none"), nh.Plate()), (256, 256)),
}


@pytest.mark.filterwarnings("ignore:The estimated error of the approach:nonhertz.AccuracyWarning")  # 16 x 16 cells
@pytest.mark.parametrize("name", TAKEN)
@pytest.mark.slow
def test_the_memory_foretold_is_what_is_taken(name):
    contact, cells = TAKEN[name]
    nh.patch.solve(contact, load=3e3, cells=(16, 16))  # so that what is loaded then is not counted
    tracemalloc.start()
    solution = nh.patch.solve(contact, load=3e3, cells=cells, threads=1, tolerance=1e-4)
    taken = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    # Temporaries come and go; a fifth is what the documentation promises.
    np.testing.assert_allclose(memory(cells, contact), taken, rtol=0.2, atol=0.0)
    assert solution.memory == memory(cells, contact)


@pytest.mark.skipif(not hasattr(os, "sysconf"), reason="asks the system as Unix does")
def test_where_the_kernel_keeps_no_such_file_the_system_is_asked(monkeypatch):
    def missing(path, **_):
        raise FileNotFoundError(errno.ENOENT, path)

    monkeypatch.setattr("pathlib.Path.open", missing)
    total = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    assert resources.available_memory() == total
    monkeypatch.setattr("sys.platform", "win32")  # which does not say
    assert resources.available_memory() == 8 * 2**30
    monkeypatch.undo()
    assert 0.0 < resources.available_memory() <= total


def test_what_does_not_fit_is_refused_before_it_is_tried(monkeypatch):
    monkeypatch.setattr("nonhertz.patch.resources.available_memory", lambda: 2.0**30)
    refuse_excess((1024, 2048), CROWNED)
    with pytest.raises(nh.InputError, match=r"must need less than the 0\.8 GiB of memory available, not 1\.9 GiB"):
        refuse_excess((4096, 4096), CROWNED)
