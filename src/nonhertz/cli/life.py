"""``nonhertz life``: how long both bodies last."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping, Sequence
from itertools import filterfalse
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from nonhertz import ConvergenceError, InputError, read_case
from nonhertz.cli.answer import Answer
from nonhertz.cli.options import NONE, Changes, Words, refuse_unwritable_out, write_outputs
from nonhertz.cli.printing import Progress
from nonhertz.files.lives import Assessment, as_object, files
from nonhertz.files.results import key_by_key
from nonhertz.files.toml import name_file_in_errors
from nonhertz.inputs.files import printable_name
from nonhertz.life import MODELS
from nonhertz.plot import dent_figure, life_figure
from nonhertz.show.analysis import assess_lives, choose_models, solve_loads
from nonhertz.show.lives import compared_section, sections
from nonhertz.show.sections import Notes, Section, assumed_section
from nonhertz.verdict import worst_verdict

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def life(
    case: Path,
    /,
    *,
    changes: Changes = NONE,
    model: Words = (),
    compared: Annotated[Path | None, Parameter(name="--compare")] = None,
    out: Path | None = None,
) -> Answer:
    """Assess how long both bodies of a case last, by several fatigue models.

    Lives are relative to those of the same bodies under an ideal pressure, Hertz's line pressure with the load spread
    evenly. This takes a few seconds per load.

    Parameters
    ----------
    case : Path
        The case file; its table life has the number of rollers, model parameters, and a load spectrum.
    model : tuple of str
        Names of the models: lundberg-palmgren, ioannides-harris, zaretsky, weibull, iso-16281. By default those in the
        file, or all of them.
    compared : Path
        Another case file, for comparison by the same models: how much longer the first one lasts.
    out : Path
        Directory for life.json, tables and the figure; created if it does not exist.
    """
    unknown = next(filterfalse(MODELS.__contains__, model), None)
    if unknown is not None:
        raise InputError("--model", unknown, "be a fatigue model", f"choose from {', '.join(MODELS)}")
    cases = [read_case(case, changes)]
    if compared is not None:
        with name_file_in_errors(compared):
            cases.append(read_case(compared, changes))
    refuse_unwritable_out(out)
    models, notes = choose_models(cases[0], model, cases[1:])
    assessments: list[Assessment] = []
    with Progress(sum(life_case.life.steps for life_case in cases)) as progress:
        for life_case in cases:
            with name_file_in_errors(life_case.path) if assessments else contextlib.nullcontext():
                try:
                    spectrum = solve_loads(life_case)
                except ConvergenceError as error:
                    sentence = f"{life_case.path}: {error}" if assessments else str(error)
                    raise ConvergenceError(sentence, error.solution) from None
                assessments.append(assess_lives(life_case, spectrum, models, notes, progress.announce))
    first, other = assessments[0], (*assessments, None)[1]
    pairs = zip(cases, assessments, strict=True)
    verdicts = {f"in {printable_name(str(solved.path))}": assessment.verdict for solved, assessment in pairs}
    made = write_outputs(out, lambda: files(first, other), lambda: _draw_figures(first, other))
    shown = [*_list_sections([life_case.path for life_case in cases], first, other), assumed_section(cases[0].assumed)]
    return Answer(
        first.title, shown, lambda: key_by_key(as_object(first, other)), worst_verdict(verdicts), written=made
    )


def _draw_figures(assessment: Assessment, other: Assessment | None) -> Mapping[str, Figure]:
    beside = None if other is None else other.lives
    drawn = {"life-density": life_figure(assessment.spectrum, assessment.lives, assessment.title, beside)}
    if assessment.dent is not None:
        drawn["life-dent"] = dent_figure(assessment.dent, assessment.judging_dents, assessment.title)
    return drawn


def _list_sections(files: Sequence[Path], first: Assessment, other: Assessment | None) -> list[Section]:
    """Return the lives by all models, what they are relative to, those of another case, and warnings of both.

    With two cases each has a heading: its file and its title.
    """
    parts = [(assessment, sections(assessment)) for assessment in (first, other) if assessment is not None]
    shown = []
    for file, (assessment, (section,)) in zip(files, parts, strict=True):
        lead = "compared with " * (assessment is other)
        head = Notes([f"{lead}{printable_name(str(file))}: {assessment.title}"] * len(files[1:]), "head")
        warned = Notes([f"warning: {one}" for one in assessment.warnings], "warning")
        shown.append(Section(section.title, [head, *section.blocks, warned]))
    if other is not None:
        names = [printable_name(str(file)) for file in files]
        shown.append(compared_section([(names[1], other), (names[0], first)]))
    return shown
