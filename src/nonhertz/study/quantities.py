"""The quantities that a row of a study can have, for a contact or for a bearing."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property

from nonhertz.bearing.quantities import LIVES, SolvedBearing
from nonhertz.bearing.quantities import QUANTITIES as OF_BEARING
from nonhertz.errors import NonhertzError
from nonhertz.files.casefile import Case
from nonhertz.inputs.descriptions import unknown_word_error
from nonhertz.life import Life, assess
from nonhertz.life.assessment import Spectrum
from nonhertz.life.spectrum import solve_spectrum
from nonhertz.model.body import BODIES
from nonhertz.result.quantities import QUANTITIES, Quantity
from nonhertz.result.solution import Solution

LIFE_MODEL = "iso-16281"  # if a case names none: it takes milliseconds, volume models take seconds


def life_of(case: Case, solved: Solution | Spectrum, name: str) -> Life:
    """Return the life of one body by a model: of the body with a raceway, else of body a."""
    (model,) = case.life.build_models((name,))
    options = {"rollers": case.life.rollers, "contact_angle": case.life.contact_angle}
    lives = [assess(solved, model, body=body, **options)[0] for body in BODIES]  # type: ignore[arg-type]
    return next((life for life in lives if life.million_revolutions is not None), lives[0])


@dataclass(frozen=True)
class SolvedContact:
    """A case and its solution, from which the numbers of a row are taken."""

    case: Case
    solution: Solution

    @cached_property
    def life(self) -> Life:
        """The life of one body by the first model of the case: of the body with a raceway, else of body a.

        It is the life under the spectrum, if the case has one.
        """
        case = self.case.life
        solved: Solution | Spectrum = self.solution
        if case.spectrum:
            solved = solve_spectrum(self.case.contact, case.spectrum, **self.case.solver.keywords, threads=1)
        return life_of(self.case, solved, (*case.models, LIFE_MODEL)[0])


def number_of(quantity: Quantity, solved: SolvedContact | SolvedBearing) -> float:
    """Return a number of a row; NaN if there is none, such as a life without a rating."""
    try:
        return float(quantity.get(solved))
    except NonhertzError:
        return math.nan


def _of_contact() -> dict[str, Quantity]:
    def getter(quantity: Quantity) -> Callable[[SolvedContact], float]:
        return lambda solved: quantity.clean(solved.solution)

    by_name = {name: replace(quantity, get=getter(quantity), scale=None) for name, quantity in QUANTITIES.items()}
    for quantity in (
        Quantity("error", "estimated error of approach or load", "", "", _error, "%"),
        Quantity("warnings", "warnings", "", "", lambda solved: len(solved.solution.warnings)),
        Quantity("relative_life", "relative life", "", "", lambda s: s.life.relative_life),
        Quantity("life", "life", "L10", LIVES[0], lambda s: s.life.million_revolutions or math.nan, LIVES[1]),
    ):
        by_name[quantity.name] = quantity
    return by_name


def _error(solved: SolvedContact) -> float:
    estimate = solved.solution.error_estimate
    return max(estimate.approach, estimate.load)


#: All numbers of a contact, by name.
OF_CONTACT: Mapping[str, Quantity] = _of_contact()
#: The default quantities of a row.
USUAL_OF_CONTACT = (
    *("approach", "tilt", "load", "moment", "max_pressure", "max_pressure_y", "max_half_width", "contact_length"),
    *("error", "warnings"),
)
USUAL_OF_BEARING = (
    *("max_load", "max_pressure", "loaded_rollers", "displacement_x", "displacement_y", "displacement_z"),
    *("force_x", "force_y", "tilt_z", "moment_z", "reference_life", "modified_life"),
)


def known_quantities(*, bearing: bool) -> Mapping[str, Quantity]:
    """Return all quantities that a row can have, by name."""
    return OF_BEARING if bearing else OF_CONTACT


def choose_quantities(names: Iterable[str], *, bearing: bool) -> tuple[Quantity, ...]:
    """Return quantities by name, or the default ones.

    Raises
    ------
    InputError
        If there is no such quantity; the nearest is named.
    """
    every = known_quantities(bearing=bearing)
    wanted = tuple(dict.fromkeys(names)) or (USUAL_OF_BEARING if bearing else USUAL_OF_CONTACT)
    for name in wanted:
        if name not in every:
            raise unknown_word_error("quantities", name, "quantity", every)
    return tuple(every[name] for name in wanted)
