"""Whether the numbers are right: claims about them, by publications, exact solutions and other methods.

Each page of docs/validation, which says what is compared and how well, has a module with a function for each section,
which yields its claims. `sections` computes their numbers, and `claims.page` makes tables of them.
"""

from __future__ import annotations

import pkgutil
from collections.abc import Callable, Iterable, Iterator

from claims.claim import Claim, Section, forget, named
from nonhertz.errors import without_accuracy_warnings
from nonhertz.inputs.descriptions import unknown_word_error

#: Module and function of the claims of every section, and its title, in reading order.
CATALOGUE = {
    "hertz-ellipse": ("hertz:ellipses", "Elliptical contacts: Hertz (paper, Fig. 3)"),
    "line-limits": ("hertz:lines", "Line contact: limits of both elements (paper, Eqs. 59, 61, 62)"),
    "half-space": ("half_space:rollers", "Rollers on half-spaces"),
    "plane-strain": ("bodies:plane_strain", "Plane strain: how deep a cylinder is (paper, section 6)"),
    "finite-bodies": ("bodies:limits", "Side faces and depth: limits"),
    "edge-exponents": ("half_space:exponents", "Sharp ends: the exponent of the singularity"),
    "quarter-space": ("free_ends:mirrored", "Free ends: what mirroring leaves"),
    "whole-roller": ("whole_roller:claims", "The whole roller: models of ends and depth side by side"),
    "profiled-roller": ("paper_rollers:profiled", "A profiled roller on an inner ring (paper, Figs. 6 and 7)"),
    "load-compression": ("paper_rollers:compression", "Load and compression (paper, Figs. 8 and 9)"),
    "plane-grid": ("plane_grid:claims", "Strips against a plane grid"),
    "free-ends": ("free_ends:free", "Free ends: strips against a plane grid"),
    "subsurface": ("subsurface_stress:claims", "Stress below the surface"),
    "fatigue-life": ("fatigue_life:claims", "Fatigue life"),
    "bearings": ("bearings:claims", "Whole bearings"),
    "cost": ("cost:claims", "Cost (paper, section 8)"),
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
            raise unknown_word_error("--only", name, "section", CATALOGUE)
    return tuple(name for name in CATALOGUE if name in names or not names)


def claims(name: str) -> tuple[Claim, ...]:
    """Return the claims of a section by its name; nothing is solved yet."""
    # Imported late, so that running one section does not load the others.
    return named(name, pkgutil.resolve_name(f"claims.{CATALOGUE[name][0]}")())


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
        forget()
        with without_accuracy_warnings():
            checks = tuple(claim.check() for claim in claims(name))
        forget()
        yield Section(name, CATALOGUE[name][1], checks)
