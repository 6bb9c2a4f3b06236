"""How the pressure grows towards a sharp end: exponents for several image weights and pairs of materials."""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import without_accuracy_warnings
from nonhertz.model.body import Plate, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.plot.style import COLOUR_MAP, INK
from nonhertz.solver.one import solve
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

LENGTH, LOAD, MODULUS = 20.0, 20000.0, 207000.0
# Weight of the roller's images, and modulus of the plate over that of the roller.
CASES = ((0.0, 1.0), (0.5, 1.0), (1.0, 1.0), (1.0, 0.4), (1.0, 2.277), (1.39, 1.0), (1.6, 1.0))
NARROWEST, GROWTH, WIDEST = 3e-5, 1.15, 0.6  # mm, from strip to strip, mm
BIASED_STRIPS, FIT_REACH, TENTH = 9, 0.3, 0.1  # the last two in half-widths
_SOURCE = "cos(pi alpha) = kappa"
_TEXT = """\
A straight roller, its side faces freed by images, is pressed on a plate that goes on beyond its ends. Close to the
end, at distances $s$ small against the half-width, the equations of the strips become

```math
\\int_0^\\infty s'^{{-\\alpha}} \\left[\\frac{{1}}{{s - s'}} + \\frac{{\\kappa}}{{s + s'}}\\right] ds' = 0
```

with $\\kappa$ the weight of the roller's images times its share of the compliance.
Hence $p \\sim K / s^\\alpha$ with $\\cos \\pi\\alpha = \\kappa$: 1/2 without images, 1/3 for mirrored faces and equal
materials. (The exact frictionless quarter-plane on a half-plane of the same material has 0.226.)

The exponent appears only very close to the end: at a tenth of the half-width the local slope of $\\ln p$ is still far
from it. So the strips narrow geometrically to {narrowest:.0e} mm, and the exponent is extrapolated by fitting

```math
\\ln p = \\ln K - \\alpha \\ln s + c_1 s^{{2\\alpha}} + c_2 s
```

with $\\alpha$ unknown, from {first} strips off the end to {reach:g} half-widths.

**Found.** The extrapolated exponents agree with the formula within {worst:.3f} for all pairs. The last strip's
pressure says nothing: a strip half as wide shows $2^\\alpha$ times as much.

| image weight | modulus of plate / roller | kappa | alpha | extrapolated | local slope at 0.1 b |
|---|---|---|---|---|---|
{rows}
"""


@dataclass(frozen=True)
class _End:
    """Image weight of the roller, modulus of plate over roller, and the pressure near one end.

    Distances are in half-widths.
    """

    weight: float
    ratio: float
    kappa: float
    distance: Array
    pressure: Array

    @property
    def expected(self) -> float:
        """The exponent of the formula."""
        return math.acos(self.kappa) / math.pi

    @functools.cached_property
    def extrapolated(self) -> float:
        """The exponent of the fit, which is independent of the formula."""
        from scipy.optimize import minimize_scalar

        near = (np.arange(self.distance.size) >= BIASED_STRIPS) & (self.distance < FIT_REACH)
        s, log_pressure = self.distance[near], np.log(self.pressure[near])

        def misfit(exponent: float) -> float:
            shape = np.column_stack([np.ones(s.size), s ** (2.0 * exponent), s])
            target = log_pressure + exponent * np.log(s)
            return float(np.sum((shape @ np.linalg.lstsq(shape, target, rcond=None)[0] - target) ** 2))

        return float(minimize_scalar(misfit, bounds=(0.05, 0.7), method="bounded", options={"xatol": 1e-6}).x)

    @property
    def local(self) -> float:
        """The slope of -ln p over ln s at a tenth of the half-width."""
        log_s = np.log(self.distance)
        return float(np.interp(math.log(TENTH), log_s, -np.gradient(np.log(self.pressure), log_s)))


@without_accuracy_warnings()
def section() -> Section:
    """Return the exponents for several image weights and pairs of materials."""
    ends = [_end(weight, ratio) for weight, ratio in CASES]
    checks = [
        Check(
            f"exponent, image weight {end.weight:g}, modulus of plate / roller {end.ratio:g}: kappa {end.kappa:.3f}",
            _SOURCE, end.expected, end.extrapolated, 0.03, absolute=True,
        )
        for end in ends
    ]  # fmt: skip
    rows = "\n".join(
        f"| {end.weight:g} | {end.ratio:g} "
        f"| {end.kappa:.3f} | {end.expected:.3f} | {end.extrapolated:.3f} | {end.local:.3f} |"
        for end in sorted(ends, key=lambda end: end.kappa)
    )
    text = _TEXT.format(
        narrowest=NARROWEST,
        first=BIASED_STRIPS,
        reach=FIT_REACH,
        worst=max(abs(check.difference) for check in checks),
        rows=rows,
    )
    picture = Picture(
        "edge-exponents",
        "Pressure towards a sharp end, over the pressure at half a half-width, for several kappa. The thin lines have "
        "the slope of the formula.",
        functools.partial(_draw, ends),
    )
    return Section("Sharp ends: the exponent of the singularity", text, tuple(checks), (picture,))


def graded_edges(length: float, narrowest: float, growth: float, widest: float) -> Array:
    """Return the edges of strips over a length, narrowing geometrically towards both ends."""
    widths = [narrowest]
    while widths[-1] < widest and sum(widths) < 0.4 * length:
        widths.append(widths[-1] * growth)
    outer = np.concatenate([[0.0], np.cumsum(widths)])
    inner = np.linspace(outer[-1], 0.5 * length, math.ceil((0.5 * length - outer[-1]) / widths[-1]) + 1)
    from_end = np.concatenate([outer, inner[1:]])
    return np.concatenate([from_end - 0.5 * length, (0.5 * length - from_end)[-2::-1]])


def _end(weight: float, ratio: float) -> _End:
    roller = Roller(diameter=20.0, length=LENGTH, material=Material(MODULUS, 0.3), side_faces=weight, depth="none")
    plate = Plate(material=Material(ratio * MODULUS, 0.3))
    edges = graded_edges(LENGTH, NARROWEST, GROWTH, WIDEST)
    solution = solve(Contact(roller, plate), load=LOAD, strips=edges)
    inwards = slice(None, None, -1)
    distance = (0.5 * LENGTH - solution.y[inwards]) / solution.half_width[-1]
    return _End(weight, ratio, solution.edge_pressure[1].image_weight, distance, solution.centre_pressure[inwards])


def _draw(ends: list[_End], figure: Figure) -> None:
    import matplotlib as mpl

    axes = figure.add_subplot()
    colours = mpl.colormaps[COLOUR_MAP]
    for end in sorted(ends, key=lambda end: end.kappa):
        shown = (np.arange(end.distance.size) >= 2) & (end.distance < 3.0)
        over = float(np.exp(np.interp(math.log(0.5), np.log(end.distance), np.log(end.pressure))))
        axes.loglog(
            end.distance[shown], end.pressure[shown] / over, color=colours(0.9 * end.kappa),
            label=f"$\\kappa$ = {end.kappa:.2f}, $\\alpha$ = {end.expected:.3f}",
        )  # fmt: skip
        s = np.array([1e-4, 3e-3])
        first = int(np.argmax(end.distance > 1e-3))
        slope = end.pressure[first] / over * (s / end.distance[first]) ** -end.expected
        axes.loglog(s, slope, color=INK, linewidth=0.5, linestyle=(0, (2, 2)))
    axes.set(xlabel="distance from the end / half-width", ylabel="pressure / that at b/2")
    axes.legend(loc="upper right")
