"""Make the pictures in docs/figures and the terminal output in the tutorials.

    python docs/figures.py

Pictures of examples are those that `nonhertz solve --out` writes; those of finite bodies are drawn here. In the
tutorials every line that begins with `$ nonhertz` is run and what it prints put below it; a comment `<!-- edit: `old`
to `new` -->` edits the case file in between. The pictures of the first solve are of its own case, as edited by then,
and those of the tutorial of bearing loads of the bearing that its lines of Python make.
"""

from __future__ import annotations

import contextlib
import doctest
import importlib.util
import io
import itertools
import os
import re
import shlex
import tempfile
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import FancyArrowPatch, Rectangle
from matplotlib.ticker import NullFormatter

import nonhertz as nh
from nonhertz.cli import main as nonhertz
from nonhertz.files.casefile import Case, read_case
from nonhertz.files.traces import read_trace
from nonhertz.plot import bearing_figures, figures, life_figure, measured_figure, save, stress_figures
from nonhertz.plot.sheets import WIDTH
from nonhertz.plot.studies import study_lines
from nonhertz.plot.style import (
    END_DASHES,
    FAINT_INK,
    FIRST,
    HAIR,
    INK,
    PALE,
    SECOND,
    SMALL_SIZE,
    THIN,
    sheet_style,
)

ROOT = Path(__file__).parents[1]
FIGURES = ROOT / "docs" / "figures"
TUTORIAL = ROOT / "docs" / "tutorials" / "first-solve.md"
BEARING_TUTORIAL = ROOT / "docs" / "tutorials" / "bearing-loads.md"
LIFE_TUTORIAL = ROOT / "docs" / "tutorials" / "bearing-life.md"
EDGE_LOADING = ROOT / "docs" / "how-to" / "edge-loading.md"
# Picture's name to the example it is of, and which of its figures the documents show.
EXAMPLES = {
    "bearing": ("cylindrical-roller-bearing", ("pressure",)),
    "crown": ("crowned-roller", ("pressure",)),
    "tabulated": ("tabulated-profile", ("pressure",)),
}

# Of the pictures of finite bodies: a roller, and the load on each millimetre of it.
DIAMETER, LENGTH, LINE_LOAD = 20.0, 20.0, 1000.0  # mm, mm, N/mm
SLENDERNESS = np.geomspace(0.5, 50.0, 13)  # length / diameter
# Of the sketch of images, in lengths of the body: where the strip is and how wide, how far the sketch goes.
STRIP_AT, STRIP_WIDTH, SKETCHED = 0.18, 0.12, 2.55

PYCON = re.compile(r"^```pycon\n(.*?)^```$", re.MULTILINE | re.DOTALL)
STEP = re.compile(r"<!-- edit: `(?P<old>.*?)` to `(?P<new>.*?)` -->|```console\n(?P<lines>.*?)```", re.DOTALL)
NUMBER = re.compile(r"-?\d+\.?\d*(?:e[+-]\d+)?")


def main() -> None:
    """Make everything."""
    FIGURES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        case = Path(folder, "first-solve.toml")
        nonhertz_quietly(["new", str(case)])
        draw("first-solve", read_case(case), ("pressure", "footprint", "profile"))
        edit_as_before("first-solve-crown-pressure.png", case)
        draw("first-solve-crown", read_case(case), ("pressure",))
    for stem, (example, names) in EXAMPLES.items():
        draw(stem, read_case(ROOT / "examples" / f"{example}.toml"), names)
    draw_finite_bodies()
    draw_below("bearing", read_case(ROOT / "examples" / f"{EXAMPLES['bearing'][0]}.toml"))
    draw_four_profiles()
    draw_measured("measured-roller")
    draw_bearing("whole-bearing")
    draw_bearing_tutorial("bearing-life")
    draw_edge_loading("edge-loading")
    for page in (TUTORIAL, LIFE_TUTORIAL):
        page.write_text(with_output(page.read_text(encoding="utf-8")), encoding="utf-8")
        print(f"wrote {page.relative_to(ROOT)}")


def edit_as_before(picture: str, case: Path) -> None:
    """Edit a case file as the tutorial does before it shows a picture."""
    before, found, _ = TUTORIAL.read_text(encoding="utf-8").partition(picture)
    if not found:
        raise ValueError(f"{TUTORIAL} does not show {picture}")
    for step in STEP.finditer(before):
        if step["lines"] is None:
            edit(case, step["old"], step["new"])


