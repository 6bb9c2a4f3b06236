"""Bearing files: from TOML to a bearing and what loads it.

All mistakes in a file are found at once and raised together, in the wording of the Python classes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonhertz.bearing.assessed import LifeConditions
from nonhertz.bearing.bearings import Paired, RollerBearing
from nonhertz.bearing.clearance import Mounting
from nonhertz.bearing.prescribed import BearingLoad
from nonhertz.bearing.spectrum import LoadCase
from nonhertz.bearing.verb import BearingSolver
from nonhertz.errors import CaseError, InputError
from nonhertz.inputs.checks import one_line, one_of, whole
from nonhertz.inputs.files import legible
from nonhertz.io.casefile import OF_BEARINGS, Case, as_toml, case_text, parsed, starting_text, write_document
from nonhertz.io.changes import changed
from nonhertz.io.title_block import TitleBlock

if TYPE_CHECKING:
    from nonhertz.bearing.assessed import BearingLife
    from nonhertz.bearing.clearance import OperatingClearance
    from nonhertz.bearing.solution import BearingSolution
    from nonhertz.io.origin import Origin

_SECTIONS: dict[str, tuple[str, ...]] = {
    "fit": tuple(Mounting.descriptions),
    "load": tuple(BearingLoad.descriptions),
    "solver": tuple(BearingSolver.descriptions),
    # In a file the speed beside a viscosity is that of the load.
    "life": (*LifeConditions.descriptions, "speed"),
}


@dataclass(frozen=True)
class BearingCase:
    """A bearing, what loads it, how that is solved, and how its life is assessed.

    Attributes
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    prescribed : dict
        Forces or displacements, moment or tilt, and speed: keywords for `nonhertz.bearing.solve`.
    solver : dict
        Method and number of slices: keywords for `nonhertz.bearing.solve`; strips where left out.
    life : dict
        Viscosity, contamination, reliability and so on: keywords for `nonhertz.bearing.assess`.
    spectrum : tuple of LoadCase
        The loads under which life is assessed, in place of what is prescribed; empty if there are none.
    title : str
        What the bearing is called; the file's name if the file has none.
    path : Path
        The file it was read from; other file names are relative to it.
    fit : dict
        Seats and temperatures: keywords for `nonhertz.bearing.operating_clearance` but for the speed, which is that of
        ``prescribed``. The clearance of ``bearing`` is then the one before it is mounted.
    title_block : TitleBlock
        What the head of a report says beside the title.
    origin : Origin or None
        What the file held; None for a case made in Python, and for a changed copy made with ``dataclasses.replace``.

    Raises
    ------
    InputError
        If a part is of the wrong kind.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder, "nu206.toml")
    ...     _ = path.write_text(starting_bearing())
    ...     case = read_bearing(path)
    >>> case.bearing.rollers, case.prescribed["radial"]
    (13, 10000.0)
    >>> case.solve().load[0].round(-1)
    array([3810., 3810.])
    """

    bearing: RollerBearing | Paired
    prescribed: dict[str, Any] = field(default_factory=dict)
    solver: dict[str, Any] = field(default_factory=dict)
    life: dict[str, Any] = field(default_factory=dict)
    title: str = ""
    path: Path = field(default=Path("bearing.toml"), compare=False)
    spectrum: tuple[LoadCase, ...] = ()
    fit: dict[str, Any] = field(default_factory=dict)
    title_block: TitleBlock = field(default_factory=TitleBlock)
    # No argument, so that a changed copy does not carry the text of the case it was made from.
    origin: Origin | None = field(default=None, init=False, compare=False, repr=False)

    def __post_init__(self) -> None:
        if not isinstance(self.bearing, RollerBearing | Paired):
            remedy = "make one, such as nonhertz.bearing.CylindricalRollerBearing"
            raise InputError("bearing", self.bearing, "be a bearing", remedy)
        for name, value, kind in (
            ("title", self.title, str),
            ("path", self.path, Path),
            ("title_block", self.title_block, TitleBlock),
        ):
            if not isinstance(value, kind):
                raise InputError(name, value, f"be a {kind.__name__}", "make the case with one")
        if not (isinstance(self.spectrum, tuple) and all(isinstance(each, LoadCase) for each in self.spectrum)):
            remedy = "make them with nonhertz.bearing.LoadCase, and leave the tuple empty for one load"
            raise InputError("spectrum", self.spectrum, "be a tuple of load cases", remedy)
        one_line("title", self.title, "give a short name")
        for name, given, section in (
            ("prescribed", self.prescribed, "load"),
            ("solver", self.solver, "solver"),
            ("life", self.life, "life"),
            ("fit", self.fit, "fit"),
        ):
            known = _SECTIONS[section]
            if not isinstance(given, dict) or not set(given) <= set(known):
                raise InputError(name, given, f"be a dictionary of {', '.join(known)}", "give no other names")
        if self.fit and not {"shaft", "housing"} <= set(self.fit):
            remedy = "make them with nonhertz.bearing.Shaft and Housing"
            raise InputError("fit", self.fit, "hold shaft and housing", remedy)

    @property
    def file_name(self) -> str:
        """The name of its file, without the directory."""
        return legible(self.path.name)

    @property
    def document(self) -> dict[str, Any]:
        """What its file holds, or would hold.

        Raises
        ------
        InputError
            If no bearing file can hold it; see `write`.
        """
        from nonhertz.io.bearing_document import document

        return document(self) if self.origin is None else self.origin.document

    @property
    def text(self) -> str:
        """The text of its file, or what `write` would write.

        Raises
        ------
        InputError
            If no bearing file can hold it; see `write`.
        """
        text = None if self.origin is None else self.origin.text
        return as_toml(self.document) if text is None else text

    @property
    def notes(self) -> tuple[str, ...]:
        """Warnings raised when its file was read, such as gaps in a measured profile."""
        return () if self.origin is None else self.origin.notes

    @property
    def attachments(self) -> Mapping[str, bytes]:
        """Contents of the files that its file names, by name; missing and too large ones are left out."""
        return {} if self.origin is None else self.origin.attachments

    @property
    def operating_clearance(self) -> OperatingClearance | None:
        """What fits, temperatures and speed leave of the clearance of a row, and what each takes; None without fits.

        Raises
        ------
        CaseError
            If such a bearing has no fits, or a seat does not fit its rings.
        """
        if not self.fit:
            return None
        try:
            return Mounting(**self.fit).operating(self.bearing.rows[0].bearing, self._inner_speed)
        except InputError as error:
            raise placed(error, "fit") from None

    @property
    def mounted(self) -> RollerBearing | Paired:
        """The bearing with the clearance that it is solved with.

        Raises
        ------
        CaseError
            As `nonhertz.bearing.operating_clearance` does, or if what is left is no clearance that a bearing can have.
        """
        if not self.fit:
            return self.bearing
        try:
            return Mounting(**self.fit).mounted(self.bearing, self._inner_speed)
        except InputError as error:
            raise placed(error, "fit") from None

    @property
    def _turning(self) -> str:
        return str(self.life.get("turning", "inner"))

    @property
    def _inner_speed(self) -> float:
        """The speed at which the inner ring and the shaft widen [1/min]."""
        return float(self.prescribed.get("speed") or 0.0) if self._turning == "inner" else 0.0

    def solve(self, method: str | None = None) -> BearingSolution:
        """Return the loaded bearing, as `nonhertz.bearing.solve` does.

        Parameters
        ----------
        method : {"strips", "slices"}, optional
            In place of that of the file.

        Raises
        ------
        CaseError
            If the bearing or its loads are refused; the sentence names the key in the file.
        ConvergenceError
            If no balance is found.
        """
        from nonhertz.bearing.verb import solve

        chosen: dict[str, Any] = {} if method is None else {"method": method}
        bearing = self.mounted
        try:
            return solve(bearing, **self.prescribed, turning=self._turning, **self.solver | chosen)
        except InputError as error:
            raise placed(error) from None

    def assess(self, solution: BearingSolution) -> BearingLife:
        """Return how long the bearing lasts, as `nonhertz.bearing.assess` does, under the spectrum if there is one.

        Raises
        ------
        CaseError
            If something that the file says about life is refused; the sentence names its key.
        ConvergenceError
            If no balance is found under a load of the spectrum.
        InputError
            If such a bearing has no rating.
        """
        from nonhertz.bearing.assessed import assess
        from nonhertz.bearing.spectrum import solve_spectrum

        try:
            if not self.spectrum:
                return assess(solution, **self.life)
            speeds = {"speed": [case.speed for case in self.spectrum]} if "viscosity" in self.life else {}
            pairs = solve_spectrum(self.mounted, self.spectrum, turning=self._turning, **self.solver)
            return assess(pairs, **self.life | speeds)
        except InputError as error:
            if error.field in {*_SECTIONS["life"], "viscosity_ratio"}:
                raise placed(error, "life") from None
            raise

    def contact_case(self, solution: BearingSolution, roller: int, ring: str = "inner") -> Case:
        """Return the contact of a roller with a ring as a case of its own, with the load and tilt that it has there.

        Its bodies are those of the bearing, cut along their common generator, with y along the roller. What else acts
        on the roller, such as ribs, speed, raceways that are not round and the other ring, is in load and tilt. Solved,
        it is `BearingSolution.contact`.

        Parameters
        ----------
        solution : BearingSolution
            This bearing, solved by strips or by slices, whose load and tilt are then those of slices.
        roller : int
            Its number, from 0.
        ring : {"inner", "outer"}
            Which ring; of thrust bearings the washer of the shaft or of the housing.

        Raises
        ------
        InputError
            If there is no such contact, or it bears no load.

        Examples
        --------
        >>> import tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     path = Path(folder, "nu206.toml")
        ...     _ = path.write_text(starting_bearing())
        ...     bearing = read_bearing(path)
        >>> case = bearing.contact_case(bearing.solve("slices"), 0, "outer")
        >>> case.title, round(case.prescribed["load"], -1)
        ('NU 206, roller 0 on the outer ring, by slices', 3720.0)
        """
        from nonhertz.bearing.frames import RINGS
        from nonhertz.bearing.solution import BearingSolution

        if not isinstance(solution, BearingSolution):
            remedy = "give what BearingCase.solve returns"
            raise InputError("solution", solution, "be a solved bearing", remedy)
        roller = whole("roller", roller, 0, solution.angle.size - 1, "count from 0")
        one_of("ring", ring, RINGS, "name one of both")
        side = RINGS.index(ring)
        load, tilt = float(solution.load[roller, side]), float(solution.tilt[roller, side])
        if not load > 0.0:
            condition = f"be a roller that the {ring} ring loads"
            raise InputError("roller", roller, condition, "choose one within the load zone")
        numbers = range(len(solution.bearing.rows))
        row = next(number for number in numbers if roller < solution.rollers_of(number).stop)
        method = "" if solution.method == "strips" else f", by {solution.method}"
        return Case(
            contact=solution.bearing.rows[row].bearing.contacts[side],
            prescribed={"load": load, "tilt": tilt},
            title=f"{self.title}, roller {roller} on the {ring} ring{method}".removeprefix(", "),
            path=Path(f"{self.path.stem}-{roller}-{ring}.toml"),
            title_block=self.title_block,
        )

    def write(self, path: str | Path) -> None:
        """Write the bearing to a file that `read_bearing` reads back as the same.

        Values are in mm, N, MPa, rad and 1/min. The points of measured and tabulated profiles are written into the
        file, so it needs no other file. An existing file is overwritten.

        Raises
        ------
        InputError
            If the file cannot be written, or the bearing has something no file can hold: a profile, a diameter or
            the shape of a raceway of a user-defined class, or rows that are not two equal ones.
        """
        from nonhertz.io.bearing_document import document

        write_document(lambda: document(self), path)


def read_bearing(path: str | Path, changes: Mapping[str, Any] | None = None) -> BearingCase:
    """Return the bearing in a file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see docs/reference/bearing-file.md.
    changes : mapping of str to object, optional
        Values in place of those in the file, by dotted path, such as ``{"load.radial": "5 kN"}``; None takes a key out.
        The title names them.

    Returns
    -------
    BearingCase
        The bearing and what loads it.

    Raises
    ------
    CaseError
        With every mistake in the file, one sentence each.
    InputError
        If ``path`` is not the name of a file, or ``changes`` not a mapping.
    """
    if not isinstance(path, str | Path):
        raise InputError("path", path, "be the name of a bearing file", "give a string or a Path")
    path = Path(path)
    text = case_text(path, "bearing file", "nonhertz new --bearing")
    document = parsed(text, str(path))
    if "body" in document and "bearing" not in document:
        raise CaseError([f"{path} must hold a bearing, not a single contact: use 'nonhertz solve {path}'."])
    return bearing_in(document, path, text, changes=changes)


def bearing_in(
    document: dict[str, Any],
    path: Path,
    text: str | None = None,
    *,
    files: bool = True,
    changes: Mapping[str, Any] | None = None,
) -> BearingCase:
    """Return the bearing in a document that has already been parsed.

    Parameters
    ----------
    document : dict
        What a TOML file holds.
    path : Path
        Where it came from; the names of other files are relative to it.
    text : str, optional
        What it was parsed from.
    files : bool
        Whether it may name files; False for an untrusted document, which must not make us read any.
    changes : mapping of str to object, optional
        Values in place of those in the document, by dotted path, as of `read_bearing`.

    Raises
    ------
    CaseError
        With every mistake in the document, one sentence each.
    """
    # Imported here: they import this module.
    from nonhertz.io.bearing_document import radius_across, read_document
    from nonhertz.io.mistakes import TableError, case_error, in_order
    from nonhertz.io.origin import Origin, with_notes
    from nonhertz.io.reading import Surroundings

    if changes is not None:
        document, text = changed(document, text, changes, bearing_schema, legible(path.stem))
    folder = path.parent if files else None
    file = Surroundings(folder, radius_across(document))
    try:
        found, notes = with_notes(lambda: read_document(document, file))
    except TableError as error:
        raise case_error(in_order(error.mistakes, document)) from None
    load, life = found.load, found.life
    loads = document["life"]["spectrum"] if life.spectrum else []
    conditions = {name: value for name in LifeConditions.descriptions if (value := getattr(life, name)) is not None}
    case = BearingCase(
        title=found.title or legible(path.stem),
        bearing=found.bearing,
        prescribed={name: getattr(load, name) for name in BearingLoad.descriptions if name in document["load"]},
        solver=dict(vars(found.solver)),
        life=conditions
        | ({} if life.viscosity is None else {"speed": load.speed if "speed" in document["load"] else None}),
        fit={} if found.fit is None else {name: getattr(found.fit, name) for name in document["fit"]},
        path=path,
        spectrum=tuple(
            case if "speed" in table else replace(case, speed=load.speed)
            for case, table in zip(life.spectrum, loads, strict=True)
        ),
        title_block=found.report,
    )
    object.__setattr__(case, "origin", Origin(document, text, notes, folder))
    return case


@cache
def bearing_schema() -> Mapping[str, Any]:
    """Return the JSON schema of a bearing file, with the meaning and the unit of every key; made once, only read."""
    from nonhertz.io.bearing_document import schema

    return {"$schema": "https://json-schema.org/draft/2020-12/schema"} | schema()


#: Bearings whose files `starting_bearing` returns, by name, in words.
BEARING_TEMPLATES = {
    "cylindrical": "cylindrical roller bearing",
    "needle": "needle roller bearing",
    "tapered-pair": "pair of tapered roller bearings",
    "spherical": "spherical roller bearing",
    "thrust": "cylindrical roller thrust bearing",
}


def starting_bearing(template: str | None = None) -> str:
    """Return a commented bearing file to start from.

    Parameters
    ----------
    template : str, optional
        One of `BEARING_TEMPLATES`, each an example of a kind of bearing; one with all that a bearing file may hold if
        left out.

    Raises
    ------
    InputError
        If there is no such template.
    """
    return starting_text("starting_bearing.toml", template, BEARING_TEMPLATES, "templates/bearings")


def placed(error: InputError, *sections: str) -> CaseError:
    """Return an error of `nonhertz.bearing` as one about the bearing file, with the field named as in the file.

    An error about something that is in no file, such as the approach of a contact, comes from the loads.
    """
    from nonhertz.io.bearing_document import of_fit
    from nonhertz.io.mistakes import Mistake, case_error
    from nonhertz.io.reading import place_of

    field = error.field.partition(".")[0]
    if sections == ("fit",):
        error = of_fit(error)
    elif section := next((each for each in sections or ("load", "solver") if field in _SECTIONS[each]), ""):
        error = error.within(section)
    elif field == "viscosity_ratio":
        error = InputError("life.viscosity", error.value, error.condition, error.remedy)
    elif field not in OF_BEARINGS:
        if not any(field in kind.descriptions for kind in RollerBearing.kinds.values()) and field != "pair":
            sentence = f"load must leave every contact of the rollers within the model: {error}"
            return CaseError([sentence], ["load"])
        error = error.within("bearing")
    return case_error([Mistake(place_of(error.field), error, absent=error.value is None)])
