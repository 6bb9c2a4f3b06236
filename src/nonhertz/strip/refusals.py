"""Why no strips can meet a prescription, in words."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.native import core

Reason = core.Refusal


def in_words(refused: core.Refused, target: NDArray[np.float64], compliance: float) -> InputError:
    """Return the error that a refusal of the core is for the user.

    Parameters
    ----------
    refused : Refused
        What the core raised.
    target : ndarray, shape (2,)
        K Q [mm^2] or delta [mm]; K T [mm^3] or gamma [rad].
    compliance : float
        K of the contact [1/MPa].
    """
    why, value, low, high, strips = refused.args
    if why in {Reason.NAN_RELIEF, Reason.ENDLESS_RELIEF}:
        return _of_relief(why, value)
    if why is Reason.NO_END:
        remedy = "give one of the bodies a length, or a profile that falls away"
        return InputError("length", None, "be given where nothing else ends the contact", remedy)
    if why is Reason.ARM_OUTSIDE:
        condition = f"keep moment / load = {mm(value):.9g} between {mm(low, high, between=' and '):.9g}"
        return InputError("moment", float(target[1]) / compliance, condition, "reduce it or raise the load")
    if why is Reason.ARM_OFF_STRIPS:
        condition = f"have centres on both sides of moment / load = {mm(value):.9g}"
        return InputError("strips", strips, condition, "use more strips or reduce the moment")
    if why is Reason.BETWEEN_STRIPS:
        remedy = "use more strips, or leave it out for an automatic grid"
        return InputError("strips", strips, "put the centre of a strip inside the contact", remedy)
    return _of_approach(refused, float(target[0]))


def _of_relief(why: core.Refusal, y: float) -> InputError:
    if why is Reason.NAN_RELIEF:
        return InputError("profile", math.nan, f"not be NaN, but is at y = {y:g}", "correct its relief")
    remedy = "reduce the relief or lengthen the logarithmic profile"
    return InputError("profile", math.inf, "leave a finite separation somewhere on the bodies", remedy)


def _of_approach(refused: core.Refused, approach: float) -> InputError:
    why, needed, low, high, _ = refused.args
    if why is Reason.TILTED_APART:
        condition = "bring the bodies into contact at the tilt that the moment causes"
        return InputError("approach", approach, condition, "raise it, or give a tilt")
    if why is Reason.UNRESOLVED:
        return InputError("approach", approach, "lead to a contact that strips can resolve", "raise it")
    condition = f"exceed {mm(needed):.6g}, where the bodies begin to touch"
    if low < high:  # on strips that the user gave
        condition += f" between y = {mm(low, high, between=' and '):.6g}"
    return InputError("approach", approach, condition, "raise it, or prescribe the load")
