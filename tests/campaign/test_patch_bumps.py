"""Whether the plane grid finds every place of contact of a gap with several bumps, without being told where to look.

The checker knows the pressures and Boussinesq's point load, and looks at the user's gap on a finer net than any search.
"""

import math

import numpy as np
import pytest
from extent import extent

import nonhertz as nh
from nonhertz.errors import without_accuracy_warnings

CASES, SEED = extent(300, 12), 291
NET, HALF = 1201, 6.0  # places along a side of the square looked at [mm]
NOTICED = 0.02  # of the largest interference
FARTHER = 1.6  # cells from any cell in contact: nearer than that it ends between cells
MOST = 400  # places at which the displacement is summed
BODY = nh.Contact(nh.Body(diameter=20.0), nh.Plate())


def bumps(generator):
    """A paraboloid with two to six bumps, narrow and wide, high and low, anywhere within its neighbourhood."""
    count = int(generator.integers(2, 7))
    places = generator.uniform(-4.0, 4.0, (count, 2))
    heights = 10.0 ** generator.uniform(-3.0, 0.0, count)
    widths = 10.0 ** generator.uniform(-0.7, 0.6, count)
    radii = 10.0 ** generator.uniform(1.3, 2.5, 2)

    def gap(x, y):
        several = zip(places, heights, widths, strict=True)
        return (
            x**2 / (2.0 * radii[0])
            + y**2 / (2.0 * radii[1])
            - sum(h * np.exp(-((x - a) ** 2 + (y - b) ** 2) / w**2) for (a, b), h, w in several)
        )

    return gap


def overlap_missed(solution, gap):
    """Return the largest overlap away from the footprint over the largest interference, by point loads."""
    net = np.linspace(-HALF, HALF, NET)
    x, y = np.meshgrid(net, net, indexing="ij")
    depth = solution.approach + solution.tilt * y - gap(x, y)
    loaded = np.argwhere(solution.pressure > 0.0)
    own_x, own_y = solution.x[loaded[:, 0]], solution.y[loaded[:, 1]]
    force = solution.pressure[loaded[:, 0], loaded[:, 1]] * solution.dx * solution.dy
    deepest = float(np.max(solution.approach + solution.tilt * own_y - gap(own_x, own_y)))
    suspects = np.argwhere(depth > NOTICED * deepest)
    near = np.zeros(len(suspects), dtype=bool)
    at_x, at_y = net[suspects[:, 0]], net[suspects[:, 1]]
    touched = {(int(i), int(j)) for i, j in loaded}
    reach = math.ceil(FARTHER)
    for k, (a, b) in enumerate(zip(at_x, at_y, strict=True)):
        i, j = round((a - solution.x[0]) / solution.dx), round((b - solution.y[0]) / solution.dy)
        near[k] = any((i + p, j + q) in touched for p in range(-reach, reach + 1) for q in range(-reach, reach + 1))
    suspects = suspects[~near]
    if not len(suspects):
        return 0.0
    deep = depth[suspects[:, 0], suspects[:, 1]]
    chosen = suspects[np.argsort(deep)[-MOST:]]
    worst = 0.0
    for i, j in chosen:
        lift = BODY.compliance * float(np.sum(force / np.hypot(own_x - net[i], own_y - net[j])))
        worst = max(worst, (depth[i, j] - lift) / deepest)
    return worst


@pytest.mark.campaign
def test_no_bump_in_contact_is_missed_in_silence():
    missed, told = [], 0
    for number in range(CASES):
        generator = np.random.default_rng((SEED, number))
        gap, load = bumps(generator), 10.0 ** generator.uniform(1.0, 3.7)
        with without_accuracy_warnings():
            solution = nh.patch.solve(BODY, gap=gap, load=load, cells=(64, 64))
        worst = overlap_missed(solution, gap)
        if worst > NOTICED:
            said = " ".join(solution.warnings)
            if "overlap" in said or "missed" in said or "uncertain" in said:
                told += 1
            else:
                missed.append((number, worst, solution.warnings))
    print(f"\n{CASES} gaps with bumps: {len(missed)} with a place of contact missed in silence, {told} told of")
    assert not missed


@pytest.mark.campaign
def test_the_checker_notices_a_bump_that_was_left_out():
    def smooth(x, y):
        return x**2 / 40.0 + y**2 / 100.0

    def bumped(x, y):
        return smooth(x, y) - 0.25 * np.exp(-((x - 1.0) ** 2 + (y - 2.0) ** 2) / 0.2)

    solution = nh.patch.solve(BODY, gap=smooth, load=300.0, cells=(32, 32))
    assert overlap_missed(solution, smooth) == 0.0
    assert overlap_missed(solution, bumped) > 0.5
