"""What ``nonhertz life`` evaluates, and what it prints for people."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Iterable, Sequence

import numpy as np
from rich.console import Console
from rich.table import Table
from rich.text import Text

from nonhertz.cli.summary import digits
from nonhertz.cli.verification import Progress
from nonhertz.errors import CaseError, InputError
from nonhertz.io.casefile import Case, placed
from nonhertz.io.lives import BODIES, Assessment
from nonhertz.life import MODELS, RATED, Model, VolumeModel, assess
from nonhertz.singular import largest_away, singular_ends
from nonhertz.solution import Solution

WIDTH = 120  # of what is piped
Spectrum = tuple[tuple[Solution, float], ...]

_IDEAL = (
    "1 is the life of the same bodies under Hertz's line pressure, the load spread evenly over the length on which "
    "they can touch."
)
_RATIO = (
    "Ratios are those of passes of a roller: where the cases differ in rings or in the number of rollers, compare "
    "their L10."
)
_REVOLUTIONS = "L10 [10^6 rev]"
_STRESSES = {"orthogonal_shear": "tau_xz", "shear": "tau_max", "von_mises": "sigma_vM"}


def check_models(names: Iterable[str]) -> None:
    """Refuse names that no model has.

    Raises
    ------
    InputError
    """
    for name in names:
        if name not in MODELS:
            raise InputError("--model", name, "be a fatigue model", f"choose from {', '.join(MODELS)}")


def models_for(case: Case, names: Sequence[str], others: Iterable[Case]) -> tuple[tuple[Model, ...], tuple[str, ...]]:
    """Return the models that are wanted, with the parameters of a case, and why there are fewer than all.

    Laminae are cut from a length: where a contact has none, and nobody asks for them, they are left out.
    """
    models = case.life.models(dict.fromkeys(names))
    lengths = [np.ptp(each.contact.interval) for each in (case, *others)]
    if names or case.life.names or np.isfinite(lengths).all():
        return models, ()
    kept = tuple(model for model in models if isinstance(model, VolumeModel))
    return kept, ("iso-16281 is left out: it needs a length on which the bodies can touch.",)


def assessed(
    case: Case, spectrum: Spectrum, models: tuple[Model, ...], notes: tuple[str, ...], progress: Progress
) -> Assessment:
    """Return the lives of both bodies of a case that is solved.

    Raises
    ------
    CaseError
        If the case has no life by one of the models.
    """
    lives = {}
    try:
        for body in BODIES:
            told = _announcer(progress, body, len(spectrum))
            lives[body] = assess(spectrum, models, body=body, rollers=case.life.rollers, announce=told)
    except InputError as error:
        raise CaseError([placed(error)]) from None
    return Assessment(case.title, case.life.rollers, spectrum, lives, notes)


def print_lives(found: Assessment, other: Assessment | None) -> None:
    """Print the lives by all models, what they are relative to, those of another case, and warnings."""
    console = Console(highlight=False, width=None if sys.stdout.isatty() else WIDTH)
    console.print(Text(found.title, style="bold"))
    console.print(_table(("", "life in a", "in b", _REVOLUTIONS, "damage"), life_rows(found), left=(0, 4)))
    for sentence in sentences(found):
        console.print(Text(sentence), soft_wrap=True)
    _print_spectrum(console, found)
    _print_warnings(console, found)
    if other is None:
        return
    console.print()
    console.print(Text(f"Compared with: {other.title}", style="bold"))
    head = ("", "life in a", "in b", _REVOLUTIONS, "first / this, a", "first / this, b")
    console.print(_table(head, ratio_rows(found, other), left=(0,)))
    for sentence in [_RATIO, *_without_ratio(found, other), *sentences(other)[1:]]:
        console.print(Text(sentence), soft_wrap=True)
    _print_spectrum(console, other)
    _print_warnings(console, other)


def life_rows(found: Assessment) -> list[tuple[str, ...]]:
    """Return name, life in both bodies, revolutions and the integrand of each model."""
    return [
        (life.model.name, *_lives(found, number), _integrand(life.model))
        for number, life in enumerate(found.lives["a"])
    ]


def ratio_rows(found: Assessment, other: Assessment) -> list[tuple[str, ...]]:
    """Return name, the other case's lives, and those of the first over them, for each model."""
    return [
        (
            life.model.name,
            *_lives(other, number),
            *(_relative(found.over(other, body, number)) for body in BODIES),
        )
        for number, life in enumerate(found.lives["a"])
    ]


