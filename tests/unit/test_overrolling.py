"""The life of a raceway with a dent that is rolled over."""

import math
import runpy
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.errors import InputError
from nonhertz.life import VolumeModel, exposure, lundberg_palmgren, model, overrolled, weibull, zaretsky

# Coarse cells say what they miss; how far the results depend on them is tested here.
pytestmark = pytest.mark.filterwarnings("ignore::nonhertz.errors.AccuracyWarning")

DENT = nh.patch.Dent(y=0.0, depth=0.002, diameter=0.3, shoulder=0.0005)
COARSE = 0.02  # mm, a cell


def crowned(load=300.0):
    """Return a small contact, 0.4 x 1.4 mm, which few cells cover, on a raceway of 80 mm."""
    roller = nh.Roller(diameter=20, length=8, profile=nh.profile.crown(radius=100))
    return nh.solve(nh.Contact(roller, nh.Ring(diameter=80)), load=load)


@pytest.fixture(scope="module")
def smooth():
    return crowned()


@pytest.fixture(scope="module")
def found(smooth):
    return overrolled(smooth, DENT, body="b", cell=COARSE, reach=2.0)


# What is refused


def test_the_life_of_one_position_of_a_dent_is_refused_with_the_way_out(smooth):
    dented = nh.patch.solve(smooth.contact, load=300.0, cells=(24, 48), features=[DENT])
    for name in ("iso-16281", "lundberg-palmgren"):
        with pytest.raises(InputError, match=r"a dent rolls on .*: .*nonhertz\.life\.overrolled\.$"):
            nh.life.assess(dented, name)
    waves = nh.patch.Waviness(amplitude=1e-4, wavelength=0.5, direction="along")
    steady = nh.patch.solve(smooth.contact, load=300.0, cells=(24, 48), features=[waves])
    assert nh.life.assess(steady, "iso-16281")[0].damage > 0.0


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"y": 3.9}, "y = 3.9 must lie between"),
        ({"reach": 0.0}, "reach = 0.0 must be positive"),
        ({"body": "c"}, "body = 'c' must"),
    ],
)
def test_what_cannot_be_rolled_over_is_refused_in_one_sentence(smooth, changes, words):
    y = changes.pop("y", 0.0)
    with pytest.raises(InputError, match=words):
        overrolled(smooth, replace(DENT, y=y), **{"body": "b"} | changes)


# Nothing to roll over


@pytest.mark.slow
@pytest.mark.parametrize(
    ("dent", "cell", "side", "reach"),
    [
        (replace(DENT, y=2.5), 0.035, 0.035, 1.0),
        # An eighth of the width of the shoulder.
        (nh.patch.Dent(depth=1e-9, diameter=0.3, shoulder=1e-10, shoulder_diameter=0.4), None, 0.00625, 0.3),
    ],
)
def test_a_dent_far_away_or_of_no_depth_leaves_the_life_as_it_is(smooth, dent, cell, side, reach):
    seen = overrolled(smooth, dent, body="b", cell=cell, reach=reach)
    for points in (seen.x, seen.y):  # at every second cell
        assert 0.8 * side < 0.5 * (points[1] - points[0]) <= side
    for each in (lundberg_palmgren(), zaretsky()):
        assert seen.excess(each) == 0.0
        assert seen.relative_life(each) == 1.0
    assert seen.positions.size == 0


@pytest.mark.slow
def test_relative_lives_follow_from_the_excess(found):
    each, damage = zaretsky(), found.smooth.damage(zaretsky())
    assert found.relative_life(each, dents=0) == found.relative_life(each, per_area=0.0) == 1.0
    lived = (1.0 + 5.0 * found.excess(each) / (math.pi * 60.0 * damage)) ** (-1.0 / each.slope)
    assert found.relative_life(each, dents=5, raceway_diameter=60.0) == pytest.approx(lived, rel=1e-12)
    assert found.diameter == pytest.approx(80.0, rel=1e-12)
    added = found.density(each) - found.density(each, dented=False)
    integral = np.trapezoid(np.trapezoid(added, found.y), found.x)
    assert found.excess(each) == pytest.approx(integral, rel=0.01)
    # What the excess of these cells is; whether it is true is asked below.
    for by, expected in ((lundberg_palmgren(), 0.99609), (each, 0.87005), (weibull(stress="von_mises"), 0.85327)):
        assert found.relative_life(by, per_area=0.1) == pytest.approx(expected, abs=1e-4)
    with pytest.raises(InputError, match="with that many, dents cover the raceway"):
        found.relative_life(each, per_area=100.0)


