"""Rollers in balance: sums by hand, derivatives, and convergence from any start."""

from collections import Counter

import numpy as np
import pytest
from numpy.testing import assert_allclose

from nonhertz.bearing.equilibrium import Joint, System, solve_balance
from nonhertz.bearing.laws import Slices
from nonhertz.bearing.section import point_motion, raceway_motion, ring_motion
from nonhertz.native import core

ALL, RADIAL = np.ones(5, dtype=bool), np.array([False, True, True, False, False])


def system(rollers=14, angles=(0.0, 0.0), gap=0.0, crown=400.0, load=(0.0, 0.0, 0.0), rib=False):
    y = np.linspace(-4.8, 4.8, 31)
    law = Slices(y, y**2 / (2.0 * crown), 20e3)
    gaps = np.full(rollers, gap)
    joints = [
        Joint(True, raceway_motion(angles[0], inner=True), gaps, law, 0),
        Joint(False, raceway_motion(angles[1], inner=False), gaps, law, 1),
    ]
    if rib:
        joints.append(
            Joint(
                True,
                point_motion((0.99, -0.14), (5.0, 2.0)),
                np.zeros(rollers),
                Slices(np.zeros(1), np.zeros(1), 2e5, 1.5),
                2,
            )
        )
    at = 2.0 * np.pi * np.arange(rollers) / rollers
    return System(ring_motion(at, (0.0, 32.5)), tuple(joints), np.tile(load, (rollers, 1)), 5.0)


def answer(law, approach, tilt):
    """Load and moment of a contact."""
    loads = law.loads(np.array([approach]), np.array([tilt]))[0]
    return loads.sum(), loads @ law.y


def by_hand(system, states, k):
    """Forces on the inner ring, and what is left of the balance of the rollers, summed one by one."""
    total, left = np.zeros(5), []
    for j in range(system.rollers):
        motion = states.motion[k, j]
        moved = system.ring[j] @ states.ring[k]
        on_roller = system.load[j]
        for joint in system.joints:
            approach, tilt = joint.motion @ ((moved if joint.inner else 0.0) - motion)
            load, moment = answer(joint.law, approach - joint.gap[j], tilt)
            force = load * joint.motion[0] + moment * joint.motion[1]
            on_roller = on_roller + force
            if joint.inner:
                total += system.ring[j].T @ force
        left.append(on_roller)
    return total, np.array(left)


CASES = {
    "clearance": system(gap=0.01),
    "preload": system(gap=-0.004),
    "speed": system(gap=0.01, load=(0.0, 150.0, 20.0)),
    "tapered": system(angles=(0.14, 0.21), rib=True),
    "preloaded taper": system(angles=(0.14, 0.21), gap=-0.004, rib=True),
}


@pytest.mark.parametrize("name", CASES)
def test_forces_and_rollers_are_in_balance(name):
    rollers = CASES[name]
    by_force = ALL if rollers.joints[0].motion[0, 0] else RADIAL
    target = np.array([[9e3, 6e3, -8e3, 2e4, -1e4], [4e2, 1e2, 3e2, 0.0, 1e3]])
    if not by_force[0]:
        target[:, 0] = 0.0
        target[:, 3:] = [[1e-3, -5e-4], [0.0, 2e-4]]
    states = solve_balance(rollers, by_force, target, np.zeros((2, 5)), 0.01)
    assert np.all(states.residual < 1e-9)
    for k in range(2):
        total, left = by_hand(rollers, states, k)
        assert_allclose(total, states.force[k], rtol=1e-9, atol=1e-6)
        assert_allclose(total[by_force], target[k, by_force], rtol=1e-8, atol=1e-8 * 1e4 * 30.0)
        assert np.abs(left).max() < 1e-8 * 1e4


@pytest.mark.parametrize("name", CASES)
def test_near_the_balance_ring_and_rollers_step_together(name):
    """Quadratically, from 2 % less load; where rollers only follow the ring it takes up to seven steps."""
    rollers = CASES[name]
    by_force = ALL if rollers.joints[0].motion[0, 0] else RADIAL
    target = np.array([[9e3, 6e3, -8e3, 2e4, -1e4]]) if by_force[0] else np.array([[0.0, 6e3, -8e3, 1e-3, -5e-4]])
    begun = solve_balance(rollers, by_force, target, np.zeros((1, 5)), 0.01)
    found = solve_balance(
        rollers, by_force, np.where(by_force, 1.02, 1.0) * target, begun.ring, 0.01, motion=begun.motion
    )
    assert found.residual[0] < 1e-9
    assert found.steps[0] <= 3


