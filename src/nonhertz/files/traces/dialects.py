"""What files of text in columns state in lines ``key = value`` above the numbers: profiles of wheels and rails.

MiniProf (.ban, .whl) names its columns in ColumnDef and writes mm. Simpack (.prr, .prw) writes y and z between
point.begin and point.end, with z downwards as seen in the track: into the material of a rail (type 0), out of that of a
wheel (type 1). A metre has units.len.f of its units. Its shifts, rotations and bounds are not applied: a profile is
levelled, aligned and trimmed anyway. The source for both is the reader of an independent program, CONTACT
(github.com/eve70a/CONTACT, matlab/read_miniprof.m and read_simpack.m).

Files of heights alone: SDF (ISO 25178-71, EUNA 15178) writes its scales in metres, and PTB's .pr the length of the
profile in um. The softgauges of NPL and the text files of NIST have no header: the first number is the distance between
points, the others are heights, all in um. Sources are NPL's description of its files
(resource.npl.co.uk/softgauges/Help.htm), NIST's (physics.nist.gov/VSC), and a program of BEV that writes them all.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

_PTB = re.compile(r"^X-(?:len|Ma\w+|Ma.{1,2}) *= *([\d.]+) .*(?:points/scanline|Punkte/Zeile) *: *(\d{1,7})\b", re.M)
_SDF = re.compile(r"a[A-Z]{2,4} ?- ?[V\d]")
_UNITS = {1.0: "m", 1e2: "cm", 1e3: "mm", 1e6: "um"}


def read_dialect(head: Sequence[str]) -> tuple[Mapping[str, Any], str | None]:
    """Return what the lines above the numbers state as fields of a `Request`, and a note about it; {}, None if nothing.

    Parameters
    ----------
    head : sequence of str
        The lines, without comments.
    """
    text = "\n".join(head)
    if match := _PTB.search(text):
        step = float(match[1]) / max(int(match[2]) - 1, 1)
        return {"step": f"{step:.15g} um", "height_unit": "um"}, "A profile in the format of PTB, in um."
    pairs = [line.split("!")[0].partition("=") for line in head]
    keys = {key.strip().lower(): value.strip() for key, _, value in reversed(pairs)}  # the first of a name
    names = [name.strip().upper() for name in keys.get("columndef", "").split(",")]
    if "X" in names and "Y" in names:
        columns = {"position_column": names.index("X") + 1, "height_column": names.index("Y") + 1}
        return columns | {"position_unit": "mm", "height_unit": "mm"}, "A MiniProf profile: X and Y in mm."
    if _SDF.match(text) and {"xscale", "zscale"} <= set(keys):
        scales = {"step": _number(keys["xscale"]), "height_unit": _number(keys["zscale"])}
        stated = {key: f"{scale:.15g} m" for key, scale in scales.items() if 0.0 < scale < math.inf}
        return stated, "A profile in the format SDF, whose scales are in m."
    if "point.begin" not in keys:
        return {}, None
    unit = _UNITS.get(_number(keys.get("units.len.f", "1e3")))
    down = _number(keys.get("type", "0")) != 1.0
    drop = down != (_number(keys.get("mirror.z", "0")) == 1.0)
    fields: dict[str, Any] = {"position_column": 1, "height_column": 2, "position_unit": unit, "height_unit": unit}
    body = "rail, whose z points into the material" if down else "wheel, whose z points out of the material"
    return fields | {"sense": "drop" if drop else "height"}, f"A Simpack profile of a {body}."


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return float("nan")
