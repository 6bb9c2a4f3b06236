"""The sections of a bearing file: their contents, checks across sections, and the sections of a bearing.

The bodies of a bearing, which are fields of its class, are sections beside ``[bearing]``; a second row, equal to the
first, is a table within it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from pathlib import Path
from typing import Annotated, Any

from nonhertz.bearing.assessed import LifeConditions
from nonhertz.bearing.bearings import RollerBearing
from nonhertz.bearing.clearance import Mounting
from nonhertz.bearing.lubrication import LEAST_RATIO, reference_viscosity
from nonhertz.bearing.oil import Lubrication, OilInPlace
from nonhertz.bearing.pairs import Pair, Paired, paired
from nonhertz.bearing.parts import InnerRing, OuterRing, Rollers
from nonhertz.bearing.prescribed import BearingLoad, TurningRing, one_state
from nonhertz.bearing.spectrum import BearingLoadCase
from nonhertz.bearing.verb import BearingSolver
from nonhertz.errors import CaseError, InputError, InputsError
from nonhertz.files.bounds import FORMAT, LOADS
from nonhertz.files.mistakes import case_error, place_of
from nonhertz.files.profiles import read_profile
from nonhertz.files.reading import ReadContext, TableReader, check_table, read_input
from nonhertz.files.ring_shapes import read_shape, shape_tables
from nonhertz.files.sections import FORMAT_FIELD, combined_radius, describe_title, locate_body_error, sample_interval
from nonhertz.files.title_block import TitleBlock
from nonhertz.files.toml import OF_BEARINGS
from nonhertz.files.writing import document_of
from nonhertz.inputs.descriptions import Part, Several
from nonhertz.inputs.fields import Input, cross_check, default_of, input_class
from nonhertz.life.spectrum import at_most_whole

PARTS = ("roller", "inner", "outer")
SHAPES = ("inner_shape", "outer_shape")
OF_OIL = OilInPlace.descriptions.keys()
PAIR = "a second row, equal to the first, and its arrangement"


@input_class(kw_only=True)
class BearingLifeConditions(TurningRing, LifeConditions):
    """Conditions of the bearing's life; the speed is that of the load."""

    spectrum: Annotated[
        tuple[BearingLoadCase, ...],
        Several(
            Part(
                "loads with their shares of the revolutions, in place of [load], whose speed is their default; if the "
                "shares add up to less than 1, the bearing is unloaded for the rest",
                BearingLoadCase,
                "write each load under a heading [[life.spectrum]]",
            ),
            LOADS,
        ),
    ] = ()

    @cross_check("spectrum")
    def _check_shares(self) -> None:
        remedy = "give shares of the revolutions; for the rest the bearing is unloaded"
        at_most_whole("spectrum.share", [case.share for case in self.spectrum], remedy)


