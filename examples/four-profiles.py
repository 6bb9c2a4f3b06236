"""Fatigue life of a cylindrical roller with four profiles against load, by four models.

Poplawski, Peters and Zaretsky compared a flat roller, one with tapered ends, one with an aerospace profile (a flat
middle and tangential arcs, a partial crown) and a full crown on a flat raceway: Effect of roller profile on cylindrical
roller bearing life prediction, NASA/TM-2000-210368 (2000). Of that report we have its title and a garbled abstract; the
rest of its trends are as others quote them. Its dimensions we do not have: roller, drops and loads below are our own.
So trends are compared here, and not numbers.

Lives are those of the raceway, relative to that under the same load spread evenly over a flat roller without edge
loading. Prints tables and what became of every trend, and writes out/four-profiles.svg.

    python examples/four-profiles.py
"""

import textwrap
import warnings
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, NullLocator

import nonhertz as nh
from nonhertz import life
from nonhertz.plot.sheets import WIDTH, save
from nonhertz.plot.style import FAINT_INK, FIRST, HAIR, INK, LINE, SECOND, SMALL_SIZE, THIN, TITLE_SIZE, sheet_style
from nonhertz.result.edges import EdgeKind

DIAMETER = LENGTH = 12.7  # mm
DESIGN = 2000.0  # MPa, maximum pressure of Hertz's line contact at the design load
PRESSURES = (1200.0, 1600.0, DESIGN, 2300.0, 2600.0)

# Every profile drops as far as it must for the contact to reach the ends at the design load, and no further.
TAPERED_FLAT, TAPERED_DROP = 0.7 * LENGTH, 13.7e-3  # mm; that is an angle of 7.2 mrad
AEROSPACE_FLAT, AEROSPACE_DROP = 0.6 * LENGTH, 12.6e-3  # mm; that is a radius of 256 mm
CROWN_DROP = 18.9e-3  # mm; that is a radius of 1067 mm
OTHER_TAPERS = ((0.6 * LENGTH, 15.3e-3), (0.9 * LENGTH, 9.0e-3))  # flats and drops


def tapered(flat: float, drop: float) -> nh.profile.Profile:
    """Return a profile with a flat middle and straight ends that drop so far."""
    return nh.profile.tapered_ends(straight=flat, angle=np.arctan(2.0 * drop / (LENGTH - flat)))


def arc(length: float, drop: float) -> float:
    """Return the radius of an arc that drops so far over a length that begins at its summit."""
    return (length**2 + drop**2) / (2.0 * drop)


FLAT, TAPERED, AEROSPACE, CROWN = "flat, sharp ends", "tapered end", "aerospace", "full crown"
PROFILES = {
    FLAT: nh.profile.straight(),
    TAPERED: tapered(TAPERED_FLAT, TAPERED_DROP),
    AEROSPACE: nh.profile.partial_crown(
        radius=arc(0.5 * (LENGTH - AEROSPACE_FLAT), AEROSPACE_DROP), straight=AEROSPACE_FLAT
    ),
    CROWN: nh.profile.crown(radius=arc(0.5 * LENGTH, CROWN_DROP)),
}
PROFILED = (TAPERED, AEROSPACE, CROWN)
# The same flat roller, deformed as if it went on beyond its ends: how half-space methods see it.
HALF_SPACE = "flat, ends not freed"

# 40 ksi. With the model's own 360 MPa a line contact below 1440 MPa does no damage at all.
FATIGUE_LIMIT = 276.0  # MPa
VOLUME_MODELS = {
    "Lundberg-Palmgren": life.lundberg_palmgren(),
    "Ioannides-Harris": life.ioannides_harris(fatigue_limit=FATIGUE_LIMIT),
    "Zaretsky": life.zaretsky(),
}
MODELS = VOLUME_MODELS | {"ISO 16281 laminae": life.iso_16281()}
SLOPES = (9.0 / 8.0, 1.5, 2.0)
BY_SLOPE = {
    "Lundberg-Palmgren": [life.lundberg_palmgren(slope=slope) for slope in SLOPES],
    "Ioannides-Harris": [life.ioannides_harris(fatigue_limit=FATIGUE_LIMIT, slope=slope) for slope in SLOPES],
    "Zaretsky": [life.zaretsky(slope=slope) for slope in SLOPES],
}

