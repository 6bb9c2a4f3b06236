"""300 random contacts: the field below them carries their loads and moments, and meets their pressures."""

import warnings

import numpy as np
import pytest
from extent import extent

import nonhertz as nh

CASES, SEED = extent(300, 25), 20240613
RESULTANTS, PRESSURE = 1e-3, 1e-3
ROWS, COLUMNS = 40, 14  # of a deep plane


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


def carried(solution, reach, depth, middle):
    """Return load and moment about y = 0 that body b carries through the plane at a depth."""
    turns = (np.arange(ROWS) + 0.5) * np.pi / ROWS - 0.5 * np.pi
    y, dy = middle + reach * np.tan(turns), reach * np.pi / ROWS / np.cos(turns) ** 2
    turns = (np.arange(COLUMNS) + 0.5) * 0.5 * np.pi / COLUMNS
    x, dx = depth * np.tan(turns), 2.0 * depth * 0.5 * np.pi / COLUMNS / np.cos(turns) ** 2
    stress = nh.subsurface.stress(solution, x[:, None], y, depth, body="b", threads=1)
    area = dx[:, None] * dy
    return -float(np.sum(area * stress.sigma_z)), -float(np.sum(area * (y * stress.sigma_z - depth * stress.tau_yz)))


def errors_of(solution):
    """Return how far off load, moment and pressures at centres are."""
    touching = solution.line_load > 0.0
    low, high = solution.edges[np.flatnonzero(touching)[[0, -1]] + [0, 1]]
    reach = 0.5 * (high - low)
    depth = reach + 2.0 * solution.half_width.max()
    load, moment = carried(solution, depth, depth, float(solution.y[touching].mean()))
    surface = nh.subsurface.stress(solution, 0.0, solution.y[touching], 0.0, body="b", threads=1)
    at_centres = np.abs(surface.sigma_z + solution.centre_pressure[touching]).max()
    return (
        abs(load / solution.load - 1.0),
        abs(moment - solution.moment) / (solution.load * reach),
        at_centres / solution.centre_pressure.max(),  # of all strips, those at sharp ends too
    )


@pytest.mark.campaign
def test_the_field_is_that_of_the_loads():
    found = []
    for number in range(CASES):
        case = random_solution(number)
        if case is not None:
            found.append(errors_of(case[0]))
            assert max(found[-1][:2]) < RESULTANTS, number
            assert found[-1][2] < PRESSURE, number
    assert len(found) > 0.9 * CASES
    for name, part in zip(("load", "moment", "centres"), np.transpose(found), strict=True):
        print(f"{name}: 99 % within {np.quantile(part, 0.99):.1e}, largest {part.max():.1e}")
