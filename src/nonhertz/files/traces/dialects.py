"""What files of text in columns state in lines ``key = value`` above the numbers: profiles of wheels and rails.

MiniProf (.ban, .whl) names its columns in ColumnDef and writes mm. Simpack (.prr, .prw) writes y and z between
point.begin and point.end, with z downwards as seen in the track: into the material of a rail (type 0), out of that of a
wheel (type 1). A metre has units.len.f of its units. Its shifts, rotations and bounds are not applied: a profile is
levelled, aligned and trimmed anyway. The source for both is the reader of an independent program, CONTACT
(github.com/eve70a/CONTACT, matlab/read_miniprof.m and read_simpack.m).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

_UNITS = {1.0: "m", 1e2: "cm", 1e3: "mm", 1e6: "um"}


def stated_by(head: Sequence[str]) -> tuple[Mapping[str, Any], str | None]:
    """Return what the lines above the numbers state as fields of a `Request`, and a note about it; {}, None if nothing.

    Parameters
    ----------
    head : sequence of str
        The lines, without comments.
    """
    pairs = [line.split("!")[0].partition("=") for line in head]
    keys = {key.strip().lower(): value.strip() for key, _, value in reversed(pairs)}  # the first of a name
    names = [name.strip().upper() for name in keys.get("columndef", "").split(",")]
    if "X" in names and "Y" in names:
        columns = {"position_column": names.index("X") + 1, "height_column": names.index("Y") + 1}
        return columns | {"position_unit": "mm", "height_unit": "mm"}, "A MiniProf profile: X and Y in mm."
    if "point.begin" not in keys:
        return {}, None
    unit = _UNITS.get(_number(keys.get("units.len.f", "1e3")))
    down = _number(keys.get("type", "0")) != 1.0
    drop = down != (_number(keys.get("mirror.z", "0")) == 1.0)
    found = {"position_column": 1, "height_column": 2, "position_unit": unit, "height_unit": unit}
    body = "rail, whose z points into the material" if down else "wheel, whose z points out of the material"
    return found | {"sense": "drop" if drop else "height"}, f"A Simpack profile of a {body}."


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return float("nan")
