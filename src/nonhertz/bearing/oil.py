"""The oil in a bearing: its viscosity there, and how clean it is."""

from __future__ import annotations

from typing import Annotated

from nonhertz.bearing.lubrication import CLEANLINESS
from nonhertz.errors import InputError
from nonhertz.inputs.checks import number_that, positive
from nonhertz.inputs.fields import Input, Quantity, Word, described, together

_contamination = number_that(lambda value: value <= 1.0, "not exceed 1", positive)


@described(kw_only=True)
class Lubrication(Input):
    """The oil in a bearing.

    Raises
    ------
    InputError
        If a value is out of range, or cleanliness or e_C are given without a viscosity.
    """

    viscosity: Annotated[
        float | None,
        Quantity(
            "mm^2/s",
            "viscosity of the oil at its temperature in the bearing, for a_ISO",
            positive,
            "give that of the oil in the bearing in mm^2/s",
        ),
    ] = None
    contamination: Annotated[
        float | None,
        Quantity(
            "",
            "the factor e_C, above 0 and at most 1; if left out, that of the cleanliness",
            _contamination,
            "give e_C, above 0 and at most 1",
        ),
    ] = None
    cleanliness: Annotated[
        str | None,
        Word(
            "class of cleanliness for a_ISO: an ISO 4406 code with circulating oil, or 'high'; none is assumed",
            "choose one, or give contamination as a number",
            tuple(CLEANLINESS),
        ),
    ] = None

    @together("viscosity", "contamination", "cleanliness")
    def _check_oil(self) -> None:
        for name in ("contamination", "cleanliness"):
            value = getattr(self, name)
            if value is not None and self.viscosity is None:
                condition, remedy = "be given with a viscosity", "give the viscosity too, or leave it out"
                raise InputError(name, value, condition, remedy)
