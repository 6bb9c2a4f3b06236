"""The text export of Mahr's MarWin software: sections in brackets, the points in the one called PROFILE_VALUES.

Mahr has published no description. This reader relies on what two independent programs agree on, one that writes such
files for MarWin and one that reads them: a line is ``number=X Y Z C Lock`` with X, Y and Z in mm and decimal points,
and the section PROFILE_HEADER has the number of points in NO_POINTS. The trace runs along X, or along Y where X is
constant.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

import numpy as np

from nonhertz.files.traces.columns import read_columns
from nonhertz.files.traces.line import Line, Request

_VALUES = "[PROFILE_VALUES]"
_NUMBER = re.compile(r"\s*\d+\s*=")
_COUNT = re.compile(r"\s*NO_POINTS\s*=\s*0*(\d+)")


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
    start = next(k for k, line in enumerate(lines) if line.strip().startswith(_VALUES)) + 1
    below = takewhile(lambda line: not line.lstrip().startswith("["), lines[start:])
    # Blank lines in place of the head: messages name lines by their number.
    text = [*[""] * start, *(_NUMBER.sub("", line) for line in below)]
    base = replace(request, position_unit="mm", height_unit="mm", height_column=3)
    along = {name: read_columns(text, replace(base, position_column=k)) for k, name in ((1, "X"), (2, "Y"))}
    name = max(along, key=lambda name: float(np.ptp(along[name].y)))
    stated = [match[1] for line in lines[:start] if (match := _COUNT.match(line))][:1]
    if stated and stated != [str(len(along[name].y))]:
        condition = f"hold the {stated[0][:20]} points stated in its header (there are {len(along[name].y)})"
        raise request.error(condition, "export it again; this file is truncated")
    return along[name].noted(f"A MarWin export: positions are its {name}, heights its Z, in mm.")
