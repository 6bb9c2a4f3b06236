"""From the results of contacts or bearings to the text of an HTML file: what stands on the page, section by section."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from nonhertz.amounts import display_units
from nonhertz.errors import InputError, joined
from nonhertz.figures.measured import measured_steps
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.measured import KIND, read_measured, validate_key
from nonhertz.files.paths import body_tables
from nonhertz.files.profiles import profile_tables
from nonhertz.files.title_block import TitleBlock
from nonhertz.report import figures
from nonhertz.report.assumptions import NO_INPUT, Assumption, Verdict, assumptions
from nonhertz.report.differences import conclusion, differing_inputs, results, verdicts
from nonhertz.report.downloads import downloads
from nonhertz.report.inputs import Entry, InputGroup, in_words, inputs
from nonhertz.report.layout import Files, Part, Words, laid_out
from nonhertz.report.method import method
from nonhertz.report.overview import geometry, key_numbers, opening
from nonhertz.report.results import BearingResults, CaseResults, Results, examined, settled
from nonhertz.show import bearing, stresses
from nonhertz.show import lives as life_shown
from nonhertz.show import measured as measured_shown
from nonhertz.show import summary as contact
from nonhertz.show.analysis import Announce, in_silence
from nonhertz.show.beside import Cells, Compared, beside
from nonhertz.show.sections import SUMMARY, Block, Cell, Said, Section, Table, summary

_SHORT = ("Film", "Friction", "Speeds and frequencies")
MOST_NAMED = 3  # cases that the title of a comparison names

_OF_CONTACT = Words(
    "case",
    "solve",
    "Elastic contact, solved with strip elements",
    "The axis y runs along the contact from the middle of the bodies, x across it, z down into a body; positive relief "
    "is material removed; a positive tilt loads the side of positive y.",
)
_OF_BEARING = Words(
    "bearing",
    "bearing",
    "Whole bearing, rollers and rings in equilibrium",
    "x is the bearing's axis, y points to the first roller; forces and motions are those of the inner ring. Along a "
    "roller, y is its own axis, from its middle; positive relief is material removed; positive clearance is room.",
)


def compose(
    cases: Sequence[Case | BearingCase],
    *,
    life: bool | None = None,
    stress: bool = True,
    compare: bool = False,
    title_block: TitleBlock | None = None,
    units: str = "si",
    announce: Announce = in_silence,
) -> str:
    """Return a report on one case, or a comparison of several, as the text of an HTML file.

    Parameters
    ----------
    cases : sequence of Case or of BearingCase
        At least one; others are compared with the first.
    life : bool or None
        Whether to assess lives, which takes seconds; None for only those cases that mention life. Bearings are rated
        unless it is False.
    stress : bool
        Whether to search for the largest stresses below the surface; bearings have none.
    compare : bool
        Whether to solve bearings by slices as well.
    title_block : TitleBlock or None
        Project, author and date for the head of the page; what it leaves empty is that of the first case.
    units : {"si", "us"}
        Units in which numbers are shown: ``"us"`` for in, lbf and ksi. The files in the report keep theirs.
    announce : callable
        Called with the name of each step as it begins.

    Returns
    -------
    str
        The file. Cases that have not converged are reported without stress and life.

    Raises
    ------
    CaseError
        If the solver rejects a case.
    InputError
        If there are cases of both kinds.
    """
    if not (title_block is None or isinstance(title_block, TitleBlock)):
        remedy = "make one with nonhertz.report.TitleBlock"
        raise InputError("title_block", title_block, "be a TitleBlock", remedy)
    with display_units(units):
        found = examined(settled(cases, announce), life=life, stress=stress, compare=compare, announce=announce)
        return rendered(found, title_block)


def rendered(found: Sequence[Results], block: TitleBlock | None = None) -> str:
    """Return the text of the report on these results; what ``block`` leaves empty in its head is that of the first.

    Of several there is a comparison, and of each what is not compared, folded.
    """
    words = _OF_BEARING if isinstance(found[0], BearingResults) else _OF_CONTACT
    head = (block or TitleBlock()).over(found[0].case.title_block)
    if len(found) == 1:
        only = found[0]
        shown = _shown(only)
        drawn = figures.belonging(only)
        first = Section("", drawn.pop(""))
        with_figures = [Section(title, [*blocks, *drawn.get(title, [])]) for title, blocks in shown]
        part = Part(only, [first, *with_figures, *_given(only, words)], numbers=key_numbers(only))
        return laid_out(only.case.title, words, head, opening(only), [part])
    labels, rows = [each.label for each in found], results(found)
    parts = [Part(None, _compared(found, rows, words))]
    for number, each in enumerate(found, start=1):
        parts.append(Part(each, folded=_given(each, words), anchor=f"case-{number}", opening=opening(each)))
    title = f"{joined(labels)} compared" if len(found) <= MOST_NAMED else f"{len(found)} {words.one}s compared"
    return laid_out(title, words, head, conclusion(rows, labels), parts)


def _shown(found: Results) -> list[Section]:
    """Return what a terminal shows of results, too."""
    if isinstance(found, BearingResults):
        if found.solution is None:
            return []
        sections = _joined(bearing.sections(found.case, found.solution, found.life, found.reason))
        if found.slices is not None:
            sections += bearing.compared_sections(found.case, found.solution, found.slices)
        return sections
    sections = contact.sections(found.solution, found.case)
    if found.stress is not None:
        sections += stresses.sections(found.solution, *found.stress, found.strengths)
    return sections + (life_shown.sections(found.lives) if found.lives else [])


def _joined(sections: Sequence[Section]) -> list[Section]:
    """Return sections, of which those of short summaries share a heading and stand beside each other on paper."""
    sections = [*map(_without_method, sections)]
    short = [section for section in sections if section.title in _SHORT]
    blocks = [replace(block, title=title) for title, blocks in short for block in blocks if isinstance(block, Table)]
    return [
        Section(figures.OF_OPERATION, blocks) if section in short else section
        for section in sections
        if section not in short[1:]
    ]


def _without_method(section: Section) -> Section:
    """Return a section without the rows on the method, which has a section of its own in a report."""
    blocks = []
    for block in section.blocks:
        names = [row[0] for row in block.rows] if isinstance(block, Table) and block.layout == SUMMARY else []
        at = names.index(bearing.METHOD) if bearing.METHOD in names else None
        blocks.append(block if at is None or not isinstance(block, Table) else replace(block, rows=block.rows[:at]))
    return Section(section.title, blocks)


def _given(found: Results, words: Words) -> list[Section]:
    """Return what results rest on: inputs, assumptions, method, references and files."""
    every = assumptions(found)
    beyond = [f"{each.name}: {each.criterion}. {each.remark}".strip() for each in every if each.number == NO_INPUT]
    judged = [each for each in every if each.number != NO_INPUT]
    holding = [each for each in judged if each.verdict is Verdict.HOLDS]
    others = _judged([each for each in judged if each not in holding], words)
    names = "; ".join(each.name for each in holding)
    held = [
        Said([f"These hold: {names[:1].lower()}{names[1:]}."] if holding else []),
        replace(_judged(holding, words), folded="What these are, and the numbers"),
    ]
    paragraphs, references = method(found)
    derived = Table(geometry(found), layout="inputs follows", title="Derived quantities")
    return [
        Section("Inputs", [*(table for group in inputs(found.case) for table in _tables(group)), derived]),
        *_measured(found.case),
        Section(
            "Assumptions and whether they hold",
            [others, *held, Said(["No input shows whether these hold.", *beyond])],
        ),
        Section("Method", [Said(paragraphs, "paragraphs")]),
        Section("References", [Said(references, "references")]),
        Section("Files", [Files(found.case, downloads(found))]),
    ]


def _judged(found: Sequence[Assumption], words: Words) -> Table:
    """Return assumptions with their criteria, numbers and verdicts, each with its remark below."""
    rows = [
        row
        for each in found
        for row in ((each.name, each.criterion, each.number, each.verdict.value), (Cell("", each.remark),))
        if any(map(any, row))
    ]
    return Table(rows, ("Assumption", "Holds where", f"This {words.one}", "Verdict"), layout="assumptions")


def _tables(group: InputGroup) -> Iterator[Table]:
    """Yield the inputs that were given, and the usual ones, folded."""
    usual = [each for each in group.entries if each.default]
    rows = [_input(each) if isinstance(each, Entry) else each for each in group.rows if each not in usual]
    yield Table(rows, layout="inputs", title=group.title)
    if usual:
        keys = ", ".join(each.name for each in usual)
        folded = f"{len(usual)} default{'s' if len(usual) > 1 else ''}: {keys}"
        yield Table([_input(each) for each in usual], layout="inputs", folded=folded)


def _input(entry: Entry) -> tuple[str | Cell, ...]:
    written = f"written {entry.written}" if entry.written else ""
    return entry.name, Cell(entry.shown, written), entry.meaning


def _measured(case: Case | BearingCase) -> Iterator[Section]:
    """Yield what was done to the measured profiles whose files are available, step by step."""
    for place, body in body_tables(case.document):
        for number, table in enumerate(profile_tables(body), start=1):
            content, file = case.attachments.get(str(table.get("file"))), table.get("file")
            if table.get("kind") == KIND and content is not None:
                values = {key: validate_key(key, value) for key, value in table.items() if key != "kind"}
                measured = read_measured(content, values, file)
                drawn = figures.pictures_of({"": measured_steps(measured)})
                title = f"What was done to {file}: {in_words(f'{place}.profile[{number}]')}"
                yield Section(title, [summary(measured_shown.rows(measured)), *drawn])


def _compared(found: Sequence[Results], rows: Sequence[Compared | Cells], words: Words) -> list[Section]:
    """Return several results beside the first: inputs, figure, numbers, given as rows, and lives."""
    labels = [each.label for each in found]
    differing, same, notes = differing_inputs([inputs(each.case) for each in found])
    blocks: list[Block] = [Said([f"None differ: the {words.one}s have the same."], "paragraphs")]
    if differing:
        blocks = [beside(differing, labels, "Inputs that differ"), Said(notes)]
    sections = [
        Section("", [Table(verdicts(found), layout="summary")]),
        Section("Inputs", blocks),
        Section("", figures.of_all(found)),
        Section(
            "Results",
            [
                beside(rows, labels, "Result"),
                Said([f"Percentages are differences from the first {words.one}."]),
            ],
        ),
    ]
    contacts = [each for each in found if isinstance(each, CaseResults)]
    if contacts and contacts[0].lives and any(each.lives for each in contacts[1:]):
        sections.append(life_shown.compared_section([(each.label, each.lives) for each in contacts]))
    return [*sections, Section("Inputs that are the same", [Table(same, layout="inputs")] if same else [])]
