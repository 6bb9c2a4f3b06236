"""The text export of Mahr's MarWin software: sections in brackets, the points in the one called PROFILE_VALUES.

Mahr has published no description. This reader relies on what two independent programs agree on, one that writes such
files for MarWin and one that reads them: a line is ``number=X Y Z C Lock`` with X, Y and Z in mm and decimal points,
and the section PROFILE_HEADER has the number of points in NO_POINTS. The trace runs along X, or along Y where X is
constant.
"""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from nonhertz.io.traces.line import Line, Request
from nonhertz.io.traces.text import value_in

_VALUES = "[PROFILE_VALUES]"
_POINT = re.compile(r"\s*\d+\s*=\s*(.*)")
_COUNT = re.compile(r"\s*NO_POINTS\s*=\s*(\d+)")


def is_marwin(lines: Sequence[str]) -> bool:
    """Return whether a text has the section of points."""
    return any(line.strip().startswith(_VALUES) for line in lines)


def read_marwin(lines: Sequence[str], request: Request) -> Line:
    """Return the measured line in a text export of MarWin.

    Raises
    ------
    InputError
        If a line is not a point, or the number of points is not that in the file's header.
    """
    request.refuse_choices("a MarWin export")
    start = next(k for k, line in enumerate(lines) if line.strip().startswith(_VALUES))
    rows = []
    for number, line in enumerate(lines[start + 1 :], start=start + 2):
        if line.strip().startswith("["):
            break
        if not line.strip() or line.strip().startswith("//"):
            continue
        rows.append(_point(line, number, request))
    counts = [found[1].lstrip("0") for line in lines[:start] if (found := _COUNT.match(line))]
    if counts and str(len(rows)) != (counts[0] or "0"):
        condition = f"hold the {counts[0][:20] or 0} points stated in its header (there are {len(rows)})"
        raise request.refuse(condition, "export it again; this file is truncated")
    if not rows:
        raise request.refuse("hold points below [PROFILE_VALUES]", "export the profile again")
    x, y, z = np.array(rows).T
    along = "Y" if np.ptp(y) > np.ptp(x) else "X"
    return Line(y if along == "Y" else x, z, (f"A MarWin export: positions are its {along}, heights its Z, in mm.",))


def _point(line: str, number: int, request: Request) -> list[float]:
    found = _POINT.fullmatch(line)
    cells = found[1].split()[:3] if found else []
    values = [value_in(cell) for cell in cells]
    if len(values) < 3 or None in values:
        condition = f"hold a point X Y Z in line {number} (there is {line.strip()[:40]!r})"
        raise request.refuse(condition, "export the profile again")
    return [value for value in values if value is not None]
