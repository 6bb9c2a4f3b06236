"""Lives of both bodies of a case, one row of name and numbers per model."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from nonhertz.amounts import format_digits, mpa, mrad, newton
from nonhertz.files.lives import Assessment
from nonhertz.life import RATED, Life, Model, VolumeModel
from nonhertz.model.body import BODIES, BodyName
from nonhertz.show.beside import ABSENT, Cells, beside
from nonhertz.show.sections import Cell, Notes, Section, Table, assumed_rows, summary
from nonhertz.verdict import judge_contact

_IDEAL = (
    "1 is the life of the same bodies under Hertz's line pressure, the load spread evenly over the length on which "
    "they can touch."
)
RATIO = (
    "The factor after × is the ratio to the life in the first column. Ratios are those of roller passes: if the rings "
    "or the number of rollers differ, compare L10."
)
_RELATIVE, _L10 = "life relative to ideal profile", "L10 [10^6 rev]"
_STRESSES = {"orthogonal_shear": "tau_xz", "shear": "tau_max", "von_mises": "sigma_vM"}


def sections(assessment: Assessment) -> list[Section]:
    """Return the section on the lives of a case: for each model both lives, revolutions and the damage integral."""
    rows = [
        (life.model.name, *_lives(assessment, number), _integrand(life.model))
        for number, life in enumerate(assessment.lives["a"])
    ]
    heads = ("", f"{_RELATIVE}: a", "b", _L10, "damage")
    assumptions = [summary(assumed_rows(assessment.assumed))] if assessment.assumed else []
    return [
        Section(
            "Life",
            [loads_table(assessment), Table(rows, heads, (0, 4)), *assumptions, Notes(sentences(assessment))],
        )
    ]


def life_sections(life: Life) -> list[Section]:
    """Return the sections on the life of one body by one model."""
    revolutions = "" if life.million_revolutions is None else of_life(life.million_revolutions)
    rows = [(life.model.name, of_life(life.relative_life), revolutions, _integrand(life.model))]
    table = Table(rows, ("", f"{_RELATIVE}: {life.body}", _L10, "damage"), (0, 3))
    unrated = [f"No life in revolutions: {life.no_revolutions}."] if life.no_revolutions else []
    return [Section("Life", [table, Notes([_IDEAL, *unrated])])]


def compared_section(results: Sequence[tuple[str, Assessment | None]]) -> Section:
    """Return the lives of several cases side by side by their labels, with ratios to the first, which has lives."""
    labels, (first, *others) = zip(*results, strict=True)
    rows: list[Cells] = []
    for number, life in enumerate(first.lives["a"] if first else ()):
        for body in BODIES:
            cells = [_beside_first(assessment, first, body, number) for assessment in (first, *others)]
            rows.append((f"{life.model.name}, body {body}", *cells))
    without = dict.fromkeys(
        words for assessment in others if first and assessment for words in _without_ratio(assessment, first)
    )
    table = replace(beside(rows, labels, "Life relative to ideal profile"), remarks="ratio")
    return Section("Lives", [table, Notes([RATIO, *without])])


def _beside_first(assessment: Assessment | None, first: Assessment | None, body: BodyName, number: int) -> Cell:
    if assessment is None or first is None:
        return Cell(ABSENT)
    ratio = math.nan if assessment is first else assessment.over(first, body, number)
    relative = of_life(assessment.lives[body][number].relative_life)
    return Cell(relative, f"× {format_digits(ratio, 4)}" if math.isfinite(ratio) else "")


def sentences(assessment: Assessment) -> list[str]:
    """Return notes for the interpretation of the numbers."""
    lines = [_IDEAL]
    lives = [life for body in BODIES for life in assessment.lives[body]]
    if any(math.isnan(life.reference) for life in lives):
        lines.append("none: the bodies can touch over an unlimited length, so no load can be spread evenly.")
    elif any(math.isnan(life.relative_life) for life in lives):
        lines.append("none: there is no damage, not even under the ideal pressure.")
    if any(life.relative_life == 0.0 for life in lives):
        lines.append("0: under the ideal pressure there is no damage.")
    return [*lines, *_explain_revolutions(assessment), *_of_dents(assessment)]


def _explain_revolutions(assessment: Assessment) -> list[str]:
    """Return the meaning of L10, or why there is no life in revolutions."""
    if all(assessment.million_revolutions(number) is None for number in range(len(assessment.lives["a"]))):
        lives = assessment.lives[assessment.raceway or "b"]
        reasons = dict.fromkeys(life.no_revolutions for life in lives if life.model.name in RATED)
        return [f"No life in revolutions: {reason}." for reason in reasons]
    rollers = "its one roller is" if assessment.rollers == 1 else f"all {assessment.rollers} rollers are"
    load = "this load" if len(assessment.spectrum) == 1 else "these loads"
    return [f"L10 is the life that 90 % of rings, body {assessment.raceway}, reach if {rollers} under {load}."]


def _of_dents(assessment: Assessment) -> list[str]:
    """Return a sentence on the life with dents, if there are any."""
    if assessment.dent is None:
        return []
    per_area, dents = assessment.dents.get("per_area"), assessment.dents.get("dents", 1)
    number = (
        f"{dents:g} dent{'s' * (dents != 1)}" if per_area is None else f"{per_area:.4g} dents per square millimetre"
    )
    lives = ", ".join(f"{of_life(life)} ({name})" for name, life in assessment.dent_lives.items())
    verb = "reduces" if (per_area, dents) == (None, 1) else "reduce"
    lines = [f"{number} in the raceway of body {assessment.dent.body} {verb} its life to this fraction: {lives}."]
    if any(getattr(life.model, "stress", "") == "orthogonal_shear" for life in assessment.lives["b"]):
        lines.append("Dents hardly change the range of the orthogonal shear: judge them by models of maximum shear.")
    return lines


def _without_ratio(assessment: Assessment, other: Assessment) -> list[str]:
    """Return why lives by the lamina model cannot be compared, if they cannot."""
    names = [life.model.name for life in assessment.lives["b"]]
    if "iso-16281" in names and math.isnan(assessment.over(other, "b", names.index("iso-16281"))):
        return ["No ratio by iso-16281: laminae of a raceway cannot be compared with those of a contact without one."]
    return []


def loads_table(assessment: Assessment) -> Table:
    """Return share, load, tilt, maximum pressure and verdict of every load."""
    solutions = [solution for solution, _ in assessment.spectrum]
    loads, pressures = (
        newton(*(solution.load for solution in solutions)),
        mpa(*(solution.max_pressure for solution in solutions)),
    )
    tilts = mrad(*(solution.tilt for solution in solutions))
    heads = ("share", f"load [{loads.scale[1]}]", "tilt [mrad]", f"maximum p0 [{pressures.scale[1]}]", "")
    columns = (amounts.apart()[0] for amounts in (loads, tilts, pressures))
    rows: list[tuple[str, ...]] = [
        (
            f"{100.0 * share:.4g} %",
            load,
            tilt,
            pressure,
            verdict.level.value if (verdict := judge_contact(solution)) else "",
        )
        for (solution, share), load, tilt, pressure in zip(assessment.spectrum, *columns, strict=True)
    ]
    return Table(rows, heads, (4,))


def _lives(assessment: Assessment, number: int) -> tuple[str, ...]:
    revolutions = assessment.million_revolutions(number)
    relative = (of_life(assessment.lives[body][number].relative_life) for body in BODIES)
    return *relative, "" if revolutions is None else of_life(revolutions)


def of_life(value: float, unit: str = "") -> str:
    """Return a life in words, with its unit; "none" for NaN, "no damage" for infinity."""
    if math.isnan(value):
        return "none"
    return f"{format_digits(value, 4)}{unit}" if math.isfinite(value) else "no damage"


def _integrand(model: Model) -> str:
    """Return the integrand over the volume, or the loads of the laminae, with Weibull's slope."""
    slope = f"e = {model.slope:.4g}"
    if not isinstance(model, VolumeModel):
        edges = {"pressure": "edges as solved", "standard": "edges of the standard", "none": "no edges"}
        loads = "" if model.line_loads == "solution" else ", loads of the standard"
        return f"{model.laminae} laminae, {edges[model.edge_stress]}{loads}, {slope}"
    stress = _STRESSES[model.stress]
    if model.fatigue_limit > 0.0:
        stress = f"({stress} - {mpa(model.fatigue_limit):.4g})"
    depth = f" / z^{model.depth_exponent:.4g}" if model.depth_exponent > 0.0 else ""
    return f"{stress}^{model.exponent:.4g}{depth}, {slope}"
