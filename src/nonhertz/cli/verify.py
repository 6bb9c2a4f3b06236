"""``nonhertz verify``: known results, recomputed."""

from __future__ import annotations

import sys
from pathlib import Path

from rich.console import Console
from rich.table import Table
from rich.text import Text

from nonhertz.cli import FINE, NOT_VERIFIED
from nonhertz.cli.options import AsJson, Words, refuse_unwritable_out
from nonhertz.cli.printing import Progress, print_table, print_written
from nonhertz.verify import chosen, sections
from nonhertz.verify.claim import Section
from nonhertz.verify.page import COLUMNS, row, summary, tally, write_page
from nonhertz.verify.page import as_json as json_text

_WIDTHS = {"claim": 3, "source": 2}  # shares of the width that the numbers leave
_COLOURS = {"pass": "green", "FAIL": "bold red", "shown": "cyan"}


def verify(
    *,
    out: Path | None = None,
    only: Words = (),
    as_json: AsJson = False,
) -> int:
    """Compare with publications, exact solutions and other methods.

    Every number is recomputed and set beside its reference value; the exit code is 1 if one is off by more than its
    tolerance. This takes less than two minutes.

    Parameters
    ----------
    out : Path
        Directory for validation.md and verify.json, tables of all claims; created if it does not exist.
    only : tuple of str
        Names of the sections to run, such as 'half-space plane-strain'; by default all of them.
    """
    names = chosen(only)
    refuse_unwritable_out(out)
    found = []
    with Progress(len(names)) as progress:
        for section in sections(names, progress.announce):
            progress.wipe()
            found.append(section)
            if not as_json:
                _print_section(section)
    command = " ".join(["nonhertz verify --out DIR", *(["--only", *names] if only else [])])
    made = write_page(out, found, command) if out is not None else ()
    if as_json:
        print(json_text(found))
    else:
        print_written(made)
        print(summary(found))
    return NOT_VERIFIED if tally(found)["FAIL"] else FINE


def _print_section(section: Section) -> None:
    """Print a section's checks as a table."""
    printing = Console(highlight=False, width=None if sys.stdout.isatty() else 100)
    table = Table(box=None, pad_edge=False, padding=(0, 1, 0, 0), header_style="dim", expand=True)
    for column in COLUMNS:
        if column in _WIDTHS:
            table.add_column(column, ratio=_WIDTHS[column], overflow="fold")
        else:
            table.add_column(column, justify="left" if column == "verdict" else "right", no_wrap=True)
    for check in section.checks:
        *cells, verdict = row(check)
        table.add_row(*map(Text, cells), Text(verdict, style=_COLOURS[verdict]))
    printing.print(Text.assemble((section.title, "bold"), (f"  ({section.name})", "dim")))
    print_table(printing, table)
    printing.print()
