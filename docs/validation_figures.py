"""The figures of docs/validation, from the same solved cases as the claims of the tests."""

from __future__ import annotations

from collections.abc import Callable

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from claims import (
    bearings,
    bodies,
    fatigue_life,
    free_ends,
    half_space,
    hertz,
    known_bearings,
    paper_rollers,
    plane_grid,
    subsurface_stress,
    whole_roller,
)
from nonhertz.bodies.depths import plane_strain_depth
from nonhertz.figures.comparison import compared_methods
from nonhertz.life import assess, ioannides_harris, lundberg_palmgren, weibull, zaretsky
from nonhertz.plot.contact_area import footprint
from nonhertz.plot.drawer import draw_panel
from nonhertz.plot.style import COLOUR_MAP, END_DASHES, FAINT_INK, FIRST, INK, LINE, PALE, SECOND, SMALL_SIZE, THIN
from nonhertz.solver.one import solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC
from nonhertz.subsurface import passage, stress
from nonhertz.subsurface.field import von_mises_of

Array = NDArray[np.float64]
LOOKS = ((FIRST, "-"), (SECOND, "--"), (INK, ":"), (FAINT_INK, "-."))


def draw_hertz_ellipse(figure: Figure) -> None:
    """Pressure and half-width along an ellipse, after Fig. 3 of the paper."""
    exact = hertz.ellipse()
    upper, lower = figure.subplots(2, 2, sharex=True, height_ratios=(3.0, 1.3))
    y = exact.half_length * np.sin(np.linspace(-0.5 * np.pi, 0.5 * np.pi, 301))
    for axes, along in zip(upper, (exact.pressure(y), exact.half_width_at(y)), strict=True):
        axes.plot(y, along, color=INK, linewidth=0.9, label="Hertz")
    for element, colour, mark in ((SEMI_ELLIPTIC, FIRST, "o"), (PARABOLIC, SECOND, "x")):
        solution = hertz.on_strips(exact, element, hertz.REACH, hertz.EQUAL_STRIPS)
        look = {"color": colour, "mfc": "none"}
        for axes, values in zip(upper, (solution.centre_pressure, solution.half_width), strict=True):
            axes.plot(solution.y, values, mark, markersize=3.5, label=element.name, **look)
        places, *off = hertz.off(solution, exact)
        for axes, difference in zip(lower, off, strict=True):
            axes.plot(places, 100.0 * difference, mark, markersize=3.0, **look)
    upper[0].set(ylabel="pressure $p_0$ (MPa)", ylim=(0.0, 1750.0))
    upper[1].set(ylabel="half-width $b$ (mm)", ylim=(0.0, 0.3))
    upper[0].legend(loc="lower center")
    for axes in lower:
        axes.axhline(0.0, color=FAINT_INK, linewidth=0.5)
        axes.set(xlabel="y (mm)", ylabel="off (% of greatest)", ylim=(-2.4, 1.4))


def draw_half_space(figure: Figure) -> None:
    """Pressure on the centre line of rollers on half-spaces."""
    axes = figure.add_subplot()
    for reference, (colour, dashes) in zip(half_space.REFERENCES, LOOKS, strict=False):
        solution = half_space.on_strips(reference)
        touching = solution.line_load > 0.0
        axes.plot(
            solution.y[touching], solution.centre_pressure[touching], linestyle=dashes, color=colour, marker=".",
            markersize=3.0, label=reference.name,
        )  # fmt: skip
        axes.plot(*zip((0.0, reference.pressure), *reference.inwards, strict=True), "o", color=colour, mfc="none")
    axes.set(xlim=(-10.5, 10.5), ylim=(0.0, 3500.0), xlabel="y (mm)", ylabel="pressure $p_0$ (MPa)")
    axes.legend(loc="upper center")


def draw_plane_strain(figure: Figure) -> None:
    """Depth over diameter that makes a long cylinder's compression that of plane strain."""
    axes = figure.add_subplot()
    poisson = np.linspace(0.0, 0.5, 101)
    for element, (colour, _), marker in zip((SEMI_ELLIPTIC, PARABOLIC), LOOKS, "os", strict=False):
        closed = [plane_strain_depth(element, float(nu)) for nu in poisson]
        axes.plot(poisson, closed, color=colour, label=f"{element.name}, closed form")
        dots = [(nu, bodies.depth_found(element, 1.0, 10.0, nu)) for nu in (0.0, 0.15, 0.3, 0.45)]
        axes.plot(*zip(*dots, strict=True), marker, color=colour, mfc="none", label=f"{element.name}, found")
    axes.axhline(1.0, color=FAINT_INK, linestyle="--", label="paper: D")
    axes.axhline(0.75, color=FAINT_INK, linestyle=":", label="de Mul and van Engelenburg: 3/4 D")
    axes.set(xlabel="Poisson's ratio", ylabel="depth / diameter", xlim=(0.0, 0.5))
    axes.legend()


