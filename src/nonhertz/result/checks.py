"""Checks of whether a result is within the validity of its model, each with its value, its limit and its wording.

The solver warns with the sentences of the checks that fail; the report shows every check with its value.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm, mpa, um
from nonhertz.bodies.depths import depth_below
from nonhertz.bodies.ends import End
from nonhertz.bodies.shape import Shape
from nonhertz.errors import InputError
from nonhertz.findings import Finding, finding
from nonhertz.model.body import Body, BodyName
from nonhertz.model.contact import Contact
from nonhertz.native import core
from nonhertz.result.solution import Solution

Array = NDArray[np.float64]

MOST_OF_RADIUS = 0.3  # a circle departs from its parabola there by 2 % of its drop
MOST_OF_MODULUS = 0.1  # the hardness of metals and ceramics is a few hundredths of their modulus
LEAST_DEPTH, LEAST_OF_ALL = 3.0, 1.0  # half-widths: a warning below the first, an error below the second
HEAVIEST = 1.0 + 1e-9  # largest kappa, with room for the rounding of a sum that is 1
# The remedy for a load or approach that is too large for the bodies.
WAY_OUT = "reduce it, or check diameters, moduli, tilt and units"
WIDER_THAN_LONG = 1.02  # so that rounding does not make a circle count as wide
# Of the largest interference; waves from 0.75 half-widths upwards then cost the approach up to MODEL_ERROR times the
# square, by the plane grid. Usual profiles have 4e-4 at most.
MOST_UNEVEN, MODEL_ERROR = 0.01, 7.0


@dataclass(frozen=True)
class ValidityCheck:
    """One condition of the model, and the value of a case.

    Attributes
    ----------
    assumption : str
        What is assumed.
    criterion : str
        When the assumption is justified.
    value, limit : float
        The value in this case, and the limit that it must not pass.
    findings : tuple of Finding
        The warnings if the condition does not hold; empty if it does.
    remark : str
        The consequence, in short; empty if the condition holds.
    """

    assumption: str
    criterion: str
    value: float
    limit: float
    findings: tuple[Finding, ...] = ()
    remark: str = ""

    @property
    def holds(self) -> bool:
        """Whether the model is valid in this respect."""
        return not self.findings


def checks(solution: Solution, values: core.Checks, freed: tuple[End, ...]) -> tuple[ValidityCheck, ...]:
    """Return all checks of a solution with a contact.

    Parameters
    ----------
    solution : Solution
        The solution.
    values : core.Checks
        The values for the conditions.
    freed : tuple of End
        The side faces from `nonhertz.bodies.ends`.
    """
    contact, touching = solution.contact, solution.line_load > 0.0
    y, half_width = solution.y[touching], solution.half_width[touching]
    return (
        _long(values.length_ratio), check_curvature(values.radius_ratio), _even(values),
        small_strains(contact, values.mean_pressure), *thick(contact, solution.element, y, half_width),
        *image_weights(freed),
    )  # fmt: skip


def all_hold(values: core.Checks, softer: float) -> bool:
    """Return whether all conditions but that of side faces hold; ``softer`` is the modulus of the softer body [MPa]."""
    return (
        values.length_ratio <= WIDER_THAN_LONG
        and values.radius_ratio <= MOST_OF_RADIUS
        and values.unevenness <= MOST_UNEVEN * max(values.deepest, 0.0)
        and values.mean_pressure <= MOST_OF_MODULUS * softer
        and values.depth_ratio >= LEAST_DEPTH
    )


def _long(ratio: float) -> ValidityCheck:
    what, criterion = "Strips across a contact that is long", f"width / length up to {WIDER_THAN_LONG:g}"
    if ratio <= WIDER_THAN_LONG:
        return ValidityCheck(what, criterion, ratio, WIDER_THAN_LONG)
    problem = finding(
        "wider-than-long",
        "The contact is wider than long: width / length = {ratio:.2f}, but strips assume a contact longer than it is "
        "wide; expect errors where the contact ends.",
        ratio=ratio,
    )
    return ValidityCheck(what, criterion, ratio, WIDER_THAN_LONG, (problem,), "Expect errors where the contact ends.")


def check_curvature(ratio: float) -> ValidityCheck:
    """Return the check that half-widths are small compared with the bodies' radii; ``ratio`` is the largest."""
    what = "Half-spaces, parabolic separation across"
    criterion = f"half-width up to {MOST_OF_RADIUS:g} of the smaller radius of curvature"
    problem = finding(
        "wide-for-its-radius",
        "The half-width is {ratio:.2f} of the smaller radius of curvature, over {limit:g}: neither half-spaces nor a "
        "parabolic separation describe such a contact.",
        ratio=ratio,
        limit=MOST_OF_RADIUS,
    )
    return ValidityCheck(what, criterion, ratio, MOST_OF_RADIUS, (problem,) if ratio > MOST_OF_RADIUS else ())