# Whether the numbers are true


@pytest.mark.slow
@pytest.mark.parametrize(
    ("cell", "models"),
    [
        (0.01, (lundberg_palmgren(), model("ioannides-harris", fatigue_limit=200.0))),
        (0.035, (zaretsky(), weibull(), weibull(stress="von_mises"))),
    ],
)
def test_the_smooth_raceway_has_the_damage_that_its_strips_have(smooth, cell, models):
    # All of the small contact lies within the surroundings: each mm in the direction of rolling has the same damage.
    seen = overrolled(smooth, nh.patch.Dent(depth=1e-9, diameter=0.3), body="b", cell=cell, reach=6.0)
    for each in models:
        rolled = seen.density(each, dented=False).mean(axis=0).sum() * (seen.y[1] - seen.y[0])
        assert rolled == pytest.approx(exposure(smooth, body="b").damage(each), rel=0.01)


@pytest.mark.slow
def test_the_excess_is_that_of_point_loads_summed_at_every_point(smooth, found):
    """Own positions, own cells, own depths: Boussinesq's point loads in the middles of cells, and midpoint sums."""
    models = [VolumeModel(name, name, 4.0, 0.0, 1.0, 0.0, "none") for name in ("orthogonal_shear", "shear")]
    b = smooth.max_half_width
    within, step, deep = 0.24 + 0.5 * b, 0.125 * b, 0.2 * b
    options = {"cells": (31, 81), "region": ((-1.3 * b, 1.3 * b), (-0.85, 0.85)), "tilt": 0.0}
    alone = nh.patch.solve(smooth.contact, load=300.0, **options)
    x, y = (each[np.abs(each) <= within] for each in (found.x, found.y))
    weight = np.where(x[x > -1e-9] < 1e-9, 1.0, 2.0)[:, None, None]
    points = np.stack(np.meshgrid(x[x > -1e-9], y, deep * (np.arange(10) + 0.5), indexing="ij"), axis=-1)
    histories = []
    for at in step * np.arange(-math.ceil((within + 1.5 * b) / step), math.ceil(1.5 * b / step)):
        seen = [criteria(alone, points.reshape(-1, 3) + np.array([at, 0.0, 0.0]))] * 2
        if abs(at) < 0.24 + 1.05 * b:
            moved = replace(DENT, x=float(at))
            dented = nh.patch.solve(smooth.contact, approach=alone.approach, features=moved, **options)
            seen[0] = criteria(dented, points.reshape(-1, 3) + np.array([at, 0.0, 0.0]))
        histories.append(seen)
    direct = np.array(histories)  # shape (stations, dented and smooth, criteria, points)
    volume = (x[1] - x[0]) * (y[1] - y[0]) * deep
    for each, levels in zip(models, (0.5 * np.ptp(direct[:, :, 0], axis=0), direct[:, :, 1].max(axis=0)), strict=True):
        added = volume * weight * (levels[0] ** 4 - levels[1] ** 4).reshape(points.shape[:3])
        # Of the orthogonal shear gains and losses nearly cancel, so each is held to their sum without signs.
        assert found.excess(each, within=within) == pytest.approx(added.sum(), abs=0.03 * np.abs(added).sum())


