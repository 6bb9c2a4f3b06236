"""Printing for people."""

from __future__ import annotations

import contextlib
import re
import sys
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Self

from rich.console import Console
from rich.measure import Measurement
from rich.progress import BarColumn, MofNCompleteColumn, TextColumn, TimeRemainingColumn
from rich.progress import Progress as Bar
from rich.table import Table as Grid
from rich.text import Text

from nonhertz.show.sections import Section, Table, group_blocks, shown_columns, with_columns_of_remarks
from nonhertz.verdict import Level, Verdict

# Between a number and its unit, and within a unit; as a letter, since rich breaks lines at any blank.
_TOGETHER, _GLUE = (
    re.compile(r"(?<=\d) (?=[^\W\d])|(?<=MPa|ksi|psi) (?=mm|in)|(?<=\bN) (?=m)|(?<=\bK) (?==)|(?<=K =) "),
    "\ue000",
)
Update = Callable[..., None]
_VERDICTS = {"pass": "green", "FAIL": "bold red", "shown": "cyan"}
_LEVELS = {Level.MET: "green", Level.NOT_JUDGED: "bright_black", Level.NOT_MET: "bold red"}
_STYLES = {"head": "bold", "warning": "yellow"}


def print_result(
    title: str,
    sections: Iterable[Section],
    verdict: Verdict | None = None,
    warnings: Iterable[object] = (),
    written: Iterable[Path] = (),
    *,
    piped: int | None = 120,
) -> None:
    """Print a result for people: title, verdict, sections, warnings, and the files that were written.

    Without a terminal the width is ``piped`` columns; None for COLUMNS, or else 80.
    """
    console = Console(highlight=False, width=None if sys.stdout.isatty() else piped)

    def say(sentence: object, style: str = "") -> None:
        """Print a sentence; as text, since rich would take [MPa] for markup."""
        console.print(Text(str(sentence), style), soft_wrap=True)

    if title:
        console.print(Text(title, style="bold"))
    if verdict is not None:
        say(f"{verdict.words} {verdict.sentence}", _LEVELS.get(verdict.level, "yellow"))
    for number, blocks in enumerate(group_blocks(sections)):
        if number:
            console.print()
        for block in blocks:
            if isinstance(block, Table):
                _print_rows(console, with_columns_of_remarks(block))
            else:
                for sentence in block.sentences:
                    say(sentence, _STYLES.get(block.layout, ""))
    for warning in warnings:
        say(f"warning: {warning}", "yellow")
    print_written(written)


def _print_rows(console: Console, shown: Table) -> None:
    """Print rows, without columns that are blank throughout: numbers aligned right, words left.

    A table may be wider than the terminal, since a truncated number looks like a different one. No line breaks between
    a number and its unit, and none ends in blanks.
    """
    heads, columns = shown.heads, shown_columns(shown)
    table = Grid(box=None, pad_edge=False, padding=(0, 2, 0, 0), show_header=bool(heads), header_style="dim")
    words = {*columns} if shown.words is None else shown.words
    folded = {1} if shown.room else words  # columns whose cells may be broken
    for at in columns:
        table.add_column(
            _keep_together(heads[at] if heads else "", at not in folded),
            justify="left" if at in words else "right",
            overflow="fold",
            no_wrap=at not in folded,
            min_width={1: shown.room or None}.get(at),
        )
    for row in shown.rows:
        cells, heading = [*map(str, row), *[""] * (1 + max(columns, default=0))], "bold" if len(row) == 1 else ""
        texts = (_keep_together(cells[at], at not in folded, _VERDICTS.get(cells[at], heading)) for at in columns)
        table.add_row(*texts)
    least = Measurement.get(console, console.options.update(width=sys.maxsize), table).minimum
    wide = Console(highlight=False, width=max(console.width, least))
    with wide.capture() as captured:
        wide.print(table)
    print(*map(str.rstrip, captured.get().replace(_GLUE, " ").splitlines()), sep="\n")


def _keep_together(cell: str, whole: bool, style: str = "") -> Text:
    """Return the text of a cell that is not broken at all, or not between a number and its unit."""
    return Text(cell.replace(" ", _GLUE) if whole else _TOGETHER.sub(_GLUE, cell), style)


def print_written(written: Iterable[Path]) -> None:
    """Print the names of files that were written."""
    for path in written:
        print(f"wrote {path}")


class Progress:
    """A progress line on a terminal, wiped before anything else is printed.

    Parameters
    ----------
    steps : int or None
        Total number of steps; None if that is not known.
    """

    def __init__(self, steps: int | None) -> None:
        self._steps = steps
        self._done = 0
        self._line = ""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.wipe()

    def announce(self, name: str) -> None:
        """Show the name of the next step."""
        self._done += 1
        self._write(f"{self._done if self._steps is None else f'{self._done}/{self._steps}'} {name} ...")

    def wipe(self) -> None:
        """Clear the line."""
        self._write("")

    def _write(self, line: str) -> None:
        if sys.stderr.isatty():
            print(f"\r{' ' * len(self._line)}\r{line}", end="", file=sys.stderr, flush=True)
        self._line = line


@contextlib.contextmanager
def progress_bar(what: str) -> Iterator[Update | None]:
    """Show a progress bar on a terminal; it is updated with the numbers done, in total, and done before the start."""
    if not sys.stderr.isatty():
        yield None
        return
    columns = TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn()
    with Bar(*columns, console=Console(stderr=True), transient=True) as shown:
        task = shown.add_task(what, total=None)

        def update(done: int, total: int, before: int = 0) -> None:
            if shown.tasks[0].total is None:
                shown.reset(task, total=total, completed=before)
            shown.update(task, completed=done)

        yield update
