"""The slider range of each quantity, and the initial value of a key that is added.

The ranges of loads, displacements, relief and corners follow from the geometry and end where no sensible case lies
beyond: loads at a pressure that hardened steel just withstands, tilts where a roller lifts off. They do not depend on
the value of the quantity itself, so that they do not move while it is dragged.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Final, Literal

from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.pairs import Paired
from nonhertz.bearing.prescribed import BearingLoad, one_state
from nonhertz.errors import AccuracyWarning, InputError
from nonhertz.files.bearing_document import BearingFile, read_document
from nonhertz.files.keys import Table, table_of
from nonhertz.files.profiles import profile_tables
from nonhertz.files.reading import read_input
from nonhertz.files.sections import Bodies, read_context
from nonhertz.files.toml import OF_BEARINGS
from nonhertz.hertz import half_space_line_compression, line_contact
from nonhertz.inputs.units import to_unit
from nonhertz.model.body import Body
from nonhertz.model.contact import Contact

MOST_PRESSURE: Final = 3500.0
"""MPa; ISO 76 takes 4000 as the limit of a roller at rest."""
_USUAL: Final = 0.3  # of the largest load: some 1900 MPa
_AXIAL: Final = 0.25  # of the radial load, which ribs can support
_DECADES: Final = 1e-3  # of the largest load, down to which a slider goes
_RELIEFS: Final = ("amplitude", "drop", "zm")
_MOST_DROP: Final = 0.01  # of the length: more than a contact reaches
_WITHIN: Final = 0.48  # of the length: some profiles have no end at the end of the body
_TIGHT, _LOOSE = 1e-3, 3e-3  # of the pitch diameter: beyond the clearance groups in catalogues
_FASTEST: Final = 1e6  # mm/min, pitch diameter times speed: beyond that of oil-lubricated rolling bearings
_FITTING: Final = ("roller.diameter", "inner.diameter", "outer.diameter", "bearing.pitch_diameter")
_STOPS: Final = (1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0)
_NOTICEABLE: Final = 0.1  # of the length of a body: the range of shifts of a profile
_HALVES: Final = (1.0, 2.0, 2.5, 5.0, 10.0)  # of ranges around zero; a thousandth of the whole is round as well


@dataclass(frozen=True)
class Range:
    """Range of a slider.

    Attributes
    ----------
    low, high : float
        Its ends, in the unit of the quantity.
    scale : str
        ``"linear"`` or ``"log"``; the latter has ends of one sign.
    start : float
        Initial value of a key when it is added.
    """

    low: float
    high: float
    scale: str
    start: float


LENGTH: Final = Range(0.5, 500.0, "log", 20.0)
DIAMETER: Final = Range(1.0, 2000.0, "log", 20.0)
STRENGTH: Final = Range(10.0, 5000.0, "log", 1500.0)
TEMPERATURE: Final = Range(-40.0, 200.0, "linear", 20.0)
#: By key, which denotes the same quantity throughout a file, or by the last two keys; the radius of a profile for a
#: design load is the one across the contact. The ranges of a known geometry replace these.
RANGES: Final[dict[str, Range]] = {
    **dict.fromkeys(("core_yield_strength", "yield_strength"), STRENGTH),
    **dict.fromkeys(("inner_temperature", "outer_temperature", "roller_temperature", "temperature"), TEMPERATURE),
    **dict.fromkeys(
        ("diameter", "inner_groove", "outer_groove", "outside_diameter", "pitch_diameter", "profile_radius"), DIAMETER
    ),
    **dict.fromkeys(("depth", "distance", "length", "middle", "width"), LENGTH),
    "across.radius": Range(0.5, 1000.0, "log", 10.0),
    "amplitude": Range(1e-4, 0.1, "log", 0.005),
    "angle": Range(1e-4, 1.0, "log", 0.001),
    "approach": Range(1e-4, 1.0, "log", 0.02),
    "blend_radius": Range(0.0, 20.0, "linear", 1.0),
    "case_depth": Range(0.05, 20.0, "log", 1.0),
    "centre": Range(-20.0, 20.0, "linear", 0.0),
    "compliance": Range(1e-7, 1e-4, "log", 2.8e-6),
    "bore": Range(0.5, 500.0, "log", 8.0),
    "contact_angle": Range(0.01, 1.0, "log", 0.25),
    "contamination": Range(0.0, 1.0, "linear", 0.5),
    "dent.depth": Range(1e-4, 0.1, "log", 0.003),
    "dent.diameter": Range(0.01, 2.0, "log", 0.2),
    "drop": Range(1e-4, 1.0, "log", 0.02),
    "end_radius": Range(1.0, 1e5, "log", 200.0),
    "fatigue_limit": Range(0.0, 1000.0, "linear", 360.0),
    "fraction": Range(0.5, 0.99999, "linear", 0.9999),
    "height": Range(0.1, 100.0, "log", 4.0),
    "k1": Range(0.1, 10.0, "log", 1.0),
    "k2": Range(0.1, 1.0, "linear", 1.0),
    "load": Range(10.0, 1e6, "log", 20000.0),
    "modulus": Range(1e3, 1e6, "log", 207000.0),
    "moment": Range(-1e5, 1e5, "linear", 0.0),
    "phase": Range(-math.pi, math.pi, "linear", 0.0),
    "poisson": Range(0.0, 0.5, "linear", 0.3),
    "position": Range(-20.0, 20.0, "linear", 0.0),
    "pressure_limit": Range(10.0, 10000.0, "log", 4000.0),
    "radius": Range(10.0, 1e6, "log", 4000.0),
    "reliability": Range(0.9, 0.9995, "linear", 0.9),
    "scale": Range(0.0, 3.0, "linear", 1.0),
    "share": Range(0.0, 1.0, "linear", 1.0),
    "shift": Range(-10.0, 10.0, "linear", 0.0),
    "slope": Range(0.2, 5.0, "linear", 1.125),
    "straight": Range(0.0, 100.0, "linear", 10.0),
    "tilt": Range(-0.005, 0.005, "linear", 0.0),
    "viscosity": Range(1.0, 1000.0, "log", 20.0),
    "width": Range(0.01, 10.0, "log", 0.5),
    "zm": Range(1e-4, 1.0, "log", 0.01),
}
# Initial values of lists, which have no sliders.
ENDS: Final[dict[str, list[float]]] = {
    "y": [-10.0, 0.0, 10.0],
    "relief": [0.01, 0.0, 0.01],
    "diameter": [20.0, 20.0, 20.0],
    "angle": [0.0, 1.5, 3.0, 4.5],
    "deviation": [0.005, -0.005, 0.005, -0.005],
}


def form_state(document: dict[str, Any], file: Literal["case", "bearing"]) -> dict[str, Any]:
    """Return the parts of a form that depend on the geometry of its document, as JSON.

    Parameters
    ----------
    document : dict
        A case, or a bearing, valid or not.
    file : {"case", "bearing"}
        The kind of document.

    Returns
    -------
    dict
        ``"ranges"``: by key, the range of its slider, null if it has none; ``"bodies"``: by path of a body, its own
        ``"ranges"``, its default ``"depth"``, and the ``"sizes"`` of its profile by key.
    """
    names = ("a", "b") if file == "case" else OF_BEARINGS[1:]
    within = document.get("body") if file == "case" else document
    tables = table_of(Bodies if file == "case" else BearingFile).keys
    with warnings.catch_warnings():  # the answer to the document has them
        warnings.simplefilter("ignore", AccuracyWarning)
        bodies = {
            f"body.{name}" if file == "case" else name: _body_state(within[name], tables[name].tables[0])
            for name in names
            if isinstance(within, dict) and isinstance(within.get(name), dict)
        }
        return {"ranges": _as_json(ranges_of(document, file)), "bodies": bodies}


def _as_json(ranges: Mapping[str, Range | None]) -> dict[str, Any]:
    return {name: one and asdict(one) for name, one in ranges.items()}


def _body_state(body: dict[str, Any], table: Table) -> dict[str, Any]:
    table = table.of_kind(body.get("kind"))
    fixed: dict[str, Range | None] = {} if _can_be_moved(body, table) else {"shift": None}
    ranges = _as_json(of_body(body) | fixed)
    return {"ranges": ranges, "depth": _usual_depth(body, table), "sizes": _sizes(body, table)}


def ranges_of(document: dict[str, Any], file: str) -> Mapping[str, Range | None]:
    """Return the ranges of the sliders of a document, by key: those of its geometry if it has no mistakes."""
    try:
        if file == "case":
            bodies = read_input(Bodies, document.get("body"), read_context(document, None))
            return RANGES | _of_contact(Contact(bodies.a, bodies.b))
        parts = {name: document[name] for name in OF_BEARINGS if name in document}
        unloaded = {"radial_displacement": 0.0, "axial_displacement": 0.0}
        case = read_document(parts | {"load": unloaded}, None)
        return RANGES | _of_bearing(case.bearing)
    except InputError:
        return RANGES


def of_body(table: Mapping[str, Any]) -> dict[str, Range]:
    """Return the ranges of profile, corners and bore of a body, as far as its length and diameter are known."""
    length, diameter = (size_of(name, table.get(name)) for name in ("length", "diameter"))
    corner = Range(_DECADES * length, 0.25 * length, "log", 0.05 * length)
    of_length = {
        "at": Range(0.25 * length, _WITHIN * length, "linear", 0.45 * length),
        "effective_length": Range(0.5 * length, length, "linear", 0.9 * length),
        **dict.fromkeys(("corner_radius", "chamfer.length"), corner),
    }
    bore = {"bore": Range(0.1 * diameter, 0.9 * diameter, "linear", 0.5 * diameter)}
    return (of_length if length else {}) | (bore if diameter else {})


def size_of(name: str, value: Any) -> float:
    """Return the size of a dimension [mm]; zero if it is not a single number."""
    try:
        size = to_unit(name, value, "mm")
    except InputError:
        return 0.0
    return abs(size) if isinstance(size, float) and math.isfinite(size) else 0.0


def _read(body: dict[str, Any], table: Table) -> Body | None:
    """Return the body of a table; None if it has mistakes."""
    try:
        return read_input(Body, body, read_context({}, None), likely=table.likely)
    except InputError:
        return None


def _usual_depth(document: dict[str, Any], table: Table) -> str:
    """Return the default depth of a body in words; "" if the body has mistakes."""
    body = _read(
        {name: value for name, value in document.items() if name not in ("depth", "profile", "chamfer")}, table
    )
    return body.behind.word if body else ""


def _sizes(document: dict[str, Any], table: Table) -> dict[str, float]:
    """Return drop and parameters of a body's profile, if it has a single one that is neither shifted nor scaled."""
    body = _read(document, table) if _has_plain_profile(document) else None
    if body is None or body.profile.catalogue_entry is None:
        return {}
    end = body.land[1] - body.position
    if not math.isfinite(end):
        return {}
    drop = float(body.profile.relief(end) - body.profile.relief(0.0))
    parameters = body.profile.catalogue_entry[1]
    values = {name: value for name, value in parameters.items() if isinstance(value, float)} | {"drop": drop}
    return {name: float(f"{value:.4g}") for name, value in values.items() if math.isfinite(value) and value}


