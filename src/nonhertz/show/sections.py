"""Sections of tables, sentences and figures, in which all results are shown in a terminal and in reports.

One function for each kind of result makes them. The layout depends on tables only, not on contacts.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final, NamedTuple, TypeGuard, cast

from nonhertz.findings import Finding

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Name, value and remark; a row without a name continues the one before.
Row = tuple[str, str, str]
SUMMARY: Final = "summary"
"""The layout of a table of such rows."""


class Cell(NamedTuple):
    """A cell with a remark, which is shown below it in small letters."""

    text: str
    remark: str = ""


class Block:
    """A part of a section."""


@dataclass(frozen=True)
class Table(Block):
    """Rows of numbers and words.

    Attributes
    ----------
    rows : sequence of sequences of str or Cell
        A row of one cell is a heading, or, if the cell has only a remark, a remark on the row before.
    heads : sequence of str
        Headings of the columns; empty for none.
    words : sequence of int or None
        Columns of words, aligned left; None for all.
    layout : str
        Its CSS class on a page.
    title : str
        Its caption on a page.
    room : int
        Least width in a terminal of the second column, the only one whose words may be broken; 0 for no such column.
    folded : str
        Text that a page shows until the table is unfolded; empty if it is always open.
    remarks : str
        Heading of the remarks on cells, which have columns of their own in a terminal.
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
        Its caption.
    description : str
        Its numbers in words, for readers who cannot see it.
    """

    figure: Figure
    caption: str
    description: str


class Section(NamedTuple):
    """A heading, which may be empty, and the blocks below it."""

    title: str
    blocks: Sequence[Block]


def assumed_rows(findings: Iterable[Finding]) -> list[Row]:
    """Return the assumed values, the keys that are not given, and the results that they affect."""
    assumptions = [dict(finding.numbers) for finding in findings]
    rows = [(numbers["default"], f"for {numbers['keys']}; decides {numbers['decides']}") for numbers in assumptions]
    return [("" if number else "assumed", *row) for number, row in enumerate(rows)]


def assumed_section(findings: Iterable[Finding]) -> Section:
    """Return the assumed values as a section, which is empty if there are none."""
    rows = assumed_rows(findings)
    return Section("", [summary(rows)] if rows else [])


def summary(rows: Iterable[Row], title: str = "") -> Table:
    """Return rows of name, value and remark as a table."""
    return Table(list(rows), layout=SUMMARY, title=title)


def rows_of_summaries(sections: Iterable[Section]) -> list[Row]:
    """Return the rows of all summaries."""
    tables = (block for section in sections for block in section.blocks if isinstance(block, Table))
    return [cast("Row", row) for table in tables if table.layout == SUMMARY for row in table.rows]


def group_blocks(sections: Iterable[Section]) -> list[list[Table | Notes]]:
    """Return what stands together without an empty line; summaries that follow each other are one table."""
    groups: list[list[Table | Notes]] = []
    for section in sections:
        blocks = [block for block in section.blocks if isinstance(block, Table | Notes) and len(block)]
        if groups and blocks and _is_summary(first := blocks[0]) and _is_summary(before := groups[-1][-1]):
            groups[-1][-1] = replace(before, rows=[*before.rows, *first.rows])
            groups[-1] += blocks[1:]
        elif blocks:
            groups.append(blocks)
    return groups


def _is_summary(block: Table | Notes) -> TypeGuard[Table]:
    return isinstance(block, Table) and block.layout == SUMMARY


def with_columns_of_remarks(table: Table) -> Table:
    """Return a table with the remarks on cells in columns of their own, to the right of these cells."""
    if not table.remarks:
        return table
    remarked = {at for row in table.rows for at, cell in enumerate(row) if isinstance(cell, Cell) and cell.remark}

    def spread(cells: Sequence[str | Cell], remark: str) -> list[str]:
        """Return cells of text; ``remark`` replaces a missing remark."""
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