def draw_edge_exponents(figure: Figure) -> None:
    """Pressure towards sharp ends, with the slopes of the formula."""
    axes = figure.add_subplot()
    colours = mpl.colormaps[COLOUR_MAP]
    for end in sorted((half_space.end(*case) for case in half_space.CASES), key=lambda end: end.kappa):
        shown = (np.arange(end.distance.size) >= 2) & (end.distance < 3.0)
        over = float(np.exp(np.interp(np.log(0.5), np.log(end.distance), np.log(end.pressure))))
        label = f"$\\kappa$ = {end.kappa:.2f}, $\\alpha$ = {end.expected:.3f}"
        axes.loglog(end.distance[shown], end.pressure[shown] / over, color=colours(0.9 * end.kappa), label=label)
        s, first = np.array([1e-4, 3e-3]), int(np.argmax(end.distance > 1e-3))
        slope = end.pressure[first] / over * (s / end.distance[first]) ** -end.expected
        axes.loglog(s, slope, color=INK, linewidth=0.5, linestyle=(0, (2, 2)))
    axes.set(xlabel="distance from the end / half-width", ylabel="pressure / that at b/2")
    axes.legend(loc="upper right")


def draw_quarter_space(figure: Figure) -> None:
    """Pressure towards ends with images, and towards exact free ends."""
    axes, far = figure.add_subplot(), free_ends.FAR
    looks = ((FIRST, "-"), (SECOND, "-"), (SECOND, "--"), (FAINT_INK, ":"))
    for (name, (weights, _)), (colour, dashes) in zip(free_ends.MIRRORED.items(), looks, strict=True):
        solution = free_ends.with_weights(*weights)
        over = float(np.interp(far, solution.y, solution.centre_pressure))
        axes.plot(solution.y, solution.centre_pressure / over, color=colour, linestyle=dashes, label=name)
    places = free_ends.DISTANCES
    axes.plot(places, free_ends.EXACT_ROLLER, "o", color=INK, mfc="none", label="roller ends: exact")
    axes.plot(places, free_ends.EXACT_BOTH, "s", color=INK, mfc="none", label="both bodies end: exact")
    axes.set(
        xscale="log", xlim=(0.05, 10.0), ylim=(0.4, 2.6), xlabel="distance from the end (mm)", ylabel="p / p(8 mm)"
    )
    axes.legend(loc="upper right")