def _has_plain_profile(document: dict[str, Any]) -> bool:
    """Return whether a body has a single profile, neither shifted nor scaled."""
    tables = profile_tables(document) if isinstance(document.get("profile"), list | dict) else []
    return len(tables) == 1 and isinstance(tables[0], dict) and not {"at", "shift", "scale", "flip"} & set(tables[0])


def _can_be_moved(document: dict[str, Any], table: Table) -> bool:
    """Return whether the profiles of a body can be shifted: bounded ones between corners cannot."""
    if not {"corner_radius", "chamfer"} & set(document) or not isinstance(document.get("profile"), list | dict):
        return True
    shift = _NOTICEABLE * size_of("length", document.get("length"))
    moved = [
        profile | {"shift": shift} if isinstance(profile, dict) else profile for profile in profile_tables(document)
    ]
    return _read(document | {"profile": moved}, table) is not None


def _of_contact(contact: Contact) -> dict[str, Range]:
    """Return the ranges of a contact."""
    most, length = _most_load(contact), contact.interval[1] - contact.interval[0]
    if not 0.0 < most < math.inf:
        return {}
    ranges = {"load": _upwards(most, _USUAL)}
    if not math.isfinite(length):
        return ranges
    usual, deepest = (_compression(contact, share * most) for share in (_USUAL, 1.0))
    half = _stop(0.5 * length)
    return ranges | {
        "approach": _upwards(deepest, usual / deepest),
        "tilt": _around(2.0 * usual / length),
        "moment": _around(_USUAL * most * length / 6.0),  # this unloads one end
        **dict.fromkeys(("position", "shift", "centre"), _around(half)),
        **dict.fromkeys(_RELIEFS, _upwards(_MOST_DROP * length, 0.1)),
    }


