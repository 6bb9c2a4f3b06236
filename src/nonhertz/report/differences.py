"""Several cases side by side: which inputs differ, and how the results change."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from operator import attrgetter

from nonhertz.amounts import mpa
from nonhertz.bearing.quantities import QUANTITIES as BEARING_QUANTITIES
from nonhertz.bearing.quantities import SolvedBearing
from nonhertz.report.inputs import Entry, InputGroup
from nonhertz.report.results import BearingResults, CaseResults, Results
from nonhertz.result.quantities import QUANTITIES
from nonhertz.show.bearing import clean_numbers
from nonhertz.show.beside import ABSENT, Cells, Compared, shared_quantities
from nonhertz.show.sections import Cell
from nonhertz.show.summary import end_words

# Inputs that do not describe the shape of a body: sections of files, and keys of bodies.
_CONDITIONS = {"load", "solver", "lubrication", "life", "fit"}
_ENTRIES = attrgetter("entries")
_BESIDE_SHAPES = {*_CONDITIONS, "material", "depth", "side_faces", "effective_length", "clearance"}


def compare_inputs(cases: Sequence[Sequence[InputGroup]]) -> tuple[list[Cells], list[Cells], list[str]]:
    """Return the inputs in which cases differ, those given in a file that are the same in all, and a note.

    ``cases`` are the inputs of each case. The note lists differences other than dimensions and profiles, with which not
    all results are comparable.
    """
    tables = [{entry.place: entry for entry in chain.from_iterable(map(_ENTRIES, groups))} for groups in cases]
    differing: list[Cells] = []
    same: list[Cells] = []
    conditions: list[str] = []
    for place in dict.fromkeys(chain.from_iterable(tables)):
        entries = [table.get(place) for table in tables]
        values = [getattr(entry, "value_with_unit", ABSENT) for entry in entries]
        first = next(filter(None, entries))
        if len(set(values)) > 1:
            differing.append((first.full_name, *values))
            conditions += _condition(first)
        elif not all(table[place].default for table in tables):
            same.append((first.full_name, values[0], first.meaning))
    what = "; ".join(dict.fromkeys(conditions))
    return differing, same, [f"Not all results are comparable, since more than shapes differs: {what}."] if what else []


def _condition(entry: Entry) -> list[str]:
    """Return the name of an input that does not describe the shape of a body; otherwise nothing."""
    section, key = entry.place.partition(".")[0], entry.place.rpartition(".")[2]
    if section in _CONDITIONS:
        return [section]
    return [entry.full_name] if {section, key} & _BESIDE_SHAPES else []


def result_rows(results: Sequence[Results]) -> list[Compared | Cells]:
    """Return the results of all cases or bearings, with differences from the first, without empty rows."""
    contacts = [result for result in results if isinstance(result, CaseResults)]
    return [*(_contact_rows(contacts) if contacts else _bearing_rows(results))]


def _contact_rows(contacts: Sequence[CaseResults]) -> Iterator[Compared | Cells]:
    solutions = [contact.solution for contact in contacts]
    first, *others = (
        Compared(quantity.label, quantity.amount(*(float(quantity.clean(solution)) for solution in solutions)))
        for quantity in map(QUANTITIES.__getitem__, _COMPARED)
    )
    yield first
    for at, end in enumerate(("low", "high")):
        cells = [Cell(*end_words(solution.edge_pressure[at], solution)) for solution in solutions]
        yield f"pressure at the {end} end", *cells
    yield from others
    stresses = [contact.stress[0] for contact in contacts if contact.stress]
    if len(stresses) == len(contacts):
        for name, key in _STRESSES.items():
            yield Compared(f"largest {name} in body a", mpa(*(getattr(stress, key).max for stress in stresses)))


def _bearing_rows(results: Sequence[Results]) -> list[Compared]:
    names = sorted(set(BEARING_QUANTITIES) - {"warnings"}, key=["max_pressure", *BEARING_QUANTITIES].index)
    bearings = [result for result in results if isinstance(result, BearingResults)]
    return shared_quantities(map(BEARING_QUANTITIES.__getitem__, names), [*map(_bearing_numbers, bearings)])


def _bearing_numbers(result: BearingResults) -> dict[str, float]:
    """Return the numbers of a bearing by name, including those of its life only if it was assessed."""
    if result.solution is None:
        return {}
    lived = result.life is not None
    quantities = (quantity for quantity in BEARING_QUANTITIES.values() if lived or quantity.within != "life")
    return clean_numbers(quantities, SolvedBearing(result.case, result.solution))


def summarize(compared_results: Sequence[Compared | Cells], labels: Sequence[str]) -> str:
    """Return sentences that compare the maximum pressures, and for bearings also the lives."""
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


def verdict_rows(results: Sequence[Results]) -> list[Cells]:
    """Return label, verdict and its reason for each result that has a verdict, or why it was not solved."""
    rows: list[Cells] = []
    for result in results:
        if result.complaint:
            rows.append((result.label, "Not solved.", result.complaint))
        elif result.verdict is not None:
            rows.append((result.label, result.verdict.words, result.verdict.sentence))
    return rows


# The maximum pressure comes first; its position and the coupling stiffnesses are left out.
_LEFT_OUT = {"max_pressure_y", "load_by_tilt", "moment_by_approach"}
_COMPARED = sorted(set(QUANTITIES) - _LEFT_OUT, key=["max_pressure", *QUANTITIES].index)
_STRESSES = {"von Mises stress": "von_mises", "shear stress": "shear", "orthogonal shear stress": "orthogonal_shear"}
