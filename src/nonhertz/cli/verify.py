"""``nonhertz verify``: known results, recomputed."""

from __future__ import annotations

from pathlib import Path

from nonhertz.cli import FINE, NOT_VERIFIED
from nonhertz.cli.options import AsJson, Words, refuse_unwritable_out
from nonhertz.cli.printing import Progress, print_result, print_written
from nonhertz.show.sections import Section, Table
from nonhertz.verify import chosen, sections
from nonhertz.verify.page import COLUMNS, row, summary, tally, write_page
from nonhertz.verify.page import as_json as json_text


def verify(
    *,
    out: Path | None = None,
    only: Words = (),
    as_json: AsJson = False,
) -> int:
    """Compare with publications, exact solutions and other methods.

    Every number is recomputed and set beside its reference value; the exit code is 1 if one is off by more than its
    tolerance. This takes about four minutes on two cores.

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
                table = Table([row(check) for check in section.checks], COLUMNS, (0, 1, len(COLUMNS) - 1))
                print_result(f"{section.title}  ({section.name})", [Section("", [table])])
                print()
    command = " ".join(["nonhertz verify --out DIR", *(["--only", *names] if only else [])])
    made = write_page(out, found, command) if out is not None else ()
    if as_json:
        print(json_text(found))
    else:
        print_written(made)
        print(summary(found))
    return NOT_VERIFIED if tally(found)["FAIL"] else FINE