def _of_bearing(rows: RollerBearing | Paired) -> dict[str, Range | None]:
    """Return the ranges of a bearing."""
    row = rows.rows[0].bearing
    most = min(map(_most_load, row.contacts))
    if not 0.0 < most < math.inf:
        return {}
    number, pitch, length = row.rollers * len(rows.rows), row.pitch, row.roller_length
    inclined = row.nominal_angle
    # The most loaded roller takes 5 / (number of rollers) of a radial load (ISO 76).
    radial, axial = most * number * math.cos(inclined) / 5.0, most * number * math.sin(inclined)
    usual = _compression(row.contacts[0], _USUAL * most)
    moved, loose = _around(_LOOSE * pitch), Range(0.0, _stop(_LOOSE * pitch), "linear", 0.0)
    ranges = {
        "radial": Range(0.0, _stop(radial), "linear", _stop(_USUAL * radial)),
        "axial": _around(axial if inclined else _AXIAL * radial),
        "moment": _around(0.25 * pitch * max(radial, axial)),
        "tilt": _around(2.0 * usual / length),
        **dict.fromkeys(("radial_displacement", "axial_displacement"), moved),
        "clearance": Range(-_stop(_TIGHT * pitch), loose.high, "linear", 0.0),
        "axial_clearance": loose,
        "interference": _around(_TIGHT * pitch),
        "smoothing": Range(0.0, _stop(_TIGHT * pitch), "linear", 0.0),
        **dict.fromkeys(("position", "shift", "centre"), _around(0.5 * length)),
        **_of_seat("shaft", row.inner, 0.5, 0.8, 0.95),
        **_of_seat("housing", row.outer, 1.05, 1.2, 1.6),
        "speed": Range(0.01 * _stop(_FASTEST / pitch), _stop(_FASTEST / pitch), "linear", 0.0),
        **dict.fromkeys(_RELIEFS, _upwards(_MOST_DROP * length, 0.1)),
    }
    # No sliders for loads that a bearing cannot support, and none for diameters that depend on each other.
    unborne = [name for name in ("radial", "axial", "moment") if not _bears(rows, name)]
    fitting = [] if row.inner.diameter is None else _FITTING
    return ranges | dict.fromkeys((*unborne, *fitting))