@input_class(kw_only=True)
class BearingFile(Input):
    """A bearing file."""

    format: Annotated[int, FORMAT_FIELD] = FORMAT
    title: Annotated[str, describe_title("bearing")] = ""
    # A section follows those on which it depends.
    roller: Rollers
    inner: InnerRing
    outer: OuterRing
    bearing: Annotated[
        RollerBearing | Paired,
        Part("the bearing, except its rollers and rings", object, ""),
    ]
    load: Annotated[BearingLoad, Part("loads on the inner ring, or its displacements", BearingLoad, "")]
    fit: Annotated[
        Mounting | None,
        Part(
            "fits and temperatures: `clearance` is then that before mounting, and the bearing is solved with the "
            "operating clearance; the speed is that of the load",
            Mounting,
            "",
        ),
    ] = None
    solver: Annotated[BearingSolver, Part("method of solution", BearingSolver, "")] = BearingSolver()
    lubrication: Annotated[Lubrication, Part("the oil in the bearing", Lubrication, "")] = Lubrication()
    life: Annotated[BearingLifeConditions, Part("conditions of the bearing's life", BearingLifeConditions, "")] = (
        BearingLifeConditions()
    )
    report: Annotated[TitleBlock, Part("head of a report", TitleBlock, "")] = TitleBlock()

    @cross_check("bearing")
    def _check_contacts(self) -> None:
        ring = "inner"
        try:
            for ring, contact in zip(("inner", "outer"), self.bearing.rows[0].bearing.contacts, strict=True):  # noqa: B007
                contact.curvature(sample_interval(contact.interval))
        except InputError as error:
            renamed = locate_body_error(error)
            body, _, rest = renamed.field.partition(".")
            place = f"{'roller' if body == 'a' else ring}.{rest}"
            raise InputError(place, renamed.value, renamed.condition, renamed.remedy) from None

    @cross_check("bearing", "load")
    def _check_load(self) -> None:
        try:
            one_state(self.bearing, self.load)
        except InputError as error:
            raise error.within("load") from None

    @cross_check("bearing", "load", "fit")
    def _check_fit(self) -> None:
        if self.fit is not None:
            try:
                rows = self.bearing
                self.fit.mounted(replace(rows, preload=None) if isinstance(rows, Paired) else rows, self.load.speed)
            except InputError as error:
                raise locate_fit_error(error) from None

    @cross_check("solver", "life")
    def _check_edges(self) -> None:
        if self.life.edge_stress == "pressure" and self.solver.method != "strips":
            condition, remedy = "be 'standard' or 'none' for slices", "solve by strips for pressures"
            raise InputError("life.edge_stress", "pressure", condition, remedy)

    @cross_check("bearing", "life")
    def _check_spectrum(self) -> None:
        mistakes = []
        for position, case in enumerate(self.life.spectrum, start=1):
            try:
                one_state(self.bearing, case)
            except InputError as error:
                mistakes.append(error.within(f"life.spectrum[{position}]"))
        if mistakes:
            raise InputsError(mistakes)

    @cross_check("load", "life", "lubrication")
    def _check_oil(self) -> None:
        speeds = {case.speed or self.load.speed for case in self.life.spectrum} or {self.load.speed}
        if self.lubrication.in_place.viscosity is not None and not all(speeds):
            condition, remedy = "be given with a speed above zero", "give load.speed too, in 1/min"
            raise InputError("lubrication.viscosity", self.lubrication.in_place.viscosity, condition, remedy)

    @cross_check("bearing", "load", "life", "lubrication")
    def _check_viscosity(self) -> None:
        viscosity, pitch = self.lubrication.in_place.viscosity, self.bearing.rows[0].bearing.pitch
        speeds = {case.speed or self.load.speed for case in self.life.spectrum} or {self.load.speed}
        for speed in sorted(speeds):
            least = LEAST_RATIO * reference_viscosity(speed, pitch) if speed else 0.0
            if viscosity is not None and viscosity < least:
                condition = f"be at least {least:.3g} mm^2/s at this speed, below which ISO 281 has no factor"
                raise InputError("lubrication.viscosity", viscosity, condition, "use a thicker oil, or leave it out")


def read_document(document: dict[str, Any], folder: Path | None) -> BearingFile:
    """Return the contents of a document; names of files are relative to a folder, without which none may be read.

    Raises
    ------
    InputsError
        With all mistakes.
    """
    file = ReadContext(folder, _radius_across(document), read_profile)
    bearing_file = _FileReader(BearingFile, document, file, ()).build()
    assert isinstance(bearing_file, BearingFile)
    return bearing_file


class _FileReader(TableReader):
    """A bearing file that is being read."""

    def hint(self, name: str) -> str:
        """Return the remedy for a missing section."""
        return "write it under a heading [bearing]" if name == "bearing" else super().hint(name)

    def read_value(self, name: str, written: Any) -> Any:
        """Return the value of a section."""
        if name == "life" and isinstance(written, dict):
            _refuse_oil(written)
        if name != "bearing":
            return super().read_value(name, written)
        table = check_table(written, (name,))
        mistakes: list[InputError] = []
        parts = {part: self.values.get(part) for part in PARTS}
        try:
            return _RowReader(RollerBearing, table, self.file, (name,), beside=parts, known=("pair",)).build()
        except InputsError as error:
            for mistake in error.each:
                part = place_of(mistake.field)[0]
                (self.mistakes if part in PARTS and part not in table else mistakes).append(mistake)
            raise InputsError(mistakes) from None


