"""The oil in a bearing, or the base oil of its grease: viscosity, pressure coefficient, and cleanliness.

A grade of ISO 3448 gives the viscosity at 40 degC, and with a viscosity index that at 100 degC (ASTM D2270, ISO 2909);
`oil_viscosity` interpolates and extrapolates in temperature (ASTM D341). The coefficient alpha of exp(alpha p), by
which the viscosity grows with the pressure, is that of a mineral oil if none is given,

    alpha = s nu^t        s = 9.904 / GPa, t = 0.139, nu in mm^2/s

(Gold, Schmidt, Dicke, Loos, Assmann: Viscosity-pressure-temperature behaviour of mineral and synthetic oils, J. Synth.
Lubr. 18 (2001) 51; s and t as in a public program, contact_mechanics of P. Tayer).
"""

from __future__ import annotations

import math
import tomllib
from collections.abc import Mapping
from functools import cache, cached_property
from importlib.resources import files
from typing import Annotated, Any, ClassVar, Final

import numpy as np

from nonhertz.bearing.lubrication import CLEANLINESS, GUIDE, oil_viscosity
from nonhertz.errors import InputError
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.checks import number_that, positive
from nonhertz.inputs.descriptions import Flag, Quantities, Quantity, Word
from nonhertz.inputs.fields import Input, cross_check, input_class

_contamination = number_that(lambda value: value <= 1.0, "not exceed 1", positive)
_index = number_that(lambda value: value <= 200.0, "not exceed 200")
_VISCOSITY = "give the viscosity of the oil in the bearing in mm^2/s"
_OF_FILM: Final = "the film"
_MINERAL: Final = (9.904e-3, 0.139)  # s [1/MPa] and t


@cache
def _table() -> dict[str, Any]:
    return tomllib.loads(files(__package__).joinpath("oils.toml").read_text(encoding="utf-8"))


def _grade(name: str, value: str, remedy: str) -> str:
    """Return an oil by its grade, which may be written in lower case, without ISO or with other spaces."""
    grade = value.upper().replace("ISO", "").replace("VG", "").strip() if isinstance(value, str) else ""
    if grade not in _table()["grades"]:
        raise InputError(name, value, f"be a grade of ISO 3448, VG {', '.join(_table()['grades'])}", remedy)
    return f"ISO VG {grade}"


@cache
def viscosity_at_100(viscosity: float, index: float) -> float:
    """Return the viscosity of an oil at 100 degC [mm^2/s].

    Parameters
    ----------
    viscosity : float
        Viscosity at 40 degC [mm^2/s].
    index : float
        The viscosity index: 100 (L - U) / (L - H) up to 100, and beyond 100 + (10^N - 1) / 0.00715 with Y^N = H / U.

    Examples
    --------
    >>> round(viscosity_at_100(68.0, 95.0), 2), round(viscosity_at_100(220.0, 95.0), 1)
    (8.53, 18.7)
    """
    rows = np.array(_table()["viscosity_index"]["parabolas"], dtype=float)

    def at_40(thin: float) -> float:
        """Return the viscosity at 40 degC of the oil that has another one at 100 degC."""
        row = rows[max(int(np.searchsorted(rows[:, 0], thin, side="right")) - 1, 0)]
        low, high = (float(a * thin**2 + b * thin + c) for a, b, c in (row[1:4], row[4:]))
        if index > 100.0:
            return high / math.pow(thin, math.log10(1.0 + 0.00715 * (index - 100.0)))
        return low - 0.01 * index * (low - high)

    below, above = 0.1, viscosity
    for _ in range(60):
        middle = 0.5 * (below + above)
        below, above = (middle, above) if at_40(middle) < viscosity else (below, middle)
    return 0.5 * (below + above)


@input_class(kw_only=True)
class OilInPlace(Input):
    """Data of the oil for the life.

    Raises
    ------
    InputError
        If a value is out of range, or cleanliness or e_C are given without a viscosity.
    """

    viscosity: Annotated[
        float | None,
        Quantity(
            "mm^2/s",
            "viscosity of the oil at its temperature in the bearing, for a_ISO and films",
            positive,
            _VISCOSITY,
        ),
    ] = None
    contamination: Annotated[
        float | None,
        Quantity(
            "",
            "contamination factor e_C, above 0 and at most 1; if left out, that of the cleanliness",
            _contamination,
            "give e_C, above 0 and at most 1",
        ),
    ] = None
    cleanliness: Annotated[
        str | None,
        Word(
            "class of cleanliness for a_ISO: an ISO 4406 code with circulating oil, 'high', or a level of the guide of "
            "ISO 281, whose lower e_C is used; none is assumed",
            "choose one, or give contamination as a number",
            (*CLEANLINESS, *GUIDE),
        ),
    ] = None

    @cross_check("viscosity", "contamination", "cleanliness")
    def _check_oil(self) -> None:
        for name in ("contamination", "cleanliness"):
            value = getattr(self, name)
            if value is not None and not self._known:
                condition, remedy = "be given with a viscosity", "also give an oil or a viscosity, or leave it out"
                raise InputError(name, value, condition, remedy)

    @property
    def _known(self) -> bool:
        return self.viscosity is not None


