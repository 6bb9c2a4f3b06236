"""``nonhertz life``: how long both bodies last."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from nonhertz import ConvergenceError, InputError, read_case
from nonhertz.cli.answer import Answer
from nonhertz.cli.options import NONE, Changes, Words, refuse_unwritable_out, written
from nonhertz.cli.printing import Progress
from nonhertz.files.documents import named
from nonhertz.files.lives import Assessment, as_object, files
from nonhertz.files.results import key_by_key
from nonhertz.inputs.files import legible
from nonhertz.life import MODELS
from nonhertz.plot import dent_figure, life_figure
from nonhertz.show.analysis import assessed, models_for, spectrum_solved
from nonhertz.show.lives import compared_section, sections
from nonhertz.show.sections import Said, Section, assumed_section
from nonhertz.verdict import worst_of

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
        Another case file to compare with, by the same models: how much longer the first one lasts.
    out : Path
        Directory for life.json, tables and the figure; created if it does not exist.
    """
    for name in model:
        if name not in MODELS:
            raise InputError("--model", name, "be a fatigue model", f"choose from {', '.join(MODELS)}")
    cases = [read_case(case, changes)]
    if compared is not None:
        with named(compared):
            cases.append(read_case(compared, changes))
    refuse_unwritable_out(out)
    models, notes = models_for(cases[0], model, cases[1:])
    found: list[Assessment] = []
    with Progress(sum(each.life.steps for each in cases)) as progress:
        for each in cases:
            with named(each.path) if found else contextlib.nullcontext():
                try:
                    spectrum = spectrum_solved(each)
                except ConvergenceError as error:
                    raise ConvergenceError(f"{each.path}: {error}" if found else str(error), error.solution) from None
                found.append(assessed(each, spectrum, models, notes, progress.announce))
    first, other = found[0], found[1] if len(found) > 1 else None
    verdicts = {f"in {legible(str(case.path))}": each.verdict for case, each in zip(cases, found, strict=True)}
    made = written(out, lambda: files(first, other), lambda: _figures(first, other))
    shown, text = _shown([each.path for each in cases], first, other), lambda: key_by_key(as_object(first, other))
    shown.append(assumed_section(cases[0].assumed))
    return Answer(first.title, shown, text, worst_of(verdicts), written=made)


def _figures(found: Assessment, other: Assessment | None) -> Mapping[str, Figure]:
    beside = None if other is None else other.lives
    drawn = {"life-density": life_figure(found.spectrum, found.lives, found.title, beside)}
    if found.dent is not None:
        drawn["life-dent"] = dent_figure(found.dent, found.judging_dents, found.title)
    return drawn


def _shown(files: Sequence[Path], found: Assessment, other: Assessment | None) -> list[Section]:
    """Return the lives by all models, what they are relative to, those of another case, and warnings of both.

    Of two cases each has a heading: its file and its title.
    """
    parts = [(each, sections(each)) for each in (found, other) if each is not None]
    shown = []
    for file, (each, (section,)) in zip(files, parts, strict=True):
        head = Said(
            [f"{'compared with ' * (each is other)}{legible(str(file))}: {each.title}"] * len(files[1:]), "head"
        )
        warned = Said([f"warning: {one}" for one in each.warnings], "warning")
        shown.append(Section(section.title, [head, *section.blocks, warned]))
    if other is not None:
        names = [legible(str(file)) for file in files]
        shown.append(compared_section([(names[1], other), (names[0], found)]))
    return shown
