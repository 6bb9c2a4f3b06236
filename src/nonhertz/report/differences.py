"""Several cases side by side: which inputs differ, and how the results change."""

from __future__ import annotations

import math
from collections.abc import Sequence

from nonhertz.amounts import Amount, digits, mpa, percent
from nonhertz.bearing.quantities import QUANTITIES as OF_BEARING
from nonhertz.bearing.quantities import SolvedBearing
from nonhertz.model.body import BODIES
from nonhertz.report.inputs import InputGroup
from nonhertz.report.results import BearingResults, CaseResults, Results
from nonhertz.result.quantities import QUANTITIES
from nonhertz.show.bearing import clean
from nonhertz.show.sections import Cell
from nonhertz.show.summary import end_words

ABSENT = "–"
NOTICED = 5e-6  # relative difference
# What is not the shape of a body: sections of files, and keys of bodies.
_CONDITIONS = {"load", "solver", "life", "fit"}
_BESIDE_SHAPES = {*_CONDITIONS, "material", "depth", "side_faces", "effective_length", "clearance"}


#: What it is, with its unit, and a cell for each case, whose remark is usually the difference from the first.
Compared = tuple[str | Cell, ...]


def differing_inputs(cases: Sequence[Sequence[InputGroup]]) -> tuple[list[Compared], list[Compared], list[str]]:
    """Return the inputs in which cases differ, those given in a file that are the same in all, and a note.

    Each case is given by its inputs; the note says what differs beside dimensions and profiles, as not all numbers
    compare then.
    """
    tables = [{entry.place: entry for group in groups for entry in group.entries} for groups in cases]
    differing: list[Compared] = []
    same: list[Compared] = []
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


def results(found: Sequence[Results]) -> list[Compared]:
    """Return the results of all cases or bearings, with differences from the first; what none has is left out."""
    contacts = [each for each in found if isinstance(each, CaseResults)]
    if not contacts:
        return _of_bearings([each for each in found if isinstance(each, BearingResults)])
    solutions = [each.solution for each in contacts]
    rows = [
        compared(quantity.label, quantity.amount(*(float(quantity.clean(each)) for each in solutions)))
        for quantity in map(QUANTITIES.__getitem__, _COMPARED)
    ]
    for at, end in enumerate(("low", "high")):
        cells = [Cell(*end_words(each.edge_pressure[at], each)) for each in solutions]
        rows.insert(1 + at, (f"pressure at the {end} end", *cells))
    if all(each.stress for each in contacts):
        for name, key in _STRESSES.items():
            largest = [getattr(each.stress[0], key).max for each in contacts if each.stress]
            rows.append(compared(f"largest {name} in body a", mpa(*largest)))
    return rows


def _of_bearings(found: Sequence[BearingResults]) -> list[Compared]:
    solved = [None if each.solution is None else SolvedBearing(each.case, each.solution) for each in found]
    rows: list[Compared] = []
    for name in sorted(set(OF_BEARING) - {"warnings"}, key=["max_pressure", *OF_BEARING].index):
        quantity = OF_BEARING[name]
        if quantity.within == "life":
            values = [math.nan if each.life is None else float(getattr(each.life, name)) for each in found]
        else:
            values = [math.nan if each is None else clean(quantity, each) for each in solved]
        if name == "loaded_rollers":
            rows.append((quantity.label, *(f"{each:g}" if math.isfinite(each) else ABSENT for each in values)))
        elif any(value and math.isfinite(value) for value in values):
            rows.append(compared(quantity.label, quantity.amount(*values)))
    return rows


def conclusion(found: Sequence[Results]) -> str:
    """Return in a sentence how the largest pressures compare, of bearings the lives, too."""
    rows = {str(row[0]).partition(" [")[0]: row for row in results(found)}
    life = next((name for name in ("modified life", "reference life") if name in rows), "")
    shown = [rows[name] for name in ("maximum pressure", life) if name in rows]
    sentences = []
    for name, *cells in shown:
        label, _, unit = str(name).rstrip("]").partition(" [")
        parts = [
            f"{cell.text} {unit} in {each.label}{f' ({cell.remark})' if cell.remark else ''}"
            for cell, each in zip(cells, found, strict=True)
            if isinstance(cell, Cell) and cell.text != ABSENT
        ]
        sentences.append(f"{label.capitalize()}: {', '.join(parts)}.")
    return " ".join(sentences)


def verdicts(found: Sequence[Results]) -> list[Compared]:
    """Return label, verdict and what it rests on of each that has one, or why it was not solved."""
    rows: list[Compared] = []
    for each in found:
        if each.complaint:
            rows.append((each.label, "Not solved.", each.complaint))
        elif each.verdict is not None:
            rows.append((each.label, each.verdict.words, each.verdict.sentence))
    return rows


def lives(found: Sequence[CaseResults]) -> list[Compared]:
    """Return the lives of all cases that have any, with ratios to the first case; empty if the first has none."""
    first = found[0].lives
    if first is None or sum(each.lives is not None for each in found) < 2:
        return []
    rows: list[Compared] = []
    for number, life in enumerate(first.lives["a"]):
        for body in BODIES:
            cells = []
            for each in found:
                own = _number(each.lives.lives[body][number].relative_life) if each.lives else ABSENT
                ratio = each.lives.over(first, body, number) if each.lives else math.nan
                compares = each is not found[0] and math.isfinite(ratio)
                cells.append(Cell(own, f"× {digits(ratio, 4)}" if compares else ""))
            rows.append((f"{life.model.name}, body {body}", *cells))
    return rows


# The largest pressure comes first; its position and the coupling stiffnesses are left out.
_LEFT_OUT = {"max_pressure_y", "load_by_tilt", "moment_by_approach"}
_COMPARED = sorted(set(QUANTITIES) - _LEFT_OUT, key=["max_pressure", *QUANTITIES].index)
_STRESSES = {"von Mises stress": "von_mises", "shear stress": "shear", "orthogonal shear stress": "orthogonal_shear"}


def compared(name: str, found: Amount) -> Compared:
    """Return a row of numbers, with differences from the first in per cent; NaN is absent."""
    (factor, unit), values = found.scale, found.values
    changes = ("", *(_change(value, values[0]) for value in values[1:]))
    cells = (Cell(_number(factor * value), change) for value, change in zip(values, changes, strict=True))
    return (f"{name} [{unit}]" if unit else name, *cells)


def _number(value: float) -> str:
    return digits(value) if math.isfinite(value) else ABSENT


def _change(value: float, first: float) -> str:
    if not (math.isfinite(value) and math.isfinite(first)) or first == 0.0:
        return ""
    change = (value - first) / abs(first)
    return percent(change, 3) if abs(change) >= NOTICED else "0 %"
