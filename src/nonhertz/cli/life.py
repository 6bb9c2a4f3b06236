"""What ``nonhertz life`` assesses, writes and prints."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path

from nonhertz.cli import FINE, NOT_CONVERGED
from nonhertz.cli.printing import print_result
from nonhertz.cli.solve import spectrum_or_not
from nonhertz.cli.verify import Progress
from nonhertz.errors import InputError
from nonhertz.files.casefile import Case
from nonhertz.files.held import named
from nonhertz.files.lives import Assessment
from nonhertz.files.lives import as_json as as_json_text
from nonhertz.life import MODELS
from nonhertz.show.analysis import assessed, models_for
from nonhertz.show.lives import compared_sections, sections
from nonhertz.show.sections import Said, Section

WIDTH = 120  # of piped output


def check_models(names: Iterable[str]) -> None:
    """Reject unknown model names.

    Raises
    ------
    InputError
    """
    for name in names:
        if name not in MODELS:
            raise InputError("--model", name, "be a fatigue model", f"choose from {', '.join(MODELS)}")


def report_lives(cases: list[Case], names: Sequence[str], out: Path | None, as_json: bool) -> int:
    """Solve one or two cases, assess their lives, write them if requested, print them; return the exit code."""
    models, notes = models_for(cases[0], names, cases[1:])
    progress = Progress(sum(case.life.steps for case in cases))
    found: list[Assessment] = []
    try:
        for case in cases:
            with named(case.path) if found else contextlib.nullcontext():
                spectrum, complaint = spectrum_or_not(case)
                if complaint:
                    progress.wipe()
                    print(f"{case.path}: {complaint}" if found else complaint, file=sys.stderr)
                    return NOT_CONVERGED
                found.append(assessed(case, spectrum, models, notes, progress.announce))
    finally:
        progress.wipe()
    assessment, other = found[0], found[1] if len(found) > 1 else None
    written = _lives_written(out, assessment, other) if out is not None else ()
    if as_json:
        print(as_json_text(assessment, other))
        return FINE
    print_result(assessment.title, _shown(assessment, other), written=written, piped=WIDTH)
    return FINE


def _lives_written(directory: Path, found: Assessment, other: Assessment | None) -> tuple[Path, ...]:
    from nonhertz.files.folder import write_files
    from nonhertz.files.lives import files
    from nonhertz.plot import dent_figure, life_figure, save

    def draw(folder: Path) -> None:
        compared = None if other is None else other.lives
        save(life_figure(found.spectrum, found.lives, found.title, compared), folder / "life-density")
        if found.dent is not None:
            save(dent_figure(found.dent, found.judging_dents, found.title), folder / "life-dent")

    return write_files(directory, files(found, other), draw)


def _shown(found: Assessment, other: Assessment | None) -> list[Section]:
    """Return the lives by all models, what they are relative to, those of another case, and warnings of both."""
    parts = [(found, sections(found))] + ([] if other is None else [(other, compared_sections(found, other))])
    warned = ((shown, Said([f"warning: {each}" for each in of.warnings], "warning")) for of, shown in parts)
    return [Section(each.title, [*each.blocks, words]) for shown, words in warned for each in shown]
