"""Figs. 8 and 9 of the paper: load against compression of a roller on a ring and of a needle on a cylinder."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from numpy.typing import NDArray

from nonhertz.hertz import line_contact, plane_strain_cylinder_compression
from nonhertz.model.body import Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.profile import Profile, iso_logarithmic, partial_crown, straight
from nonhertz.plot.style import FAINT_INK, FIRST, INK, SECOND
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element
from nonhertz.verify.claim import Check, Picture, Section
from nonhertz.verify.profiled_roller import ARC, DIAMETER, LENGTH, LOAD, RING_DIAMETER, RING_WIDTH, STEEL, STRAIGHT

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

DEPTHS = ("none", "plane-strain", "diameter")
DRAWN = 12  # loads of a curve
_NAMES = {"none": "no depth", "plane-strain": "depth of plane strain", "diameter": "depth of one diameter"}


@dataclass(frozen=True)
class _Pair:
    """A roller on a solid cylinder [mm], and the loads [N] to examine, ascending."""

    name: str
    diameter: float
    length: float
    profile: Profile
    ring_diameter: float
    ring_width: float
    loads: tuple[float, float, float]

    def contact(
        self,
        depth: str,
        profile: Profile | None = None,
        ring_width: float | None = None,
        images: int | Literal["series"] = 1,
    ) -> Contact:
        """Return the pair with faces mirrored and one depth on both bodies."""
        roller = Roller(
            diameter=self.diameter, length=self.length, profile=profile or self.profile, material=STEEL, depth=depth,
            side_faces="mirror", images=images,
        )  # fmt: skip
        width = self.ring_width if ring_width is None else ring_width
        ring = Ring(
            diameter=self.ring_diameter, length=width, material=STEEL, depth=depth, side_faces="mirror", images=images
        )
        return Contact(roller, ring)

    def palmgren(self, load: float) -> float:
        """Return Palmgren's compression of one contact [mm]."""
        return float(3.84e-5 * load**0.9 / self.length**0.8)

    def iso(self, load: float) -> float:
        """Return half of the compression between two raceways after ISO/TS 16281 [mm]."""
        return 0.5 * float((load / (35948.0 * self.length ** (8.0 / 9.0))) ** 0.9)

    def plane_strain(self, load: float) -> float:
        """Return the compression [mm] of both bodies in plane strain under ``load`` spread over the length."""
        curvature = 2.0 / self.diameter + 2.0 / self.ring_diameter
        line = line_contact(line_load=load / self.length, radius=1.0 / curvature, compliance=2.0 * STEEL.compliance)
        return sum(
            plane_strain_cylinder_compression(line, diameter=diameter, material=STEEL)
            for diameter in (self.diameter, self.ring_diameter)
        )


ROLLER = _Pair(
    "roller", diameter=DIAMETER, length=LENGTH, profile=partial_crown(ARC, STRAIGHT), ring_diameter=RING_DIAMETER,
    ring_width=RING_WIDTH, loads=(1e3, 5e3, LOAD),
)  # fmt: skip
NEEDLE = _Pair(
    "needle", diameter=3.0, length=15.8, profile=iso_logarithmic(diameter=3.0, length=15.8), ring_diameter=25.0,
    ring_width=20.0, loads=(500.0, 2e3, 6e3),
)  # fmt: skip


@dataclass(frozen=True)
class _Curves:
    """A pair, its compression [mm] at the three loads for each depth, and that of the paper's own combination."""

    pair: _Pair
    by_depth: dict[str, tuple[Solution, ...]]
    paper: tuple[Solution, ...]
    straight: tuple[Solution, ...]

    def over(self, depth: str, formula: str) -> Array:
        """Return how far the compression lies above a formula [%], at the three loads."""
        expected = np.array([getattr(self.pair, formula)(load) for load in self.pair.loads])
        found = np.array([solution.approach for solution in self.solutions(depth)])
        return np.asarray(100.0 * (found / expected - 1.0))

    def solutions(self, which: str) -> tuple[Solution, ...]:
        """Return the solutions with a depth, with ``"straight"`` or with ``"paper"``."""
        return {**self.by_depth, "straight": self.straight, "paper": self.paper}[which]

    def exponent(self, which: str = "plane-strain") -> tuple[float, ...]:
        """Return d ln(load) / d ln(compression) at the three loads."""
        return tuple(float(one.stiffness[0, 0]) * one.approach / one.load for one in self.solutions(which))