def edit(case: Path, old: str, new: str) -> None:
    """Replace a text in a case file."""
    text = case.read_text(encoding="utf-8")
    if old not in text:
        raise ValueError(f"{case} has no {old!r}")
    case.write_text(text.replace(old, new), encoding="utf-8")


def draw(stem: str, case: Case, names: tuple[str, ...]) -> None:
    """Write the figures of a case as ``stem``-pressure.svg and so on."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        solution = nh.solve(case.contact, **case.prescribed.keywords, **case.solver.keywords)
    drawn = figures(solution, case.title)
    for name in names:
        write(drawn[name], f"{stem}-{name}")


def write(figure: Figure, stem: str) -> None:
    """Write a figure as ``stem``.png."""
    vector, pixels = save(figure, FIGURES / stem)
    # One copy is enough for the documents.
    vector.unlink()
    print(f"wrote {pixels.relative_to(ROOT)}")


def draw_below(stem: str, case: Case) -> None:
    """Write the pictures of stress below the surface, and of where it makes the bodies fatigue."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        solution = nh.solve(case.contact, **case.prescribed.keywords, **case.solver.keywords)
    overall = nh.subsurface.extremes(solution)
    section = nh.subsurface.extremes(solution, overall.von_mises.y)
    for name, figure in stress_figures(solution, overall, section, case.title).items():
        write(figure, f"{stem}-{name}")
    lives = {body: nh.life.assess(solution, body=body) for body in "ab"}
    write(life_figure([(solution, 1.0)], lives, case.title), f"{stem}-life-density")


def draw_four_profiles() -> None:
    """Write the figure of the example of four profiles."""
    specification = importlib.util.spec_from_file_location("four_profiles", ROOT / "examples" / "four-profiles.py")
    assert specification is not None
    assert specification.loader is not None
    example = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(example)
    write(example.draw(example.study()), "four-profiles")


def draw_measured(stem: str) -> None:
    """Write the figure of the steps of a measured profile, with the profile of the catalogue that fits best."""
    trace = read_trace(ROOT / "examples" / f"{stem}.txt")
    measured = nh.measured.prepare(trace)
    write(measured_figure(measured, trace.name, measured.fit_best()[0]), stem)


def draw_bearing(stem: str) -> None:
    """Write the pictures of the bearing of the how-to page."""
    drawn = bearing_figures(nh.bearing.solve(nh.new_bearing().bearing, radial=10e3, tilt=3e-4), "NU 206, misaligned")
    for name in ("loads", "pressure"):
        write(drawn[name], f"{stem}-{name}")


def draw_bearing_tutorial(stem: str) -> None:
    """Write the pictures of the bearing's tutorial, from its own lines of Python up to them."""
    before, step, _ = BEARING_TUTORIAL.read_text(encoding="utf-8").partition("## 5 Look at the figures")
    if not step:
        raise ValueError(f"{BEARING_TUTORIAL} has no step for figures")
    drawn = bearing_figures(run_examples(before)["first"], "NU 206 in first gear")
    for name in ("loads", "pressure", "roller"):
        write(drawn[name], f"{stem}-{name}")


def draw_edge_loading(stem: str) -> None:
    """Write the chart of pressure and life over misalignment, from the page's own lines of Python."""
    results = run_examples(EDGE_LOADING.read_text(encoding="utf-8"))
    tilts = 1e3 * results["tilts"]
    with sheet_style():
        figure = Figure(figsize=(WIDTH, 3.2), layout="constrained")
        pressure, life = figure.subplots(1, 2)
        tilt = "Misalignment [mrad]"
        study_lines(tilts, results["pressures"], pressure, x_label=tilt, y_label="Maximum pressure [MPa]")
        study_lines(tilts, results["lives"], life, x_label=tilt, y_label="Life L10r [million revolutions]")
        life.get_legend().remove()
        pressure.set_ylim(bottom=0)
    write(figure, stem)


def run_examples(page: str) -> dict[str, Any]:
    """Run a page's lines of Python; return their variables."""
    names: dict[str, Any] = {}
    for block in PYCON.findall(page):
        for example in doctest.DocTestParser().get_examples(block):
            exec(compile(example.source, "page", "single"), names)
    return names


def draw_finite_bodies() -> None:
    """Write the pictures of images, of free ends and of depth."""
    with sheet_style():
        write(images_sketch(), "images")
        write(free_ends(), "free-ends")
        write(approach_over_length(), "depth")


