"""Whether the numbers are right: claims about them, by publications, exact solutions and other methods.

Each topic is a module with a ``TITLE`` and a function ``claims``. `sections` computes the numbers of the claims, and
`nonhertz.verify.page` makes tables of them; what is compared and how well is told in docs/validation.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterable, Iterator

from nonhertz.errors import InputError, without_accuracy_warnings
from nonhertz.verify.claim import Claim, Section, forget, named

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


def claims(name: str) -> tuple[Claim, ...]:
    """Return the claims of a section by its name; nothing is solved yet."""
    return named(name, importlib.import_module(CATALOGUE[name]).claims())


def sections(only: Iterable[str] = (), announce: Callable[[str], object] | None = None) -> Iterator[Section]:
    """Compute the numbers of sections one after another.

    Parameters
    ----------
    only : iterable of str
        Their names; empty for all.
    announce : callable or None
        Called with the name of each section before it runs.

    Yields
    ------
    Section
        Each as soon as it is ready. Cases that were solved for it are forgotten before and after.
    """
    for name in chosen(only):
        if announce is not None:
            announce(name)
        # Imported late, so that running one section does not load the others.
        title = importlib.import_module(CATALOGUE[name]).TITLE
        forget()
        with without_accuracy_warnings():
            checks = tuple(claim.check() for claim in claims(name))
        forget()
        yield Section(name, title, checks)