def _of_seat(name: str, ring: Body, *shares: float) -> dict[str, Range]:
    """Return the range of the diameter of a ring's seat, by its lowest, usual and highest ratio to the raceway."""
    if not isinstance(ring.diameter, float):
        return {}
    low, usual, high = (float(f"{share * abs(ring.diameter):.4g}") for share in shares)
    return {f"{name}.diameter": Range(low, high, "linear", usual)}


def _bears(rows: RollerBearing | Paired, name: str) -> bool:
    try:
        one_state(rows, BearingLoad(**{name: 1e-6}))
    except InputError:
        return False
    return True


def _most_load(contact: Contact) -> float:
    """Return the load [N] under which the pressure in the middle is `MOST_PRESSURE`.

    It is the smaller of those of a line contact and of a point contact; zero if the bodies do not meet in the middle.
    """
    low, high = contact.interval
    middle = 0.5 * (low + high) if math.isfinite(high - low) else 0.0
    curvature, compliance = float(contact.curvature(middle)), contact.compliance
    if not 0.0 < curvature < math.inf:
        return 0.0
    radius = 1.0 / curvature
    step = 0.1 * min(radius, high - low)
    before, at, after = contact.separation([middle - step, middle, middle + step])
    if not math.isfinite(before + at + after):
        return 0.0
    bend = max(float(before + after - 2.0 * at) / step**2, 1e-12)
    line = math.pi**2 * compliance * radius * MOST_PRESSURE**2 * (high - low)
    return min(line, math.pi**5 * (radius / bend) * compliance**2 * MOST_PRESSURE**3 / 6.0)


def _compression(contact: Contact, load: float) -> float:
    """Return a rough approach [mm] of bodies of finite length under a load [N]."""
    length = contact.interval[1] - contact.interval[0]
    radius = 1.0 / float(contact.curvature(sum(contact.interval) / 2.0))
    line = line_contact(line_load=load / length, radius=radius, compliance=contact.compliance)
    return half_space_line_compression(line, length=max(length, 3.0 * line.half_width))


def _upwards(most: float, usual: float) -> Range:
    """Return a logarithmic range up to a stop; it starts at the fraction ``usual`` of it."""
    high = _stop(most)
    return Range(_DECADES * high, high, "log", _stop(usual * high))


def _around(most: float) -> Range:
    """Return a range on both sides of zero."""
    high = _stop(most, _HALVES)
    return Range(-high, high, "linear", 0.0)


def _stop(value: float, stops: tuple[float, ...] = _STOPS) -> float:
    """Return the round number next to a positive one.

    Examples
    --------
    >>> _stop(67.7e3), _stop(0.031)
    (70000.0, 0.03)
    """
    power = 10.0 ** math.floor(math.log10(value))
    # Text, since 3 * 0.01 is not 0.03.
    return float(f"{min(stops, key=lambda stop: abs(stop * power - value)) * power:.3g}")