@pytest.mark.parametrize("name", CASES)
def test_stiffness_is_the_derivative_of_the_forces(name):
    rollers = CASES[name]
    ring = np.array([0.02, 0.033, -0.01, 2e-4, -3e-4])
    ring[0] *= rollers.joints[0].motion[0, 0] != 0.0
    held = np.zeros(5, dtype=bool)

    def at(moved):
        return solve_balance(rollers, held, moved[None], np.zeros((1, 5)), 0.01)

    steps = np.diag([1e-6, 1e-6, 1e-6, 1e-7, 1e-7])
    found = [(at(ring + step).force[0] - at(ring - step).force[0]) / (2.0 * step.sum()) for step in steps]
    stiffness = at(ring).stiffness[0]
    assert_allclose(np.transpose(found), stiffness, rtol=2e-5, atol=2e-6 * np.abs(stiffness).max())
    # Slices and points store energy.
    assert_allclose(stiffness, stiffness.T, rtol=1e-9, atol=1e-9 * np.abs(stiffness).max())


@pytest.mark.parametrize("seed", range(60))
def test_random_bearings_come_to_a_balance(seed):
    rng = np.random.default_rng(seed)
    outer = rng.choice([0.0, rng.uniform(0.1, 0.6)])
    rib = outer > 0.0
    inner = outer - rng.uniform(0.02, 0.08) * rib
    speed = rng.choice([0.0, 1.0]) * 10.0 ** rng.uniform(0.0, 3.0) * np.array([0.0, 1.0, rng.uniform(-1.0, 1.0) * rib])
    gap = rng.choice([0.0, 0.01, 0.03, -0.005])
    rollers = system(rng.integers(5, 40), (inner, outer), gap, 10.0 ** rng.uniform(2.0, 5.0), speed, rib)
    load = 10.0 ** rng.uniform(0.0, 5.5)
    radial = load * rng.normal(size=2)
    by_force = RADIAL | np.array([rib, False, False, False, False])
    # Less than that of one roller that bears all, and what speed presses against the ribs, and a row falls apart.
    axial = np.tan(outer) * (1.1 * np.hypot(*radial) + 1.5 * rollers.rollers * speed[1]) * rng.uniform(1.0, 5.0)
    target = np.array([[axial, *radial, *rng.uniform(-2e-3, 2e-3, 2)]])
    states = solve_balance(rollers, by_force, target, np.zeros((1, 5)), 0.01)
    assert states.residual[0] < 1e-9
    assert states.steps[0] < 40
    total, left = by_hand(rollers, states, 0)
    size = np.sum(np.abs(states.load)) + np.abs(speed).max()
    assert np.all(np.abs(total - target[0])[by_force] < 1e-8 * size)
    assert np.abs(left[:, :2]).max() < 1e-8 * size


def test_a_roller_that_touches_nothing_bears_nothing():
    states = solve_balance(CASES["clearance"], RADIAL, np.array([[0.0, 5e3, 0.0, 0.0, 0.0]]), np.zeros((1, 5)), 0.01)
    load = states.load[0]
    assert load[7].max() < 1e-9 * load.max()
    assert load[0, 0] == pytest.approx(load[0, 1], rel=1e-8)


def test_laws_without_a_balance_are_asked_a_hundred_times_at_most():
    times = Counter()

    def jumping(rollers, pose):
        """Contacts that bear 100 N or nothing."""
        times.update(rollers.tolist())
        found = np.zeros((*pose.shape[:2], 7))
        found[..., 0], found[..., 2], found[..., 6] = 100.0 * (pose[..., 0] > 0.0), 1e4, pose[..., 0]
        return found

    law = core.PythonLaw(jumping)
    joints = [
        Joint(inner, raceway_motion(0.0, inner=inner), np.zeros(8), law, int(not inner)) for inner in (True, False)
    ]
    rollers = System(ring_motion(np.pi / 4.0 * np.arange(8), (0.0, 30.0)), tuple(joints), np.zeros((8, 3)), 5.0)
    states = solve_balance(rollers, RADIAL, np.array([[0.0, 150.0, 0.0, 0.0, 0.0]]), np.zeros((1, 5)), 0.01)
    assert states.residual[0] > 1e-9
    assert max(times.values()) == 100


def test_a_search_that_is_stopped_returns_nothing():
    stop, held = core.Stop(), [False] * 5
    ring = np.array([[0.0, 0.02, 0.0, 0.0, 0.0]])
    given = CASES["clearance"].assembly, held, 0.01, 1e-9, 80, ring, ring, np.full((14, 3), np.nan), 1
    assert core.balance(*given, stop=stop) is not None
    stop.set()
    assert core.balance(*given, stop=stop) is None


def test_what_a_law_raises_passes_through_the_search():
    def failing(rollers, pose):
        raise LookupError("no answer")

    joints = [Joint(True, raceway_motion(0.0, inner=True), np.zeros(8), core.PythonLaw(failing), 0)]
    rollers = System(ring_motion(np.pi / 4.0 * np.arange(8), (0.0, 30.0)), tuple(joints), np.zeros((8, 3)), 5.0)
    with pytest.raises(LookupError, match="no answer"):
        solve_balance(rollers, RADIAL, np.array([[0.0, 150.0, 0.0, 0.0, 0.0]]), np.zeros((1, 5)), 0.01)