def images_sketch() -> Figure:
    """Return a sketch of a strip and its images: body a ends at two faces, body b has none."""
    figure = Figure(figsize=(WIDTH, 3.0))
    axes = figure.add_axes((0.01, 0.01, 0.98, 0.98))
    axes.set(xlim=(-SKETCHED, SKETCHED), ylim=(-1.0, 1.42))
    axes.axis("off")
    beyond = (-2.0 * SKETCHED, 4.0 * SKETCHED)
    axes.add_patch(Rectangle((beyond[0], 0.0), beyond[1], 0.32, fill=False, linewidth=HAIR, edgecolor=FAINT_INK))
    axes.add_patch(Rectangle((-0.5, 0.0), 1.0, 0.32, facecolor=PALE, edgecolor=INK, linewidth=THIN))
    axes.add_patch(Rectangle((beyond[0], -0.9), beyond[1], 0.32, facecolor=PALE, edgecolor=INK, linewidth=THIN))
    for face, name in ((-0.5, "$f_1$"), (0.5, "$f_2$")):
        axes.plot([face, face], [-0.06, 0.7], color=INK, linewidth=THIN)
        axes.text(face, -0.08, name, ha="center", va="top")
    low, high = -1.0 - STRIP_AT, 1.0 - STRIP_AT
    for y, colour, weight in (
        (low, SECOND, r"$\psi_1$"),
        (high, SECOND, r"$\psi_2$"),
        (STRIP_AT + 2.0, FAINT_INK, r"$\psi_1\,\min(\psi_2, 1)$"),
        (STRIP_AT - 2.0, FAINT_INK, r"$\psi_2\,\min(\psi_1, 1)$"),
    ):
        axes.add_patch(
            Rectangle((y - 0.5 * STRIP_WIDTH, 0.32), STRIP_WIDTH, 0.24, linewidth=THIN, linestyle="--",
                      edgecolor=colour, facecolor="white")
        )  # fmt: skip
        axes.text(y, 0.14, weight, ha="center", va="center", color=colour)
    for surface in (0.32, -0.58):
        axes.add_patch(Rectangle((STRIP_AT - 0.5 * STRIP_WIDTH, surface), STRIP_WIDTH, 0.24, facecolor=FIRST))
        axes.text(STRIP_AT, surface - 0.18, "1", ha="center", va="center", color=FIRST)
    for start, stop, colour, bow, free in (
        (STRIP_AT, high, SECOND, -0.3, 1.0),
        (STRIP_AT, low, SECOND, 0.25, 1.0),
        (high, STRIP_AT - 2.0, FAINT_INK, 0.42, 10.0),
        (low, STRIP_AT + 2.0, FAINT_INK, -0.38, 10.0),
    ):
        axes.add_patch(
            FancyArrowPatch(
                (start, 0.58), (stop, 0.58), arrowstyle="-|>", mutation_scale=7.0, linewidth=THIN, color=colour,
                connectionstyle=f"arc3,rad={bow}", shrinkA=free, shrinkB=1.0,
            )
        )  # fmt: skip
    axes.text(-0.46, 0.14, "body a", va="center", fontsize=SMALL_SIZE)
    axes.text(-0.46, -0.76, "body b", va="center", fontsize=SMALL_SIZE)
    return figure


def free_ends() -> Figure:
    """Return the pressure towards the end of a straight roller on a ring, by what is behind the end."""
    cases = (
        ("half-spaces", "none", None, FAINT_INK, ":"),
        ("roller mirrored", "mirror", None, SECOND, "--"),
        ("roller free (default)", "free", None, FIRST, "-"),
        ("ring as long, both free", "free", LENGTH, INK, END_DASHES),
    )
    figure = Figure(figsize=(WIDTH, 3.2))
    along = figure.add_axes((0.09, 0.155, 0.4, 0.8))
    near = figure.add_axes((0.575, 0.155, 0.4, 0.8))
    for name, faces, width, colour, dashes in cases:
        roller = nh.Roller(diameter=DIAMETER, length=LENGTH, side_faces=faces)
        contact = nh.Contact(roller, nh.Ring(diameter=4.0 * DIAMETER, length=width))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", nh.AccuracyWarning)
            solution = nh.solve(contact, load=LINE_LOAD * LENGTH)
        middle = solution.strips // 2
        ratio = solution.centre_pressure / solution.centre_pressure[middle]
        distance = (0.5 * LENGTH - solution.y) / solution.half_width[middle]
        shown = distance > 0.03  # the last strips say nothing
        along.plot(solution.y[shown], ratio[shown], color=colour, linestyle=dashes, label=name)
        alpha = solution.edge_pressure[1].exponent
        exponent = rf"$\alpha$ = {alpha:.3g}" if alpha > 0.0 else "finite"
        near.loglog(distance[shown], ratio[shown], color=colour, linestyle=dashes, label=exponent)
    along.set(xlim=(0.0, 10.3), ylim=(0.6, 3.2), xlabel="$y$ [mm]", ylabel="pressure / that in the middle")
    near.set(xlim=(0.03, 30.0), ylim=(0.6, 5.0), xlabel="distance from the end / half-width")
    near.set_yticks([0.6, 0.8, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0], ["0.6", "0.8", "1", "1.5", "2", "3", "4", "5"])
    near.yaxis.set_minor_formatter(NullFormatter())
    near.set_xticks([0.1, 1.0, 10.0], ["0.1", "1", "10"])
    along.legend(loc="upper left")
    near.legend(loc="upper right")
    return figure


