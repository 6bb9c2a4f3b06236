"""How a result prints: at most ten lines, and in notebooks as tables."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import error_words, mm, worth_reading
from nonhertz.inputs.short_repr import shorten
from nonhertz.model.body import Body
from nonhertz.result.maximum import places_of_largest
from nonhertz.result.penetration import is_noticeable
from nonhertz.result.quantities import QUANTITIES

if TYPE_CHECKING:
    from nonhertz.result.solved import Solved

Array = NDArray[np.float64]


def lines(solution: Solved, resolution: str, ends: Iterable[str]) -> list[str]:
    """Return the summary lines of a solution.

    Parameters
    ----------
    solution : Solution or PatchSolution
        The solution.
    resolution : str
        Strips or plane grid, in words.
    ends : iterable of str
        A description of each end of the contact.
    """
    estimate, both = solution.error_estimate, is_noticeable(solution.approach, solution.penetration)
    text = [
        f"{body_line(solution.contact.a)} against {body_line(solution.contact.b)}",
        f"{solution.status.label} on {resolution}",
        _numbers(solution, ("load", "moment", "tilt"), estimate.load),
        _numbers(solution, ("approach", "penetration") if both else ("approach",), estimate.approach),
    ]
    if solution.contact_y:
        text.append(_pressure(solution))
        text.append(_numbers(solution, ("max_half_width",)))
        places = ", ".join(f"{mm(*ends, between=' to '):4}" for ends in solution.contact_y)
        named = list(ends)
        alike = len(named) == 2 and len({*named}) == 1
        how = f"both ends {named[0]}" if alike else " and ".join(named)
        text.append(f"contact along y from {shorten(places)}: {how}")
        text += map(str, solution.remarks)
    return [*text, *warning_lines(solution.warnings)]


def _pressure(solution: Solved) -> str:
    where = f" {where_largest(solution, 4)}"
    if solution.peaks_at_corner:
        return _numbers(solution, ("max_pressure",), 0.0, f"{where}, a corner of the profile: unbounded")
    return _numbers(solution, ("max_pressure",), solution.error_estimate.max_pressure, where)


def _numbers(solution: Solved, names: tuple[str, ...], error: float = 0.0, where: str = "") -> str:
    spec = worth_reading(error)
    numbers = ", ".join(f"{QUANTITIES[name].label} {QUANTITIES[name].text(solution, spec)}" for name in names)
    words = error_words(error)
    return numbers + where + (f", {words}" if words else "")


def body_line(body: Body) -> str:
    """Return kind, size and model of a body."""
    shown = "; ".join(filter(None, (", ".join(sizes(body)), body.model)))
    return f"{type(body).__name__.lower()} ({shown})"


def sizes(body: Body) -> Iterator[str]:
    """Yield diameter and length of a body in words, if it has them."""
    if body.diameter is not None:
        yield f"diameter {mm(body.diameter):g}" if isinstance(body.diameter, float | int) else "diameter varying"
    if body.length is not None:
        yield f"length {mm(body.length):g}"


def where_largest(solution: Solved, significant: int = 5) -> str:
    """Return the position of the maximum pressure in words: both positions if they mirror each other."""
    places = mm(*places_of_largest(solution), between=" and ")
    away = ", away from singular ends" if solution.singular_ends else ""
    return f"at y = {places:{significant}}{away}"


def warning_lines(warnings: Sequence[str]) -> list[str]:
    """Return a line on warnings: the first, shortened, and how many more there are; no line without any."""
    more = f" (and {len(warnings) - 1} more)" if len(warnings) > 1 else ""
    return [f"warning: {shorten(warning)}{more}" for warning in warnings[:1]]


def plain_text(name: str, items: list[str]) -> str:
    """Return lines under a name, indented."""
    return "\n".join([name, *(f"  {line}" for line in items)])


class HasHtml:
    """A result that notebooks show as the tables that terminal and report have."""

    def _repr_html_(self) -> str:
        from nonhertz.show.notebook import to_html  # what lays out stands above what is laid out

        return to_html(self)
