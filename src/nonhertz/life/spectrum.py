"""Load spectra: loads on a contact, each for a fraction of the revolutions."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Annotated, Any, TypeVar

from nonhertz.errors import InputError
from nonhertz.inputs.checks import above_zero, check_list, finite, number_that, positive
from nonhertz.inputs.descriptions import Quantity
from nonhertz.inputs.fields import Input, input_class
from nonhertz.model.contact import Contact
from nonhertz.result.solution import Solution
from nonhertz.solver.many import solve_many
from nonhertz.solver.one import Goal, Strips
from nonhertz.strip.element import SEMI_ELLIPTIC, Element

WHOLE = 1e-3  # tolerance for the sum of shares, so that three of 0.333, for example, are accepted

Case = TypeVar("Case")
_SHARE_REMEDY = "give the share of the revolutions, above 0 and at most 1"


def at_most_whole(name: str, shares: Iterable[float], remedy: str) -> None:
    """Refuse shares that add up to more than 1."""
    total = math.fsum(shares)
    if total > 1.0 + WHOLE:
        raise InputError(name, round(total, 6), "add up to 1 at most", remedy)


def check_shares(
    solution: object, check: Callable[[object], object], of: str, condition: str, remedy: str
) -> list[tuple[Any, float]]:
    """Return checked pairs of a solution and its share, all for one contact or bearing."""
    pairs = list(solution) if isinstance(solution, Sequence) else []
    if not pairs or not all(isinstance(pair, Sequence) and len(pair) == 2 for pair in pairs):
        raise InputError("solution", solution, condition, remedy)
    for result, share in pairs:
        check(result)
        positive("share", share, remedy)
        if getattr(result, of) != getattr(pairs[0][0], of):
            raise InputError("solution", "several", f"all belong to one {of}", f"assess {of}s one by one")
    at_most_whole("share", [share for _, share in pairs], remedy)
    return pairs


def check_cases(name: str, cases: Iterable[Any], kind: type[Case]) -> list[Case]:
    """Return load cases of a kind as a list; refuse anything else, and an empty list."""
    remedy = f"give a list of {kind.__module__.removesuffix('.spectrum')}.{kind.__name__}"
    items: list[Case] = check_list(name, cases, "be load cases", remedy)
    if not items or not all(isinstance(case, kind) for case in items):
        raise InputError(name, cases, "be load cases", remedy)
    return items


def refuse_other_than_whole(name: str, cases: Sequence[ContactLoadCase], remedy: str) -> float:
    """Refuse shares that do not add up to 1 within 0.001; return their sum."""
    total = math.fsum(case.share for case in cases)
    if abs(total - 1.0) > WHOLE:
        raise InputError(name, round(total, 6), "add up to 1", remedy)
    return total


def miner(lives: Sequence[float], shares: Sequence[float]) -> float:
    """Return the life under loads with fractions of the revolutions, after Palmgren and Miner."""
    damage = math.fsum(share / life for life, share in zip(lives, shares, strict=True))
    return 1.0 / damage if damage != 0.0 else math.inf


share_of_revolutions = number_that(lambda share: share <= 1.0, "not exceed 1", positive)


@input_class(kw_only=True)
class ContactLoadCase(Input):
    """A load for a fraction of the revolutions.

    Raises
    ------
    InputError
        If a value is out of range.
    """

    load: Annotated[
        float,
        Quantity(
            "N",
            "the load that presses the bodies together",
            above_zero,
            "give the force in N that presses the bodies together",
        ),
    ]
    share: Annotated[
        float,
        Quantity("", "its share of the revolutions, above 0 and at most 1", share_of_revolutions, _SHARE_REMEDY),
    ]
    tilt: Annotated[
        float, Quantity("rad", "tilt, positive loads the side of positive y", finite, "give the tilt in rad")
    ] = 0.0


def solve_spectrum(
    contact: Contact,
    cases: Sequence[ContactLoadCase],
    *,
    element: Element = SEMI_ELLIPTIC,
    strips: Strips = None,
    accuracy: float | None = None,
    accuracy_of: Goal | None = None,
    threads: int | None = None,
) -> tuple[tuple[Solution, float], ...]:
    """Solve a contact under every load of a spectrum.

    Parameters
    ----------
    contact : Contact
        The two bodies.
    cases : sequence of ContactLoadCase
        The loads; their shares add up to 1.
    element, strips, accuracy, accuracy_of, threads
        As in `nonhertz.solve_many`.

    Returns
    -------
    tuple of pairs
        Solution and share of each load, as `nonhertz.life.assess` takes them.

    Raises
    ------
    InputError
        If there are no cases, or their shares do not add up to 1 within 0.001.
    NonhertzError
        If a case cannot be solved.

    Examples
    --------
    >>> import nonhertz as nh
    >>> contact = nh.Contact(nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000)), nh.Plate())
    >>> cases = [ContactLoadCase(load=20e3, share=0.2, tilt=0.3e-3), ContactLoadCase(load=5e3, share=0.8)]
    >>> [round(share, 3) for _, share in solve_spectrum(contact, cases, strips=41)]
    [0.2, 0.8]
    """
    cases = check_cases("cases", cases, ContactLoadCase)
    total = refuse_other_than_whole("share", cases, "give all loads with their shares of the revolutions")
    loads, tilts = [case.load for case in cases], [case.tilt for case in cases]
    aim: dict[str, Any] = {"strips": strips, "accuracy": accuracy, "accuracy_of": accuracy_of}
    solutions = solve_many(contact, load=loads, tilt=tilts, element=element, **aim, threads=threads)
    return tuple((solutions[number], case.share / total) for number, case in enumerate(cases))
