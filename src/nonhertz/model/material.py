"""Linear elastic, isotropic materials, and their strength as far as it is known."""

from __future__ import annotations

import math
import re
from typing import Annotated, Final

from nonhertz.amounts import mpa
from nonhertz.errors import InputError
from nonhertz.findings import finding, warn
from nonhertz.inputs.checks import finite, positive
from nonhertz.inputs.descriptions import Quantity, Word
from nonhertz.inputs.fields import Input, input_class

#: Scales of hardness, each with the range in which its test is made: ISO 6507, 6508 and 6506.
SCALES: Final = {"HV": (1.0, 3000.0), "HRC": (20.0, 70.0), "HBW": (1.0, 650.0)}
_HARDNESS: Final = re.compile(r"(\d+(?:\.\d+)?) ?(HV|HRC|HBW)")
_HARDNESS_REMEDY: Final = "write a number and its scale such as '60 HRC', '700 HV' or '280 HBW', or leave it out"
_STRENGTH_REMEDY: Final = "give the stress in MPa, or leave it out where it is not known"
#: Young's moduli of steels [MPa].
STEEL_MODULUS: Final = 195e3, 220e3
_STEEL_HARDNESS: Final = {"HV": (650.0, 1000.0), "HRC": (58.0, 70.0), "HBW": (600.0, 650.0)}
# No metal, ceramic or solid polymer has both a modulus and a Poisson's ratio below these; metals and ceramics have if
# the modulus is in GPa. Rubber has 0.49, polyethylene 0.45.
_SOFT: Final = 1000.0, 0.4
_IN_GPA: Final = (
    "A modulus of {modulus:g} with a Poisson's ratio of {poisson:g} is plausible only for cork or foam: "
    "give the modulus in MPa, 207000 for steel."
)
_SQRT_3: Final = math.sqrt(3.0)


def _read_hardness(name: str, hardness: object, remedy: str) -> str:
    """Return a hardness as number, space and scale."""
    match = _HARDNESS.fullmatch(hardness.strip()) if isinstance(hardness, str) else None
    if match is None:
        raise InputError(name, hardness, "be a number with its scale, HV, HRC or HBW", remedy)
    number, scale = match.groups()
    low, high = SCALES[scale]
    if not low <= float(number) <= high:
        raise InputError(name, hardness, f"lie between {low:g} and {high:g} {scale}", remedy)
    return f"{number} {scale}"


def check_poisson(name: str, poisson: float, remedy: str = "give Poisson's ratio, 0.3 for steel") -> None:
    """Refuse a Poisson's ratio that no elastic material has."""
    finite(name, poisson, remedy)
    if not -1.0 < poisson <= 0.5:
        raise InputError(name, poisson, "lie in (-1, 0.5]", remedy)


@input_class()
class Material(Input):
    """A linear elastic, isotropic material, and its strength.

    Raises
    ------
    InputError
        If a value is not finite or outside its range.

    Warns
    -----
    AccuracyWarning
        If the modulus seems to be in GPa.

    Notes
    -----
    Strength does not change the deformation: contacts are solved as elastic. `nonhertz.strength.assess` compares
    solutions with the strength.

    Examples
    --------
    >>> steel = Material(modulus=207000, poisson=0.3)
    >>> round(steel.shear_modulus)
    79615
    >>> Material(modulus=207000, poisson=0.3, yield_strength=1800, hardness="60 HRC")
    Material(modulus=207000, poisson=0.3, yield_strength=1800, hardness='60 HRC')
    """

    modulus: Annotated[
        float, Quantity("MPa", "Young's modulus", positive, "give Young's modulus in MPa, 207000 for steel")
    ]
    poisson: Annotated[
        float, Quantity("", "Poisson's ratio, in (-1, 0.5]", check_poisson, "give Poisson's ratio, 0.3 for steel")
    ]
    yield_strength: Annotated[
        float | None,
        Quantity(
            "MPa",
            "yield strength or 0.2 % proof strength; for a case-hardened body that of the case",
            positive,
            _STRENGTH_REMEDY,
        ),
    ] = None
    core_yield_strength: Annotated[
        float | None,
        Quantity("MPa", "yield strength of the core below a hardened case", positive, _STRENGTH_REMEDY),
    ] = None
    hardness: Annotated[
        str | None,
        Word(
            "hardness at the surface with its scale, HV, HRC or HBW; shown, not computed with",
            _HARDNESS_REMEDY,
            condition=_read_hardness,
        ),
    ] = None
    pressure_limit: Annotated[
        float | None,
        Quantity(
            "MPa",
            "maximum pressure of a contact at rest; 4000 MPa in roller bearings by ISO 76",
            positive,
            _STRENGTH_REMEDY,
        ),
    ] = None

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.modulus < _SOFT[0] and self.poisson < _SOFT[1]:
            # Four calls up: two constructors, of inputs and of the dataclass, lie between this line and the user's.
            warn([finding("modulus-in-gpa", _IN_GPA, modulus=mpa(self.modulus), poisson=self.poisson)], stacklevel=4)

    @property
    def shear_modulus(self) -> float:
        """Shear modulus G = E / (2 (1 + nu)) [MPa]."""
        return self.modulus / (2.0 * (1.0 + self.poisson))

    @property
    def compliance(self) -> float:
        """Half-space compliance K = (1 - nu^2) / (pi E) [1/MPa]."""
        return (1.0 - self.poisson**2) / (math.pi * self.modulus)

    @property
    def shear_yield_strength(self) -> float | None:
        """Yield strength in pure shear k = Y / sqrt(3) [MPa], by the criterion of von Mises; None without Y."""
        return None if self.yield_strength is None else self.yield_strength / _SQRT_3


def is_steel(material: Material) -> bool:
    """Return whether a material is as stiff as bearing steel and, if its hardness is known, as hard.

    ISO 281 applies to hardened steel of 58 HRC and more; ceramics as stiff as steel are harder.
    """
    if not STEEL_MODULUS[0] <= material.modulus <= STEEL_MODULUS[1]:
        return False
    number, scale = (material.hardness or "60 HRC").split(" ")
    low, high = _STEEL_HARDNESS[scale]
    return low <= float(number) <= high


#: Handbook values of steel at room temperature, of no particular grade.
STEEL = Material(modulus=207000.0, poisson=0.3)
