"""The balance of a loaded bearing, summed as vectors in space: apart from how the balance is found."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from claims.claim import Array
from nonhertz.bearing import BearingSolution, RollerBearing, SphericalRollerBearing

_AXIS = np.array([1.0, 0.0, 0.0])


@dataclass(frozen=True, eq=False)
class SpaceSums:
    """What forces add up to: those of the rollers and ribs on the inner ring, about the origin."""

    loads: float  # N, all of them without their directions
    reach: float  # mm, how far from the middle of the bearing they act
    force: Array  # N, shape (3,)
    moment: Array  # N mm, shape (3,)
    # What is left of the balance of the roller that is farthest from it, over all loads: of its forces, or of its
    # moments over its length.
    rollers_left: float

    def off(self, force: Array) -> Array:
        """Return by how much forces and moments (x, y, z; y, z) on the ring differ from those given, over all loads."""
        found = np.concatenate([self.force, self.moment[1:]])
        return np.asarray((found - force) / self.loads / np.array([1.0, 1.0, 1.0, self.reach, self.reach]))


def sums_in_space(solution: BearingSolution) -> SpaceSums:
    """Return the sums over all contacts of a bearing."""
    loads = float(np.sum(np.abs(solution.load)) + np.sum(np.abs(solution.roller_load[:, :2])))
    force, moment = np.zeros(3), np.zeros(3)
    left, reach = 0.0, 0.0
    for number, row in enumerate(solution.bearing.rows):
        reach = max(reach, abs(row.x) + 0.5 * row.bearing.pitch)
        these = solution.rollers_of(number)
        axis = -_AXIS if row.turned else _AXIS
        for j in range(these.start, these.stop):
            radial = np.array([0.0, np.cos(solution.angle[j]), np.sin(solution.angle[j])])
            place = row.x * _AXIS + 0.5 * row.bearing.pitch * radial
            on_ring, about_middle, alone = _of_roller(solution, row.bearing, j, axis, radial)
            force += on_ring
            moment += np.cross(place, on_ring) + about_middle
            left = max(left, alone)
    return SpaceSums(loads, reach, force, moment, left / loads)


def _of_roller(
    solution: BearingSolution, bearing: RollerBearing, j: int, axis: Array, radial: Array
) -> tuple[Array, Array, float]:
    """Return force and moment about a roller's middle on the inner ring, and what is left of its own balance [N].

    ``axis`` is x of the roller's row.
    """
    stripped = solution.method == "strips"
    angles = bearing.contact_angles if stripped else (bearing.nominal_angle,) * 2
    barrel = bearing.profile_radius if isinstance(bearing, SphericalRollerBearing) else np.inf
    by_speed = solution.roller_load[j]
    on_roller, turning = by_speed[0] * axis + by_speed[1] * radial, np.zeros(3)
    on_ring, about_middle = np.zeros(3), np.zeros(3)
    if stripped:
        turning = by_speed[2] * np.cross(axis, radial)
    for k, sign in enumerate((1.0, -1.0)):
        normal = sign * (np.sin(angles[k]) * axis + np.cos(angles[k]) * radial)
        along = np.cos(angles[k]) * axis - np.sin(angles[k]) * radial
        place = -0.5 * bearing.roller_diameter * normal
        force = solution.load[j, k] * normal - solution.moment[j, k] / barrel * along
        couple = np.cross(place, force) + solution.moment[j, k] * np.cross(along, normal)
        on_roller, turning = on_roller + force, turning + couple
        if k == 0:
            on_ring, about_middle = on_ring + force, about_middle + couple
    # By slices tapered rows have no ribs.
    for rib, load in zip(bearing.rib_contacts, solution.each_rib_load[j].tolist(), strict=False):
        normal_x, normal_r, arm = rib.motion[0]
        force = load * (normal_x * axis + normal_r * radial)
        couple = load * arm * np.cross(axis, radial)
        on_roller, turning = on_roller + force, turning + couple
        if rib.ring == "inner":
            on_ring, about_middle = on_ring + force, about_middle + couple
    # Slices hold no roller along its axis.
    held = np.sin(angles[1]) * axis + np.cos(angles[1]) * radial
    left = on_roller if stripped else (on_roller @ held) * held
    alone = max(np.linalg.norm(left), np.linalg.norm(turning) / bearing.roller_length)
    return on_ring, about_middle, float(alone)
