"""Spectra of loads on a bearing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Any

from numpy.typing import ArrayLike

from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.mapped import BearingMaps
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.prescribed import BearingLoad
from nonhertz.bearing.solution import BearingSolution
from nonhertz.bearing.standard import LAMINAE
from nonhertz.bearing.verb import Method, solve
from nonhertz.errors import InputError
from nonhertz.inputs.checks import numbers, positive
from nonhertz.inputs.descriptions import Quantity
from nonhertz.inputs.fields import input_class
from nonhertz.life.spectrum import at_most_whole, check_cases, share_of_revolutions

_SHARE = "give the share of the revolutions, above 0 and at most 1"


@input_class(kw_only=True)
class BearingLoadCase(BearingLoad):
    """A load on a bearing, as in `nonhertz.bearing.solve`, for a share of the revolutions.

    `shares_of_revolutions` converts shares of the time.

    Raises
    ------
    InputError
        If one of them is out of range; whether the bearing bears the load is known when it is solved.
    """

    share: Annotated[
        float, Quantity("", "the share of the revolutions, above 0 and at most 1", share_of_revolutions, _SHARE)
    ]

    @property
    def load(self) -> dict[str, Any]:
        """The arguments of `solve`."""
        return {name: getattr(self, name) for name in BearingLoad.descriptions}


def solve_spectrum(
    bearing: RollerBearing | Paired,
    cases: Sequence[BearingLoadCase],
    *,
    turning: str = "inner",
    method: Method | BearingMaps = "strips",
    laminae: int = LAMINAE,
) -> tuple[tuple[BearingSolution, float], ...]:
    """Return a bearing in equilibrium under every load of a spectrum.

    Parameters
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    cases : sequence of BearingLoadCase
        The loads. Where their shares add up to less than 1, the bearing is unloaded for the rest.
    turning, method, laminae
        As in `solve`.

    Returns
    -------
    tuple of pairs
        Solution and share of each, as `assess` takes them.

    Raises
    ------
    InputError
        If there are no cases, their shares add up to more than 1, or a load is not valid.
    ConvergenceError
        If no equilibrium is found under a load.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=9, length=10, profile=nh.profile.crown(radius=4000))
    >>> rings = {"inner": nh.Ring(diameter=37.5), "outer": nh.Ring(diameter=-55.5)}
    >>> row = nh.bearing.CylindricalRollerBearing(roller=roller, **rings, rollers=13)
    >>> loads = {0.2: 10e3, 0.8: 4e3}
    >>> cases = [BearingLoadCase(share=share, radial=radial, speed=1500) for share, radial in loads.items()]
    >>> pairs = solve_spectrum(row, cases, method="slices")
    >>> round(nh.bearing.assess(pairs).equivalent_load, -1)
    6500.0
    """
    cases = check_cases("cases", cases, BearingLoadCase)
    at_most_whole("share", [case.share for case in cases], "give all loads with their shares of the revolutions")
    options: dict[str, Any] = {"turning": turning, "method": method, "laminae": laminae}
    return tuple((solve(bearing, **case.load, **options), case.share) for case in cases)


def shares_of_revolutions(times: ArrayLike, speeds: ArrayLike) -> tuple[float, ...]:
    """Return shares of the revolutions from shares of the time and speeds.

    Parameters
    ----------
    times : sequence of float
        Shares of the time [-], together at most 1; for the rest the bearing stands still.
    speeds : sequence of float
        [1/min].

    Returns
    -------
    tuple of float
        t n over the sum of t n, which add up to 1.

    Examples
    --------
    >>> shares_of_revolutions([0.5, 0.5], [3000, 1000])
    (0.75, 0.25)
    """
    remedy = "give one for each load"
    rows = numbers("times", times, remedy), numbers("speeds", speeds, remedy)
    if rows[0].ndim != 1 or rows[0].shape != rows[1].shape or not rows[0].size:
        raise InputError("speeds", rows[1].size, f"be as many as times, {rows[0].size}", remedy)
    for share in rows[0].tolist():
        positive("times", share, "give shares of the time, above 0 and together at most 1")
    for speed in rows[1].tolist():
        positive("speeds", speed, "give speeds in 1/min, above 0: what stands still has no revolutions")
    at_most_whole("times", rows[0].tolist(), "give shares of the time")
    turned = rows[0] * rows[1]
    return tuple((turned / turned.sum()).tolist())
