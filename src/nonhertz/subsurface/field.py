"""The stress at points below a contact: a read-only value with derived quantities."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from nonhertz.findings import Finding, HasFindings
from nonhertz.model.body import BodyName
from nonhertz.result.read_only import ReadOnly, freeze

Array = NDArray[np.float64]

SIGMA_X, SIGMA_Y, SIGMA_Z, TAU_YZ, TAU_XZ, TAU_XY = range(6)


@dataclass(frozen=True, eq=False, repr=False)
class Field(HasFindings, ReadOnly):
    """Stress, and displacement if requested, at points inside one body of a solved contact.

    Attributes
    ----------
    body : {"a", "b"}
        ``"a"`` or ``"b"``, the body that the points lie in.
    x, y, z : ndarray, shape (...)
        The points [mm]: across, along, and below the surface.
    stress : ndarray, shape (..., 6)
        sigma_x, sigma_y, sigma_z, tau_yz, tau_xz, tau_xy [MPa]; compressive stress is negative.
    displacement : ndarray, shape (..., 3), or None
        u_x, u_y, u_z [mm], u_z into the body. u_z has the same reference as the approach: the point at the body's depth
        under the same y, or one far away.
    findings : tuple of Finding
        Effects that the numbers leave out; empty if none.

    Notes
    -----
    Values are NaN where the body has no material: in a bore, below its thickness or beyond its diameter.

    Axes are those of the contact, with z pointing into the body for both bodies, so that their fields are mirror images
    of each other.
    """

    body: BodyName
    x: Array
    y: Array
    z: Array
    stress: Array
    displacement: Array | None = None
    findings: tuple[Finding, ...] = ()

    @property
    def shape(self) -> tuple[int, ...]:
        """Shape of the points."""
        return self.x.shape

    @property
    def sigma_x(self) -> Array:
        """Normal stress across, in the direction of rolling [MPa]."""
        return self.stress[..., SIGMA_X]

    @property
    def sigma_y(self) -> Array:
        """Normal stress along the contact [MPa]."""
        return self.stress[..., SIGMA_Y]

    @property
    def sigma_z(self) -> Array:
        """Normal stress towards the surface [MPa]; on the surface minus the pressure."""
        return self.stress[..., SIGMA_Z]

    @property
    def tau_yz(self) -> Array:
        """Shear stress in the plane along the contact [MPa]."""
        return self.stress[..., TAU_YZ]

    @property
    def tau_xz(self) -> Array:
        """Shear stress in the plane of rolling, parallel to the surface [MPa]: the orthogonal shear stress."""
        return self.stress[..., TAU_XZ]

    @property
    def tau_xy(self) -> Array:
        """Shear stress in planes parallel to the surface [MPa]."""
        return self.stress[..., TAU_XY]

    @cached_property
    def tensor(self) -> Array:
        """The stress as symmetric matrices [MPa], shape (..., 3, 3)."""
        return freeze(as_tensor(self.stress))

    @cached_property
    def principal(self) -> Array:
        """Principal stresses [MPa], the largest first, shape (..., 3)."""
        return freeze(principal_of(self.stress))

    @cached_property
    def von_mises(self) -> Array:
        """Von Mises equivalent stress [MPa]."""
        return freeze(np.asarray(von_mises_of(self.stress)))

    @cached_property
    def max_shear(self) -> Array:
        """Maximum shear stress, half the difference of the largest and smallest principal stress [MPa]."""
        return freeze(np.asarray(0.5 * (self.principal[..., 0] - self.principal[..., 2])))


def as_tensor(stress: Array) -> Array:
    """Return six components (..., 6) as symmetric matrices (..., 3, 3)."""
    rows = [[SIGMA_X, TAU_XY, TAU_XZ], [TAU_XY, SIGMA_Y, TAU_YZ], [TAU_XZ, TAU_YZ, SIGMA_Z]]
    return stress[..., rows]


def principal_of(stress: Array) -> Array:
    """Return the principal stresses of six components (..., 6), the largest first, shape (..., 3)."""
    known = np.isfinite(stress).all(axis=-1, keepdims=True)  # LAPACK refuses NaN
    values = np.linalg.eigvalsh(as_tensor(np.where(known, stress, 0.0)))[..., ::-1]
    return np.where(known, values, np.nan).astype(np.float64, copy=False)


def von_mises_of(stress: Array) -> Array:
    """Return the von Mises stress of six components (..., 6)."""
    s_x, s_y, s_z, t_yz, t_xz, t_xy = np.moveaxis(stress, -1, 0)
    normal = (s_x - s_y) ** 2 + (s_y - s_z) ** 2 + (s_z - s_x) ** 2
    von_mises: Array = np.sqrt(0.5 * normal + 3.0 * (t_yz**2 + t_xz**2 + t_xy**2))
    return von_mises


def max_shear_of(stress: Array) -> Array:
    """Return the maximum shear stress of six components (..., 6)."""
    principal = principal_of(stress)
    shear: Array = 0.5 * (principal[..., 0] - principal[..., 2])
    return shear


def orthogonal_shear_of(stress: Array) -> Array:
    """Return |tau_xz| of six components (..., 6)."""
    return np.abs(stress[..., TAU_XZ])
