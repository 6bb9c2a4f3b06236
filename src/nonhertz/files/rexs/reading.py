"""A bearing of a model in REXS as a bearing file."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any, Final

from nonhertz.bearing.catalogue import from_catalogue, half_cone
from nonhertz.bearing.section import RINGS
from nonhertz.errors import InputError, joined
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.catalogue import commented, guessed_document
from nonhertz.files.documents import parsed
from nonhertz.files.rexs import attributes as table
from nonhertz.files.rexs.attributes import Attribute
from nonhertz.files.rexs.model import Attributes, Model, read_model
from nonhertz.files.rexs.writing import PAIRS
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
    "limiting_ratio": ("none", "catalogue_value_e"),
}
_STEEL, _LISTED, _OF_RATING, _USUAL_RATING = "100Cr6", 20, 0.1, 1e4


def read_rexs(path: str | Path, component: int | None = None) -> BearingCase:
    """Return a bearing of a file in REXS, with what it says of loads, oil and life.

    Parameters
    ----------
    path : str or Path
        A file of version 1.4 or later, XML or JSON. What it holds beside the bearing is left alone.
    component : int, optional
        Number of the bearing; may be left out where there is one.

    Raises
    ------
    InputError
        If the file is no REXS, or holds no such bearing, several without a number, or not what a bearing needs.
    CaseError
        If what it says of the bearing makes none.
    """
    text = bearing_file_of_rexs(path, component)
    return BearingCase.of(parsed(text, str(path)), Path(path).with_suffix(".toml"), text, files=False)


def bearing_file_of_rexs(path: str | Path, component: int | None = None) -> str:
    """Return the text of a bearing file for a bearing of a file in REXS, with what is guessed as comments.

    Parameters and errors are those of `read_rexs`.
    """
    model = read_model(path)
    number = _chosen(model, component)
    bearing, name = _Bearing(model, number), printable_name(Path(path).name)
    first = f"For 'nonhertz bearing': {bearing.title or 'bearing'}, component {number} of {name}. Add what you know."
    try:
        document = bearing.document()
        text = commented([first, *bearing.sentences], document)
    except (ArithmeticError, AttributeError, KeyError, TypeError) as error:  # of what REST holds
        condition = f"hold what {table.REST} of this program does ({type(error).__name__})"
        raise InputError("rexs", name, condition, "remove that attribute, or write the file anew") from None
    BearingCase.of(parsed(text, str(path)), Path(path), files=False)  # raises what is wrong with it
    return text


def _chosen(model: Model, number: int | None) -> int:
    """Return the number of the bearing that is meant."""
    known = [entry for entry in model.components if model.components[entry].type in (table.BEARING, table.CATALOGUE)]
    if not known:
        raise InputError("rexs", "no rolling bearing", "hold one", "export the model with its bearings")
    if number is None and len(known) == 1:
        return known[0]
    if number not in known:
        names = [f"{entry} ({printable_name(model.components[entry].name)})" for entry in known[:_LISTED]]
        more = [f"{len(known) - _LISTED} more"] if len(known) > _LISTED else []
        condition = f"be the number of a rolling bearing of the model: {joined([*names, *more], 'or')}"
        raise InputError("component", number, condition, "name one of them")
    return number


class _Bearing:
    """A bearing of a model that is being read."""

    def __init__(self, model: Model, number: int) -> None:
        self.model, self.number = model, number
        self.own = model.components[number].attributes
        self.title = printable_name(model.components[number].name)
        self.sentences: list[str] = []
        word = _word(self.own, "bearing_type")
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
        absorbed = [_word(entry, "axial_force_absorption_of_row") for entry in self.rows]
        self.absorbed = absorbed if len(rows) > 1 else [_word(self.own, "axial_force_absorption"), *absorbed]

    def _part(self, whole: int, kind: str) -> Attributes:
        number = next(iter(self.model.parts(whole, kind)), None)
        return {} if number is None else self.model.components[number].attributes

    def value(self, entry: Attribute, among: Attributes | None = None) -> float | None:
        """Return an attribute in units of the bearing file; None if it is not there."""
        number = _number(self.components.get(entry.component, {}) if among is None else among, entry.unit, *entry.ids)
        return None if number is None else entry.sign * number

    def document(self) -> dict[str, Any]:
        """Return what the bearing file holds."""
        document = self._rest()
        for name in ("bearing", "roller", "inner", "outer", "lubrication", "life", "load"):
            document.setdefault(name, {})
        for entry in table.EXCHANGED:
            if self.kind in entry.kinds and entry.component in (table.BEARING, table.ROW, table.ROLLER):
                self._put(document, entry)
        self._clearance(document["bearing"])
        keys = (*_NEEDED, *_NEEDED_BESIDE.get(self.kind, ()))
        absent = [key for key in keys if key.partition(".")[2] not in document[key.partition(".")[0]]]
        document["title"] = document.get("title") or self.title
        if absent:
            self._guess(document, absent)
        else:
            document["bearing"]["kind"] = self.kind
            self._arrange(document["bearing"])
            if self.kind != "thrust":
                self._raceways(document)
            if table.REST not in self.own and self.kind != "spherical":
                document["roller"]["profile"] = self._profile()
            self._make_of(document)
        self._oil(document["lubrication"])
        self._load(document)
        return {name: entry for name, entry in document.items() if entry or name == "load"}

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
        if "pair" in tables and len(self.rows) < 2:
            return
        place, value = document, self.value(entry)
        # Zero is what others write for unknown numbers, but for clearances.
        if value is None or (value == 0.0 and name != "clearance"):
            return
        for step in tables:
            place = place.setdefault(step, {})
        if name not in place or not (entry.value or name == "clearance"):
            place[name] = int(value) if name == "rollers" else value

    def _clearance(self, bearing: dict[str, Any]) -> None:
        group = _word(self.own, "radial_clearance_class")
        if "clearance" in bearing or self.kind == "thrust":
            return
        if self.kind == "tapered" and len(self.rows) == 1:
            bearing["clearance"] = _number(self.own, "mum", "operating_axial_bearing_clearance") or 0.0
        elif group and self.kind != "tapered":
            bearing["clearance"] = group.replace("C0", "CN")

    def _arrange(self, bearing: dict[str, Any]) -> None:
        """Put in design and pair, by the directions in which rows bear axial loads."""
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
                raise InputError("axial_force_absorption_of_row", joined(self.absorbed), condition, "correct it")
            bearing.setdefault("pair", {})["arrangement"] = arrangement
        elif self.kind in ("cylindrical", "needle"):
            design = {"positive": "NJ", "negative": "NJ", "both_directions": "NUP"}.get(self.absorbed[0])
            if design is not None:
                bearing.setdefault("design", design)

    def _raceways(self, document: dict[str, Any]) -> None:
        """Put in cones and raceways that are not given, and take out a pitch circle that goes without saying."""
        bearing, roller, inner, outer = (document[name] for name in ("bearing", "roller", *RINGS))
        pitch, angle = bearing["pitch_diameter"], bearing.get("contact_angle", 0.0)
        if "diameter" not in inner or "diameter" not in outer:
            across, length = roller["diameter"], roller["length"]
            if self.kind == "tapered":
                half = half_cone(across / pitch, angle)
                raceways = [pitch * math.tan(entry) / math.tan(angle - half) for entry in (angle - 2.0 * half, angle)]
                ends = [across + sign * length * math.tan(half) for sign in (1.0, -1.0)]
                roller["diameter"] = {"y": [-0.5 * length, 0.5 * length], "diameter": ends}
                self.sentences.append("- rollers and raceways are cones that meet in one point")
            else:
                raceways = [pitch + sign * across / math.cos(angle) for sign in (-1.0, 1.0)]
            self.sentences.append("- raceways touch the rollers on their pitch circle; corners and ribs are not known")
            inner["diameter"], outer["diameter"] = raceways[0], -raceways[1]
            for ring, name, sign in ((inner, "bore", 1.0), (outer, "outside_diameter", -1.0)):
                depth = 0.5 * sign * (abs(ring["diameter"]) - bearing.get(name, 0.0)) if name in bearing else 0.0
                if depth > 0.0:
                    ring.setdefault("depth", depth)
                else:  # needles may run on the shaft itself
                    bearing.pop(name, None)
        if math.isclose(pitch, 0.5 * (inner["diameter"] - outer["diameter"]), rel_tol=1e-9):
            del bearing["pitch_diameter"]

    def _profile(self) -> list[dict[str, Any]]:
        radius = _number(self.components[table.ROLLER], "mm", "roller_crowning_radius")
        if radius:
            return [{"kind": "crown", "radius": radius}]
        self.sentences.append("- profile of the rollers: the reference profile of ISO 16281; put yours in its place")
        return [{"kind": {"tapered": "iso-tapered", "thrust": "iso-thrust"}.get(self.kind, "iso-logarithmic")}]

    def _make_of(self, document: dict[str, Any]) -> None:
        for body, attributes in self.materials.items():
            modulus, poisson = (
                _number(attributes, "MPa", "elastic_modulus"),
                _number(attributes, "none", "poisson_ratio"),
            )
            word = _word(attributes, "material_designation")
            material: Any = word if word in MATERIALS else _STEEL
            if word not in MATERIALS and modulus and poisson is not None:
                material = {"modulus": modulus, "poisson": poisson}
            document[body].setdefault("material", material)

    def _guess(self, document: dict[str, Any], absent: list[str]) -> None:
        """Put in an inside that is guessed from catalogue numbers; refuse where that cannot be."""
        tapered = self.kind == "tapered"
        catalogue = {
            name: value
            for name, (unit, attribute) in _GUESSED_OF.items()
            if (value := _number({**self.own, **self.components[table.ROW]}, unit, attribute))
            and (tapered or name not in ("contact_angle", "limiting_ratio"))
        }
        if "contact_angle" in catalogue:
            catalogue.pop("limiting_ratio", None)
        unknown = [_GUESSED_OF[name][1] for name in [*_GUESSED_OF][: 6 if tapered else 5] if name not in catalogue]
        if "limiting_ratio" in catalogue:
            unknown.remove("pressure_angle")
        if unknown or self.kind in ("spherical", "thrust") or len(self.rows) > 1:
            names = [entry.id for entry in table.EXCHANGED if entry.key in absent and "custom" not in entry.id]
            able = self.kind not in ("spherical", "thrust") and len(self.rows) < 2
            rather = f", or {joined(unknown)} for a guess" if able else ""
            condition = f"have the inside of the bearing, of which {joined(names)} are missing{rather}"
            raise InputError("component", self.number, condition, "export it with detailed geometry")
        guess = from_catalogue(**catalogue, kind=self.kind)
        self.sentences += [f"- {sentence}" for sentence in guess.sentences]
        guessed = guessed_document(guess)
        document |= {name: guessed[name] for name in ("bearing", "roller", *RINGS)}

    def _oil(self, oil: dict[str, Any]) -> None:
        """Put in the oil, and take out what needs one if there is none."""
        attributes = self.components[table.OIL]
        pair = [_number(attributes, "mm^2 / s", f"viscosity_at_{at}_degree_celsius") for at in (40, 100)]
        name = _word(attributes, "name").replace("-", " ")
        if "viscosity" not in oil and "temperature" in oil:
            if all(pair):
                oil["viscosities"] = pair
            elif name.startswith("ISO VG"):
                oil["oil"] = name
        if _word(attributes, "kind") == "grease":
            oil["grease"] = True
        if not oil.keys() & {"viscosity", "viscosities", "oil"}:
            for entry in ("temperature", "contamination", "grease"):
                oil.pop(entry, None)
        elif "viscosity" in oil and table.REST not in self.own:
            oil.pop("temperature", None)

    def _load(self, document: dict[str, Any]) -> None:
        """Put in the loads of the first load case that has any of this bearing."""
        cases = [case[self.number] for case in self.model.load_cases if self.number in case]
        states = [entry for entry in (*cases, self.own) if self._state(entry)]
        state, load = (states or [{}])[0], document["load"]
        load |= self._state(state)
        if len(cases) > 1 and states:
            self.sentences.append(f"- loads are those of the first of {len(cases)} load cases; the others are left out")
        inner, outer = (self.value(entry, {**self.own, **state}) or 0.0 for entry in table.SPEEDS)
        if inner or outer:
            load["speed"] = abs(inner or outer)
            if not inner:
                document["life"]["turning"] = "outer"
            elif outer:
                self.sentences.append("- both rings turn; here the outer one is at rest")
        if not states:
            self.sentences.append("- the file has no loads of this bearing: put yours in place of the example")
            usual = _OF_RATING * document["life"].get("dynamic", _USUAL_RATING)
            load["axial" if self.kind == "thrust" else "radial"] = usual
            if self.kind == "tapered":
                load["axial"] = 2.0 * math.tan(document["bearing"]["contact_angle"]) * usual

    def _state(self, state: Attributes) -> dict[str, Any]:
        """Return loads and motions of a load case as a bearing file has them; empty if there are none."""
        values: dict[str, Any] = {}
        for entry in (*table.LOADS, *table.REACTIONS):
            value = self.value(entry, state)
            name, _, place = entry.key.removeprefix("load.").partition(".")
            if value is not None:
                values.setdefault(name, {}).setdefault(int(place or 0), value)
        pairs = {name: [entry.get(0, 0.0), entry.get(1, 0.0)] for name, entry in values.items()}
        if table.PRESCRIBED in state:
            pairs = {name: pairs[name] for name in _word(state, table.PRESCRIBED).split() if name in pairs}
        else:
            # Forces, or displacements where there are none, and the tilt, or the moment where there is none.
            order = (("radial", "radial_displacement"), ("axial", "axial_displacement"), ("tilt", "moment"))
            names = [next((name for name in entry if any(pairs.get(name, ()))), "") for entry in order]
            pairs = {name: pairs[name] for name in names if name}
        if self.absorbed[:1] == ["negative"] and len(self.rows) < 2:
            # Rows bear axial loads along +x here: by half a turn about v.
            pairs = {name: [a, -b] if name in PAIRS else [-a, b] for name, (a, b) in pairs.items()}
        return {
            name: pair[0] if name not in PAIRS else pair if pair[1 - PAIRS[name]] else pair[PAIRS[name]]
            for name, pair in pairs.items()
        }


def _word(attributes: Attributes, name: str) -> str:
    return str(attributes.get(name, ("", ""))[0] or "")


def _number(attributes: Attributes, unit: str, *names: str) -> float | None:
    """Return the first attribute of these names in units of the bearing file; None where it is not there, or empty."""
    name = next((entry for entry in names if entry in attributes), "")
    value, stated = attributes.get(name, (None, ""))
    if value is None or value == "":
        return None
    # A number that states no unit is in that of REXS.
    size = table.UNITS.get(unit if stated in ("", "none") else stated)
    if size is None:
        raise InputError(f"the unit of {name}", stated, f"be {unit}", "correct it in the file")
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError):
        number = math.nan
    if not math.isfinite(number):
        raise InputError(name, str(value)[:40], "be a number", "correct it in the file")
    return size * number
