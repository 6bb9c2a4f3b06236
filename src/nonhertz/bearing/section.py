"""Contacts of a roller with its rings in the plane through the bearing's axis, and the kinematics of approach and tilt.

In this plane a point has the axial coordinate x and the radius r; a rotation by theta turns x towards r. A ring or a
roller moves by ``(u_x, u_r, theta)``, given at the centre of the roller. The bearing's axis is x, and angles run from y
to z. An inner ring that moves by ``(x, y, z)`` and turns by ``(about_y, about_z)`` moves at the roller at the angle
phi by

    u_x = x + r (about_y sin phi - about_z cos phi)
    u_r = (y + about_z x_0) cos phi + (z - about_y x_0) sin phi
    theta = about_z cos phi - about_y sin phi

with (x_0, r) the centre of the roller. A contact has a normal n from the ring into the roller and a line of contact t,
towards high x. For a motion (w_x, w_r, omega) of the ring relative to the roller, approach and tilt of the contact are

    approach = n . w + omega n . J rho        tilt = omega n . J t        J (a, b) = (-b, a)

rho being the position of the contact relative to the roller's centre. Loads and moments transform with the transpose.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
RINGS = ("inner", "outer")
#: Motions of the inner ring, along x, y and z and about y and z, with their units; their names among other quantities;
#: and the corresponding forces and moments.
MOTIONS = {"x": "mm", "y": "mm", "z": "mm", "about_y": "rad", "about_z": "rad"}
DISPLACEMENTS = {
    "displacement_x": "mm", "displacement_y": "mm", "displacement_z": "mm", "tilt_y": "rad", "tilt_z": "rad",
}  # fmt: skip
FORCES = {"force_x": "N", "force_y": "N", "force_z": "N", "moment_y": "N mm", "moment_z": "N mm"}


def ring_motion(angles: Array, middle: tuple[float, float]) -> Array:
    """Return the motion at each roller per motion of a ring, shape (rollers, 3, 5).

    Parameters
    ----------
    angles : ndarray, shape (rollers,)
        Angular positions of the rollers [rad].
    middle : tuple of float
        Axial coordinate and radius of the rollers' centres [mm].
    """
    x, r = middle
    c, s, zero, one = np.cos(angles), np.sin(angles), np.zeros(angles.size), np.ones(angles.size)
    rows = [[one, zero, zero, r * s, -r * c], [zero, c, s, -x * s, x * c], [zero, zero, zero, -s, c]]
    return np.ascontiguousarray(np.array(rows).transpose(2, 0, 1))


def raceway_motion(
    contact_angle: float, *, inner: bool, roller_radius: float = 0.0, profile_radius: float = math.inf
) -> Array:
    """Return approach and tilt of a raceway contact per motion of ring against roller, shape (2, 3).

    The normal at the middle of the contact passes through the centre of the roller. If the contact angle is not zero, a
    load along +x presses the inner ring against the rollers.

    Parameters
    ----------
    contact_angle : float
        Angle between the normal and the radial plane [rad].
    inner : bool
        Whether it is the inner ring.
    roller_radius : float
        Radius of the roller in its middle [mm].
    profile_radius : float
        Profile radius of a barrel along the roller [mm]: a shift along the ring brings another part of its surface into
        contact, as if it were tilted by the shift over this radius.
    """
    # For the outer ring n, and with it n . J t, has the opposite sign.
    sign, s, c = 1.0 if inner else -1.0, math.sin(contact_angle), math.cos(contact_angle)
    shift = np.array([c, -s, sign * roller_radius])
    return np.array([[sign * s, sign * c, 0.0], np.array([0.0, 0.0, sign]) - shift / profile_radius])


def point_motion(normal: Sequence[float], place: Sequence[float]) -> Array:
    """Return the same for a point contact, at a position relative to the roller's centre; it has no tilt."""
    (n_x, n_r), (x, r) = normal, place
    return np.array([[n_x, n_r, n_r * x - n_x * r], [0.0, 0.0, 0.0]])
