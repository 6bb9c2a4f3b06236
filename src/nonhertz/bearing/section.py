"""Where a roller touches its rings in the plane through the bearing's axis, and how motions become approaches.

In this plane a place has the axial coordinate x and the radius r; a rotation by theta turns x towards r. A ring or a
roller moves in it by ``(u_x, u_r, theta)``, given at the middle of the roller. The bearing's axis is x, and angles go
from y to z. An inner ring that moves by ``(x, y, z)`` and turns by ``(about_y, about_z)`` moves, where the roller at
the angle phi is, by

    u_x = x + r (about_y sin phi - about_z cos phi)
    u_r = (y + about_z x_0) cos phi + (z - about_y x_0) sin phi
    theta = about_z cos phi - about_y sin phi

with (x_0, r) the middle of the roller. A contact has a normal n from the ring into the roller and a line along which
the roller touches, t, towards high x. Where ring and roller move against each other by (w_x, w_r, omega), approach and
tilt of the contact are

    approach = n . w + omega n . J rho        tilt = omega n . J t        J (a, b) = (-b, a)

rho being the place of the contact from the roller's middle. Loads and moments follow from them as the transpose says.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
RINGS = ("inner", "outer")
#: Motions of the inner ring, along x, y and z and about y and z, with their units; what they are called beside others;
#: and the forces and moments that go with them.
MOTIONS = {"x": "mm", "y": "mm", "z": "mm", "about_y": "rad", "about_z": "rad"}
DISPLACEMENTS = {
    "displacement_x": "mm", "displacement_y": "mm", "displacement_z": "mm", "tilt_y": "rad", "tilt_z": "rad",
}  # fmt: skip
FORCES = {"force_x": "N", "force_y": "N", "force_z": "N", "moment_y": "N mm", "moment_z": "N mm"}


def ring_motion(angles: Array, middle: tuple[float, float]) -> Array:
    """Return what motions of a ring are at rollers, shape (rollers, 3, 5).

    Parameters
    ----------
    angles : ndarray, shape (rollers,)
        Where the rollers are [rad].
    middle : tuple of float
        Axial coordinate and radius of the rollers' middles [mm].
    """
    x, r = middle
    c, s, zero, one = np.cos(angles), np.sin(angles), np.zeros(angles.size), np.ones(angles.size)
    rows = [[one, zero, zero, r * s, -r * c], [zero, c, s, -x * s, x * c], [zero, zero, zero, -s, c]]
    return np.ascontiguousarray(np.array(rows).transpose(2, 0, 1))


def raceway_motion(
    contact_angle: float, *, inner: bool, roller_radius: float = 0.0, profile_radius: float = math.inf
) -> Array:
    """Return approach and tilt of a raceway contact per motion of ring against roller, shape (2, 3).

    The normal at the middle of the contact goes through the middle of the roller. Where the contact angle is not zero,
    the inner ring is pressed against the rollers by a load along +x.

    Parameters
    ----------
    contact_angle : float
        Between the normal and the radial plane [rad].
    inner : bool
        Whether it is the inner ring.
    roller_radius : float
        Radius of the roller in its middle [mm].
    profile_radius : float
        Of a barrel's surface along the roller [mm]: where it shifts along the ring, another part of it comes to lie
        there, as if it had been tilted by the shift over this radius.
    """
    # Of the outer ring n, and with it n . J t, has the other sign.
    sign, s, c = 1.0 if inner else -1.0, math.sin(contact_angle), math.cos(contact_angle)
    shift = np.array([c, -s, sign * roller_radius])
    return np.array([[sign * s, sign * c, 0.0], np.array([0.0, 0.0, sign]) - shift / profile_radius])


def point_motion(normal: Sequence[float], place: Sequence[float]) -> Array:
    """Return the same of a contact in one point, at a place from the roller's middle; it has no tilt."""
    (n_x, n_r), (x, r) = normal, place
    return np.array([[n_x, n_r, n_r * x - n_x * r], [0.0, 0.0, 0.0]])
