"""Whether the numbers are right: comparisons with publications, exact solutions and other methods.

Each comparison is a module with a function ``section`` that solves what it needs and returns a
`nonhertz.verify.claim.Section`: checks with a verdict, a text and pictures. `sections` runs them, and
`nonhertz.verify.page` turns them into the validation page.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING

from nonhertz.errors import InputError, NonhertzError, without_accuracy_warnings

if TYPE_CHECKING:
    from nonhertz.verify.claim import Section

#: Name and module of every section, in reading order.
CATALOGUE = {
    "hertz-ellipse": "nonhertz.verify.hertz_ellipse",
    "line-limits": "nonhertz.verify.line_limits",
    "half-space": "nonhertz.verify.half_space",
    "plane-strain": "nonhertz.verify.plane_strain",
    "finite-bodies": "nonhertz.verify.finite_bodies",
    "edge-exponents": "nonhertz.verify.edge_exponents",
    "quarter-space": "nonhertz.verify.quarter_space",
    "whole-roller": "nonhertz.verify.whole_roller",
    "profiled-roller": "nonhertz.verify.profiled_roller",
    "load-compression": "nonhertz.verify.load_compression",
    "plane-grid": "nonhertz.verify.plane_grid",
    "free-ends": "nonhertz.verify.free_ends",
    "subsurface": "nonhertz.verify.subsurface_stress",
    "fatigue-life": "nonhertz.verify.fatigue_life",
    "bearings": "nonhertz.verify.bearings",
    "cost": "nonhertz.verify.cost",
}


def chosen(only: Iterable[str] = ()) -> tuple[str, ...]:
    """Return the names of the chosen sections in reading order.

    Parameters
    ----------
    only : iterable of str
        Names in any order; empty for all sections.

    Raises
    ------
    InputError
        If a name is not in the catalogue.
    """
    names = list(only)
    for name in names:
        if name not in CATALOGUE:
            raise InputError("--only", name, "be a section", f"choose from {', '.join(CATALOGUE)}")
    return tuple(name for name in CATALOGUE if name in names or not names)


def sections(
    only: Iterable[str] = (), announce: Callable[[str], object] | None = None
) -> Iterator[tuple[str, Section]]:
    """Run sections one after another.

    Parameters
    ----------
    only : iterable of str
        Their names; empty for all.
    announce : callable or None
        Called with the name of each section before it runs.

    Yields
    ------
    tuple of str and Section
        Name and result, as soon as each is ready.
    """
    for name in chosen(only):
        if announce is not None:
            announce(name)
        # Imported late, so that running one section does not load the others.
        module = importlib.import_module(CATALOGUE[name])
        try:
            with without_accuracy_warnings():
                found = module.section()
        except (NonhertzError, ValueError, ArithmeticError) as error:
            found = _broken(name, error)
        yield name, found


def _broken(name: str, error: Exception) -> Section:
    """Return a substitute for a section that could not finish: one check that fails."""
    from nonhertz.verify.claim import Check, Section

    check = Check(f"{name} runs to its end", "this command", 1.0, 0.0, 0.0)
    return Section(name, f"This section did not run to its end: {error}", (check,))
