"""How long designs, sweeps and tolerance studies take, and what they find.

    python benchmarks/studies.py [OUT]

writes studies.md and studies.json into OUT, docs/benchmarks if left out. Wall-clock times on all cores, processes
started anew each time; each is taken once, as they are long.
"""

from __future__ import annotations

import json
import math
import resource
import sys
import time
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from machine import machine

import nonhertz as nh
from nonhertz.life import ContactLoadCase

OUT = Path(__file__).resolve().parents[1] / "docs" / "benchmarks"
EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
PAGE = Path("studies.md")
ROWS, SAMPLES, NUMBERS = 100_000, 10_000, ("approach", "load", "moment", "max_pressure", "max_half_width")
ARC_MINUTE = math.pi / 180.0 / 60.0
DROP = {"body.a.profile.drop": "2 um : 100 um"}
THREE = DROP | {"body.a.profile.fraction": "0.5 : 0.999", "body.a.profile.straight": "0 : 12 mm"}
FREE = {"body.a.profile": "free(60 um, 8)"}


def main(out: Path) -> None:
    """Measure and write."""
    warnings.simplefilter("ignore", nh.AccuracyWarning)
    found: dict[str, Any] = {"machine": machine(), "designs": designs(), "uniform": uniform(), "rows": rows()}
    (out / PAGE.with_suffix(".json")).write_text(json.dumps(found, indent=2) + "\n", encoding="utf-8")
    (out / PAGE).write_text(page(found), encoding="utf-8")
    print(page(found))


def case() -> nh.Case:
    """Return a roller 15 x 20 with a corner of 0.5 mm on a ring of 80."""
    profile = nh.profile.logarithmic(amplitude=4e-3, length=20, fraction=0.95)
    roller = nh.Roller(diameter=15, length=20, corner_radius=0.5, profile=profile)
    found = nh.Case(nh.Contact(roller, nh.Ring(diameter=80, length=24)), {"load": 15e3})
    document = found.document
    document["body"]["a"]["profile"] = [{"kind": "logarithmic", "length": 20.0, "drop": 0.02, "fraction": 0.95}]
    return nh.Case.of(document, Path("roller.toml"))


def loads() -> list[ContactLoadCase]:
    """Return three loads at three tilts."""
    return [
        ContactLoadCase(load=load, share=1.0 / 9.0, tilt=minutes * ARC_MINUTE)
        for load in (5e3, 15e3, 30e3)
        for minutes in (0, 1, 2)
    ]


def designs() -> list[dict[str, Any]]:
    """Return how long designs take, what they find, and how far five starts are apart."""
    found = []
    for name, vary, goal in (
        ("drop of a logarithm", DROP, "pressure"),
        ("drop of a logarithm", DROP, "life"),
        ("three parameters of a logarithm", THREE, "pressure"),
        ("three parameters of a logarithm", THREE, "life"),
        ("free form of eight steps", FREE, "pressure"),
        ("free form of eight steps", FREE, "life"),
    ):
        begun = time.perf_counter()
        design = nh.optimize(case(), bounds=vary, goal=goal, loads=loads())
        taken = time.perf_counter() - begun
        values = [start.value for start in design.starts]
        found.append(
            {
                "name": name, "goal": goal, "seconds": taken, "value": design.value, "before": design.before,
                "spread": float(np.ptp(values) / abs(design.value)), "agreeing": design.agreeing,
                "points": sum(len(start.history) for start in design.starts), "values": design.values,
            }
        )  # fmt: skip
    return found


def uniform() -> dict[str, float]:
    """Return how even the pressure under the best free form for one load is, over 90 % of the land."""
    design = nh.optimize(case(), bounds=FREE, loads=[ContactLoadCase(load=15e3, share=1.0)])
    solution = nh.solve(design.case.contact, load=15e3)
    inner = solution.centre_pressure[np.abs(solution.y) <= 0.9 * 9.5]
    return {"unevenness": float(np.ptp(inner) / inner.mean()), "largest": float(inner.max())}