@input_class(kw_only=True)
class Lubrication(OilInPlace):
    """The oil in a bearing, or the base oil of its grease.

    Raises
    ------
    InputError
        If a value is out of range or values are inconsistent.

    Examples
    --------
    >>> oil = Lubrication(oil="ISO VG 68", temperature=70.0)
    >>> round(oil.in_place.viscosity, 1), round(1e3 * oil.pressure_coefficient, 1)
    (19.9, 15.0)
    """

    instead: ClassVar[Mapping[str, str]] = {"oil": "viscosity"}
    apart: ClassVar[tuple[tuple[str, ...], ...]] = (("oil", "viscosities"), ("viscosity", "viscosities"))

    oil: Annotated[
        str | None,
        Word(
            "the oil by its grade, such as 'ISO VG 68', with its temperature",
            "give the viscosity in its place",
            (),
            _grade,
        ),
    ] = None
    temperature: Annotated[
        float | None,
        Quantity(
            "",
            "temperature of the oil in the bearing [degC]",
            number_that(lambda value: -60.0 <= value <= 250.0, "lie between -60 and 250 degC"),
            "give it in degC",
        ),
    ] = None
    viscosity_index: Annotated[
        float,
        Quantity(
            "", "viscosity index of an oil that is given by its grade", _index, "give it: 95 is usual for mineral oils"
        ),
        Assumed("viscosity index of 95", "the life and the film", lambda stated: stated.oil is not None),
    ] = 95.0
    viscosities: Annotated[
        tuple[float, ...] | None, Quantities("mm^2/s", "viscosities of the oil at two temperatures, such as [68, 8.7]")
    ] = None
    temperatures: Annotated[tuple[float, ...], Quantities("", "these two temperatures [degC]")] = (40.0, 100.0)
    density: Annotated[
        float,
        Quantity("t/mm^3", "density of the oil", positive, "give it in t/mm^3, 8.8e-10 for mineral oils"),
        Assumed("oil of 880 kg/m³", _OF_FILM, lambda stated: stated._known),
    ] = 8.8e-10
    pressure_viscosity: Annotated[
        float | None,
        Quantity(
            "1/MPa", "coefficient alpha by which the viscosity grows with the pressure", positive, "give it in 1/MPa"
        ),
        Assumed("alpha of a mineral oil", _OF_FILM, lambda stated: stated._known),
    ] = None
    grease: Annotated[
        bool,
        Flag("whether the oil is the base oil of a grease, whose films are assumed fully flooded"),
    ] = False

    @cross_check("oil", "viscosities", "temperature", "temperatures", "viscosity_index")
    def _check_temperature(self) -> None:
        if self.temperature is None and (self.oil or self.viscosities):
            raise InputError("temperature", None, "be given with an oil", "give that of the oil in the bearing in degC")
        _ = self._viscosity

    @cross_check("grease", "cleanliness")
    def _check_grease(self) -> None:
        if self.grease and str(self.cleanliness).startswith("-"):
            condition = f"be 'high' or one of {', '.join(map(repr, GUIDE))} for grease: codes apply to circulating oil"
            raise InputError(
                "cleanliness", self.cleanliness, condition, "choose one, or give contamination as a number"
            )

    @property
    def _known(self) -> bool:
        return any(entry is not None for entry in (self.viscosity, self.oil, self.viscosities))

    @cached_property
    def _viscosity(self) -> float | None:
        if self.temperature is None or (self.oil is None and self.viscosities is None):
            return self.viscosity
        viscosities, temperatures = self.viscosities, self.temperatures
        if self.oil is not None:
            thick = float(_table()["grades"][self.oil.rpartition(" ")[2]])
            viscosities, temperatures = (thick, viscosity_at_100(thick, self.viscosity_index)), (40.0, 100.0)
        return oil_viscosity(self.temperature, viscosities=viscosities, temperatures=temperatures)  # type: ignore[arg-type]

    @property
    def in_place(self) -> OilInPlace:
        """The oil at its temperature in the bearing, as keywords of `nonhertz.bearing.assess`."""
        return OilInPlace(viscosity=self._viscosity, contamination=self.contamination, cleanliness=self.cleanliness)

    @property
    def dynamic_viscosity(self) -> float | None:
        """Viscosity times density [MPa s]; None where the oil is not known."""
        viscosity = self._viscosity
        return None if viscosity is None else viscosity * self.density

    @property
    def pressure_coefficient(self) -> float | None:
        """Coefficient alpha, as given or that of a mineral oil [1/MPa]; None where the oil is not known."""
        viscosity, (s, t) = self._viscosity, _MINERAL
        if self.pressure_viscosity is not None or viscosity is None:
            return self.pressure_viscosity
        return float(s * viscosity**t)