_TEXT = """\
The paper's Figs. 8 and 9 show measured and calculated load against compression of a profiled roller on an inner ring
and of a needle on a solid cylinder. The measurements are not available as numbers, so there is no comparison with
them here. Two pairs of that kind, chosen by us, are set beside what practice computes with:

- Palmgren, one contact: $`\\delta = 3.84 \\cdot 10^{{-5}}\\, Q^{{0.9}} / L^{{0.8}}`$
- ISO/TS 16281, roller between two raceways: $`Q = 35948\\, L^{{8/9}} \\delta^{{10/9}}`$, one contact takes half of it:
  $`\\delta = {iso:.4f} \\cdot 10^{{-5}}\\, Q^{{0.9}} / L^{{0.8}}`$

in mm and N, for steel. Neither knows diameters, profiles or thickness. The **roller** is the stand-in of the section
before: {roller.diameter:g} x {roller.length:g} mm, straight over {straight:g} mm, arcs of {arc:g} mm radius, on a
cylinder of diameter {roller.ring_diameter:g} and width {roller.ring_width:g} mm. The **needle** is
{needle.diameter:g} x {needle.length:g} mm with the profile of ISO 16281, on a cylinder of diameter
{needle.ring_diameter:g} and length {needle.ring_width:g} mm. Steel, E = {modulus:g} MPa; faces mirrored; the same rule
of depth for both bodies. Compression in um:

{table}
"Paper" is its own combination, parabolic strips and a depth of one diameter; "straight" is without the profile, with
the depth of plane strain.

**Found.** Half-spaces without a depth compress {none_low:.0f} to {none_high:.0f} % more than Palmgren says
and {none_iso_low:.0f} to {none_iso_high:.0f} % more than ISO, and are no model of this. Of the three depths that of
plane strain lies nearest to Palmgren in {nearest_palmgren} and nearest to ISO in {nearest_iso} of the {rows} rows
above. The depth of one diameter gives {more_low:.1f} to {more_high:.1f} % more compression than it. With the depth of
plane strain the difference is, in per cent,

- roller, {roller_loads} kN: {roller_palmgren} from Palmgren, {roller_iso} from ISO
- needle, {needle_loads} kN: {needle_palmgren} from Palmgren, {needle_iso} from ISO

What is left is mostly the profile, whose relief has to be closed before the ends bear, more of it the smaller the
load. Without a profile the roller is {straight_roller[0]:+.1f} to {straight_roller[1]:+.1f} % from Palmgren and the
needle {straight_needle[0]:+.1f} to {straight_needle[1]:+.1f} %. For the same reason the local exponent of load over
compression is not the formulas' 10/9 = {formula:.2f} but {profiled_low:.2f} to {profiled_high:.2f} with the profiles;
straight it is {straight_low:.2f} to {straight_high:.2f}.

In plane strain the compression has a closed form. Cut out of endless cylinders, as long as each other and with all
mirror images, the needle and its cylinder have it; the needle of the table, with relieved ends and a cylinder
shorter than thick, stays {short_low:.1f} to {short_high:.1f} % below that at the line load in its middle.
"""