def rows() -> list[dict[str, Any]]:
    """Return how long many rows take."""
    half_spaces = nh.read_case(EXAMPLES / "crowned-roller.toml")
    real = nh.read_case(EXAMPLES / "cylindrical-roller-bearing.toml")
    found = []
    for name, each, share in (("roller between half-spaces", half_spaces, 1.0), ("whole roller on a ring", real, 0.1)):
        load = each.prescribed.load
        side = round(math.sqrt(share * ROWS))
        over = {"load.load": np.linspace(0.25, 2.0, side) * load, "load.tilt": np.linspace(-1e-3, 1e-3, side)}
        found.append(timed(f"sweep over load and tilt, {name}", nh.sweep, each, over, NUMBERS))
    name = "tolerance of five parameters"
    over = {
        "load.load": "normal(nominal, 2 kN)",
        "load.tilt": "normal(0, 0.3 mrad)",
        "body.a.diameter": "normal(nominal, 3 um)",
        "body.a.profile.radius": "uniform(3600 mm, 4400 mm)",
        "body.a.length": "uniform(19.9 mm, 20.1 mm)",
    }
    found.append(
        timed(f"{name}, roller between half-spaces", nh.tolerance, half_spaces, over, NUMBERS, samples=SAMPLES)
    )
    over = {
        "load.load": "normal(nominal, 200 N)",
        "load.tilt": "normal(0, 0.3 mrad)",
        "body.a.diameter": "normal(nominal, 1 um)",
        "body.a.effective_length": "uniform(8.7 mm, 8.9 mm)",
        "body.b.diameter": "normal(nominal, 5 um)",
    }
    found.append(timed(f"{name}, whole roller on a ring", nh.tolerance, real, over, NUMBERS, samples=SAMPLES))
    return found


def timed(
    name: str, study: Any, each: nh.Case, over: dict[str, Any], names: tuple[str, ...], **options: Any
) -> dict[str, Any]:
    """Return how long a study takes, and how much memory this process has then taken."""
    begun = time.perf_counter()
    found = study(each, over=over, quantities=names, **options)
    taken = time.perf_counter() - begun
    done = found if isinstance(found, nh.study.Sweep) else found.sweep
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    return {"name": name, "rows": len(done), "failed": done.failed, "seconds": taken, "memory": memory}


def page(found: dict[str, Any]) -> str:
    """Return the page."""
    lines = [
        "# What studies cost",
        "",
        f"Measured by `benchmarks/studies.py`. {found['machine']['processor']}, "
        f"{found['machine']['cores']} cores, load average",
        f"{found['machine']['load']}. Wall-clock times with the start of the processes, once each.",
        "",
        "## Designs",
        "",
        "A roller 15 x 20 with corners of 0.5 mm on a ring of 80, under 5, 15 and 30 kN at 0, 1 and 2 arc-minutes.",
        "Target: 10 s, and five starts that end within 1 %.",
        "",
        "| | goal | found | before | starts differ by | points | time |",
        "|---|---|--:|--:|--:|--:|--:|",
    ]
    for each in found["designs"]:
        unit = " MPa" if each["goal"] == "pressure" else " x"
        numbers = f"{each['value']:.5g}{unit} | {each['before']:.5g}{unit} | {100 * each['spread']:.2g} %"
        lines.append(f"| {each['name']} | {each['goal']} | {numbers} | {each['points']} | {each['seconds']:.3g} s |")
    even = found["uniform"]
    lines += [
        "",
        f"The free form for 15 kN without tilt: the pressure differs by {100 * even['unevenness']:.2g} % over 90 % of",
        f"the land, {even['largest']:.5g} MPa at most.",
        "",
        "## Rows",
        "",
        "Targets: 100,000 rows over two parameters in 60 s, 10,000 samples of five in 15 s. *Memory* is the peak",
        "of the process, with the rows of all studies.",
        "",
        "| | rows | time | per row | memory |",
        "|---|--:|--:|--:|--:|",
    ]
    for each in found["rows"]:
        per_row = 1e3 * each["seconds"] / each["rows"]
        numbers = f"{each['rows']} | {each['seconds']:.3g} s | {per_row:.2g} ms | {each['memory']:.0f} MB"
        lines.append(f"| {each['name']} | {numbers} |")
    return "\n".join([*lines, ""])


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else OUT)