def _refuse_oil(life: dict[str, Any]) -> None:
    """Refuse keys of ``[lubrication]`` in ``[life]``."""
    elsewhere = [InputError(name, life[name], "be in [lubrication]", "move it there") for name in OF_OIL & life.keys()]
    if elsewhere:
        raise InputsError(sorted(elsewhere, key=lambda error: error.field))


class _RowReader(TableReader):
    """A row of rollers, or a pair of rows, that is being read."""

    pair: Pair | None = None

    def build(self) -> Any:
        """Return the row, or the pair."""
        row: Any = super().build()
        return row if self.pair is None else paired(row, **self.pair.keywords)

    def read_fields(self) -> None:
        """Read every field that is given, and the arrangement of a second row."""
        super().read_fields()
        if "pair" in self.table:
            try:
                self.pair = read_input(Pair, self.table["pair"], self.file, (*self.place, "pair"))
            except InputError as error:
                self.mistakes += error.within("pair").each

    def read_value(self, name: str, written: Any) -> Any:
        """Return the value of a field."""
        if name in SHAPES:
            return read_shape(written, self.file, (*self.place, name))
        return super().read_value(name, written)


def _radius_across(document: dict[str, Any]) -> Any:
    """Return the combined radius of roller and inner raceway [mm], the default of profiles for a design load.

    None for cones and barrels: their radii across the contact do not follow from the diameters in the file.
    """
    bearing = document.get("bearing")
    kind = bearing.get("kind") if isinstance(bearing, dict) else None
    if kind == "tapered" or kind == "spherical":  # noqa: PLR1714  (a list is in no set)
        return None
    return combined_radius(document.get("roller"), document.get("inner"))


def locate_fit_error(error: InputError) -> InputError:
    """Return an error about a fit as one about ``[fit]``."""
    if error.field == "bearing":
        condition = "be left out: fits are those of cylindrical, needle, tapered and spherical bearings"
        return InputError("fit", None, condition, "remove the table")
    return error.within("load" if error.field == "speed" else "fit")


def with_file_path(error: InputError, document: Mapping[str, Any], *sections: str) -> CaseError:
    """Return an error of `nonhertz.bearing` as one about the bearing file, with the field named as in the file.

    Errors about quantities that are not in a file, such as the approach of a contact, are due to the loads.
    """
    field = error.field.partition(".")[0]
    if sections == ("fit",):
        error = locate_fit_error(error)
    elif within := [
        section
        for section in (*sections, "lubrication", "load", "solver")
        if field in BearingFile.inputs[section].descriptions
    ]:
        error = error.within(within[0])
    elif field == "viscosity_ratio":
        error = error.about("lubrication.viscosity", error.value)
    elif field not in OF_BEARINGS:
        if not any(field in kind.descriptions for kind in RollerBearing.kinds.values()) and field != "pair":
            sentence = f"load must leave every contact of the rollers within the model: {error}"
            return CaseError([sentence], ["load"])
        error = error.within("bearing")
    return case_error([error], document)


def bearing_sections(bearing: RollerBearing | Paired) -> dict[str, Any]:
    """Return the sections of a bearing and of its parts.

    Raises
    ------
    InputError
        If it has no form as a file: a profile, diameter or raceway shape of a user-defined class, or rows other than
        one or two equal ones.
    """
    row = bearing.rows[0].bearing
    if type(row) not in RollerBearing.kinds.values():
        condition = "be of a kind that a bearing file knows"
        raise InputError("bearing", type(row).__name__, condition, "solve such a bearing in Python")
    shapes = {name: shape_tables(name, shape) for name in SHAPES if (shape := getattr(row, name)) is not None}
    table = {
        field.name: document_of(value, name=field.name)
        for field in fields(row)
        if field.name not in (*PARTS, *SHAPES) and (value := getattr(row, field.name)) != default_of(field)
    }
    word = next(word for word, kind in row.kinds.items() if kind is type(row))
    pair = {"pair": document_of(Pair.of(bearing))} if isinstance(bearing, Paired) else {}
    tables: dict[str, Any] = {"bearing": {"kind": word} | table | shapes | pair}
    for name in PARTS:
        try:
            tables[name] = document_of(getattr(row, name), name=name)
        except InputError as error:
            raise error.within(name) from None
    return tables
