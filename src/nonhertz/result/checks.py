"""Where a result may leave the validity of its model: each check once, with its number, its limit and its words.

Warnings of the solver are the sentences of checks that do not hold; the report shows every check beside its number.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.bodies.ends import End
from nonhertz.bodies.solid import Shape
from nonhertz.errors import InputError
from nonhertz.model.body import BODIES, Body, BodyName
from nonhertz.model.contact import Contact
from nonhertz.result.solution import Solution

Array = NDArray[np.float64]

MOST_OF_RADIUS = 0.3  # a circle departs from its parabola there by 2 % of its drop
MOST_OF_MODULUS = 0.1  # the hardness of metals and ceramics is a few hundredths of their modulus
LEAST_DEPTH, LEAST_OF_ALL = 3.0, 1.0  # half-widths: warned of below the first, refused below the second
HEAVIEST = 1.0 + 1e-9  # kappa, but for the rounding of a sum that is 1
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
    contact, touching = solution.contact, solution.line_load > 0.0
    y, half_width = solution.y[touching], solution.half_width[touching]
    area = 2.0 * float(np.sum(solution.half_width * solution.strip_width))
    mean = float(np.sum(solution.line_load * solution.strip_width)) / area
    return (
        _long(solution), curved(contact, y, half_width), small_strains(contact, mean),
        *thick(contact, solution.element, y, half_width), *image_weights(freed),
    )  # fmt: skip


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


def curved(contact: Contact, y: Array, half_width: Array) -> Check:
    """Return whether a contact of these half-widths [mm] at ``y`` is narrow against its bodies' radii."""
    ratio = float(np.max(half_width * sharper_curvature(contact, y)))
    what = "Half-spaces, parabolic separation across"
    criterion = f"half-width up to {MOST_OF_RADIUS:g} of the smaller radius of curvature"
    sentence = (
        f"The half-width is {ratio:.2f} of the smaller radius of curvature, over {MOST_OF_RADIUS}: neither "
        "half-spaces nor a parabolic separation describe such a contact."
    )
    return Check(what, criterion, ratio, MOST_OF_RADIUS, (sentence,) if ratio > MOST_OF_RADIUS else ())


def small_strains(contact: Contact, mean: float) -> Check:
    """Return whether strains under a ``mean`` pressure [MPa] are small."""
    softer = min(contact.a.material.modulus, contact.b.material.modulus)
    what, criterion = "Small strains", f"mean pressure up to {MOST_OF_MODULUS:g} of the softer body's modulus"
    sentence = (
        f"The mean pressure is {mean:.3g} MPa, {mean / softer:.2g} of the softer body's modulus and over "
        f"{MOST_OF_MODULUS:g}: no material stays elastic under that, and strains are not small; check load and units."
    )
    return Check(
        what, criterion, mean / softer, MOST_OF_MODULUS, (sentence,) if mean > MOST_OF_MODULUS * softer else ()
    )


def thick(contact: Contact, shape: Shape, y: Array, half_width: Array) -> Iterator[Check]:
    """Yield whether each body that has a depth is thick under half-widths [mm] at ``y``."""
    for name, _, ratio in depths(contact, shape, y, half_width):
        sentence = (
            f"The depth of body {name} is only {ratio:.2f} half-widths, less than {LEAST_DEPTH:g}: the body is so thin "
            "that neither half-spaces nor line loads describe it."
        )
        what, criterion = f"Body {name} is thick", f"depth of at least {LEAST_DEPTH:g} half-widths"
        yield Check(what, criterion, ratio, LEAST_DEPTH, (sentence,) if ratio < LEAST_DEPTH else ())


def depths(contact: Contact, shape: Shape, y: Array, half_width: Array) -> list[tuple[BodyName, Body, float]]:
    """Return name, body and least depth in half-widths of each body that has a depth, where it is in contact."""
    touching = half_width > 0.0
    found = []
    for name, body in zip(BODIES, (contact.a, contact.b), strict=True):
        below = body.behind.below(body, shape)
        if below is not None and np.any(touching):
            found.append((name, body, float(np.min(below(y[touching]) / half_width[touching]))))
    return found


def refuse_thin_bodies(contact: Contact, shape: Shape, y: Array, half_width: Array, least: float) -> None:
    """Refuse a depth of less than ``least`` half-widths: the points at depth move as much as the surface there.

    Raises
    ------
    InputError
    """
    for name, body, ratio in depths(contact, shape, y, half_width):
        if ratio < least:
            widest = float(np.max(half_width))
            shown = ratio * widest if isinstance(body.depth, str) else body.depth
            condition = f"be large against the half-width of the contact, about {widest:.2g} mm"
            remedy = "give the thickness of the body, or 'none'"
            raise InputError("depth", shown, condition, remedy).within(f"body.{name}")


def image_weights(freed: tuple[End, ...]) -> Iterator[Check]:
    """Yield whether the images about side faces weigh as asked, if there are any."""
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
