"""Where a result may leave the validity of its model: each check once, with its number, its limit and its words.

Warnings of the solver are the sentences of checks that do not hold; the report shows every check beside its number.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.ends import End
from nonhertz.model.body import Body
from nonhertz.model.contact import Contact
from nonhertz.result.solution import Solution

Array = NDArray[np.float64]

MOST_OF_RADIUS = 0.3
MOST_OF_MODULUS = 0.1
LEAST_DEPTH = 3.0  # half-widths
HEAVIEST = 1.0 + 1e-9
WIDER_THAN_LONG = 1.02  # so that a circle is not called wide for its rounding


@dataclass(frozen=True)
class Check:
    """One condition of the model, and what a case has of it.

    Attributes
    ----------
    assumption : str
        What is assumed.
    criterion : str
        When that can be.
    value, limit : float
        The number of this case, and the one that it must not pass.
    sentences : tuple of str
        What is to be said where it does not hold; empty where it does.
    remark : str
        What follows, in short; empty where it holds.
    """

    assumption: str
    criterion: str
    value: float
    limit: float
    sentences: tuple[str, ...] = ()
    remark: str = ""

    @property
    def holds(self) -> bool:
        """Whether the model is valid in this respect."""
        return not self.sentences


def checks(solution: Solution, freed: tuple[End, ...]) -> tuple[Check, ...]:
    """Return all checks of a solution that has a contact; ``freed`` side faces as `nonhertz.bodies.ends` has them."""
    return (_long(solution), _curved(solution), _small_strains(solution), *_deep(solution), *_images(freed))


def sharper_curvature(contact: Contact, y: Array) -> Array:
    """Return the larger curvature of both bodies across the contact [1/mm], whatever its sign."""
    return np.maximum(np.abs(contact.a.curvature(y)), np.abs(contact.b.curvature(y)))


def _long(solution: Solution) -> Check:
    ratio = 2.0 * solution.max_half_width / max(end - start for start, end in solution.contact_y)
    what, criterion = "Strips across a contact that is long", f"width / length up to {WIDER_THAN_LONG:g}"
    if ratio <= WIDER_THAN_LONG:
        return Check(what, criterion, ratio, WIDER_THAN_LONG)
    sentence = (
        f"The contact is wider than long: width / length = {ratio:.2f}, and strips should be "
        "long against their width in sum; expect errors where the contact ends."
    )
    return Check(what, criterion, ratio, WIDER_THAN_LONG, (sentence,), "Expect errors where the contact ends.")


def _curved(solution: Solution) -> Check:
    touching = solution.line_load > 0.0
    ratio = float(np.max(solution.half_width[touching] * sharper_curvature(solution.contact, solution.y[touching])))
    what = "Half-spaces, parabolic separation across"
    criterion = f"half-width up to {MOST_OF_RADIUS:g} of the smaller radius of curvature"
    sentence = (
        f"The half-width is {ratio:.2f} of the smaller radius of curvature, over {MOST_OF_RADIUS}: neither "
        "half-spaces nor a parabolic separation describe such a contact."
    )
    return Check(what, criterion, ratio, MOST_OF_RADIUS, (sentence,) if ratio > MOST_OF_RADIUS else ())


def _small_strains(solution: Solution) -> Check:
    softer = min(solution.contact.a.material.modulus, solution.contact.b.material.modulus)
    area = 2.0 * float(np.sum(solution.half_width * solution.strip_width))
    mean = float(np.sum(solution.line_load * solution.strip_width)) / area
    what, criterion = "Small strains", f"mean pressure up to {MOST_OF_MODULUS:g} of the softer body's modulus"
    sentence = (
        f"The mean pressure is {mean:.3g} MPa, {mean / softer:.2g} of the softer body's modulus and over "
        f"{MOST_OF_MODULUS:g}: no material stays elastic under that, and strains are not small; check load and units."
    )
    return Check(
        what, criterion, mean / softer, MOST_OF_MODULUS, (sentence,) if mean > MOST_OF_MODULUS * softer else ()
    )


def _deep(solution: Solution) -> Iterator[Check]:
    for name, _, ratio in depths(solution, solution.half_width):
        sentence = (
            f"The depth of body {name} is only {ratio:.2f} half-widths, less than {LEAST_DEPTH:g}: the body is so thin "
            "that neither half-spaces nor line loads describe it."
        )
        what, criterion = f"Body {name} is thick", f"depth of at least {LEAST_DEPTH:g} half-widths"
        yield Check(what, criterion, ratio, LEAST_DEPTH, (sentence,) if ratio < LEAST_DEPTH else ())


def depths(solution: Solution, half_width: Array) -> list[tuple[str, Body, float]]:
    """Return name, body and least depth in half-widths of each body that has a depth."""
    touching = half_width > 0.0
    if not np.any(touching):
        return []
    found = []
    for name, body in (("a", solution.contact.a), ("b", solution.contact.b)):
        below = body.behind.below(body, solution.element)
        if below is not None:
            found.append((name, body, float(np.min(below(solution.y[touching]) / half_width[touching]))))
    return found


def _images(freed: tuple[End, ...]) -> Iterator[Check]:
    if not freed:
        return
    heavy = [end for end in freed if end.requested > HEAVIEST]
    sentences = tuple(
        f"The images about the side face at y = {end.y:.6g} mm would weigh {end.requested:.3g} of the surface, a face "
        "of the other body at the same place counted in, and above 1 refinement leads nowhere: their weights were "
        "lowered until it is 1. The pressure up to that end is finite only by this."
        for end in heavy
    )
    places = " and ".join(f"{end.y:.5g}" for end in heavy)
    remark = f"Those about y = {places} mm were lowered until it is 1; the pressure up to there is finite only by this."
    yield Check(
        "Images about side faces", "weight of at most 1 of the surface", max(end.requested for end in freed), HEAVIEST,
        sentences, remark if heavy else "",
    )  # fmt: skip