# How far lives may be apart without a test of a few dozen bearings telling them apart; ours to choose.
SIGNIFICANT = 1.5
LOSS = 0.98  # "as much as"
STEADY = 0.05  # how far an exponent may move and hardly do so

STYLES = {
    FLAT: (INK, "-", "s"),
    TAPERED: (FIRST, "--", "o"),
    AEROSPACE: (SECOND, "-.", "^"),
    CROWN: ("#009E73", (0, (1, 1.2)), "D"),
    HALF_SPACE: (FAINT_INK, (0, (5, 1.5, 1, 1.5, 1, 1.5)), "x"),
}
LIFE_SHOWN = (5e-3, 2.0)


@dataclass(frozen=True)
class Study:
    """Lives and what else is drawn and judged.

    ``relative[profile][model]`` holds one life for each of the pressures. At the design load, ``exponent[model]`` holds
    n of life ~ pressure^-n of the ideal flat roller for each slope, ``crowned[model]`` the crown's relative life,
    ``nearer[profile][model]`` the flat roller's with half as much left out of the volume around its ends, and
    ``highest[profile]`` the maximum pressure. ``sharp_from[profile]`` is the lowest pressure at which a sharp end
    bears.
    """

    pressures: np.ndarray
    relative: dict[str, dict[str, np.ndarray]]
    exponent: dict[str, np.ndarray]
    crowned: dict[str, np.ndarray]
    nearer: dict[str, dict[str, float]]
    sharp_from: dict[str, float]
    highest: dict[str, float]


@dataclass(frozen=True)
class Finding:
    """One trend of the source, how well it is known, and what became of it."""

    trend: str
    known: str
    verdict: str
    found: Sequence[str]


def contact(name: str) -> nh.Contact:
    """Return a roller on the raceway."""
    roller = nh.Roller(diameter=DIAMETER, length=LENGTH, profile=PROFILES.get(name, PROFILES[FLAT]))
    return nh.Contact(replace(roller, side_faces="none") if name == HALF_SPACE else roller, nh.Plate())


def load(pressure: float) -> float:
    """Return the load [N] that gives a flat roller without edge loading a maximum pressure [MPa]."""
    return 0.5 * DIAMETER * LENGTH * np.pi**2 * contact(FLAT).compliance * pressure**2


def solve(bodies: nh.Contact, pressure: float, strips: int | None = None) -> nh.Solution:
    """Return the contact under the load of a pressure; what the solver warns of is in the solution."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        return nh.solve(bodies, load=load(pressure), strips=strips)


def ends_sharply(solution: nh.Solution) -> bool:
    """Return whether the pressure has no limit at an end."""
    return any(end.kind is EdgeKind.SINGULAR for end in solution.edge_pressure)


def study(pressures: Sequence[float] = PRESSURES, strips: int | None = None) -> Study:
    """Return the lives of all rollers; the design load must be among two or more pressures."""
    at = list(pressures).index(DESIGN)
    wanted = [*MODELS.values(), *(each for several in BY_SLOPE.values() for each in several)]
    relative, nearer, sharp_from, highest, lives = {}, {}, {}, {}, {}
    for name in (*PROFILES, HALF_SPACE):
        solutions = [solve(contact(name), pressure, strips) for pressure in pressures]
        lives[name] = [dict(zip(wanted, life.assess(each, wanted, body="b"), strict=True)) for each in solutions]
        relative[name] = {
            label: np.array([each[model].relative_life for each in lives[name]]) for label, model in MODELS.items()
        }
        sharp = [p for p, each in zip(pressures, solutions, strict=True) if ends_sharply(each)]
        sharp_from[name] = min(sharp, default=np.inf)
        highest[name] = solutions[at].max_pressure
        if name in (FLAT, HALF_SPACE):
            nearer[name] = _nearer(solutions[at])
    exponent = {
        label: np.array([_exponents(pressures, [each[model] for each in lives[FLAT]])[at] for model in several])
        for label, several in BY_SLOPE.items()
    }
    crowned = {
        label: np.array([lives[CROWN][at][model].relative_life for model in several])
        for label, several in BY_SLOPE.items()
    }
    return Study(np.array(pressures), relative, exponent, crowned, nearer, sharp_from, highest)


def _exponents(pressures: Sequence[float], lives: Sequence[life.Life]) -> np.ndarray:
    """Return n of life ~ pressure^-n at every pressure, for the ideal flat roller."""
    slope = lives[0].model.slope
    return np.gradient(np.log([each.reference for each in lives]), np.log(pressures)) / slope


def _nearer(solution: nh.Solution) -> dict[str, float]:
    """Return relative lives with only a twentieth of the half-width around sharp ends left out, not a tenth."""
    seen = life.exposure(solution, body="b")
    away = [np.hypot(seen.y[:, None] - end, seen.z) for end in seen.sharp]
    seen = replace(seen, counted=np.min(away, axis=0) >= 0.05 * seen.half_width.max())
    return {
        label: (seen.reference.damage(model) / seen.damage(model)) ** (1.0 / model.slope)
        for label, model in VOLUME_MODELS.items()
    }


def judge(results: Study) -> Iterator[Finding]:
    """Yield the source's trends and what became of them."""
    yield _flat_lives_longest(results)
    yield _edges_cost(results)
    yield _tapered_is_best(results)
    yield _tapered_is_like_aerospace(results)
    yield _crown_is_worst(results)
    yield _exponents_follow_the_slope(results)