def section() -> Section:
    """Return load against compression of both pairs."""
    curves = (_solve_all(ROLLER), _solve_all(NEEDLE))
    roller, needle = curves
    needle_checks = _plane_strain(needle)
    checks = [*(check for one in curves for check in _checks(one)), *needle_checks]
    none, more = _range(*(one.over("none", "palmgren") for one in curves)), _range(*map(_softer, curves))
    none_iso = _range(*(one.over("none", "iso") for one in curves))
    profiled, plain = (_range(*(one.exponent(which) for one in curves)) for which in ("plane-strain", "straight"))
    short = _range([-100.0 * check.difference for check in needle_checks if "as in the table" in check.claim])
    text = _TEXT.format(
        iso=1e5 * 0.5 / 35948.0**0.9,
        roller=ROLLER,
        needle=NEEDLE,
        straight=STRAIGHT,
        arc=ARC,
        modulus=STEEL.modulus,
        table=_table(curves),
        none_low=none[0],
        none_high=none[1],
        none_iso_low=none_iso[0],
        none_iso_high=none_iso[1],
        more_low=more[0],
        more_high=more[1],
        roller_palmgren=_listed(roller.over("plane-strain", "palmgren"), "+.0f"),
        roller_iso=_listed(roller.over("plane-strain", "iso"), "+.0f"),
        roller_loads=_listed(1e-3 * np.array(ROLLER.loads), "g"),
        needle_palmgren=_listed(needle.over("plane-strain", "palmgren"), "+.0f"),
        needle_iso=_listed(needle.over("plane-strain", "iso"), "+.0f"),
        needle_loads=_listed(1e-3 * np.array(NEEDLE.loads), "g"),
        nearest_palmgren=_nearest(curves, "palmgren"),
        nearest_iso=_nearest(curves, "iso"),
        rows=sum(len(one.pair.loads) for one in curves),
        straight_roller=_range(roller.over("straight", "palmgren")),
        straight_needle=_range(needle.over("straight", "palmgren")),
        formula=10.0 / 9.0,
        profiled_low=profiled[0],
        profiled_high=profiled[1],
        straight_low=plain[0],
        straight_high=plain[1],
        short_low=short[0],
        short_high=short[1],
    )
    pictures = tuple(
        Picture(
            f"load-compression-{one.pair.name}",
            f"Load against compression of the {one.pair.name}, after Fig. {figure} of the paper: strips with three "
            "depths, and the formulas of practice.",
            functools.partial(_draw, one.pair),
        )
        for figure, one in zip((8, 9), curves, strict=True)
    )
    return Section("Load and compression (paper, Figs. 8 and 9)", text, tuple(checks), pictures)


def _solve_all(pair: _Pair) -> _Curves:
    return _Curves(
        pair,
        {depth: _solve(pair, pair.loads, depth) for depth in DEPTHS},
        _solve(pair, pair.loads, "diameter", element=PARABOLIC),
        _solve(pair, pair.loads, "plane-strain", profile=straight()),
    )


def _solve(
    pair: _Pair,
    loads: tuple[float, ...],
    depth: str,
    element: Element = SEMI_ELLIPTIC,
    profile: Profile | None = None,
) -> tuple[Solution, ...]:
    contact = pair.contact(depth, profile)
    return tuple(solve(contact, load=load, element=element) for load in loads)


def _checks(curves: _Curves) -> list[Check]:
    pair, checks = curves.pair, []
    for place, load in enumerate(pair.loads):
        none, plane, diameter = (1e3 * curves.by_depth[depth][place].approach for depth in DEPTHS)
        case = f"{pair.name}, {1e-3 * load:g} kN"
        ordered = float(none > diameter) + float(diameter > plane)
        checks += [
            Check(f"{case}: depths in the order none > one diameter > plane strain", "the nearer the stiffer", 2.0,
                  ordered, 0.0),
            Check(f"{case}: compression, depth of plane strain", "Palmgren", 1e3 * pair.palmgren(load), plane, None,
                  "um"),
            Check(f"{case}: compression, depth of plane strain", "ISO/TS 16281, half", 1e3 * pair.iso(load), plane,
                  None, "um"),
            Check(f"{case}: exponent of load over compression", "10/9 of both formulas", 10.0 / 9.0,
                  curves.exponent()[place], None),
        ]  # fmt: skip
    return checks


