"""The sliders of a bearing: its loads, tilt, clearances and profile drops, in the units that people read.

Lengths are in um, forces in kN, rotations in mrad, or in what people read in place of these. Which sliders a bearing
has, its own checks say: an axial force, say, where the bearing bears one. Ranges depend on the bearing's size and not
on the values, so that they keep still while a slider is dragged.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Final

from nonhertz.bearing.bearings import Paired, RollerBearing
from nonhertz.bearing.prescribed import BearingLoad, one_state
from nonhertz.errors import InputError
from nonhertz.inputs.units import in_unit
from nonhertz.io.bearing_document import PARTS
from nonhertz.io.bearingfile import BearingCase
from nonhertz.io.profiles import profile_tables
from nonhertz.model.body import Body
from nonhertz.model.profile import PARAMETERS
from nonhertz.model.profile.drop import determined
from nonhertz.result.numerals import given
from nonhertz.result.reading import chosen

_SHOWN: Final = {"mm": ("um", 1e-3), "N": ("kN", 1e3), "rad": ("mrad", 1e-3), "N mm": ("N m", 1e3)}
_PAIRS: Final = (("radial", "radial_displacement"), ("axial", "axial_displacement"), ("tilt", "moment"))
_UNITS: Final = {
    "radial": "N",
    "axial": "N",
    "tilt": "rad",
    "moment": "N mm",
    "radial_displacement": "mm",
    "axial_displacement": "mm",
}
_WORDS: Final = {
    "radial": "radial load",
    "axial": "axial load",
    "radial_displacement": "radial displ.",
    "axial_displacement": "axial displ.",
}
_MEANING: Final = {
    "radial": "Force on the inner ring along y, towards the first roller at the bottom of the picture.",
    "axial": "Force on the inner ring along the axis.",
    "tilt": "Rotation of the inner ring about z, against the outer ring.",
    "moment": "Moment on the inner ring about z.",
    "radial_displacement": "How far the inner ring is moved along y, in place of a force.",
    "axial_displacement": "How far the inner ring is moved along the axis, in place of a force.",
}
MOST_TILT: Final = 5.0  # mrad
LEAST_DROP: Final = 1e-4  # mm
MOST_DROP: Final = 0.01  # of the roller's length: corners begin with a gentle slope
_TIGHT, _LOOSE = -1e-3, 3e-3  # of the pitch diameter: beyond the clearance groups of catalogues
_FLAT = 44.0  # N/mm^2, of ISO 76: a static load rating is about this times Z L D
_STEPS = (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0)


@dataclass(frozen=True)
class BearingSlider:
    """A number that can be dragged or typed.

    Attributes
    ----------
    path : str
        The key in the bearing file.
    label, help : str
        What it is called, and its meaning.
    unit : str
        The unit in which it is read and typed.
    value : str
        The number in that unit.
    low, high, scale
        The slider's range in that unit, ``"linear"`` or ``"log"``.
    without : tuple of str
        Keys that do not go with this one.
    zero : bool
        Whether an empty field is a zero, as in a list, and not a key that is left out.
    """

    path: str
    label: str
    help: str
    unit: str
    value: str
    low: float
    high: float
    scale: str = "linear"
    without: tuple[str, ...] = ()
    zero: bool = False


def sliders(case: BearingCase, document: dict[str, Any]) -> list[BearingSlider]:
    """Return the sliders of a bearing.

    Parameters
    ----------
    case : BearingCase
        The bearing.
    document : dict
        What it was read from.
    """
    return [*_of_loads(case), *_of_clearances(case.bearing), *_of_drops(case, document)]


def _of_loads(case: BearingCase) -> Iterator[BearingSlider]:
    bearing = case.bearing
    for pair in _PAIRS:
        name = next((each for each in pair if each in case.prescribed), pair[0])
        value = case.prescribed.get(name)
        if value is None and not _bears(bearing, name):
            continue
        low, high = _range(bearing, name)
        words, unit = _WORDS.get(name, name), _UNITS[name]
        if not isinstance(value, tuple):
            yield _slider(f"load.{name}", words, _MEANING[name], unit, value or 0.0, low, high)
            continue
        axes = "yz"
        for place, (axis, each) in enumerate(zip(axes, value, strict=True), start=1):
            help_ = f"{'About' if name in {'tilt', 'moment'} else 'Along'} {axis}. {_MEANING[name]}"
            spread = max(abs(low), abs(high))
            yield _slider(f"load.{name}[{place}]", f"{words} {axis}", help_, unit, each, -spread, spread, zero=True)


def _bears(bearing: RollerBearing | Paired, name: str) -> bool:
    try:
        one_state(bearing, BearingLoad(**{name: 1e-6}))
    except InputError:
        return False
    return True


def _range(bearing: RollerBearing | Paired, name: str) -> tuple[float, float]:
    """Return the range of a load or a displacement, in its shown unit."""
    row = bearing.rows[0].bearing
    force = _FLAT * row.rollers * len(bearing.rows) * row.roller_length * row.roller_diameter
    match name:
        case "radial":
            return 0.0, _round(force, "N")
        case "axial":
            reach = _round(force, "N")
        case "moment":
            reach = _round(0.25 * force * row.pitch, "N mm")
        case "tilt":
            reach = MOST_TILT
        case _:
            reach = _round(_LOOSE * row.pitch, "mm")
    return -reach, reach


def _of_clearances(bearing: RollerBearing | Paired) -> Iterator[BearingSlider]:
    row = bearing.rows[0].bearing
    low, high = (math.copysign(_round(abs(share) * row.pitch, "mm"), share) for share in (_TIGHT, _LOOSE))
    clearance = getattr(row, "clearance", None)
    if clearance is not None:
        words = "Internal clearance of a row; negative is preload."
        yield _slider("bearing.clearance", "clearance", words, "mm", clearance, low, high)
    if isinstance(bearing, Paired):
        words = "Axial clearance of the pair, beside that of the rows; negative is preload."
        yield _slider("bearing.pair.clearance", "pair's clearance", words, "mm", bearing.clearance, low, high)


def _of_drops(case: BearingCase, document: dict[str, Any]) -> Iterator[BearingSlider]:
    row = case.bearing.rows[0].bearing
    least, most = _round(LEAST_DROP, "mm"), _round(MOST_DROP * row.roller_length, "mm")
    for part in PARTS:
        body, tables = getattr(row, part), profile_tables(document[part])
        single = isinstance(document[part].get("profile"), dict)
        for number, table in enumerate(tables, start=1):
            drop = _drop(table, body, alone=len(tables) == 1)
            if drop is None or not drop > 0.0:
                continue
            place = f"{part}.profile" if single else f"{part}.profile[{number}]"
            several = f" {number}" if len(tables) > 1 else ""
            free = [] if "drop" in table else _freed(table)
            words = (
                f"How much more relief the {table['kind']} profile of the {part}{'' if part == 'roller' else ' ring'} "
                "has at the end of its land than in the middle."
            )
            yield _slider(
                f"{place}.drop", f"drop, {part}{several}", words, "mm", drop, least, most,
                figures=6 if "drop" in table else 4, scale="log", without=tuple(f"{place}.{name}" for name in free),
            )  # fmt: skip


def _drop(table: dict[str, Any], body: Body, *, alone: bool) -> float | None:
    """Return the drop of a profile [mm]; None if it is not known, or no drop can be given."""
    if table.get("kind") not in PARAMETERS or table["kind"] == "straight":
        return None
    if "drop" in table:
        stated = in_unit("drop", table["drop"], "mm")
        return stated if isinstance(stated, float) else None
    ends = body.effective_length if body.effective_length is not None else body.length
    if not alone or "shift" in table or "flip" in table or ends is None:
        return None
    taken = body.corner_radius or (0.0 if body.chamfer is None else body.chamfer.length)
    middle, end = (float(body.profile.relief(place)) for place in (0.0, 0.5 * ends - taken))
    return end - middle if math.isfinite(end - middle) else None


def _freed(table: dict[str, Any]) -> list[str]:
    """Return the keys of a profile that a drop takes the place of."""
    kind = table["kind"]
    names = PARAMETERS[kind].by_drop
    stated = [name for name in names if name in table]
    if names and determined(kind, set(table)) is not None:
        stated = []  # something is free without taking anything away
    return [*stated[:1], *(["scale"] if "scale" in table else [])]


def _slider(
    path: str, label: str, help_: str, unit: str, value: float, low: float, high: float, figures: int = 6, **more: Any
) -> BearingSlider:
    word, size = shown(unit)
    return BearingSlider(path, label, help_, word, given(float(value) / size, figures), low, high, **more)


def shown(unit: str) -> tuple[str, float]:
    """Return the unit in which a quantity is read and typed, and its size in that of the quantity."""
    word, size = _SHOWN[unit]
    read, factor = chosen().of(word)
    return read, size / factor


def _round(quantity: float, unit: str) -> float:
    """Return the next round number above a positive quantity, in the unit in which it is read.

    Examples
    --------
    >>> _round(51.5e3, "N"), _round(0.7e-3, "mm")
    (60.0, 0.8)
    """
    value = quantity / shown(unit)[1]
    if not 0.0 < value < math.inf:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    return float(next((step * power for step in _STEPS if step * power >= value), 10.0 * power))
