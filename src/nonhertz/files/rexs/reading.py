"""A bearing of a model in REXS as a bearing file."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable
from pathlib import Path
from typing import Any, Final

from nonhertz.bearing.catalogue import from_catalogue, half_cone
from nonhertz.bearing.section import RINGS
from nonhertz.errors import InputError, join_words
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.catalogue import add_comments, guessed_document
from nonhertz.files.rexs import attributes as table
from nonhertz.files.rexs.attributes import Attribute, array_of, number_of, word_of
from nonhertz.files.rexs.loading import read_loading
from nonhertz.files.rexs.model import Attributes, Model, read_model
from nonhertz.files.toml import parse
from nonhertz.inputs.files import printable_name
from nonhertz.model.materials import MATERIALS

_KIND_OF: Final = {word: kind for kind, words in table.TYPES.items() for word in words}
_NEEDED: Final = ("bearing.rollers", "bearing.pitch_diameter", "roller.diameter", "roller.length")
_NEEDED_BESIDE: Final = {
    "tapered": ("bearing.contact_angle",),
    "spherical": ("bearing.contact_angle", "bearing.profile_radius", "bearing.inner_groove", "bearing.outer_groove"),
}
_GUESSED_OF: Final = {
    "bore": ("mm", "inner_diameter"),
    "outside_diameter": ("mm", "outer_diameter"),
    "width": ("mm", "width"),
    "dynamic": ("kN", "radial_dynamic_load_rating"),
    "static": ("kN", "radial_static_load_rating"),
    "contact_angle": ("deg", "pressure_angle"),
}
_TABLES: Final = ("bearing", "roller", "inner", "outer", "fit", "lubrication", "life", "load")
_CLASSES: Final = {word: name for name, word in table.CLASS_WORDS.items()}
_HALF_CONE: Final = table.PROFILE[2].id
_STEEL, _LISTED, _OF_RATING, _USUAL_RATING = "100Cr6", 20, 0.1, 1e4


def read_rexs(path: str | Path, component: int | None = None) -> BearingCase:
    """Return a bearing in a REXS file, with its loads, oil and life.

    Parameters
    ----------
    path : str or Path
        A file of version 1.4 or later, XML or JSON. Parts other than the bearing are ignored.
    component : int, optional
        Number of the bearing; may be left out if there is only one.

    Raises
    ------
    InputError
        If the file is not REXS, has no such bearing, has several and ``component`` is left out, or lacks data.
    CaseError
        If the data do not describe a valid bearing.
    """
    text = bearing_file_of_rexs(path, component)
    return BearingCase.of(parse(text, str(path)), Path(path).with_suffix(".toml"), text, files=False)


def bearing_file_of_rexs(path: str | Path, component: int | None = None) -> str:
    """Return the text of a bearing file for a bearing in a REXS file, with comments on guessed values.

    Parameters and errors are as for `read_rexs`.
    """
    model = read_model(path)
    number = _chosen(model, component)
    bearing, name = _Bearing(model, number), printable_name(Path(path).name)
    first = f"For 'nonhertz bearing': {bearing.title or 'bearing'}, component {number} of {name}. Add what you know."
    try:
        document = bearing.document()
        text = add_comments([first, *bearing.sentences], document)
    except (ArithmeticError, AttributeError, KeyError, TypeError) as error:  # in the contents of REST
        condition = f"hold what {table.REST} of this program does ({type(error).__name__})"
        raise InputError("rexs", name, condition, "remove that attribute, or write the file anew") from None
    BearingCase.of(parse(text, str(path)), Path(path), files=False)  # raises its mistakes
    return text


def _chosen(model: Model, number: int | None) -> int:
    """Return the number of the chosen bearing."""
    known = [entry for entry in model.components if model.components[entry].type in (table.BEARING, table.CATALOGUE)]
    if not known:
        raise InputError("rexs", "no rolling bearing", "hold one", "export the model with its bearings")
    if number is None and len(known) == 1:
        return known[0]
    if number not in known:
        names = [f"{entry} ({printable_name(model.components[entry].name)})" for entry in known[:_LISTED]]
        more = [f"{len(known) - _LISTED} more"] if len(known) > _LISTED else []
        condition = f"be the number of a rolling bearing of the model: {join_words([*names, *more], 'or')}"
        raise InputError("component", number, condition, "name one of them")
    return number


class _Bearing:
    """A bearing of a model that is being read."""

    def __init__(self, model: Model, number: int) -> None:
        self.model, self.number = model, number
        self.own = model.components[number].attributes
        self.title = printable_name(model.components[number].name)
        self.sentences: list[str] = []
        word = word_of(self.own, "bearing_type")
        if word not in _KIND_OF:
            condition = "be a roller bearing of a kind that is known here: cylindrical, needle, tapered or spherical"
            raise InputError("bearing_type", word, condition, "choose another bearing of the model")
        self.kind = _KIND_OF[word]
        rows = model.parts(number, table.ROW)
        if len(rows) > 2:
            raise InputError("number_of_bearing_rows", len(rows), "be 1 or 2", "choose another bearing")
        rollers = model.parts(rows[0], table.ROLLER) if rows else []
        self.rows = [model.components[entry].attributes for entry in rows]
        self.components = {
            table.BEARING: self.own,
            table.ROW: self.rows[0] if rows else {},
            table.ROLLER: model.components[rollers[0]].attributes if rollers else {},
            table.OIL: self._part(number, table.OIL),
        }
        self.materials = {"roller": self._part(rollers[0], table.MATERIAL) if rollers else {}}
        self.materials |= dict.fromkeys(RINGS, self._part(number, table.MATERIAL))
        absorbed = [word_of(entry, "axial_force_absorption_of_row") for entry in self.rows]
        self.absorbed = absorbed if len(rows) > 1 else [word_of(self.own, "axial_force_absorption"), *absorbed]

    def _part(self, whole: int, kind: str) -> Attributes:
        number = next(iter(self.model.parts(whole, kind)), None)
        return {} if number is None else self.model.components[number].attributes

    def document(self) -> dict[str, Any]:
        """Return the document of the bearing file."""
        document = self._rest()
        for name in _TABLES:
            document.setdefault(name, {})
        self._exchange(document)
        keys = (*_NEEDED, *_NEEDED_BESIDE.get(self.kind, ()))
        absent = [key for key in keys if key.partition(".")[2] not in document[key.partition(".")[0]]]
        document["title"] = document.get("title") or self.title
        if absent:
            self._guess(document, absent)
        else:
            self._complete(document)
        self._oil(document["lubrication"])
        self._put_loads(document)
        return {name: entry for name, entry in document.items() if entry or name == "load"}

    def _exchange(self, document: dict[str, Any]) -> None:
        """Put in the values of attributes."""
        for entry in table.EXCHANGED:
            if self.kind in entry.kinds and entry.component in (table.BEARING, table.ROW, table.ROLLER):
                self._put(document, entry)
        if self.kind == "tapered" and len(self.rows) == 1:
            clearance = number_of(self.own, "mum", "operating_axial_bearing_clearance") or 0.0
            document["bearing"].setdefault("clearance", clearance)
        self._put_classes(document)

    def _put_classes(self, document: dict[str, Any]) -> None:
        operating = ("operating_radial_bearing_clearance", "operating_axial_bearing_clearance")
        mounted = any(number_of(self.own, "mum", name) for name in operating)
        for entry in table.CLASSES:
            *tables, name = entry.key.split(".")
            word = word_of(self.own, entry.id)
            # An operating clearance already includes the effect of seats.
            if word and self.kind in entry.kinds and not (mounted and "fit" in tables):
                _place(document, tables).setdefault(name, _CLASSES.get(word, word))

    def _complete(self, document: dict[str, Any]) -> None:
        """Put in kind, arrangement, raceways, profile and materials of a bearing with known rollers."""
        document["bearing"]["kind"] = self.kind
        self._arrange(document["bearing"])
        if self.kind != "thrust":
            self._raceways(document)
        if "profile" not in document["roller"] and self.kind != "spherical":
            document["roller"]["profile"] = self._profile(document["roller"]["length"])
        self._make_of(document)
        for seat, size in (("shaft", "bore"), ("housing", "outside_diameter")):
            # One seat alone is not enough, nor is one without a ring on it.
            if seat not in document["fit"] or not (size in document["bearing"] or "diameter" in document["fit"][seat]):
                document["fit"] = {}

    def _rest(self) -> dict[str, Any]:
        text = self.own.get(table.REST, ("{}", ""))[0]
        try:
            document = json.loads(text)
            if not all(isinstance(entry, dict) or name == "title" for name, entry in document.items()):
                raise TypeError
        except (ValueError, TypeError, AttributeError, RecursionError):
            raise InputError(table.REST, str(text)[:40], "hold tables as JSON", "remove it, or write it anew") from None
        return dict(document)

    def _put(self, document: dict[str, Any], entry: Attribute) -> None:
        """Put an attribute in the place of its key."""
        *tables, name = entry.key.split(".")
        value = entry.number(self.components.get(entry.component, {}))
        # Other programs write zero for unknown numbers, except for clearances.
        if value is None or (value == 0.0 and name != "clearance") or ("pair" in tables and len(self.rows) < 2):
            return
        place = _place(document, tables)
        if name not in place or not (entry.value or name == "clearance"):
            place[name] = int(value) if name == "rollers" else value

    def _arrange(self, bearing: dict[str, Any]) -> None:
        """Put in design and pair, by the directions in which rows support axial loads."""
        if len(self.rows) > 1:
            arranged = {
                ("negative", "positive"): "X",
                ("positive", "negative"): "O",
                ("positive", "positive"): "tandem",
            }
            usual = {"tapered": None, "spherical": "X"}.get(self.kind, "tandem")
            arrangement = arranged.get((self.absorbed[0], self.absorbed[1]), usual)
            if arrangement is None:
                condition = "be negative and positive, which is X, positive and negative, O, or twice positive"
                raise InputError("axial_force_absorption_of_row", join_words(self.absorbed), condition, "correct it")
            bearing.setdefault("pair", {})["arrangement"] = arrangement
        elif self.kind in ("cylindrical", "needle"):
            design = {"positive": "NJ", "negative": "NJ", "both_directions": "NUP"}.get(self.absorbed[0])
            if design is not None:
                bearing.setdefault("design", design)

    def _raceways(self, document: dict[str, Any]) -> None:
        """Put in cones and raceways that are not given, and remove a pitch circle that follows from them."""
        bearing, roller, inner, outer = (document[name] for name in ("bearing", "roller", *RINGS))
        pitch, across, angle = bearing["pitch_diameter"], roller["diameter"], bearing.get("contact_angle", 0.0)
        half = self._make_cone(roller, pitch, angle) if self.kind == "tapered" and isinstance(across, float) else 0.0
        if "diameter" not in inner or "diameter" not in outer:
            inner["diameter"], outer["diameter"] = _raceway_diameters(pitch, across, angle, half)
            self.sentences.append("- raceways touch the rollers on their pitch circle; corners and ribs are unknown")
            for ring, name, sign in ((inner, "bore", 1.0), (outer, "outside_diameter", -1.0)):
                depth = 0.5 * sign * (abs(ring["diameter"]) - bearing.get(name, 0.0)) if name in bearing else 0.0
                if depth > 0.0:
                    ring.setdefault("depth", depth)
                else:  # needles may run on the shaft itself
                    bearing.pop(name, None)
        if math.isclose(pitch, 0.5 * (inner["diameter"] - outer["diameter"]), rel_tol=1e-9):
            del bearing["pitch_diameter"]

    def _make_cone(self, roller: dict[str, Any], pitch: float, angle: float) -> float:
        """Make the rollers cones, and return the half cone angle [rad]."""
        across, length = roller["diameter"], roller["length"]
        half = number_of(self.components[table.ROLLER], "deg", _HALF_CONE)
        if half is None:
            half = half_cone(across / pitch, angle)
            self.sentences.append("- rollers and raceways are cones that meet in one point")
        ends = [across + sign * length * math.tan(half) for sign in (1.0, -1.0)]
        roller["diameter"] = {"y": [-0.5 * length, 0.5 * length], "diameter": ends}
        return half

    def _profile(self, length: float) -> list[dict[str, Any]]:
        roller = self.components[table.ROLLER]
        y, relief = (array_of(roller, entry.unit, entry.id) for entry in table.PROFILE[:2])
        if len(y) == len(relief) > 1:
            return [{"kind": "tabulated", **_extend(y, relief, 0.5 * length)}]
        if radius := number_of(roller, "mm", "roller_crowning_radius"):
            return [{"kind": "crown", "radius": radius}]
        self.sentences.append("- profile of the rollers: the reference profile of ISO 16281; put yours in its place")
        return [{"kind": {"tapered": "iso-tapered", "thrust": "iso-thrust"}.get(self.kind, "iso-logarithmic")}]

    def _make_of(self, document: dict[str, Any]) -> None:
        for body, attributes in self.materials.items():
            modulus, poisson = (
                number_of(attributes, "MPa", "elastic_modulus"),
                number_of(attributes, "none", "poisson_ratio"),
            )
            word = word_of(attributes, "material_designation")
            material: Any = word if word in MATERIALS else _STEEL
            if word not in MATERIALS and modulus and poisson is not None:
                material = {"modulus": modulus, "poisson": poisson}
            document[body].setdefault("material", material)

    def _guess(self, document: dict[str, Any], absent: list[str]) -> None:
        """Put in an internal geometry estimated from catalogue data, or refuse."""
        catalogue = self._catalogue()
        unknown = [attribute for name, (_, attribute) in _GUESSED_OF.items() if name not in catalogue]
        able = self.kind not in ("spherical", "thrust") and len(self.rows) < 2
        if unknown or not able:
            names = [entry.id for entry in table.EXCHANGED if entry.key in absent and "custom" not in entry.id]
            rather = f", or {join_words(unknown)} for an estimate" if able else ""
            condition = f"have the internal geometry of the bearing, but {join_words(names)} are missing{rather}"
            raise InputError("component", self.number, condition, "export it with detailed geometry")
        guess = from_catalogue(**catalogue, kind=self.kind)
        self.sentences += [f"- {sentence}" for sentence in guess.sentences]
        guessed = guessed_document(guess)
        document |= {name: guessed[name] for name in ("bearing", "roller", *RINGS)}

    def _catalogue(self) -> dict[str, Any]:
        """Return the catalogue data for an estimate, with an angle of 0 if none is needed."""
        attributes = {**self.own, **self.components[table.ROW]}
        numbers = {name: number_of(attributes, *entry) for name, entry in _GUESSED_OF.items()}
        catalogue: dict[str, Any] = {name: number for name, number in numbers.items() if number}
        if self.kind != "tapered":
            return catalogue | {"contact_angle": None}
        if "contact_angle" not in catalogue and (ratio := number_of(attributes, "none", "catalogue_value_e")):
            catalogue["contact_angle"] = math.atan(ratio / 1.5)
        return catalogue

    def _oil(self, oil: dict[str, Any]) -> None:
        """Put in the oil, or remove what needs one."""
        attributes = self.components[table.OIL]
        if "viscosity" not in oil and "temperature" in oil:
            oil |= _oil_of(attributes)
        if word_of(attributes, "kind") == "grease":
            oil["grease"] = True
        if not oil.keys() & {"viscosity", "viscosities", "oil"}:
            for entry in ("temperature", "contamination", "grease"):
                oil.pop(entry, None)
        elif "viscosity" in oil and table.REST not in self.own:
            oil.pop("temperature", None)

    def _put_loads(self, document: dict[str, Any]) -> None:
        # Here rows support axial loads along +x.
        loading = read_loading(self.model, self.number, self.absorbed[:1] == ["negative"] and len(self.rows) < 2)
        load = document["load"]
        load |= loading.load
        self.sentences += loading.sentences
        if loading.turning:
            document["life"]["turning"] = loading.turning
        if loading.spectrum:
            document["life"]["spectrum"] = loading.spectrum
        if not loading.load.keys() - {"speed"}:
            self._put_example(document, load)

    def _put_example(self, document: dict[str, Any], load: dict[str, Any]) -> None:
        self.sentences.append("- the file has no loads of this bearing: put yours in place of the example")
        usual = _OF_RATING * document["life"].get("dynamic", _USUAL_RATING)
        load["axial" if self.kind == "thrust" else "radial"] = usual
        if self.kind == "tapered":
            load["axial"] = 2.0 * math.tan(document["bearing"]["contact_angle"]) * usual


def _oil_of(attributes: Attributes) -> dict[str, Any]:
    pair = [number_of(attributes, "mm^2 / s", f"viscosity_at_{at}_degree_celsius") for at in (40, 100)]
    name = word_of(attributes, "name").replace("-", " ")
    if all(pair):
        return {"viscosities": pair}
    return {"oil": name} if name.startswith("ISO VG") else {}


def _place(document: dict[str, Any], tables: Iterable[str]) -> dict[str, Any]:
    """Return a table below others, made where it is missing."""
    for name in tables:
        document = document.setdefault(name, {})
    return document


def _raceway_diameters(pitch: float, across: float, angle: float, half_cone_angle: float) -> tuple[float, float]:
    """Return diameters of raceways that touch rollers on the pitch circle, of tapered ones with a common apex."""
    if not half_cone_angle:
        gap = across / math.cos(angle)
        return pitch - gap, -(pitch + gap)
    axis = math.tan(angle - half_cone_angle)
    return pitch * math.tan(angle - 2.0 * half_cone_angle) / axis, -pitch * math.tan(angle) / axis


def _extend(y: list[float], relief: list[float], end: float) -> dict[str, list[float]]:
    """Return a profile that reaches both ends of a roller, straight on from its last places."""
    first, last = (
        relief[k] + (relief[k] - relief[j]) / (y[k] - y[j]) * (place - y[k])
        for k, j, place in ((0, 1, -end), (-1, -2, end))
    )
    inside = [(place, drop) for place, drop in zip(y, relief, strict=True) if abs(place) < end]
    return {"y": [-end, *(place for place, _ in inside), end], "relief": [first, *(drop for _, drop in inside), last]}
