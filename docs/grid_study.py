"""Write docs/explain/grid-table.md: what grids cost in accuracy, against answers from elsewhere.

    python docs/grid_study.py

Three questions: how fast equal strips converge on a Hertz contact and what the automatic grid makes of it;
how narrow strips at a sharp end have to be; and whether the solve estimates its own error honestly.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.interpolate import PchipInterpolator

import nonhertz as nh
from nonhertz.files.casefile import read_case
from nonhertz.model.profile import Profile

Array = NDArray[np.float64]

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "explain" / "grid-table.md"
HERTZ_LOAD, HERTZ_RADIUS = 1000.0, 100.0  # N, mm along; 10 mm across
HERTZ_STRIPS = (11, 21, 41, 81, 161, 321)
END_WIDTHS = (0.64, 0.16, 0.04, 0.01)  # mm
END_GROWTH, WIDEST = 1.2, 1.0  # factor from strip to strip; mm
REFINEMENT = 4
PPM = 1e6


@dataclass(frozen=True)
class Parabola(Profile):
    """Relief y^2 / (2 R): what the crown of a Hertz contact is exactly, where a circle only comes near."""

    radius: float

    def relief(self, y: ArrayLike) -> Array:
        """Return the relief [mm]."""
        return np.asarray(y, dtype=float) ** 2 / (2.0 * self.radius)


@dataclass(frozen=True)
class SharpCase:
    """A roller 20 x 20 with sharp ends on a flat, 20 kN, as an independent program solves it.

    Uniform pressure rectangles, up to 512 x 4096, displacements by fast Fourier transform, constrained
    conjugate gradients, extrapolated to no width; near the ends a dense solve on a grid that fits the body.
    Uncertainty of approach 2e-6, of pressures 2e-5. The same figures are in tests/validation/data.
    """

    name: str
    profile: Profile
    approach: float
    pressures: dict[float, float]
    """Distance from the end [mm] to pressure on the centre line [MPa]."""


SHARP = (
    SharpCase(
        "straight",
        nh.profile.straight(),
        0.02741221026671631,
        {10.0: 1797.5316090538483, 0.5: 2168.5956865766, 0.1: 3120.7061074239},
    ),
    SharpCase(
        "crown 4000",
        Parabola(4000.0),
        0.032192419785281,
        {10.0: 2039.1706833204814, 0.5: 1685.8013146718, 0.1: 2160.3936616970},
    ),
)


def main() -> None:
    """Measure and write the page."""
    warnings.simplefilter("ignore", nh.AccuracyWarning)
    sections = (_head, _hertz_table, _sharp_tables, _honesty_table)
    PAGE.write_text("\n".join(line for section in sections for line in section()), encoding="utf-8")
    print(f"wrote {PAGE.relative_to(ROOT)}")


def _head() -> Iterator[str]:
    yield "# Errors of the automatic grid, measured"
    yield ""
    yield "Computed by `docs/grid_study.py`. The method: [grid.md](grid.md)."
    yield "Errors are relative, in ppm (1000 ppm: 0.1 %), positive where strips give too much."
    yield ""


def _hertz_table() -> Iterator[str]:
    steel = nh.MATERIALS["steel"]
    exact = nh.hertz.point_contact(load=HERTZ_LOAD, radius_x=10, radius_y=HERTZ_RADIUS, compliance=2 * steel.compliance)
    yield "## Smooth ends: a Hertz ellipse"
    yield ""
    yield f"Rx 10, Ry {HERTZ_RADIUS:g} mm, {HERTZ_LOAD:g} N, steel; exact by `nonhertz.hertz.point_contact`."
    yield f"Equal strips lie on abs(y) <= 1.3 a, a = {exact.half_length:.4f} mm, half the contact's length."
    yield ""
    yield _row("strips", "approach", "p0", "b")
    yield _rule(4)
    errors: list[float] = []
    for strips in (*HERTZ_STRIPS, None):
        solution = nh.solve(_on_plate(Parabola(HERTZ_RADIUS), 2.6 * exact.half_length), load=HERTZ_LOAD, strips=strips)
        errors.append(solution.approach / exact.approach - 1.0)
        yield _row(
            f"automatic, {solution.strips}" if strips is None else strips,
            _ppm(errors[-1]),
            _ppm(_at(solution, 0.0, solution.centre_pressure) / exact.max_pressure - 1.0),
            _ppm(_at(solution, 0.0, solution.half_width) / exact.half_width - 1.0),
        )
    order = np.polyfit(-np.log(HERTZ_STRIPS), np.log(np.abs(errors[:-1])), 1)[0]
    yield ""
    yield f"The error of the approach falls as strips^-{order:.2f}. Parabolic strips end at the"
    yield "[bias of their shape](../validation/hertz.md)."
    yield ""


def _sharp_tables() -> Iterator[str]:
    yield "## Sharp ends: how narrow the last strips"
    yield ""
    yield "Roller 20 x 20 on a plate, 20 kN, aligned. Strips grow inward"
    yield f"by a factor of {END_GROWTH:g}, up to {WIDEST:g} mm."
    yield "A dash: within the last strip, whose pressure has no limit."
    for case in SHARP:
        yield ""
        yield f"### {case.name.capitalize()}, reference approach {1e3 * case.approach:.4f} um"
        yield ""
        places = [_place(distance) for distance in case.pressures]
        yield _row("end strip [mm]", "strips", "approach", *places)
        yield _rule(3 + len(places))
        for width in (*END_WIDTHS, None):
            strips = None if width is None else _graded_by_hand(10.0, width)
            solution = nh.solve(_on_plate(case.profile, 20.0), load=20e3, strips=strips)
            last = solution.strip_width[-1]
            yield _row(
                f"automatic, {last:.4f}" if width is None else width,
                solution.strips,
                _ppm(solution.approach / case.approach - 1.0),
                *(_pressure_error(solution, *place) for place in case.pressures.items()),
            )
    yield ""


def _pressure_error(solution: nh.Solution, distance: float, pressure: float) -> str:
    """Return the error of the pressure at a distance from the end, if that is not within the last strip."""
    if distance < solution.strip_width[-1]:
        return "-"
    return _ppm(_at(solution, 10.0 - distance, solution.centre_pressure) / pressure - 1.0)


def _honesty_table() -> Iterator[str]:
    yield "## The estimate of the error, and the error"
    yield ""
    yield f"Automatic grid, against a grid with every strip cut into {REFINEMENT}; only the estimate includes what"
    yield "strips cannot do at a sharp end. p0 is the maximum pressure more than a half-width from sharp ends; at a"
    yield "corner within the contact it has no limit."
    yield ""
    yield _row("case", "strips", "approach: estimate", "approach: error", "p0: estimate", "p0: error")
    yield _rule(6)
    ratios: dict[str, list[float]] = {"approach": [], "maximum pressure": []}
    for name, solve in _catalogue():
        solution = solve(None)
        finer = solve(_cut(solution.edges, REFINEMENT))
        estimate = solution.error_estimate
        singular = not np.isfinite(estimate.max_pressure)
        of_approach = abs(solution.approach / finer.approach - 1.0)
        of_pressure = abs(solution.max_pressure / finer.max_pressure - 1.0)
        ratios["approach"].append(estimate.approach / of_approach)
        if not singular:
            ratios["maximum pressure"].append(estimate.max_pressure / of_pressure)
        yield _row(
            name,
            solution.strips,
            _ppm(estimate.approach),
            _ppm(of_approach),
            "no limit" if singular else _ppm(estimate.max_pressure),
            "" if singular else _ppm(of_pressure),
        )
    yield ""
    for quantity, values in ratios.items():
        middle, least = np.median(values), np.min(values)
        yield f"Estimate over error, {quantity}: median {middle:.2g}, least {least:.2g}."
        yield ""


def _catalogue() -> Iterator[tuple[str, Callable[[Array | None], nh.Solution]]]:
    """Yield names and functions from strips to a solution."""
    logarithmic = nh.profile.logarithmic(amplitude=0.005, length=20, fraction=0.9999)
    rollers = {
        "Hertz ellipse": (Parabola(100.0), 4.0, {"load": 1e3}),
        "crown 4000, 3 kN, -0.5 mrad": (nh.profile.crown(4000), 20.0, {"load": 3e3, "tilt": -0.5e-3}),
        "crown 1000, 20 kN": (nh.profile.crown(1000), 20.0, {"load": 20e3}),
        "logarithmic, 20 kN": (logarithmic, 20.0, {"load": 20e3}),
        "logarithmic, 40 kN, -1 mrad": (logarithmic, 20.0, {"load": 40e3, "tilt": -1e-3}),
        "Lundberg for 20 kN, 20 kN": (nh.profile.lundberg(20e3, 20, radius=10), 20.0, {"load": 20e3}),
        "partial crown 200, straight 12, 20 kN": (
            nh.profile.partial_crown(200, straight=12),
            20.0,
            {"load": 20e3},
        ),
        "tapered ends, 0.5 degrees, 10 kN": (
            nh.profile.tapered_ends(straight=14, angle=np.deg2rad(0.5)),
            20.0,
            {"load": 10e3},
        ),
        "straight, 20 kN (sharp ends)": (nh.profile.straight(), 20.0, {"load": 20e3}),
        "crown 4000, 20 kN (sharp ends)": (nh.profile.crown(4000), 20.0, {"load": 20e3}),
    }
    for name, (profile, length, given) in rollers.items():
        yield name, _solver(_on_plate(profile, length), given)
    for stem in ("cylindrical-roller-bearing", "tabulated-profile"):
        case = read_case(ROOT / "examples" / f"{stem}.toml")
        yield f"examples/{stem}.toml", _solver(case.contact, case.prescribed.keywords)


def _solver(contact: nh.Contact, given: dict[str, float]) -> Callable[[Array | None], nh.Solution]:
    return lambda strips: nh.solve(contact, strips=strips, **given)


def _on_plate(profile: Profile, length: float) -> nh.Contact:
    return nh.Contact(
        nh.Roller(diameter=20, length=length, profile=profile, side_faces="none", depth="none"), nh.Plate()
    )


def _graded_by_hand(half: float, width: float) -> Array:
    """Return edges from -half to half, ``width`` at the ends, growing inward, a strip centred on zero."""
    widths = [width]
    while sum(widths) < half:
        widths.append(min(widths[-1] * END_GROWTH, WIDEST))
    # All but the outermost are stretched so that they fill the half, the middle strip counting half.
    inner = np.array(widths[1:])
    weights = np.ones(inner.size)
    weights[-1] = 0.5
    inner *= (half - width) / np.sum(weights * inner)
    from_end = np.concatenate([[0.0, width], width + np.cumsum(inner[:-1])])
    return np.concatenate([-half + from_end, (half - from_end)[::-1]])


def _cut(edges: Array, pieces: int) -> Array:
    """Return the edges with every strip cut into equal pieces."""
    share = np.arange(pieces) / pieces
    return np.append((edges[:-1, None] + np.diff(edges)[:, None] * share).ravel(), edges[-1])


def _at(solution: nh.Solution, y: float, values: Array) -> float:
    return float(PchipInterpolator(solution.y, values)(y))


def _place(distance: float) -> str:
    return "p0 in the middle" if distance == 10.0 else f"{distance:g} mm from the end"


def _ppm(relative: float) -> str:
    return f"{PPM * relative:.3g}" if abs(PPM * relative) < 100 else f"{PPM * relative:.0f}"


def _row(*cells: object) -> str:
    return "| " + " | ".join(str(cell) for cell in cells) + " |"


def _rule(columns: int) -> str:
    return "|" + "---|" * columns


if __name__ == "__main__":
    main()
