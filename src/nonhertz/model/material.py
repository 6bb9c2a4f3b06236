"""Linear elastic, isotropic materials."""

from __future__ import annotations

import math
from dataclasses import dataclass

from nonhertz.errors import InputError
from nonhertz.inputs.checks import finite, positive


@dataclass(frozen=True)
class Material:
    """A linear elastic, isotropic material.

    Parameters
    ----------
    modulus : float
        Young's modulus E [MPa], positive.
    poisson : float
        Poisson's ratio nu [-], in (-1, 0.5].

    Raises
    ------
    InputError
        If a value is not finite or outside its range.

    Examples
    --------
    >>> steel = Material(modulus=207000, poisson=0.3)
    >>> round(steel.shear_modulus)
    79615
    """

    modulus: float
    poisson: float

    def __post_init__(self) -> None:
        positive("modulus", self.modulus, "give Young's modulus in MPa, 207000 for steel")
        check_poisson(self.poisson)

    @property
    def shear_modulus(self) -> float:
        """Shear modulus G = E / (2 (1 + nu)) [MPa]."""
        return self.modulus / (2.0 * (1.0 + self.poisson))

    @property
    def compliance(self) -> float:
        """Half-space compliance K = (1 - nu^2) / (pi E) [1/MPa]."""
        return (1.0 - self.poisson**2) / (math.pi * self.modulus)


def check_poisson(poisson: float) -> None:
    """Refuse a Poisson's ratio that no elastic material has."""
    remedy = "give Poisson's ratio, 0.3 for steel"
    finite("poisson", poisson, remedy)
    if not -1.0 < poisson <= 0.5:
        raise InputError("poisson", poisson, "lie in (-1, 0.5]", remedy)


# Handbook values at room temperature; a datasheet for the actual grade takes precedence.
STEEL = Material(modulus=207000.0, poisson=0.3)
SILICON_NITRIDE = Material(modulus=310000.0, poisson=0.26)
CAST_IRON = Material(modulus=110000.0, poisson=0.26)
BRONZE = Material(modulus=110000.0, poisson=0.34)
ALUMINIUM = Material(modulus=70000.0, poisson=0.33)

#: Materials that a case file may refer to by name.
MATERIALS = {
    "steel": STEEL,
    "silicon-nitride": SILICON_NITRIDE,
    "cast-iron": CAST_IRON,
    "bronze": BRONZE,
    "aluminium": ALUMINIUM,
}
