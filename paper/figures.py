"""Make the figure of the paper, and the paper from its template and the numbers of this repository.

    python paper/figures.py

Numbers come from docs/validation and docs/benchmarks, which `make docs-numbers` and `make bench` write, but for that of
the figure, which is computed here and kept in figure.json.
"""

from __future__ import annotations

import json
import re
import textwrap
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure

import nonhertz as nh
from nonhertz.plot.style import FIRST, INK, sheet_style

PAPER = Path(__file__).resolve().parent
ROOT = PAPER.parent
VALIDATION = ROOT / "docs/validation"
BENCHMARKS = ROOT / "docs/benchmarks"

HALF_SPACE: dict[str, Any] = {"side_faces": "none", "depth": "none"}
ROLLER = nh.Contact(
    nh.Roller(diameter=20, length=20, profile=nh.profile.iso_logarithmic(diameter=20, length=20), **HALF_SPACE),
    nh.Plate(**HALF_SPACE),
)
WRAPPING: dict[str, Any] = {"break_long_words": False, "break_on_hyphens": False}
RADII, STEEL = (10.0, 100.0), nh.Material(206000.0, 0.3)


def claim(page: str, of: str) -> str:
    """Return the number of claims that is set into a page of the validation."""
    text = (VALIDATION / f"{page}.md").read_text(encoding="utf-8")
    return found(text, re.escape(f"<!-- off {of} -->") + r"(.*?)<!-- \. -->")[0]


def found(text: str, pattern: str) -> tuple[str, ...]:
    """Return the groups of the only place that a pattern matches; a text that was reworded must be read again."""
    (match,) = re.finditer(pattern, text)
    return match.groups()


def numbers() -> dict[str, str]:
    """Return the numbers of the text, by the names in the template."""
    overview = (VALIDATION / "index.md").read_text(encoding="utf-8")
    checks, failed, shown = found(overview, r"\n\| all \| (\d+) \| (\d+) \| (\d+) \|")
    results = json.loads((BENCHMARKS / "results.json").read_text(encoding="utf-8"))
    times = [1e3 * case["time"] for case in results["automatic"].values()]
    race = (BENCHMARKS / "race.md").read_text(encoding="utf-8")
    least, most = found(race, r"The ratio to the best peer is (\S+) to (\S+);")
    machine = results["machine"]
    assert machine["processor"] == json.loads((BENCHMARKS / "race.json").read_text("utf-8"))["machine"]["processor"]
    figure = json.loads((PAPER / "figure.json").read_text(encoding="utf-8"))
    return {
        "checks": checks,
        "judged": str(int(checks) - int(shown)),
        "failed": {"0": "none"}.get(failed, failed),
        "shown": shown,
        "hertz_pressure": claim("hertz", "hertz-ellipse/semi-elliptic-automatic-grid-greatest-pressure"),
        "hertz_approach": claim("hertz", "hertz-ellipse/semi-elliptic-automatic-grid-approach"),
        "free_approach": claim("free-ends", "free-ends/*-approach"),
        "free_moment": claim("free-ends", "free-ends/straight-tilted-moment,free-ends/[tlw]*moment"),
        "whole": claim("whole-roller", "whole-roller/whole-roller*y-[0589]*"),
        "slices": claim("bearings", "bearings/hr30306j-slices-load-at-[0-9]*.[041789]-degrees"),
        "strips": claim("bearings", "bearings/hr30306j-strips-load-at-[0-9]*.[041789]-degrees"),
        "fastest": f"{min(times):.1f}",
        "slowest": f"{max(times):.1f}",
        "race_least": least,
        "race_most": most,
        "processor": f"one core of an {machine['processor']} processor",
        "figure_difference": f"{100 * figure['difference']:.2f} %",
    }


def text() -> str:
    """Return the paper, with its paragraphs wrapped anew."""
    _, head, body = (PAPER / "template.md").read_text(encoding="utf-8").format_map(numbers()).split("---\n", 2)
    paragraphs = (textwrap.fill(each, 120, **WRAPPING) for each in body.strip().split("\n\n"))
    return "\n".join(("---", f"{head}---", "", "\n\n".join(paragraphs), ""))


def draw() -> None:
    """Draw the figure, and keep its number."""
    with sheet_style():
        sheet = Figure(figsize=(7.0, 2.6), layout="constrained")
        roller, ellipse = sheet.subplots(1, 2)
        difference = draw_roller(roller)
        draw_ellipse(ellipse)
        for ax in (roller, ellipse):
            ax.set_xlabel("y [mm]")
            ax.set_ylabel("pressure [MPa]")
            ax.set_ylim(bottom=0.0)
            ax.legend(frameon=False)
        sheet.savefig(PAPER / "verification.png", dpi=200)
    (PAPER / "figure.json").write_text(json.dumps({"difference": difference}) + "\n", encoding="utf-8")


def draw_roller(ax: Any) -> float:
    """Draw the tilted roller, and return how far strips and plane grid differ, of the maximum pressure."""
    strips = nh.solve(ROLLER, load=20e3, tilt=0.5e-3)
    grid = nh.patch.solve(ROLLER, load=20e3, tilt=0.5e-3, cells=(64, 512))
    pressure = grid.centre_pressure
    ax.plot(grid.y, pressure, color=INK, label="plane grid")
    ax.plot(strips.y, strips.centre_pressure, "o", color=FIRST, markersize=3, fillstyle="none", label="strips")
    ends = strips.contact_y
    width = float(strips.half_width.max())
    inner = (strips.y > ends[0][0] + width) & (strips.y < ends[-1][1] - width)
    apart = np.abs(np.interp(strips.y[inner], grid.y, pressure) - strips.centre_pressure[inner])
    return float(apart.max() / strips.max_pressure)


def draw_ellipse(ax: Any) -> None:
    """Draw an elliptical contact."""
    across, along = RADII
    ball = nh.Body(diameter=2 * across, profile=nh.profile.crown(radius=along), material=STEEL, **HALF_SPACE)
    strips = nh.solve(nh.Contact(ball, nh.Plate(material=STEEL, **HALF_SPACE)), load=1e3)
    exact = nh.hertz.point_contact(load=1e3, radius_x=across, radius_y=along, compliance=2.0 * STEEL.compliance)
    y = np.linspace(-1.0, 1.0, 401) * exact.half_length
    ax.plot(y, exact.pressure(y), color=INK, label="Hertz")
    ax.plot(strips.y, strips.centre_pressure, "o", color=FIRST, markersize=3, fillstyle="none", label="strips")


if __name__ == "__main__":
    draw()
    (PAPER / "paper.md").write_text(text(), encoding="utf-8", newline="\n")