def _even(values: core.Checks) -> ValidityCheck:
    departure, deepest = values.unevenness, values.deepest
    ratio = departure / deepest if deepest > 0.0 else 0.0
    what = "Relief that varies slowly along the contact"
    criterion = f"departure from a parabola within a half-width up to {100.0 * MOST_UNEVEN:g} % of the interference"
    if ratio <= MOST_UNEVEN:
        return ValidityCheck(what, criterion, ratio, MOST_UNEVEN)
    share, cost = 100.0 * ratio, 100.0 * MODEL_ERROR * ratio**2
    problem = finding(
        "short-waves",
        "Within a half-width the bodies depart by {departure:.2g} from parabolas, {share:.2g} % of the interference "
        "and over {limit:g} %. Such short waves change the distribution across, which strips assume, and the approach "
        "by up to {cost:.2g} %; compare with the plane grid.",
        departure=um(departure),
        share=share,
        limit=100.0 * MOST_UNEVEN,
        cost=cost,
    )
    return ValidityCheck(what, criterion, ratio, MOST_UNEVEN, (problem,), "Compare with the plane grid.")


def small_strains(contact: Contact, mean: float) -> ValidityCheck:
    """Return the check that strains under a ``mean`` pressure [MPa] are small."""
    softer = min(contact.a.material.modulus, contact.b.material.modulus)
    what, criterion = "Small strains", f"mean pressure up to {MOST_OF_MODULUS:g} of the softer body's modulus"
    problem = finding(
        "large-strains",
        "The mean pressure is {pressure:.3g}, {ratio:.2g} of the softer body's modulus and over {limit:g}: no material "
        "stays elastic under that, and strains are not small; check load and units.",
        pressure=mpa(mean),
        ratio=mean / softer,
        limit=MOST_OF_MODULUS,
    )
    is_hard = mean > MOST_OF_MODULUS * softer
    return ValidityCheck(what, criterion, mean / softer, MOST_OF_MODULUS, (problem,) if is_hard else ())


def thick(contact: Contact, shape: Shape, y: Array, half_width: Array) -> Iterator[ValidityCheck]:
    """Yield a check for each body with a finite depth that it is thick compared with half-widths [mm] at ``y``."""
    for name, _, ratio in depths(contact, shape, y, half_width):
        problem = finding(
            "thin-body",
            "The depth of body {body} is only {ratio:.2f} half-widths, less than {limit:g}: the body is too thin for "
            "half-spaces and line loads.",
            body=name,
            ratio=ratio,
            limit=LEAST_DEPTH,
        )
        what, criterion = f"Body {name} is thick", f"depth of at least {LEAST_DEPTH:g} half-widths"
        yield ValidityCheck(what, criterion, ratio, LEAST_DEPTH, (problem,) if ratio < LEAST_DEPTH else ())


def depths(contact: Contact, shape: Shape, y: Array, half_width: Array) -> list[tuple[BodyName, Body, float]]:
    """Return name, body and smallest depth in half-widths, where in contact, of each body with a finite depth."""
    touching = half_width > 0.0
    shallowest = []
    for name, body in contact.bodies.items():
        below = depth_below(body, shape)
        if below is not None and np.any(touching):
            shallowest.append((name, body, float(np.min(below(y[touching]) / half_width[touching]))))
    return shallowest


def refuse_thin_bodies(
    contact: Contact, shape: Shape, y: Array, half_width: Array, least: float, pressed: tuple[str, float | None]
) -> None:
    """Refuse a depth of less than ``least`` half-widths, where the points at depth move as much as the surface.

    ``pressed`` are name and value of the prescribed load or approach, which is refused if no depth was given.

    Raises
    ------
    InputError
    """
    for name, body, ratio in depths(contact, shape, y, half_width):
        if ratio >= least:
            continue
        widest = float(np.max(half_width))
        if body.depth is None or isinstance(body.depth, str):
            condition = (
                f"leave the half-width, about {mm(widest):.2g}, below the {mm(ratio * widest):.4g} of body {name}"
            )
            raise InputError(*pressed, f"{condition} behind it", WAY_OUT)
        condition = f"be large compared with the half-width of the contact, about {mm(widest):.2g}"
        remedy = f"give the thickness of the body, or 'none', or reduce the {pressed[0]}"
        raise InputError("depth", body.depth, condition, remedy).within(f"body.{name}")


def image_weights(freed: tuple[End, ...]) -> Iterator[ValidityCheck]:
    """Yield the check that the images about side faces have the weights requested, if there are any."""
    if not freed:
        return
    heavy = [end for end in freed if end.requested > HEAVIEST]
    problems = tuple(
        finding(
            "images-too-heavy",
            "The images about the side face at y = {y:.6g} would have a total weight of {weight:.3g}, including a face "
            "of the other body at the same place, so their weights were lowered to a total of 1. Above 1 refinement "
            "does not converge; only the lower weights make the pressure up to that end finite.",
            y=mm(end.y),
            weight=end.requested,
        )
        for end in heavy
    )
    places = mm(*(end.y for end in heavy), between=" and ")
    remark = f"Those about y = {places:.5g} were lowered to a total of 1; only this makes the pressure there finite."
    yield ValidityCheck(
        "Images about side faces", "total weight of at most 1", max(end.requested for end in freed), HEAVIEST,
        problems, remark if heavy else "",
    )  # fmt: skip