def draw_whole_roller(figure: Figure) -> None:
    """Error of the displacement towards the end, by model of ends and depth."""
    both = figure.subplots(1, 2, sharey=True)
    looks = ((FAINT_INK, ":"), (SECOND, "-"), (INK, "--"), (SECOND, "--"), (INK, END_DASHES), (FIRST, "-"))
    for axes, load in zip(both, (whole_roller.UNIFORM, whole_roller.TILTING), strict=True):
        outer = slice(load.y.index(4.0), None)
        y, expected = np.array(load.y)[outer], np.array(load.moved)[outer]
        for model, (colour, dashes) in zip(whole_roller.MODELS, looks, strict=True):
            error = 100.0 * (whole_roller.moved(model.roller(load.poisson), load, y) / expected - 1.0)
            axes.plot(y, error, color=colour, linestyle=dashes, label=model.name)
        axes.set(xlabel="y (mm)", xlim=(4.0, whole_roller.END))
    both[0].set(ylabel="error of w (%)", ylim=(-40.0, 10.0))
    figure.legend(*both[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)


def draw_footprint(figure: Figure) -> None:
    """Footprint of the stand-in roller, in true proportions and stretched across."""
    upper, lower = figure.subplots(2, 1, height_ratios=(1.0, 3.2))
    footprint(paper_rollers.stand_in(), upper, colour_bar=False)
    footprint(paper_rollers.stand_in(), lower, stretch=6.0)
    upper.set_xlabel("")


def draw_profiled_pressure(figure: Figure) -> None:
    """Pressure and half-width of the stand-in roller, on the scales of the paper's Fig. 7."""
    axes, tilt = figure.add_subplot(), paper_rollers.TILT
    for of, width, words in ((0.0, 1.5, ""), (tilt, 0.7, f", {1e3 * tilt:g} mrad")):
        one = paper_rollers.stand_in(SEMI_ELLIPTIC, of)
        pressure, half_width = 1e-3 * one.centre_pressure, 10.0 * one.half_width
        axes.plot(one.y, pressure, "-", color=FIRST, linewidth=width, label=f"pressure (GPa){words}")
        axes.plot(one.y, half_width, "--", color=SECOND, linewidth=width, label=f"half-width (mm/10){words}")
    axes.set(xlabel="y (mm)", ylabel="pressure (GPa), half-width (mm/10)", xlim=(-8.0, 8.0), ylim=(0, 4))
    axes.legend(loc="lower center", ncols=2, fontsize=SMALL_SIZE)


def draw_load_compression(pair: paper_rollers.Pair, figure: Figure) -> None:
    """Load against compression of a pair, with three depths and by the formulas of practice."""
    axes = figure.add_subplot()
    # Equal steps of the square root: the curves bend most at small loads.
    loads = pair.loads[-1] * np.linspace(0.05, 1.0, 12) ** 2

    def compression(depth: str, **more: object) -> list[float]:
        return [1e3 * paper_rollers.on_strips(pair, float(load), depth, **more).approach for load in loads]

    names = ("no depth", "depth of plane strain", "depth of one diameter")
    looks = ((FAINT_INK, "-."), (FIRST, "-"), (SECOND, "--"))
    for depth, name, (colour, dashes) in zip(paper_rollers.DEPTHS, names, looks, strict=True):
        axes.plot([0.0, *compression(depth)], [0.0, *(1e-3 * loads)], color=colour, linestyle=dashes, label=name)
    paper = compression("diameter", element=PARABOLIC)
    label = "paper: parabolas, one diameter"
    axes.plot(paper, 1e-3 * loads, "o", color=SECOND, mfc="none", markersize=3.5, label=label)
    fine = np.linspace(0.0, pair.loads[-1], 101)
    for name, formula, marks in (("Palmgren", pair.palmgren, ":"), ("ISO/TS 16281, half", pair.iso, (0, (8, 3)))):
        by_formula = [1e3 * formula(float(load)) for load in fine]
        axes.plot(by_formula, 1e-3 * fine, color=INK, linestyle=marks, linewidth=1.0, label=name)
    axes.set(xlabel="compression (µm)", ylabel="load (kN)")
    axes.set_xlim(left=0.0)
    axes.set_ylim(0.0, 1.05e-3 * pair.loads[-1])
    axes.legend(loc="lower right")


def draw_plane_grid(figure: Figure) -> None:
    """Pressure on the centre line, strips against plane grid."""
    cases = plane_grid.CASES
    panels = figure.subplots(-(-len(cases) // 2), 2).ravel()
    for axes, case in zip(panels, cases, strict=False):
        compared = compared_methods(plane_grid.compared(case))
        draw_panel(compared.panels[1], compared, axes)
        axes.set_title(case.name, loc="left", fontsize=SMALL_SIZE)
        axes.set_xlabel("y (mm)")
        axes.set_ylabel("difference (%)" if axes.get_subplotspec().is_first_col() else "")
    for axes in panels[len(cases) :]:
        axes.remove()


def draw_free_ends(figure: Figure) -> None:
    """Pressure towards the end of the roller over that in its middle, by strips and plane grid."""
    axes = figure.add_subplot()
    for case, (colour, _) in zip((free_ends.TILTED, free_ends.TOGETHER), LOOKS, strict=False):
        strips, grid = free_ends.by_strips(case), free_ends.on_grid(case)
        for each, look in ((strips, {"color": colour, "label": case.name}), (grid, {"color": INK, "markersize": 3.0})):
            distance = (free_ends.HALF - each.y) / free_ends.half_width(case)
            over = each.centre_pressure / float(np.interp(0.0, each.y, each.centre_pressure))
            axes.plot(distance, over, "-" if each is strips else ".", **look)
    axes.set(
        xscale="log", xlim=(0.02, 10.0), ylim=(0.4, 2.2), xlabel="distance from the end (half-widths)",
        ylabel="p / p in the middle",
    )  # fmt: skip
    axes.legend(loc="upper right", fontsize=SMALL_SIZE)


def draw_depth(figure: Figure) -> None:
    """Stresses against depth below a line and below a circle."""
    depth = np.linspace(0.0, 2.0, 101)
    panels = figure.subplots(1, 2, sharey=True)
    line = subsurface_stress.line(0.3)
    circle = subsurface_stress.point_on_strips(1.0), subsurface_stress.point(1.0)[1], subsurface_stress.CIRCLE
    cases = {"line": (line.solution, line.hertz, subsurface_stress.LINE), "circle": circle}
    for axes, (case, (solution, exact, known)) in zip(panels, cases.items(), strict=True):
        z = exact.half_width * depth
        on_axis, over = stress(solution, 0.0, 0.0, z), passage(solution, 0.0, z[1:])
        curves = {"von_mises": on_axis.von_mises, "shear": on_axis.max_shear}
        curves["orthogonal_shear"] = np.append(0.0, over.orthogonal_shear)
        for (name, values), (colour, dashes) in zip(curves.items(), LOOKS, strict=False):
            label = subsurface_stress.NAMES[name]
            axes.plot(depth, values / exact.max_pressure, color=colour, linestyle=dashes, label=label)
            value, where = known[name]
            axes.plot(where, value, "o", color=colour, mfc="none")
        axes.set_title(case, loc="left", fontsize=SMALL_SIZE)
        axes.set(xlabel="z / b" if case == "line" else "z / a", xlim=(0.0, 2.0), ylim=(0.0, 0.68))
        axes.set_xticks((0.0, 0.5, 1.0, 1.5, 2.0))
    panels[0].set_ylabel("stress / $p_0$")
    panels[0].legend(loc="upper right")


def draw_tilted(figure: Figure) -> None:
    """Von Mises stress in the tilted roller, by strips and by direct summation."""
    tilted, allowed = subsurface_stress.tilted(), 100.0 * subsurface_stress.ALLOWED
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(1.3, 1.0))
    of_stations = tilted.points[0, 0, :, 1]
    y = np.sort(np.concatenate([np.linspace(-9.95, 9.95, 100), np.linspace(-9.9, -9.0, 60), np.linspace(9.3, 9.9, 60)]))
    lower.axhspan(-allowed, allowed, color=PALE)
    for i, (level, (colour, dashes)) in enumerate(zip(subsurface_stress.LEVELS, LOOKS, strict=False)):
        z = float(tilted.points[i, 0, 0, 2])
        automatic, refined, cells = (
            stress(each, 0.0, y, z).von_mises for each in (tilted.automatic, tilted.refined, tilted.grid)
        )
        upper.plot(y, automatic, color=colour, linestyle=dashes, label=f"z = {level:g} b")
        upper.plot(of_stations, von_mises_of(tilted.direct["a"][i, 0]), ".", color=colour, markersize=4.0)
        for each, width in ((automatic, LINE), (refined, THIN)):
            lower.plot(y, 100.0 * (each - cells) / cells.max(), color=colour, linestyle=dashes, linewidth=width)
    upper.set(ylabel="von Mises (MPa)", ylim=(0.0, None))
    upper.legend(loc="lower center", ncols=3)
    lower.set(xlabel="y (mm)", ylabel="difference (%)", xlim=(-10.0, 10.0))


def draw_life(figure: Figure) -> None:
    """Life over load of a line contact, and where the tilted roller fatigues."""
    left, right = figure.subplots(1, 2)
    loads = np.geomspace(0.5, 2.0, 5) * fatigue_life.LOAD_ON_LINE
    models = [lundberg_palmgren(), zaretsky(), weibull(), ioannides_harris()]
    lives = [assess(fatigue_life.line(float(load)), models, body="b") for load in loads]
    for i, (model, (colour, dashes)) in enumerate(zip(models, LOOKS, strict=True)):
        lived = np.array([each[i].damage for each in lives]) ** (-1.0 / model.slope)
        per_length, over = 1e-3 * loads / fatigue_life.LENGTH, lived / lived[loads.size // 2]
        left.loglog(per_length, over, color=colour, linestyle=dashes, label=model.name)
    left.set(xlabel="load per length (kN/mm)", ylabel="life / life under 1 kN/mm", xlim=(0.5, 2.0))
    left.set_xticks([0.5, 1.0, 2.0], ["0.5", "1", "2"])
    left.minorticks_off()
    left.legend(loc="upper right")
    contact = subsurface_stress.tilted_on_strips().contact
    for tilt, (colour, dashes) in zip((0.0, fatigue_life.TILT, 1e-3), LOOKS, strict=False):
        solution = solve(contact, load=fatigue_life.LOAD, tilt=tilt)
        (life,) = assess(solution, "lundberg-palmgren", body="b")
        words = f"{1e3 * tilt:g} mrad: life {life.relative_life:.2f}"
        right.semilogy(life.y, life.density, color=colour, linestyle=dashes, label=words)
    right.set(xlabel="y (mm)", ylabel="damage / ideal", xlim=(-10.0, 10.0), ylim=(1e-3, 10.0))
    right.legend(loc="lower center")


def draw_bearings(figure: Figure) -> None:
    """Draw loads of the rollers of a tapered bearing beside MASTA, and of a cylindrical one beside single contacts."""
    grid = figure.add_gridspec(2, 2, height_ratios=(2.0, 1.0))
    upper = figure.add_subplot(grid[0, 0])
    lower = figure.add_subplot(grid[1, 0], sharex=upper)
    masta = np.array(known_bearings.MASTA.loads)
    loaded = np.count_nonzero(masta)
    degrees = 360.0 / 14 * np.arange(masta.size)
    draw_known(upper, degrees, masta, "MASTA")
    right, hand = figure.add_subplot(grid[:, 1]), bearings.nu206_by_hand()[1]
    draw_known(right, 360.0 / 13 * np.arange(hand.size), hand, "contacts one by one")
    for method, (colour, dashes) in zip(("slices", "strips"), LOOKS, strict=False):
        look = {"color": colour, "linestyle": dashes}
        load = bearings.tapered(method).load[: masta.size, 1]
        upper.plot(degrees, 1e-3 * load, label=method, **look)
        lower.plot(degrees[:loaded], 100.0 * (load[:loaded] / masta[:loaded] - 1.0), marker=".", **look)
        of_nu206 = bearings.nu206(method).load[: hand.size, 0]
        right.plot(360.0 / 13 * np.arange(hand.size), 1e-3 * of_nu206, label=method, **look)
    lower.axhline(0.0, color=FAINT_INK, linewidth=0.6)
    upper.set(ylabel="load (kN)", ylim=(-0.3, 9.5), title="HR30306J")
    lower.set(xlabel="angle from the load (degrees)", ylabel="from MASTA (%)", xlim=(-4.0, 135.0), ylim=(-2.0, 2.0))
    lower.set_xticks(range(0, 121, 30))
    right.set(xlabel="angle from the load (degrees)", ylabel="load (kN)", xlim=(-4.0, 90.0), ylim=(-0.25, 7.7))
    right.set(title="NU 206")
    right.set_xticks(range(0, 91, 30))
    for axes in (upper, right):
        axes.legend(loc="upper right", fontsize=SMALL_SIZE)


def draw_known(axes: Axes, degrees: Array, loads: Array, label: str) -> None:
    """Draw loads [N] that are known."""
    axes.plot(degrees, 1e-3 * loads, "o", color=INK, markersize=5.0, fillstyle="none", label=label)


def draw_roller(figure: Figure) -> None:
    """Load against compression of the roller."""
    draw_load_compression(paper_rollers.ROLLER, figure)


def draw_needle(figure: Figure) -> None:
    """Load against compression of the needle."""
    draw_load_compression(paper_rollers.NEEDLE, figure)


#: How each figure is drawn, and its height [inch], by the name of its file.
FIGURES: dict[str, tuple[Callable[[Figure], None], float]] = {
    "hertz-ellipse": (draw_hertz_ellipse, 4.3),
    "half-space-pressure": (draw_half_space, 3.4),
    "plane-strain-depth": (draw_plane_strain, 3.4),
    "edge-exponents": (draw_edge_exponents, 3.4),
    "free-ends": (draw_quarter_space, 3.4),
    "whole-roller": (draw_whole_roller, 3.4),
    "profiled-roller-footprint": (draw_footprint, 3.6),
    "profiled-roller-pressure": (draw_profiled_pressure, 3.4),
    "load-compression-roller": (draw_roller, 3.4),
    "load-compression-needle": (draw_needle, 3.4),
    "plane-grid-differences": (draw_plane_grid, 7.0),
    "free-ends-plane-grid": (draw_free_ends, 3.4),
    "subsurface-depth": (draw_depth, 3.4),
    "subsurface-tilted-roller": (draw_tilted, 4.8),
    "fatigue-life": (draw_life, 3.4),
    "bearings": (draw_bearings, 3.8),
}
