"""What ``nonhertz tolerance`` prints and writes."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from nonhertz.cli.options import named_as
from nonhertz.cli.printing import print_result
from nonhertz.cli.sweep import progress
from nonhertz.files.planfile import Plan
from nonhertz.show.studies import tolerance_sections
from nonhertz.study.tolerances import Tolerance, tolerance


def studied(
    plan: Plan, samples: int | None, seed: int | None, out: Path, workers: int | None, scheduler: str | None
) -> Tolerance:
    """Return the study of a plan, with progress on a terminal.

    Raises
    ------
    InputError
        If an option is refused, named as on the command line.
    """
    with progress() as announce, named_as(threads="--workers", count="--samples", seed="--seed", over="--over"):
        return tolerance(
            plan, samples=samples, seed=seed, out=out, workers=workers, scheduler=scheduler, announce=announce
        )


def written(found: Tolerance, out: Path, excel: bool) -> tuple[Path, ...]:
    """Write the rows, quantiles and indices, and the figures; return the files."""
    from nonhertz.plot import save
    from nonhertz.study.pictures import tolerance_figures

    def draw(folder: Path) -> None:
        (folder / "tolerance.json").write_text(as_json(found, ()) + "\n", encoding="utf-8")
        for name, figure in tolerance_figures(found).items():
            save(figure, folder / name)

    return found.sweep.write(out, draw, excel=excel)


def as_json(found: Tolerance, files: Sequence[Path]) -> str:
    """Return what `print_tolerance` prints as JSON text."""
    sweep = found.sweep
    content: dict[str, Any] = {
        "title": sweep.plan.title,
        "rows": len(sweep),
        "independent_samples": found.independent.size,
        "failed": sweep.failed,
        "quantiles": {
            each.name: [_finite(dataclasses.asdict(one)) for one in found.quantiles(each.name)]
            for each in sweep.quantities
        },
        "indices": {
            each.name: [dataclasses.asdict(one) for one in found.indices(each.name)] for each in sweep.quantities
        },
        "failures": [{"sentence": why, "rows": times, "first": first} for why, times, first in sweep.reasons()],
        "files": [str(path) for path in files],
        "units": {name: sweep.unit(name) for name in (*sweep.paths, *(each.name for each in sweep.quantities))},
    }
    return json.dumps(content, indent=2, allow_nan=False)


def print_tolerance(found: Tolerance, files: Sequence[Path]) -> None:
    """Print what is distributed, quantiles, what matters, why rows failed, and the files."""
    print_result(found.sweep.plan.title, tolerance_sections(found), written=files)


def _finite(numbers: dict[str, float]) -> dict[str, float | None]:
    return {name: value if abs(value) < float("inf") else None for name, value in numbers.items()}