def verdict(holds: Sequence[bool] | np.ndarray) -> str:
    """Return how often a trend holds, in words."""
    holds = np.ravel(holds)
    if holds.all():
        return "agrees"
    return f"holds in {holds.sum()} of {holds.size} cases" if holds.any() else "differs"


def ratios(results: Study, name: str, others: Sequence[str], pick=np.max) -> dict[str, np.ndarray]:
    """Return the life of a profile over the longest or shortest of others, by model."""
    return {
        model: results.relative[name][model] / pick([results.relative[other][model] for other in others], axis=0)
        for model in MODELS
    }


def _span(values: np.ndarray) -> str:
    low, high = float(np.min(values)), float(np.max(values))
    return f"{low:.3g}" if np.isclose(low, high, rtol=5e-3) else f"{low:.3g} to {high:.3g}"


def _percent(share: float | np.ndarray) -> str:
    # The ends of a flat roller relieve its middle: what costs less than nothing is a gain.
    low, high = 100.0 * np.min(share), 100.0 * np.max(share)
    least = f"a gain of {-low:.1f}" if low < 0.0 else f"{low:.1f}"
    return f"{least} %" if high - low < 0.05 else f"{least} to {high:.1f} %"


def _flat_lives_longest(results: Study) -> Finding:
    longest = {m: np.max([results.relative[name][m] for name in PROFILED], axis=0) for m in MODELS}
    sharp = results.relative[FLAT]
    found = [f"{model}: the best of the others lives {_span(longest[model])} times as long" for model in MODELS]
    beyond = [f"{m} ({sharp[m].max():.3f})" for m in MODELS if sharp[m].max() > 1.0]
    if beyond:
        found.append(
            "But with its sharp ends the flat roller outlives the one without edge loading by "
            f"{', '.join(beyond)}: what the ends bear relieves the middle, and what is nearest to them is left out."
        )
    return Finding(
        "A flat roller without edge loading lives longest.",
        "as the abstract says",
        verdict([longest[model] < 1.0 for model in MODELS]),
        found,
    )


def _edges_cost(results: Study) -> Finding:
    reached, found = [], []
    for name, faces in ((FLAT, "ends freed"), (HALF_SPACE, "ends not freed, as in half-space methods")):
        for model in VOLUME_MODELS:
            lives = results.relative[name][model]
            reached.append(1.0 - lives.min() >= LOSS)
            at_design = 1.0 - lives[results.pressures == DESIGN][0], 1.0 - results.nearer[name][model]
            found.append(
                f"{model}, {faces}: {_percent(1.0 - lives)}; at the design load {_percent(at_design[0])}, "
                f"with half as much left out {_percent(at_design[1])}"
            )
    for name, faces in ((FLAT, "ends freed"), (HALF_SPACE, "ends not freed")):
        lives = results.relative[name]["ISO 16281 laminae"]
        reached.append(1.0 - lives.min() >= LOSS)
        found.append(f"ISO 16281 laminae, {faces}: {_percent(1.0 - lives)}")
    trend = f"Edge loading can cost as much as {_percent(LOSS)}."
    return Finding(trend, "as the abstract says", verdict(reached), found)