def criteria(solution, points):
    """Return tau_xz and the maximum shear stress at points, shape (points,) each, by Boussinesq (Johnson 3.19).

    Cells count as point loads at their four Gauss points.
    """
    i, j = np.nonzero(solution.pressure)
    gauss = 0.5 / math.sqrt(3.0) * np.array([[-1, -1], [-1, 1], [1, -1], [1, 1]]) * [solution.dx, solution.dy]
    of_loads = (np.column_stack([solution.x[i], solution.y[j]])[:, None] + gauss).reshape(-1, 2)
    force = np.repeat(solution.pressure[i, j], 4) * solution.dx * solution.dy / (8.0 * math.pi)
    total, nu = np.zeros((len(points), 3, 3)), 0.3
    for at in range(0, len(points), 200):
        (x, y), z = np.moveaxis(points[at : at + 200, None, :2] - of_loads, -1, 0), points[at : at + 200, 2:]
        r = np.sqrt(x**2 + y**2 + z**2)
        cube = r * r * r  # a power of three or more takes ten times as long
        along = -3.0 * z / (cube * r * r) * force
        round_ = (1.0 - 2.0 * nu) * (2.0 * r + z) / (cube * (r + z) ** 2) * force
        even = (1.0 - 2.0 * nu) * np.sum((z / cube - 1.0 / (r * (r + z))) * force, axis=1)
        part = total[at : at + 200]
        part[:, 0, 0] = even + np.sum((along + round_) * x**2, axis=1)
        part[:, 1, 1] = even + np.sum((along + round_) * y**2, axis=1)
        part[:, 1, 0] = np.sum((along + round_) * x * y, axis=1)
        part[:, 2, 0], part[:, 2, 1] = z[:, 0] * np.sum(along * x, axis=1), z[:, 0] * np.sum(along * y, axis=1)
        part[:, 2, 2] = z[:, 0] ** 2 * np.sum(along, axis=1)
    principal = np.linalg.eigvalsh(total)  # of the lower triangle
    return total[:, 2, 0], 0.5 * (principal[:, 2] - principal[:, 0])


# Whether they have converged


@pytest.mark.slow
def test_the_excess_converges_with_the_surroundings(found):
    rim, b = 0.24, float(found.z[-1] / 4.0)
    for each in (zaretsky(), weibull(stress="von_mises")):
        whole = found.excess(each)
        assert found.excess(each, rim + b) == pytest.approx(whole, rel=0.03)
        assert found.excess(each, rim + 1.5 * b) == pytest.approx(whole, rel=0.01)


@pytest.mark.slow
def test_where_a_dent_begins_to_roll_does_not_matter(smooth, found):
    other = overrolled(smooth, replace(DENT, x=0.4 * COARSE), body="b", cell=COARSE, reach=2.0)
    np.testing.assert_allclose(np.diff(other.positions), other.positions[-1] / (other.positions.size // 2), rtol=1e-12)
    for each in (lundberg_palmgren(), zaretsky()):
        assert other.excess(each) == found.excess(each)


@pytest.mark.slow
def test_cells_hardly_matter_to_maximum_shear_and_coarse_ones_are_warned_of(smooth, found):
    (sentence,) = [
        each for each in found.warnings if each.startswith("Cells of 0.02 mm are coarser than the usual 0.0")
    ]
    assert "with orthogonal shear" in sentence
    each, other = zaretsky(), overrolled(smooth, DENT, body="b", cell=0.75 * COARSE, reach=2.0)
    assert other.excess(each) == pytest.approx(found.excess(each), rel=0.05)
    assert other.relative_life(each, per_area=0.1) == pytest.approx(found.relative_life(each, per_area=0.1), rel=0.01)


@pytest.mark.slow
def test_the_example_ranks_its_dents_by_their_shoulders(tmp_path, capsys):
    path = Path(__file__).parents[2] / "examples" / "overrolled-dent.py"
    example = runpy.run_path(str(path))
    tried = example["main"](tmp_path, cell=0.035)
    lives = [each.relative_life(zaretsky(), per_area=0.1) for each in tried]
    assert 1.0 > lives[0] > lives[1] > lives[2] > lives[3] > 0.8
    assert len(capsys.readouterr().out.splitlines()) == 5
    assert (tmp_path / "overrolled-dent.svg").stat().st_size > 10_000