def _plane_strain(curves: _Curves) -> list[Check]:
    pair, checks = curves.pair, []
    for load, solution in zip(pair.loads, curves.by_depth["plane-strain"], strict=True):
        case = f"{pair.name}, {1e-3 * load:g} kN"
        source = "Johnson 1985, Eq. (5.57), both cylinders"
        expected = 1e3 * pair.plane_strain(load)
        # One image per face leaves the other face's image uncancelled; the series leaves 1e-7 here.
        asked: tuple[tuple[int | Literal["series"], float], ...] = ((1, 5e-3), ("series", 1e-5))
        for images, tolerance in asked:
            same_length = pair.contact("plane-strain", straight(), pair.length, images)
            found = 1e3 * solve(same_length, load=load).approach
            words = "all images" if images == "series" else "one image per face"
            claim = f"{case}, straight, on a cylinder of its length, {words}: compression"
            checks.append(Check(claim, source, expected, found, tolerance, "um"))
        middle = int(np.argmin(np.abs(solution.y)))
        uniform = 1e3 * pair.plane_strain(float(solution.line_load[middle]) * pair.length)
        claim = f"{case}, as in the table: compression"
        # Relieved ends, and a cylinder only 0.8 diameters long, which is not plane strain: a small part of its half.
        checks.append(
            Check(claim, f"{source}, line load of the middle", uniform, 1e3 * solution.approach, 2.5e-2, "um")
        )
    return checks


def _softer(curves: _Curves) -> list[float]:
    """Return how far the depth of one diameter lies above that of plane strain [%]."""
    pairs = zip(curves.by_depth["diameter"], curves.by_depth["plane-strain"], strict=True)
    return [100.0 * (diameter.approach / plane.approach - 1.0) for diameter, plane in pairs]


def _nearest(curves: tuple[_Curves, ...], formula: str) -> int:
    """Return at how many loads the depth of plane strain lies nearest to a formula."""
    off = np.concatenate([np.abs([one.over(depth, formula) for depth in DEPTHS]) for one in curves], axis=1)
    return int(np.count_nonzero(np.argmin(off, axis=0) == DEPTHS.index("plane-strain")))


def _range(*values: Array | tuple[float, ...] | list[float]) -> tuple[float, float]:
    every = np.concatenate([np.asarray(one) for one in values])
    return float(every.min()), float(every.max())


def _listed(values: Array, form: str) -> str:
    *others, last = (format(float(value), form) for value in values)
    return f"{', '.join(others)} and {last}"


def _table(curves: tuple[_Curves, ...]) -> str:
    head = ("", "Q (kN)", "none", "plane strain", "one diameter", "paper", "straight", "Palmgren", "ISO")
    lines = [f"| {' | '.join(head)} |", "|---|" + "---:|" * (len(head) - 1)]
    for one in curves:
        for place, load in enumerate(one.pair.loads):
            found = [one.solutions(which)[place].approach for which in (*DEPTHS, "paper", "straight")]
            values = [*found, one.pair.palmgren(load), one.pair.iso(load)]
            cells = " | ".join(f"{1e3 * value:.2f}" for value in values)
            lines.append(f"| {one.pair.name} | {1e-3 * load:g} | {cells} |")
    return "\n".join(lines) + "\n"


def _draw(pair: _Pair, figure: Figure) -> None:
    axes = figure.add_subplot()
    # Equal steps of the square root: the curves bend most at small loads.
    loads = pair.loads[-1] * np.linspace(0.05, 1.0, DRAWN) ** 2
    for depth, colour, dashes in zip(DEPTHS, (FAINT_INK, FIRST, SECOND), ("-.", "-", "--"), strict=True):
        found = [1e3 * one.approach for one in _solve(pair, tuple(loads), depth)]
        axes.plot([0.0, *found], [0.0, *(1e-3 * loads)], color=colour, linestyle=dashes, label=_NAMES[depth])
    paper = [1e3 * one.approach for one in _solve(pair, tuple(loads), "diameter", element=PARABOLIC)]
    axes.plot(
        paper, 1e-3 * loads, "o", color=SECOND, mfc="none", markersize=3.5, label="paper: parabolas, one diameter"
    )
    fine = np.linspace(0.0, pair.loads[-1], 101)
    for name, formula, marks in (("Palmgren", pair.palmgren, ":"), ("ISO/TS 16281, half", pair.iso, (0, (8, 3)))):
        compression = [1e3 * formula(float(load)) for load in fine]
        axes.plot(compression, 1e-3 * fine, color=INK, linestyle=marks, linewidth=1.0, label=name)
    axes.set(xlabel="compression (µm)", ylabel="load (kN)")
    axes.set_xlim(left=0.0)
    axes.set_ylim(0.0, 1.05e-3 * pair.loads[-1])
    axes.legend(loc="lower right")
