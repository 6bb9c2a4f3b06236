"""Loading of a contact: approach or load, and tilt or moment."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, ClassVar

import numpy as np

from nonhertz.amounts import mm, newton
from nonhertz.errors import InputError
from nonhertz.inputs.checks import above_zero, finite
from nonhertz.inputs.descriptions import Quantity
from nonhertz.inputs.fields import Input, cross_check, input_class
from nonhertz.model.contact import Contact, get_or_compute

# Bounds of compliance times load over the square of the bodies' smallest and largest size. Below the first, the relief
# beside the contact is lost in rounding; strips and cells solved 14 contacts of all shapes down to 1e-22. At the
# second the contact is hundreds of times wider than the bodies.
LEAST, MOST = 1e-22, 1e6
# Sine and tangent differ by 5 % there, and relief is measured normal to a body that is not tilted.
MOST_TILT = 0.3  # rad


def _small(name: str, tilt: float, remedy: str) -> None:
    finite(name, tilt, remedy)
    if abs(tilt) > MOST_TILT:
        remedy = "give it in rad: 1 mrad is 0.001, 1 degree 0.01745"
        raise InputError(name, tilt, f"be a small angle, of at most {MOST_TILT:g} rad", remedy)


@input_class(kw_only=True)
class Prescription(Input):
    """Loading of the bodies: load or approach, and tilt or moment; the other two are results."""

    instead: ClassVar[Mapping[str, str]] = {"approach": "load", "moment": "tilt"}

    load: Annotated[
        float | None,
        Quantity(
            "N",
            "load that presses the bodies together",
            above_zero,
            "give the force in N that presses the bodies together",
        ),
    ] = None
    approach: Annotated[
        float | None,
        Quantity("mm", "approach of the bodies, in place of load", finite, "give the approach in mm"),
    ] = None
    tilt: Annotated[
        float | None,
        Quantity("rad", "tilt, positive loads the side of positive y; 0 if left out", _small, "give the tilt in rad"),
    ] = None
    moment: Annotated[
        float | None,
        Quantity("N mm", "moment of the pressure about y = 0, in place of tilt", finite, "give the moment in N mm"),
    ] = None

    @cross_check("load", "approach")
    def _check_load(self) -> None:
        refuse_unpaired(self.approach, self.load, None, None)

    @property
    def by_force(self) -> tuple[bool, bool]:
        """Whether the load is given rather than the approach, and the moment rather than the tilt."""
        return self.load is not None, self.moment is not None

    @property
    def pressed(self) -> tuple[str, float | None]:
        """Name and value of load or approach, whichever is given."""
        return ("approach", self.approach) if self.load is None else ("load", self.load)

    @property
    def arm(self) -> float | None:
        """Moment over load [mm] if both are given, else None."""
        return None if self.load is None or self.moment is None else self.moment / self.load

    def target(self, compliance: float) -> tuple[float, float]:
        """Return K Q [mm^2] or the approach [mm], and K T [mm^3] or the tilt [rad], for a compliance K [1/MPa]."""
        first = self.approach if self.load is None else compliance * self.load
        second = self.tilt or 0.0 if self.moment is None else compliance * self.moment
        assert first is not None
        return first, second

    def refuse_outside(self, contact: Contact) -> None:
        """Refuse a load out of range for the bodies, and a moment that no pressure between their ends can produce."""
        if self.load is not None:
            refuse_load(contact, self.load)
        low, high = contact.interval
        if self.arm is not None and not low < self.arm < high:
            condition = f"keep moment / load between {mm(low, high, between=' and '):g}, where both bodies are"
            raise InputError("moment", self.moment, condition, "reduce it or raise the load")
        if self.moment is not None and ((self.moment > 0.0 and high <= 0.0) or (self.moment < 0.0 and low >= 0.0)):
            condition = f"have the sign of the lever arms, which lie between {mm(low, high, between=' and '):g}"
            raise InputError("moment", self.moment, condition, "reverse its sign")


def loads_between(contact: Contact) -> tuple[float, float]:
    """Return the smallest and the largest load [N] for which bodies of this size and stiffness can be solved."""
    return get_or_compute(contact, "loads between", lambda: _loads_between(contact))


def _loads_between(contact: Contact) -> tuple[float, float]:
    low, high = contact.interval
    middle = np.array(0.5 * (low + high) if np.isfinite(high - low) else 0.0)
    curvatures = [abs(float(body.curvature(middle))) for body in (contact.a, contact.b)]
    sizes = [1.0 / curvature for curvature in curvatures if curvature > 0.0]
    if np.isfinite(high - low):
        sizes.append(0.5 * (high - low))
    if not sizes:
        return 0.0, np.inf  # flat and unbounded: refused elsewhere
    return LEAST / contact.compliance * min(sizes) ** 2, MOST / contact.compliance * max(sizes) ** 2


def refuse_load(contact: Contact, load: float) -> None:
    """Refuse a load [N] that is out of range for bodies of this size and stiffness.

    Raises
    ------
    InputError
    """
    least, most = loads_between(contact)
    if load < least:
        condition = f"be at least {newton(least):.2g} for bodies of this size and stiffness"
        raise InputError("load", load, condition, "raise it: a smaller one is lost in rounding")
    if load > most:
        raise InputError("load", load, "leave the contact narrower than the bodies", "check its unit, or reduce it")


def refuse_unpaired(approach: object, load: object, tilt: object, moment: object) -> None:
    """Refuse anything but exactly one of approach and load, and at most one of tilt and moment; None means not given.

    Raises
    ------
    InputError
        If neither or both of a pair are given.
    """
    if load is None and approach is None:
        raise InputError("load", None, "be given", "give the load in N, or an approach in mm")
    for first, second, name, other in ((load, approach, "approach", "load"), (tilt, moment, "moment", "tilt")):
        if first is not None and second is not None:
            raise InputError(name, second, f"not be given together with {other}", "leave one out")
