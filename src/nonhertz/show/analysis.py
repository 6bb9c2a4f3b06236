"""From a solved case to its results: largest stresses, lives.

Shared by the command line, reports and the page. Errors name the key of the case file. Python warnings are suppressed,
since the results contain them as sentences.
"""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from nonhertz.amounts import mm
from nonhertz.errors import InputError, without_accuracy_warnings
from nonhertz.files.casefile import Case, with_file_path
from nonhertz.files.lives import Assessment
from nonhertz.findings import finding
from nonhertz.inputs.assumed import collect_assumptions
from nonhertz.life import Model, VolumeModel, overrolled, solve_spectrum
from nonhertz.life import assess as assess_life
from nonhertz.model.body import BODIES, Body, BodyName
from nonhertz.result.ends import ends_in_words
from nonhertz.result.solution import Solution
from nonhertz.show.solving import solve_case
from nonhertz.strength import Strength, assess
from nonhertz.subsurface import Extremes, extremes

Spectrum = tuple[tuple[Solution, float], ...]
Announce = Callable[[str], None]


def no_progress(name: str) -> None:
    """Announce nothing."""


def solve_loads(case: Case) -> Spectrum:
    """Return the solutions under all loads of a case, with their shares of revolutions; raises as `solve_case`."""
    if not case.life.spectrum:
        return ((solve_case(case), 1.0),)
    with _name_keys_in_errors():
        return solve_spectrum(case.contact, case.life.spectrum, **case.solver.keywords)


def largest_stresses(
    solution: Solution, station: float | None = None, body: BodyName = "a", announce: Announce = no_progress
) -> tuple[Extremes, Extremes]:
    """Return the largest stresses in a body and in the cross-section of its largest von Mises stress.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    station : float or None
        Position of the cross-section [mm], instead of that of the largest von Mises stress.
    body : {"a", "b"}
        Which body.
    announce : callable
        Called with the name of each search as it begins.

    Raises
    ------
    InputError
        If the cross-section does not lie in the body.
    """
    announce("whole body")
    overall = extremes(solution, body=body)
    announce("cross-section")
    y = overall.von_mises.y if station is None else station
    section = extremes(solution, y, body=body)
    near = [
        finding(
            "section-near-an-end",
            "The cross-section at y = {y:.5g} is within a half-width of {end}, towards which the stress is unbounded: "
            "its largest values depend on the strips.",
            y=mm(y),
            end=ends_in_words([end]),
        )
        for end in solution.singular_ends
        if abs(y - end.y) < np.interp(y, solution.y, solution.half_width)
    ]
    return overall, replace(section, findings=(*section.findings, *near))


def has_strength(body: Body) -> bool:
    """Return whether any strength of a body is known."""
    material = body.material
    known = (material.yield_strength, material.core_yield_strength, material.pressure_limit, body.case_depth)
    return any(requirement is not None for requirement in known)


def strengths(solution: Solution, overall: Extremes, announce: Announce = no_progress) -> tuple[Strength, ...]:
    """Return whether the bodies withstand the stress: the body of ``overall``, and the other if its strength is known.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    overall : Extremes
        The largest stresses in one body, from `largest_stresses`.
    announce : callable
        Called with the name of a second search as it begins.
    """
    assessments = [assess(solution, body=overall.body, largest=overall)]
    other: BodyName = "b" if overall.body == "a" else "a"
    if has_strength(solution.contact.b if other == "b" else solution.contact.a):
        announce(f"body {other}")
        assessments.append(assess(solution, body=other))
    return tuple(assessments)


def choose_models(
    case: Case, names: Sequence[str] = (), others: Iterable[Case] = ()
) -> tuple[tuple[Model, ...], tuple[str, ...]]:
    """Return the requested models with the parameters of a case, and notes on any left out.

    The lamina model needs a finite length: where a contact has none, it is left out unless requested by name.
    """
    models = case.life.build_models(dict.fromkeys(names))
    lengths = [np.ptp(compared_case.contact.interval) for compared_case in (case, *others)]
    if names or case.life.models or np.isfinite(lengths).all():
        return models, ()
    volume_models = tuple(model for model in models if isinstance(model, VolumeModel))
    return volume_models, ("iso-16281 is left out: it needs a length on which the bodies can touch.",)


def assess_lives(
    case: Case,
    spectrum: Spectrum,
    models: tuple[Model, ...],
    notes: tuple[str, ...] = (),
    announce: Announce = no_progress,
) -> Assessment:
    """Return the lives of both bodies of a solved case.

    Raises
    ------
    CaseError
        If one of the models cannot give a life.
    """
    lives = {}
    with _name_keys_in_errors():
        for body in BODIES:
            lives[body] = assess_life(
                spectrum,
                models,
                body=body,
                rollers=case.life.rollers,
                contact_angle=case.life.contact_angle,
                callback=_announce_loads(announce, body, len(spectrum)),
            )
        settings = replace(case.life, models=tuple(model.name for model in models))
        of_models = collect_assumptions({"life": settings}, None if case.origin is None else case.origin.document)
        required = case.life.required_revolutions
        assessment = Assessment(
            case.title, case.life.rollers, spectrum, lives, notes, required=required, assumed=of_models
        )
        dent = case.life.dent
        if dent is None:
            return assessment
        announce("dent")
        if not any(isinstance(life.model, VolumeModel) for life in assessment.lives["b"]):
            return replace(assessment, notes=(*notes, "The dent is left out: it needs a model of the stressed volume."))
        assessment = replace(assessment, dent=overrolled(spectrum[0][0], dent.dent, body=dent.body), dents=dent.number)
        _ = assessment.dent_lives  # evaluated here, where errors name keys of the file
    return assessment


@contextlib.contextmanager
def _name_keys_in_errors() -> Iterator[None]:
    """Name the keys of the case file in errors, and suppress warnings, which the results contain."""
    with without_accuracy_warnings():
        try:
            yield
        except InputError as error:
            raise with_file_path(error) from None


def _announce_loads(announce: Announce, body: BodyName, loads: int) -> Callable[[int, int], None]:
    """Announce a body, and return a callback that announces each further load."""
    names = iter([f"body {body}{f', load {number} of {loads}' * (loads > 1)}" for number in range(1, loads + 1)])
    announce(next(names))

    def announce_next(done: int, total: int) -> None:
        if done == total and (name := next(names, "")):
            announce(name)

    return announce_next