def approach_over_length() -> Figure:
    """Return the approach of two equal rollers under the same load per length, over their length."""
    cases = (
        ("half-spaces", "none", "none", SECOND, ":"),
        ('depth = "diameter"', "mirror", "diameter", INK, "--"),
        ('depth = "plane-strain"', "mirror", "plane-strain", FIRST, "-"),
    )
    figure = Figure(figsize=(WIDTH, 3.0))
    axes: Axes = figure.add_axes((0.09, 0.165, 0.885, 0.79))
    for name, faces, depth, colour, dashes in cases:
        approach = [pressed_together(DIAMETER * ratio, faces, depth) for ratio in SLENDERNESS]
        axes.semilogx(SLENDERNESS, 1e3 * np.array(approach), color=colour, linestyle=dashes, label=name)
    steel = nh.MATERIALS["steel"]
    line = nh.hertz.line_contact(line_load=LINE_LOAD, radius=0.25 * DIAMETER, compliance=2.0 * steel.compliance)
    exact = nh.hertz.plane_strain_cylinder_compression(line, diameter=DIAMETER, material=steel)
    axes.plot(SLENDERNESS[4:-1:2], np.full(SLENDERNESS[4:-1:2].shape, 2e3 * exact), "o", color=FAINT_INK, mfc="none",
              markersize=5.0, label="plane strain, closed form")  # fmt: skip
    axes.set(xlabel="length / diameter", ylabel="approach [\u03bcm]", xlim=(0.5, 50.0), ylim=(20.0, 55.0))
    axes.set_xticks([0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0], ["0.5", "1", "2", "5", "10", "20", "50"])
    axes.legend(loc="upper left")
    return figure


def pressed_together(length: float, faces: str, depth: str) -> float:
    """Return the approach [mm] of two equal straight rollers of a length."""
    roller = nh.Roller(diameter=DIAMETER, length=length, side_faces=faces, depth=depth)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        return nh.solve(nh.Contact(roller, roller), load=LINE_LOAD * length).approach


def with_output(page: str) -> str:
    """Return a page with what its commands print, run one after the other in an empty directory."""
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        return STEP.sub(_step, page)


def _step(found: re.Match[str]) -> str:
    if found["lines"] is None:
        (case,) = Path().glob("*.toml")
        edit(case, found["old"], found["new"])
        return found[0]
    commands = [line for line in found["lines"].splitlines() if line.startswith("$ nonhertz ")]
    shown = [f"{line}\n{abridged(nonhertz_quietly(shlex.split(line)[2:]), found['lines'])}" for line in commands]
    return "```console\n" + "".join(shown) + "```"


def abridged(printed: str, before: str) -> str:
    """Return an output without the lines for which a page shows dots; lines are the same if only numbers differ."""
    if "...\n" not in before:
        return printed
    shown = {NUMBER.sub("0", line) for line in before.splitlines()}
    lines = (line if NUMBER.sub("0", line) in shown else "..." for line in printed.splitlines())
    return "".join(f"{line}\n" for line, _ in itertools.groupby(lines))


def nonhertz_quietly(words: list[str]) -> str:
    """Run the command line and return what it prints."""
    printed = io.StringIO()
    # The width of the table's lines must not depend on whose terminal this runs in.
    os.environ["COLUMNS"] = "100"
    with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
        nonhertz(words)
    return "".join(f"{line.rstrip()}\n" for line in printed.getvalue().splitlines())


if __name__ == "__main__":
    main()
