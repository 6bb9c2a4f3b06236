"""The validation page: one Markdown file with its figures, and the same checks as JSON.

The same numbers give the same files: they contain no date, path or machine name.
"""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from nonhertz import __version__
from nonhertz.io.folder import write_files
from nonhertz.io.results import plain
from nonhertz.verify.claim import Check, Picture, Section

#: Headings of what `row` returns.
COLUMNS = ("claim", "source", "expected", "computed", "difference", "tolerance", "verdict")
PAGE, CHECKS = "validation.md", "verify.json"

_OPENING = """\
# Validation

This page was written by `{command}`, nonhertz {version}: every number on it was computed then.

One row of a table is one number, set beside what it should be. A difference is relative to the expected value; one
marked abs, and its tolerance, is absolute. "shown" is the verdict of a difference that is not judged.
"""


def tally(found: Mapping[str, Section]) -> Counter[str]:
    """Return the number of checks with each verdict."""
    return Counter(check.verdict for section in found.values() for check in section.checks)


def summary(found: Mapping[str, Section]) -> str:
    """Return a one-line summary of the outcome."""
    count = tally(found)
    return f"{count.total()} checks: {count['pass']} passed, {count['FAIL']} failed, {count['shown']} shown"


def row(check: Check) -> tuple[str, ...]:
    """Return a check as readable text, one entry for each of `COLUMNS`."""
    difference = _power(check.difference)
    return (
        f"{check.claim} [{check.unit}]" if check.unit else check.claim,
        check.source,
        _number(check.expected),
        _number(check.computed),
        f"{difference} abs" if check.absolute else difference,
        "" if check.tolerance is None else _trimmed(_power(check.tolerance, 2)),
        check.verdict,
    )


def as_json(found: Mapping[str, Section]) -> str:
    """Return all checks as one JSON list, one check per line; non-finite numbers are null."""
    objects = (_as_object(name, section, check) for name, section in found.items() for check in section.checks)
    return "[\n" + ",\n".join(f"  {json.dumps(entry, allow_nan=False)}" for entry in objects) + "\n]"


def as_markdown(found: Mapping[str, Section], command: str) -> str:
    """Return the page.

    Parameters
    ----------
    found : mapping of str to Section
        The sections in reading order, by name.
    command : str
        The command that makes the page.
    """
    blocks = [_OPENING.format(command=command, version=__version__), _overview(found)]
    figure = 0
    for section in found.values():
        blocks += [f"## {section.title}\n", f"{section.text.strip()}\n"]
        for figure, picture in enumerate(section.pictures, start=figure + 1):  # noqa: B020  (counts through the page)
            blocks.append(f"![{picture.name}]({picture.name}.svg)\n\nFigure {figure}. {picture.caption}\n")
        if section.checks:
            blocks.append(_table(COLUMNS, map(row, section.checks), numbers=COLUMNS[2:6]))
    return "\n".join(blocks)


def write_page(directory: str | Path, found: Mapping[str, Section], command: str) -> tuple[Path, ...]:
    """Write page, figures (SVG and PNG) and checks (JSON) into a directory; see `nonhertz.io.folder.write_files`.

    ``found`` has the sections in reading order, by name; ``command`` is the command that makes the page.
    """

    def draw(folder: Path) -> None:
        for section in found.values():
            for picture in section.pictures:
                _save(picture, folder)

    return write_files(directory, {PAGE: as_markdown(found, command), CHECKS: as_json(found) + "\n"}, draw)


def _save(picture: Picture, folder: Path) -> None:
    from matplotlib.figure import Figure

    from nonhertz.plot import save
    from nonhertz.plot.sheets import WIDTH
    from nonhertz.plot.style import sheet_style

    with sheet_style():
        figure = Figure(figsize=(WIDTH, picture.height), layout="constrained")
        picture.draw(figure)
        save(figure, folder / picture.name)


def _as_object(name: str, section: Section, check: Check) -> dict[str, Any]:
    return {
        "section": name,
        "title": section.title,
        "claim": check.claim,
        "source": check.source,
        "expected": plain(check.expected),
        "computed": plain(check.computed),
        "difference": plain(check.difference),
        "tolerance": plain(check.tolerance),
        "unit": check.unit,
        "absolute": check.absolute,
        "verdict": check.verdict,
    }


def _overview(found: Mapping[str, Section]) -> str:
    def counted(title: str, some: Mapping[str, Section]) -> tuple[str, ...]:
        count = tally(some)
        return title, *map(str, (count.total(), count["pass"], count["FAIL"], count["shown"]))

    rows = [counted(section.title, {name: section}) for name, section in found.items()]
    if len(rows) > 1:
        rows.append(counted("all", found))
    head = ("section", "checks", "passed", "failed", "shown")
    return _table(head, rows, numbers=head[1:])


def _table(head: tuple[str, ...], rows: Iterable[Iterable[str]], numbers: tuple[str, ...]) -> str:
    rule = ("---:" if name in numbers else "---" for name in head)
    lines = [head, rule, *([_escaped(cell) for cell in cells] for cells in rows)]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


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


def _trimmed(power: str) -> str:
    return re.sub(r"\.?0+(?=e)", "", power)


def _short_exponent(text: str) -> str:
    return re.sub(r"e([+-])0*(\d)", lambda found: f"e{found[1].strip('+')}{found[2]}", text)