def _tapered_is_best(results: Study) -> Finding:
    over = ratios(results, TAPERED, (AEROSPACE, CROWN))
    found = [f"{model}: {_span(values)} times the better of the two others" for model, values in over.items()]
    for flat, drop in OTHER_TAPERS:
        bodies = nh.Contact(nh.Roller(diameter=DIAMETER, length=LENGTH, profile=tapered(flat, drop)), nh.Plate())
        lives = life.assess(solve(bodies, DESIGN), list(MODELS.values()), body="b")
        at = results.pressures == DESIGN
        each = [one.relative_life / results.relative[AEROSPACE][m][at][0] for m, one in zip(MODELS, lives, strict=True)]
        found.append(
            f"With {100.0 * flat / LENGTH:.0f} % flat, at the design load, by the four models: {_numbers(each)} times "
            "the aerospace profile"
        )
    tapered_highest, aerospace_highest = results.highest[TAPERED], results.highest[AEROSPACE]
    found.append(
        f"At the design load its corners bear {tapered_highest:.0f} MPa, more with finer strips; the aerospace one "
        f"bears {aerospace_highest:.0f} at most."
    )
    trend = "The tapered end is the best of those with a drop."
    return Finding(trend, "as quoted, the text not seen", verdict([values >= 1.0 for values in over.values()]), found)


def _tapered_is_like_aerospace(results: Study) -> Finding:
    over = ratios(results, TAPERED, (AEROSPACE,))
    return Finding(
        f"It is not significantly different from the aerospace profile (here: by less than {SIGNIFICANT:g} times).",
        "as quoted, the text not seen",
        verdict([np.abs(np.log(values)) < np.log(SIGNIFICANT) for values in over.values()]),
        [f"{model}: {_span(values)} times" for model, values in over.items()],
    )


def _crown_is_worst(results: Study) -> Finding:
    over = ratios(results, CROWN, (TAPERED, AEROSPACE), np.min)
    return Finding(
        "The full crown is the worst of those with a drop.",
        "as quoted, the text not seen",
        verdict([values <= 1.0 for values in over.values()]),
        [f"{model}: {_span(values)} times the worse of the two others" for model, values in over.items()],
    )


def _exponents_follow_the_slope(results: Study) -> Finding:
    falls = {model: exponents[-1] < (1.0 - STEADY) * exponents[0] for model, exponents in results.exponent.items()}
    found = [
        f"{model}: {_numbers(results.exponent[model])}; the crown lives {_numbers(results.crowned[model])} times as "
        "long as the ideal roller"
        for model in BY_SLOPE
    ]
    slopes = ", ".join(f"{slope:g}" for slope in SLOPES)
    trend = (
        "Lives depend on the equation and on Weibull's slope: n of life ~ pressure^-n falls with it by "
        f"Lundberg-Palmgren and Ioannides-Harris, and hardly moves by Zaretsky. Here n at slopes {slopes}."
    )
    holds = [falls["Lundberg-Palmgren"], falls["Ioannides-Harris"], not falls["Zaretsky"]]
    return Finding(trend, "as quoted, the text not seen", verdict(holds), found)


def _numbers(values: Iterable[float]) -> str:
    return ", ".join(f"{value:.2f}" for value in values)


def report(results: Study) -> None:
    """Print the tables and what became of the trends."""
    print("Life of the raceway over that under an ideal flat roller [-]")
    print(f"\n{'Hertz line pressure [MPa]':<28}" + "".join(f"{p:10.0f}" for p in results.pressures))
    print(f"{'load [kN]':<28}" + "".join(f"{1e-3 * load(p):10.2f}" for p in results.pressures))
    for model in MODELS:
        print(model)
        for name, lives in results.relative.items():
            print(f"  {name:<26}" + "".join(f"{value:10.3g}" for value in lives[model]))
    print("\nSharp ends, where the pressure has no limit and the solver says so:")
    for name, pressure in results.sharp_from.items():
        print(f"  {name:<26}" + (f"reached from {pressure:.0f} MPa on" if np.isfinite(pressure) else "not reached"))
    for number, finding in enumerate(judge(results), start=1):
        print(f"\n{number}. " + textwrap.fill(f"{finding.trend} ({finding.known})", 110, subsequent_indent="   "))
        print(f"   {finding.verdict.upper()}")
        for sentence in finding.found:
            print(textwrap.fill(sentence, 110, initial_indent="   - ", subsequent_indent="     "))


