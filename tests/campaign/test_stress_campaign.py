"""300 random contacts: the field bears their loads, meets their pressures, and is that of point loads."""

import warnings

import numpy as np
import pytest
from extent import extent
from stress_check import Pressed, carried, images_of, stress_below

import nonhertz as nh

CASES, POINTS, SEED = extent(300, 25), 5, 20240613
RESULTANTS, PRESSURE, COMPONENTS = 1e-3, 1e-3, 2e-3


def random_profile(rng, length):
    """A profile with crowns, corners, run-outs or a groove."""
    crown = nh.profile.crown(radius=length * 10.0 ** rng.uniform(1.0, 4.0))
    chamfer = nh.profile.chamfer(length, rng.uniform(0.02, 0.15) * length, np.radians(rng.uniform(5.0, 45.0)))
    grooved = np.array([-0.5, -0.08, -0.06, 0.06, 0.08, 0.5]) * length
    return [
        nh.profile.straight(),
        crown,
        chamfer,
        crown + chamfer,
        nh.profile.iso_logarithmic(diameter=length, length=length),
        nh.profile.tapered_ends(straight=0.6 * length, angle=10.0 ** rng.uniform(-3.5, -2.0)),
        nh.profile.tabulated(grooved.tolist(), [0.0, 0.0, 0.05, 0.05, 0.0, 0.0], interpolation="linear"),
    ][rng.integers(7)]


def random_strips(rng, length):
    """Half automatic; else few, equal or uneven ones."""
    kind = rng.integers(6)
    if kind < 3:
        return {}
    if kind == 3:
        return {"strips": int(rng.choice([1, 2, 3, 5, 10, 20, 50]))}
    if kind == 4:
        return {"strips": np.sort(np.unique([-0.5, *rng.uniform(-0.5, 0.5, int(rng.integers(1, 40))), 0.5])) * length}
    return {"strips": np.concatenate([[-0.5], np.linspace(-0.1, 0.1, int(rng.integers(3, 30))), [0.5]]) * length}


def random_solution(number):
    """A roller on a body that goes on for ever, or None where there is nothing to solve."""
    rng = np.random.default_rng([SEED, number])
    length = 10.0 ** rng.uniform(0.5, 2.0)
    # Behind other faces the field is that of a free face, not of images.
    faces, images = rng.choice([0.0, 1.0]), int(rng.choice([1, 2]))
    roller = nh.Roller(
        diameter=length * 10.0 ** rng.uniform(-0.5, 0.5),
        length=length,
        profile=random_profile(rng, length),
        side_faces="mirror" if faces else "none",
        images=images,
    )
    other = nh.Plate(material=nh.Material(modulus=210e3, poisson=rng.uniform(0.0, 0.45)))
    load = length**2 * 10.0 ** rng.uniform(-1.0, 2.0)
    given = {"moment": load * length * rng.uniform(-0.1, 0.1)} if rng.random() < 0.5 else {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return nh.solve(nh.Contact(roller, other), load=load, **given, **random_strips(rng, length)), faces, rng
        except nh.NonhertzError:
            return None


def errors_of(solution, faces, rng):
    """Return how far off load, moment, pressures at centres and components at random points are."""
    pressed = Pressed(solution.edges, solution.line_load, solution.half_width, solution.contact_y)
    middle = float(solution.y[solution.line_load > 0.0].mean())
    depth = pressed.reach + 2.0 * solution.half_width.max()
    load, moment = carried(
        lambda x, y, z: nh.subsurface.stress(solution, x, y, z, body="b", threads=1).stress,
        depth, depth, middle,
    )  # fmt: skip
    touching = solution.line_load > 0.0
    surface = nh.subsurface.stress(solution, 0.0, solution.y[touching], 0.0, body="b", threads=1)
    at_centres = np.abs(surface.sigma_z + solution.centre_pressure[touching]).max()
    body = ("a", "b")[rng.integers(2)]
    within = getattr(solution.contact, body)
    low, high = solution.edges[np.flatnonzero(touching)[[0, -1]] + [0, 1]]
    b = solution.half_width.max()
    y = rng.uniform(low, high, POINTS)
    x, z = b * rng.uniform(-1.5, 1.5, POINTS), b * 10.0 ** rng.uniform(-0.9, 0.3, POINTS)
    found = nh.subsurface.stress(solution, x, y, z, body=body, threads=1).stress
    rows = (
        images_of(*within.faces, (faces, faces), 2 * within.images - 1) if body == "a" else images_of(0, 0, (0, 0), 0)
    )
    wanted = [stress_below(pressed, point, within.material.poisson, rows) for point in zip(x, y, z, strict=True)]
    largest = solution.centre_pressure.max()  # of all strips, those at sharp ends too
    return (
        abs(load / solution.load - 1.0),
        abs(moment - solution.moment) / (solution.load * pressed.reach),
        at_centres / largest,
        *(np.abs(found - wanted).max(axis=1) / largest),
    )


@pytest.mark.campaign
def test_the_field_is_that_of_the_loads():
    found = []
    for number in range(CASES):
        case = random_solution(number)
        if case is not None:
            found.append(errors_of(*case))
            assert max(found[-1][:2]) < RESULTANTS, number
            assert found[-1][2] < PRESSURE, number
            assert max(found[-1][3:]) < COMPONENTS, number
    assert len(found) > 0.9 * CASES
    errors = np.array(found)
    for name, part in (("load", errors[:, 0]), ("moment", errors[:, 1]), ("centres", errors[:, 2])):
        print(f"{name}: 99 % within {np.quantile(part, 0.99):.1e}, largest {part.max():.1e}")
    shares = " ".join(f"{share:g} % within {np.quantile(errors[:, 3:], 0.01 * share):.1e}," for share in (50, 90, 99))
    print(f"components: {shares} largest {errors[:, 3:].max():.1e}, of {errors[:, 3:].size} points")
