"""Several cases side by side: which inputs differ, and how the results change."""

from __future__ import annotations

from collections.abc import Sequence

from nonhertz.amounts import mpa
from nonhertz.bearing.quantities import QUANTITIES as OF_BEARING
from nonhertz.bearing.quantities import SolvedBearing
from nonhertz.report.inputs import InputGroup
from nonhertz.report.results import BearingResults, CaseResults, Results
from nonhertz.result.quantities import QUANTITIES
from nonhertz.show.bearing import clean_numbers
from nonhertz.show.beside import ABSENT, Cells, Compared, compared
from nonhertz.show.sections import Cell
from nonhertz.show.summary import end_words

# What is not the shape of a body: sections of files, and keys of bodies.
_CONDITIONS = {"load", "solver", "lubrication", "life", "fit"}
_BESIDE_SHAPES = {*_CONDITIONS, "material", "depth", "side_faces", "effective_length", "clearance"}


def differing_inputs(cases: Sequence[Sequence[InputGroup]]) -> tuple[list[Cells], list[Cells], list[str]]:
    """Return the inputs in which cases differ, those given in a file that are the same in all, and a note.

    Each case is given by its inputs; the note says what differs beside dimensions and profiles, as not all numbers
    compare then.
    """
    tables = [{entry.place: entry for group in groups for entry in group.entries} for groups in cases]
    differing: list[Cells] = []
    same: list[Cells] = []
    beside: list[str] = []
    for place in dict.fromkeys(place for table in tables for place in table):
        values = [table[place].shown if place in table else ABSENT for table in tables]
        if len(set(values)) > 1:
            entry = next(table[place] for table in tables if place in table)
            differing.append((entry.full_name, *values))
            section, key = place.partition(".")[0], place.rpartition(".")[2]
            if {section, key} & _BESIDE_SHAPES:
                beside.append(section if section in _CONDITIONS else entry.full_name)
        elif not all(table[place].default for table in tables):
            same.append((tables[0][place].full_name, values[0], tables[0][place].meaning))
    what = "; ".join(dict.fromkeys(beside))
    return differing, same, [f"More than shapes differs, so that not all numbers compare: {what}."] if beside else []


def results(found: Sequence[Results]) -> list[Compared | Cells]:
    """Return the results of all cases or bearings, with differences from the first; what none has is left out."""
    contacts = [each for each in found if isinstance(each, CaseResults)]
    if not contacts:
        return [*_of_bearings([each for each in found if isinstance(each, BearingResults)])]
    solutions = [each.solution for each in contacts]
    rows: list[Compared | Cells] = [
        Compared(each.label, each.amount(*(float(each.clean(one)) for one in solutions)))
        for each in map(QUANTITIES.__getitem__, _COMPARED)
    ]
    for at, end in enumerate(("low", "high")):
        cells = [Cell(*end_words(each.edge_pressure[at], each)) for each in solutions]
        rows.insert(1 + at, (f"pressure at the {end} end", *cells))
    if all(each.stress for each in contacts):
        for name, key in _STRESSES.items():
            largest = [getattr(each.stress[0], key).max for each in contacts if each.stress]
            rows.append(Compared(f"largest {name} in body a", mpa(*largest)))
    return rows


def _of_bearings(found: Sequence[BearingResults]) -> list[Compared]:
    names = sorted(set(OF_BEARING) - {"warnings"}, key=["max_pressure", *OF_BEARING].index)
    return compared(map(OF_BEARING.__getitem__, names), [*map(_numbers, found)])


def _numbers(found: BearingResults) -> dict[str, float]:
    """Return the numbers of a bearing by name, those of its life only where it was assessed."""
    if found.solution is None:
        return {}
    shown = (each for each in OF_BEARING.values() if found.life is not None or each.within != "life")
    return clean_numbers(shown, SolvedBearing(found.case, found.solution))


def conclusion(compared_results: Sequence[Compared | Cells], labels: Sequence[str]) -> str:
    """Return in a sentence how the largest pressures compare, of bearings the lives, too."""
    rows = {row.name: row for row in compared_results if isinstance(row, Compared)}
    life = next((name for name in ("modified life", "reference life") if name in rows), "")
    sentences = []
    for row in (rows[name] for name in ("maximum pressure", life) if name in rows):
        unit = row.amount.scale[1]
        parts = [
            f"{text} {unit} in {label}{f' ({change})' if change else ''}"
            for (text, change), label in zip(row.cells, labels, strict=True)
            if text != ABSENT
        ]
        sentences.append(f"{row.name.capitalize()}: {', '.join(parts)}.")
    return " ".join(sentences)


def verdicts(found: Sequence[Results]) -> list[Cells]:
    """Return label, verdict and what it rests on of each that has one, or why it was not solved."""
    rows: list[Cells] = []
    for each in found:
        if each.complaint:
            rows.append((each.label, "Not solved.", each.complaint))
        elif each.verdict is not None:
            rows.append((each.label, each.verdict.words, each.verdict.sentence))
    return rows


# The largest pressure comes first; its position and the coupling stiffnesses are left out.
_LEFT_OUT = {"max_pressure_y", "load_by_tilt", "moment_by_approach"}
_COMPARED = sorted(set(QUANTITIES) - _LEFT_OUT, key=["max_pressure", *QUANTITIES].index)
_STRESSES = {"von Mises stress": "von_mises", "shear stress": "shear", "orthogonal shear stress": "orthogonal_shear"}
