"""Tables of claims with their numbers: Markdown and JSON.

The same numbers give the same files: they contain no date, path or machine name.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path

from claims.claim import Check, Section
from nonhertz import __version__
from nonhertz.files.folder import write_files
from nonhertz.files.results import plain

#: Headings of what `row` returns.
COLUMNS = ("claim", "source", "expected", "computed", "difference", "tolerance", "verdict")
PAGE, CHECKS = "validation.md", "verify.json"

_OPENING = """\
# Validation

This page was written by `{command}`, nonhertz {version}: every number on it was computed then.

One row of a table is one number, set beside what it should be. A difference is relative to the expected value; one
marked abs, and its tolerance, is absolute. "shown" is the verdict of a difference that is not judged.
"""


def tally(found: Iterable[Section]) -> Counter[str]:
    """Return the number of checks with each verdict."""
    return Counter(check.verdict for section in found for check in section.checks)


def summary(found: Iterable[Section]) -> str:
    """Return a one-line summary of the outcome."""
    count = tally(found)
    return f"{count.total()} checks: {count['pass']} passed, {count['FAIL']} failed, {count['shown']} shown"


def row(check: Check) -> tuple[str, ...]:
    """Return a check as readable text, one entry for each of `COLUMNS`."""
    claim, difference = check.claim, _power(check.difference)
    return (
        _quantity(check) + (f" [{claim.unit}]" if claim.unit else ""),
        claim.source,
        _number(check.expected),
        _number(check.computed),
        f"{difference} abs" if claim.absolute else difference,
        "" if check.tolerance is None else re.sub(r"\.?0+(?=e)", "", _power(check.tolerance, 2)),
        check.verdict,
    )


def as_json(found: Iterable[Section]) -> str:
    """Return all checks as one JSON list, one check per line; non-finite numbers are null."""
    lines = []
    for section in found:
        for check in section.checks:
            claim = check.claim
            entry = {
                "section": section.name, "title": section.title, "id": claim.id, "claim": _quantity(check),
                "source": claim.source, "expected": plain(check.expected), "computed": plain(check.computed),
                "difference": plain(check.difference), "tolerance": plain(check.tolerance), "why": claim.why,
                "unit": claim.unit, "absolute": claim.absolute, "verdict": check.verdict,
            }  # fmt: skip
            lines.append(f"  {json.dumps(entry, allow_nan=False)}")
    return "[\n" + ",\n".join(lines) + "\n]"


def as_markdown(found: Sequence[Section], command: str) -> str:
    """Return a page with a table for each section, in reading order; ``command`` is the command that makes it."""
    blocks = [_OPENING.format(command=command, version=__version__), overview(found)]
    for section in found:
        blocks += [f"## {section.title}\n", table(COLUMNS, map(row, section.checks), numbers=COLUMNS[2:6])]
    return "\n".join(blocks)


def write_page(directory: str | Path, found: Sequence[Section], command: str) -> tuple[Path, ...]:
    """Write the page and the checks (JSON) into a directory, as `write_files` does; see `as_markdown`."""
    return write_files(directory, {PAGE: as_markdown(found, command), CHECKS: as_json(found) + "\n"})


def overview(found: Sequence[Section]) -> str:
    """Return a table of the number of checks of each section with each verdict."""

    def counted(title: str, some: Sequence[Section]) -> tuple[str, ...]:
        count = tally(some)
        return title, *map(str, (count.total(), count["FAIL"], count["shown"]))

    rows = [counted(section.title, [section]) for section in found]
    if len(rows) > 1:
        rows.append(counted("all", found))
    head = ("section", "checks", "failed", "shown")
    return table(head, rows, numbers=head[1:])


def table(head: Sequence[str], rows: Iterable[Iterable[str]], numbers: Sequence[str]) -> str:
    """Return a table in Markdown; the columns in ``numbers`` are aligned to the right."""
    rule = ("---:" if name in numbers else "---" for name in head)
    lines = [head, rule, *([_escaped(cell) for cell in cells] for cells in rows)]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def _quantity(check: Check) -> str:
    return f"{check.claim.quantity} (not found: {check.error})" if check.error else check.claim.quantity


def _escaped(text: str) -> str:
    r"""Return a text on one line, with Markdown's special characters escaped.

    Examples
    --------
    >>> print(_escaped("|p| at a_1"))
    \|p\| at a\_1
    """
    return re.sub(r"([\\`*_|<$~])", r"\\\1", " ".join(text.split()))


def _number(value: float) -> str:
    """Return a value with six digits.

    Examples
    --------
    >>> _number(1008.36569), _number(0.0000280119), _number(-6000.0), _number(float("nan"))
    ('1008.37', '2.80119e-5', '-6000', 'nan')
    """
    return _short_exponent(f"{value:.6g}")


def _power(value: float, decimals: int = 1) -> str:
    """Return a difference or a tolerance as a power of ten, so that sizes are seen at a glance.

    Examples
    --------
    >>> _power(3.14e-6), _power(-0.01), _power(0.0125, 2), _power(0.0)
    ('3.1e-6', '-1.0e-2', '1.25e-2', '0')
    """
    return "0" if value == 0.0 else _short_exponent(f"{value:.{decimals}e}")


def _short_exponent(text: str) -> str:
    return re.sub(r"e([+-])0*(\d)", lambda found: f"e{found[1].strip('+')}{found[2]}", text)
