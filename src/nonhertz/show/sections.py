"""What is shown of any result: sections of tables, sentences and figures, which terminal and report lay out.

One function for each kind of result yields them. Whoever lays them out knows tables, and nothing of contacts.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final, NamedTuple, cast

from nonhertz.findings import Finding

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Name, value and remark; one without a name continues the row before.
Row = tuple[str, str, str]
SUMMARY: Final = "summary"
"""How a table of such rows is laid out on a page."""


class Cell(NamedTuple):
    """A cell with a remark, which stands below it in small letters."""

    text: str
    remark: str = ""


class Block:
    """Something that stands below a heading."""


@dataclass(frozen=True)
class Table(Block):
    """Rows of numbers and words.

    Attributes
    ----------
    rows : sequence of sequences of str or Cell
        A row of one cell is a heading, or a remark on the row before if the cell has nothing else.
    heads : sequence of str
        Of the columns; empty for none.
    words : sequence of int or None
        Columns of words, which stand to the left; None for all.
    layout : str
        Class by which a page lays it out.
    title : str
        Its caption on a page.
    room : int
        Columns of a terminal for the words of the second column at least, which alone may be broken; 0 for no such.
    folded : str
        What a page shows in place of it until it is unfolded; empty if it is open.
    remarks : str
        Head of the remarks on cells where they have a column of their own, in a terminal.
    """

    rows: Sequence[Sequence[str | Cell]]
    heads: Sequence[str] = ()
    words: Sequence[int] | None = None
    layout: str = "numbers"
    title: str = ""
    room: int = 0
    folded: str = ""
    remarks: str = ""

    def __len__(self) -> int:
        return len(self.rows)


@dataclass(frozen=True)
class Notes(Block):
    """Sentences.

    Attributes
    ----------
    sentences : sequence
        Text or findings.
    layout : str
        ``"note"``, ``"paragraphs"``, ``"bullets"``, ``"references"``, ``"head"`` or ``"warning"``.
    """

    sentences: Sequence[str | Finding]
    layout: str = "note"

    def __len__(self) -> int:
        return len(self.sentences)


@dataclass(frozen=True)
class Picture(Block):
    """A figure.

    Attributes
    ----------
    figure : matplotlib.figure.Figure
        The figure.
    caption : str
        What it shows.
    description : str
        Its numbers, for those who do not see it.
    """

    figure: Figure
    caption: str
    description: str


class Section(NamedTuple):
    """A heading, empty where none is due, and what stands below it."""

    title: str
    blocks: Sequence[Block]


def assumed_rows(findings: Iterable[Finding]) -> list[Row]:
    """Return what is assumed, for what is not given, and what it decides."""
    assumptions = [dict(finding.numbers) for finding in findings]
    rows = [(numbers["default"], f"for {numbers['keys']}; decides {numbers['decides']}") for numbers in assumptions]
    return [("" if number else "assumed", *row) for number, row in enumerate(rows)]


def assumed_section(findings: Iterable[Finding]) -> Section:
    """Return what is assumed as a section by itself; an empty one if nothing is."""
    rows = assumed_rows(findings)
    return Section("", [summary(rows)] if rows else [])


def summary(rows: Iterable[Row], title: str = "") -> Table:
    """Return rows of name, value and remark as a table."""
    return Table(list(rows), layout=SUMMARY, title=title)


def rows_of_summaries(sections: Iterable[Section]) -> list[Row]:
    """Return the rows of all summaries."""
    tables = (block for section in sections for block in section.blocks if isinstance(block, Table))
    return [cast("Row", row) for table in tables if table.layout == SUMMARY for row in table.rows]


def with_columns_of_remarks(table: Table) -> Table:
    """Return a table that has the remarks on cells in columns of their own, on the right of these cells."""
    if not table.remarks:
        return table
    remarked = {at for row in table.rows for at, cell in enumerate(row) if isinstance(cell, Cell) and cell.remark}

    def spread(cells: Sequence[str | Cell], remark: str) -> list[str]:
        """Return cells of text; where one has no remark, ``remark`` is in its place."""
        made = []
        for at, cell in enumerate(cells):
            text, note = cell if isinstance(cell, Cell) else (cell, remark)
            made += [text, note] if at in remarked else [text]
        return made

    return replace(table, rows=[spread(row, "") for row in table.rows], heads=spread(table.heads, table.remarks))


def shown_columns(table: Table) -> list[int]:
    """Return the columns that are not blank throughout."""
    most = max(map(len, table.rows), default=0)
    return [at for at in range(most) if any("".join(row[at]) for row in table.rows if at < len(row))]