def draw(results: Study) -> Figure:
    """Return the figure: reliefs, lives by four models, and what the slope does."""
    with sheet_style():
        figure = Figure(figsize=(WIDTH, 7.4), layout="constrained")
        figure.get_layout_engine().set(w_pad=0.06, h_pad=0.05)
        figure.suptitle("Life of the raceway under four roller profiles", fontsize=TITLE_SIZE, weight="bold")
        panels = figure.subplots(3, 2)
        _draw_reliefs(panels[0, 0])
        for axes, letter, model in zip(panels.flat[1:5], "bcde", MODELS, strict=True):
            _draw_lives(axes, results, model)
            axes.set_title(f"({letter}) {model}", loc="left")
        panels[0, 1].text(
            1e-3 * DESIGN + 0.02, 1.15 * LIFE_SHOWN[0], "design load", color=FAINT_INK, fontsize=SMALL_SIZE
        )
        _draw_exponents(panels[2, 1], results)
        for axes in panels.flat:
            axes.spines[["top", "right"]].set_visible(False)
        figure.legend(*panels[0, 1].get_legend_handles_labels(), loc="outside lower center", ncols=5, handlelength=3.2)
        # Ticks are chosen when the figure is drawn, by then perhaps under other settings.
        figure.draw_without_rendering()
        return figure


def _draw_reliefs(axes) -> None:
    y = np.linspace(0.0, 0.5 * LENGTH, 400)
    for name, profile in PROFILES.items():
        colour, dashes, _ = STYLES[name]
        axes.plot(y, 1e3 * profile.relief(y), color=colour, linestyle=dashes, linewidth=LINE)
    axes.set(xlabel="$y$ from the middle [mm]", ylabel="Relief [\u03bcm]", xlim=(0.0, 0.5 * LENGTH), ylim=(20.0, -1.0))
    axes.set_title("(a) Profiles, half of the length", loc="left")


def _draw_lives(axes, results: Study, model: str) -> None:
    pressure = 1e-3 * results.pressures
    for name, lives in results.relative.items():
        colour, dashes, marker = STYLES[name]
        axes.plot(pressure, lives[model], color=colour, linestyle=dashes, linewidth=LINE, marker=marker, markersize=3.2,
                  label=name)  # fmt: skip
    axes.axhline(1.0, color=FAINT_INK, linewidth=HAIR, zorder=1.0)
    axes.axvline(1e-3 * DESIGN, color=FAINT_INK, linewidth=HAIR, zorder=1.0)
    axes.set(yscale="log", ylim=LIFE_SHOWN, xlabel="Hertz line pressure [GPa]", ylabel="Life / ideal life")
    axes.yaxis.set_major_locator(FixedLocator([0.01, 0.03, 0.1, 0.3, 1.0]))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter("{x:g}")
    axes.set_xticks([1.2, 1.6, 2.0, 2.4])


def _draw_exponents(axes, results: Study) -> None:
    for (model, exponents), colour, marker in zip(results.exponent.items(), (FIRST, SECOND, INK), "ovs", strict=True):
        axes.plot(SLOPES, exponents, color=colour, linewidth=THIN, marker=marker, markersize=4.0)
        axes.text(SLOPES[-1] + 0.04, exponents[-1], model, color=colour, fontsize=SMALL_SIZE, va="center")
    axes.set(xlim=(1.0, 3.1), ylim=(0.0, None), xlabel="Weibull's slope [-]", ylabel="$n$ of life ~ pressure$^{-n}$")
    axes.set_xticks(SLOPES, ["9/8", "1.5", "2"])
    axes.set_title("(f) Ideal flat roller, design load", loc="left")


def main(out: Path = Path("out"), pressures: Sequence[float] = PRESSURES, strips: int | None = None) -> Study:
    """Print the report, write the figure, return the study."""
    results = study(pressures, strips)
    report(results)
    out.mkdir(parents=True, exist_ok=True)
    save(draw(results), out / "four-profiles")
    return results


if __name__ == "__main__":
    main()