def sentences(found: Assessment) -> list[str]:
    """Return what has to be known to read the numbers."""
    lines = [_IDEAL]
    lives = [life for body in BODIES for life in found.lives[body]]
    if any(math.isnan(life.reference) for life in lives):
        lines.append("none: the bodies can touch on an unlimited length, along which no load can be spread evenly.")
    elif any(math.isnan(life.relative) for life in lives):
        lines.append("none: there is no damage, under the ideal pressure neither.")
    if any(life.relative == 0.0 for life in lives):
        lines.append("0: under the ideal pressure there is no damage.")
    if any(found.million_revolutions(number) is not None for number in range(len(found.lives["a"]))):
        bearing = "its one roller bears" if found.rollers == 1 else f"all {found.rollers} rollers bear"
        load = "this load" if len(found.spectrum) == 1 else "these loads"
        lines.append(f"L10 is the life of the ring, body {found.raceway}, that 90 % reach where {bearing} {load}.")
    else:
        of_ring = found.lives[found.raceway or "b"]
        why = dict.fromkeys(life.no_revolutions for life in of_ring if life.model.name in RATED)
        lines += [f"No life in revolutions: {reason}." for reason in why]
    return lines


def _without_ratio(found: Assessment, other: Assessment) -> list[str]:
    """Return why lives by laminae cannot be compared, if they cannot."""
    names = [life.model.name for life in found.lives["b"]]
    if "iso-16281" in names and math.isnan(found.over(other, "b", names.index("iso-16281"))):
        return ["none: laminae of a raceway are not compared with those of a contact without one."]
    return []


def spectrum_rows(found: Assessment) -> list[tuple[str, ...]]:
    """Return share, load, tilt and largest pressure of every load."""
    return [
        (f"{100.0 * share:.4g} %", digits(solution.load), digits(1e3 * solution.tilt), _pressure(solution))
        for solution, share in found.spectrum
    ]


def _announcer(progress: Progress, body: str, loads: int) -> Callable[[int, int], None]:
    """Say that a body is begun, and return what says whenever another load is."""
    words = (
        [f"body {body}"] if loads == 1 else [f"body {body}, load {number} of {loads}" for number in range(1, loads + 1)]
    )
    left = iter(words)
    progress.announce(next(left))

    def told(done: int, total: int) -> None:
        following = next(left, None) if done == total else None
        if following is not None:
            progress.announce(following)

    return told


def _lives(found: Assessment, number: int) -> tuple[str, ...]:
    revolutions = found.million_revolutions(number)
    relative = (_relative(found.lives[body][number].relative) for body in BODIES)
    return *relative, "" if revolutions is None else _relative(revolutions)


def _relative(value: float) -> str:
    if math.isnan(value):
        return "none"
    return digits(value, 4) if math.isfinite(value) else "no damage"


def _integrand(model: Model) -> str:
    """Return what is integrated over the volume, or how laminae are loaded, with Weibull's slope."""
    slope = f"e = {model.slope:.4g}"
    if not isinstance(model, VolumeModel):
        edges = {"pressure": "edges as solved", "standard": "edges of the standard", "none": "no edges"}
        loads = "" if model.line_loads == "solution" else ", loads of the standard"
        return f"{model.laminae} laminae, {edges[model.edge_stress]}{loads}, {slope}"
    stress = _STRESSES[model.stress]
    if model.fatigue_limit > 0.0:
        stress = f"({stress} - {model.fatigue_limit:.4g} MPa)"
    depth = f" / z^{model.depth_exponent:.4g}" if model.depth_exponent > 0.0 else ""
    return f"{stress}^{model.exponent:.4g}{depth}, {slope}"


def _pressure(solution: Solution) -> str:
    """Return the largest pressure, or that away from ends where it has no limit."""
    if not singular_ends(solution):
        return digits(solution.max_pressure)
    strips = largest_away(solution)
    return f"no limit, {digits(float(solution.peak_pressure[strips[0]]))} away" if strips else "no limit"


def _print_spectrum(console: Console, found: Assessment) -> None:
    if len(found.spectrum) > 1:
        head = ("share", "load [N]", "tilt [mrad]", "largest p0 [MPa]")
        console.print(_table(head, spectrum_rows(found), left=()))


def _print_warnings(console: Console, found: Assessment) -> None:
    for warning in found.warnings:
        console.print(Text(f"warning: {warning}", style="yellow"), soft_wrap=True)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]], *, left: Sequence[int]) -> Table:
    rows = list(rows)
    # Not a column where all is blank, as revolutions are without a raceway.
    columns = [position for position in range(len(head)) if any(row[position] for row in rows)]
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="dim")
    for position in columns:
        # As text: rich would take [MPa] for markup.
        table.add_column(Text(head[position]), justify="left" if position in left else "right", no_wrap=position < 4)
    for row in rows:
        table.add_row(*(Text(row[position]) for position in columns))
    return table
