"""From the results of contacts or bearings to the text of an HTML file: the sections of the page."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import chain

from nonhertz.amounts import display_units
from nonhertz.errors import InputError, join_words
from nonhertz.figures.measured import measured_steps
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.measured import KIND, read_measured, validate_key
from nonhertz.files.paths import body_tables
from nonhertz.files.profiles import profile_tables
from nonhertz.files.title_block import TitleBlock
from nonhertz.report import figures
from nonhertz.report.assumptions import NO_INPUT, Assumption, Verdict, judge_assumptions
from nonhertz.report.differences import compare_inputs, result_rows, summarize, verdict_rows
from nonhertz.report.downloads import collect_downloads
from nonhertz.report.inputs import Entry, InputGroup, collect_inputs, readable_place, share_material
from nonhertz.report.layout import Files, Part, Words, render_page
from nonhertz.report.method import describe_method
from nonhertz.report.overview import derived_quantities, key_numbers, opening_sentence
from nonhertz.report.results import BearingResults, CaseResults, Results, post_process, solve_all
from nonhertz.show import bearing, stresses
from nonhertz.show import lives as life_shown
from nonhertz.show import measured as measured_shown
from nonhertz.show import summary as contact
from nonhertz.show.analysis import Announce, no_progress
from nonhertz.show.beside import Cells, Compared, beside
from nonhertz.show.sections import SUMMARY, Block, Cell, Notes, Section, Table, summary

_SHORT = ("Film", "Friction", "Speeds and frequencies")
MOST_NAMED = 3  # cases that the title of a comparison names

_OF_CONTACT = Words(
    "case",
    "solve",
    "Elastic contact, solved with strip elements",
    "The axis y runs along the contact from the middle of the bodies, x across it, z down into a body; positive relief "
    "is material removed; a positive tilt (misalignment) loads the side of positive y.",
)
_OF_BEARING = Words(
    "bearing",
    "bearing",
    "Whole bearing, rollers and rings in equilibrium",
    "x is the bearing's axis, y points to the first roller; forces, displacements and tilts (misalignments) are those "
    "of the inner ring. Along a roller, y is its own axis, from its middle; positive relief is material removed; a "
    "negative clearance is preload.",
)


def compose(
    cases: Sequence[Case | BearingCase],
    *,
    life: bool | None = None,
    stress: bool = True,
    compare: bool = False,
    title_block: TitleBlock | None = None,
    units: str = "si",
    announce: Announce = no_progress,
) -> str:
    """Return a report on one case, or a comparison of several, as the text of an HTML file.

    Parameters
    ----------
    cases : sequence of Case or of BearingCase
        At least one; others are compared with the first.
    life : bool or None
        Whether to assess lives, which takes seconds; None for cases with a table life only. Bearings are rated unless
        it is False.
    stress : bool
        Whether to search for the largest stresses below the surface; without effect on bearings.
    compare : bool
        Whether to solve bearings by slices as well.
    title_block : TitleBlock or None
        Project, author and date for the head of the page; empty fields are taken from the first case.
    units : {"si", "us"}
        Units in which numbers are shown: ``"us"`` for in, lbf and ksi. The files in the report keep theirs.
    announce : callable
        Called with the name of each step as it begins.

    Returns
    -------
    str
        The text of the file. Cases that have not converged are reported without stress and life.

    Raises
    ------
    CaseError
        If the solver rejects a case.
    InputError
        If cases and bearings are mixed, or ``title_block`` is not a TitleBlock.
    """
    if not (title_block is None or isinstance(title_block, TitleBlock)):
        remedy = "make one with nonhertz.report.TitleBlock"
        raise InputError("title_block", title_block, "be a TitleBlock", remedy)
    with display_units(units):
        results = post_process(solve_all(cases, announce), life=life, stress=stress, compare=compare, announce=announce)
        return to_html(results, title_block)


def to_html(results: Sequence[Results], block: TitleBlock | None = None) -> str:
    """Return the text of the report on these results; empty fields of ``block`` are taken from the first case.

    Several results are compared; the parts that are not compared are folded.
    """
    words = _OF_BEARING if isinstance(results[0], BearingResults) else _OF_CONTACT
    head = (block or TitleBlock()).over(results[0].case.title_block)
    if len(results) == 1:
        only = results[0]
        shown = _result_sections(only)
        drawn = figures.draw_figures(only)
        first = Section("", drawn.pop(""))
        with_figures = [Section(title, [*blocks, *drawn.get(title, [])]) for title, blocks in shown]
        part = Part(only, [first, *with_figures, *_basis_sections(only, words)], numbers=key_numbers(only))
        return render_page(only.case.title, words, head, opening_sentence(only), [part])
    labels, rows = [result.label for result in results], result_rows(results)
    parts = [Part(None, _comparison_sections(results, rows, words))]
    parts += [
        Part(result, folded=_basis_sections(result, words), anchor=f"case-{number}", opening=opening_sentence(result))
        for number, result in enumerate(results, start=1)
    ]
    title = f"{join_words(labels)} compared" if len(results) <= MOST_NAMED else f"{len(results)} {words.one}s compared"
    return render_page(title, words, head, summarize(rows, labels), parts)


def _result_sections(result: Results) -> list[Section]:
    """Return the sections that a terminal shows as well."""
    if isinstance(result, BearingResults):
        if result.solution is None:
            return []
        sections = _join_short_sections(bearing.sections(result.case, result.solution, result.life, result.reason))
        if result.slices is not None:
            sections += bearing.compared_sections(result.case, result.solution, result.slices)
        return sections
    sections = contact.sections(result.solution, result.case)
    if result.stress is not None:
        sections += stresses.sections(result.solution, *result.stress, result.strengths)
    return sections + (life_shown.sections(result.lives) if result.lives else [])


def _join_short_sections(sections: Sequence[Section]) -> list[Section]:
    """Return the sections; short summaries share a heading and are side by side on paper."""
    sections = [*map(_without_method, sections)]
    short = [section for section in sections if section.title in _SHORT]
    blocks = [replace(block, title=title) for title, blocks in short for block in blocks if isinstance(block, Table)]
    return [
        Section(figures.OF_OPERATION, blocks) if section in short else section
        for section in sections
        if section not in short[1:]
    ]


def _without_method(section: Section) -> Section:
    """Return a section without the rows on the method, which has its own section in a report."""
    blocks = []
    for block in section.blocks:
        names = [row[0] for row in block.rows] if isinstance(block, Table) and block.layout == SUMMARY else []
        at = names.index(bearing.METHOD) if bearing.METHOD in names else None
        blocks.append(block if at is None or not isinstance(block, Table) else replace(block, rows=block.rows[:at]))
    return Section(section.title, blocks)


def _basis_sections(result: Results, words: Words) -> list[Section]:
    """Return the basis of the results: inputs, assumptions, method, references and files."""
    paragraphs, references = describe_method(result)
    derived = Table(derived_quantities(result), layout="inputs follows", title="Derived quantities")
    tables = chain.from_iterable(map(_input_tables, share_material(collect_inputs(result.case))))
    return [
        Section("Inputs", [*tables, derived]),
        *_measured_sections(result.case),
        Section("Assumptions and whether they hold", _assumption_blocks(judge_assumptions(result), words)),
        Section("Method", [Notes(paragraphs, "paragraphs")]),
        Section("References", [Notes(references, "references")]),
        Section("Files", [Files(result.case, collect_downloads(result))]),
    ]


def _assumption_blocks(assumptions: Sequence[Assumption], words: Words) -> list[Block]:
    """Return assumptions that are strained or not judged, then those that hold, then those that no input decides."""
    judged = [assumption for assumption in assumptions if assumption.number != NO_INPUT]
    holding = [assumption for assumption in judged if assumption.verdict is Verdict.HOLDS]
    names = "; ".join(assumption.name for assumption in holding)
    beyond = [
        f"{assumption.name}: {assumption.criterion}. {assumption.remark}".strip()
        for assumption in assumptions
        if assumption.number == NO_INPUT
    ]
    return [
        _assumption_table([assumption for assumption in judged if assumption not in holding], words),
        Notes([f"These hold: {names[:1].lower()}{names[1:]}."] if holding else []),
        replace(_assumption_table(holding, words), folded="Criteria and numbers"),
        Notes(["No input decides whether these hold.", *beyond]),
    ]


def _assumption_table(assumptions: Sequence[Assumption], words: Words) -> Table:
    """Return assumptions with their criteria, numbers and verdicts, each with its remark below."""
    rows: list[tuple[str | Cell, ...]] = []
    for assumption in assumptions:
        rows.append((assumption.name, assumption.criterion, assumption.number, assumption.verdict.value))
        rows += [(Cell("", assumption.remark),)] * bool(assumption.remark)
    return Table(rows, ("Assumption", "Holds where", f"This {words.one}", "Verdict"), layout="assumptions")


def _input_tables(group: InputGroup) -> Iterator[Table]:
    """Yield the inputs that were given, and the defaults, folded."""
    defaults = [entry for entry in group.entries if entry.default]
    rows = [_input_row(row) if isinstance(row, Entry) else row for row in group.rows if row not in defaults]
    yield Table(rows, layout="inputs", title=group.title)
    if defaults:
        keys = ", ".join(entry.name for entry in defaults)
        of = "" if rows else f"{group.title}: "
        folded = f"{of}{len(defaults)} default{'s' if len(defaults) > 1 else ''}: {keys}"
        yield Table([*map(_input_row, defaults)], layout="inputs", folded=folded)


def _input_row(entry: Entry) -> tuple[str | Cell, ...]:
    written = f"written {entry.written}" if entry.written else ""
    return entry.name, Cell(entry.value_with_unit, written), entry.meaning


def _measured_sections(case: Case | BearingCase) -> Iterator[Section]:
    """Yield the preparation of the measured profiles whose files are available, step by step."""
    for place, body in body_tables(case.document):
        for number, table in enumerate(profile_tables(body), start=1):
            content, file = case.attachments.get(str(table.get("file"))), table.get("file")
            if table.get("kind") == KIND and content is not None:
                values = {key: validate_key(key, value) for key, value in table.items() if key != "kind"}
                measured = read_measured(content, values, file)
                drawn = figures.draw_pictures({"": measured_steps(measured)})
                title = f"Preparation of {file}: {readable_place(f'{place}.profile[{number}]')}"
                yield Section(title, [summary(measured_shown.rows(measured)), *drawn])


def _comparison_sections(results: Sequence[Results], rows: Sequence[Compared | Cells], words: Words) -> list[Section]:
    """Return a comparison of several results with the first: verdicts, inputs, figure, ``rows`` of numbers, lives."""
    labels = [result.label for result in results]
    differing, same, notes = compare_inputs([collect_inputs(result.case) for result in results])
    blocks: list[Block] = [Notes([f"The {words.one}s have the same inputs."], "paragraphs")]
    if differing:
        blocks = [beside(differing, labels, "Inputs that differ"), Notes(notes)]
    sections = [
        Section("", [Table(verdict_rows(results), layout="summary")]),
        Section("Inputs", blocks),
        Section("", figures.draw_comparison(results)),
        Section(
            "Results",
            [beside(rows, labels, "Result"), Notes([f"Percentages are differences from the first {words.one}."])],
        ),
    ]
    lives = [(result.label, result.lives) for result in results if isinstance(result, CaseResults)]
    if lives and lives[0][1] and any(life for _, life in lives[1:]):
        sections.append(life_shown.compared_section(lives))
    return [*sections, Section("Inputs that are the same", [Table(same, layout="inputs")] if same else [])]
