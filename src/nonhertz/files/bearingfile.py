"""Bearing files: from TOML to a bearing and its loads.

All mistakes in a file are found at once and raised together, in the wording of the Python classes.
"""

from __future__ import annotations

import contextlib
import tomllib
from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from nonhertz.bearing.assessed import LifeConditions
from nonhertz.bearing.bearings import CylindricalThrustBearing, RollerBearing
from nonhertz.bearing.clearance import Mounting, clearance_ranges
from nonhertz.bearing.lubrication import reference_viscosity
from nonhertz.bearing.oil import Lubrication
from nonhertz.bearing.pairs import Paired, parts_of
from nonhertz.bearing.prescribed import BearingLoad
from nonhertz.bearing.ratings import Rating, rating
from nonhertz.bearing.spectrum import BearingLoadCase
from nonhertz.bearing.verb import BearingSolver
from nonhertz.errors import InputError, NonhertzError, without_accuracy_warnings
from nonhertz.files.bearing_document import (
    BearingFile,
    BearingLifeConditions,
    bearing_sections,
    read_document,
    with_file_path,
)
from nonhertz.files.casefile import Case
from nonhertz.files.document import CaseBase
from nonhertz.files.starting import starting_bearing
from nonhertz.files.writing import document_of
from nonhertz.inputs.checks import one_of, whole
from nonhertz.inputs.fields import Input
from nonhertz.model.prescription import Prescription

if TYPE_CHECKING:
    from nonhertz.bearing.assessed import BearingLife
    from nonhertz.bearing.film import Films
    from nonhertz.bearing.friction import Friction
    from nonhertz.bearing.kinematics import Kinematics
    from nonhertz.bearing.limits import Limit
    from nonhertz.bearing.operating import OperatingClearance
    from nonhertz.bearing.solution import BearingSolution
    from nonhertz.bearing.toleranced import Numbers, Tolerances
    from nonhertz.verdict import Verdict


_OF_SPEED = ("speed", "viscosity_ratio")


def _check_loaded(solution: BearingSolution, life: BearingLife | None = None) -> None:
    """Refuse arguments that are not a loaded bearing and its life."""
    from nonhertz.bearing.assessed import BearingLife
    from nonhertz.bearing.solution import BearingSolution

    if not isinstance(solution, BearingSolution):
        raise InputError("solution", solution, "be a solved bearing", "give the result of BearingCase.solve")
    if not isinstance(life, BearingLife | None):
        raise InputError("life", life, "be a life", "give the result of BearingCase.assess, or leave it out")


@dataclass(frozen=True, repr=False)
class BearingCase(CaseBase):
    """A bearing, its loads, the method of solution, and the conditions of its life.

    Attributes
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    prescribed : BearingLoad
        Forces or displacements, moment or tilt, and speed; a dictionary of its keywords is accepted too, as for the
        next three.
    solver : BearingSolver
        Method and number of slices; strips by default.
    life : BearingLifeConditions
        Reliability, ratings and so on, and a load spectrum that replaces ``prescribed``.
    fit : Mounting or None
        Seats and temperatures; the speed is that of ``prescribed``. The clearance of ``bearing`` is then that before
        mounting.
    lubrication : Lubrication
        Viscosity and cleanliness of the oil.
    title, path, title_block, origin
        As of `CaseBase`.

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
    >>> case.bearing.rollers, case.prescribed.radial
    (13, 10000.0)
    >>> case.solve().load[0].round(-1)
    array([3810., 3820.])
    """

    bearing: RollerBearing | Paired
    prescribed: BearingLoad = field(default_factory=BearingLoad)
    solver: BearingSolver = field(default_factory=BearingSolver)
    life: BearingLifeConditions = field(default_factory=BearingLifeConditions)
    path: Path = field(default=Path("bearing.toml"), compare=False, kw_only=True)
    fit: Mounting | None = field(default=None, kw_only=True)
    lubrication: Lubrication = field(default_factory=Lubrication, kw_only=True)

    contents: ClassVar = BearingFile
    kind: ClassVar = "bearing"

    @staticmethod
    def contents_of(document: dict[str, Any], folder: Path | None) -> BearingFile:
        """Return the contents of a document."""
        return read_document(document, folder)

    def sections(self) -> dict[str, Any]:
        """Return the sections of its file."""
        parts = {"load": self.prescribed, "fit": self.fit, "report": self.title_block}
        tables = document_of(parts, defaults=False) | document_of(
            {"solver": self.solver, "lubrication": self.lubrication, "life": self.life}
        )
        return bearing_sections(self.bearing) | {
            name: table for name, table in tables.items() if table or name == "load"
        }

    @property
    def parts(self) -> dict[str, Input]:
        """The inputs with defaults that are reported as assumptions, by their places in the file."""
        seats = (
            {} if self.fit is None else {"fit": self.fit, "fit.shaft": self.fit.shaft, "fit.housing": self.fit.housing}
        )
        try:
            _ = rating(self.bearing)
        except InputError:  # there is no life, and so no assumption on it
            return parts_of(self.bearing) | seats
        return parts_of(self.bearing) | seats | {"lubrication": self.lubrication, "life": self.life}

    @property
    def spectrum(self) -> tuple[BearingLoadCase, ...]:
        """The loads of the life, with their speeds, which replace the prescribed one; empty without a spectrum."""
        speed = self.prescribed.speed
        return tuple(case if case.speed else replace(case, speed=speed) for case in self.life.spectrum)

    @property
    def operating_clearance(self) -> OperatingClearance | None:
        """The operating clearance of a row, and its reduction by fits, temperatures and speed; None without fits.

        Raises
        ------
        CaseError
            If such a bearing has no fits, or a seat does not fit its rings.
        """
        if self.fit is None:
            return None
        with self._name_keys("fit"):
            return self.fit.operating(self.bearing.rows[0].bearing, self._inner_speed)

    @cached_property
    def mounted(self) -> RollerBearing | Paired:
        """The bearing with its operating clearance.

        Raises
        ------
        CaseError
            As by `nonhertz.bearing.Mounting.operating`, or if the operating clearance is out of range.
        ConvergenceError
            If the rows are not in equilibrium under their preload.
        """
        from nonhertz.bearing.verb import adjust_preload

        if self.fit is None:
            return adjust_preload(self.bearing, **self.solver.keywords)
        with self._name_keys("fit"):
            return self.fit.mounted(self.bearing, self._inner_speed, method=self.solver.method)

    @property
    def kinematics(self) -> Kinematics | None:
        """Speeds of cage and rollers, and over-rolling frequencies; None without a speed."""
        speed = self.prescribed.speed
        return self.bearing.rows[0].bearing.kinematics(**{f"{self.life.turning}_speed": speed}) if speed else None

    def films(self, solution: BearingSolution) -> Films | None:
        """Return the oil films in the loaded bearing; None without a speed or an oil."""
        from nonhertz.bearing.film import films

        _check_loaded(solution)
        oil = self.lubrication
        if not solution.speed or oil.dynamic_viscosity is None:
            return None
        return films(solution, lubrication=oil, laminae=self.solver.laminae)

    def friction(self, solution: BearingSolution) -> Friction | None:
        """Return torque and power loss of the loaded bearing; None if oil, speed, series or sizes are unknown."""
        from nonhertz.bearing.friction import friction

        _check_loaded(solution)
        rating, viscosity = self._rating, self.lubrication.in_place.viscosity
        if rating is None or viscosity is None or not solution.speed:
            return None
        return friction(solution, viscosity=viscosity, static=rating.static, grease=self.lubrication.grease)

    @property
    def thermal_speed(self) -> float | None:
        """The thermal speed rating of ISO 15312 [1/min]; None if series or sizes are unknown."""
        from nonhertz.bearing.friction import reference_speed

        return None if self._rating is None else reference_speed(self.bearing, self._rating.static)

    def limits(self, solution: BearingSolution) -> tuple[Limit, ...]:
        """Return the comparison of the loaded bearing with limits that manufacturers publish."""
        from nonhertz.bearing.limits import limits

        _check_loaded(solution)
        oil, speed, pitch = self.lubrication, solution.speed, self.bearing.rows[0].bearing.pitch
        ratio = oil.in_place.viscosity / reference_viscosity(speed, pitch) if oil.in_place.viscosity and speed else None
        return limits(
            solution, rating=self._rating, clearance=self.operating_clearance, grease=oil.grease, viscosity_ratio=ratio
        )

    def verdict(self, solution: BearingSolution, life: BearingLife | None = None) -> Verdict | None:
        """Return the verdict on the loaded bearing; with a life under a spectrum the worst of all its loads too."""
        from nonhertz.verdict import judge_bearing, worst_verdict

        _check_loaded(solution, life)
        states = {"": solution}
        if life is not None:
            states |= {f"under load {k} of the spectrum": state for k, (state, _) in enumerate(self._states, start=1)}
        return worst_verdict(
            {
                where: judge_bearing(state, life, self.operating_clearance, self.films(state), self.limits(state))
                for where, state in states.items()
            }
        )

    @cached_property
    def _states(self) -> tuple[tuple[BearingSolution, float], ...]:
        """The bearing under the loads of its spectrum, with their shares."""
        from nonhertz.bearing.spectrum import solve_spectrum

        if not self.spectrum:
            return ()
        return solve_spectrum(self.mounted, self.spectrum, turning=self.life.turning, **self.solver.keywords)

    @property
    def _rating(self) -> Rating | None:
        """The load ratings; None if such a bearing has none."""
        try:
            return rating(self.bearing, dynamic=self.life.dynamic, static=self.life.static)
        except InputError:
            return None

    @contextlib.contextmanager
    def _name_keys(self, *sections: str, fields: Container[str] | None = None) -> Iterator[None]:
        """Name keys of the file in errors raised within, or only those in ``fields`` if they are given."""
        try:
            yield
        except InputError as error:
            if fields is not None and error.field not in fields:
                raise
            raise with_file_path(error, self.document, *sections) from None

    @property
    def _inner_speed(self) -> float:
        """The speed that expands inner ring and shaft [1/min]."""
        return self.prescribed.speed if self.life.turning == "inner" else 0.0

    def at(self, clearance: str = "likely") -> BearingCase:
        """Return the case with numbers in place of classes, and so without tolerances.

        Parameters
        ----------
        clearance : {"least", "likely", "greatest"}
            Its clearance within the limits of the classes.

        Raises
        ------
        CaseError
            As `operating_clearance`.
        """
        if self.fit is None:
            return replace(self, bearing=self.bearing.at(clearance))
        with self._name_keys("fit"):
            fit, _ = self.fit.at(self.bearing.rows[0].bearing, clearance)
        return replace(self, bearing=self.bearing.at(clearance), fit=fit)

    def tolerances(self, solution: BearingSolution, life: BearingLife | None = None) -> Tolerances | None:
        """Return the limits by its classes, and their effect on pressure and life; None without classes.

        Parameters
        ----------
        solution : BearingSolution
            The result of `solve`, at the likely clearance. The bearing is solved here at the least and the greatest.
        life : BearingLife or None
            The life of the solution, if there is one.

        Raises
        ------
        CaseError
            As `operating_clearance`.
        """
        from nonhertz.bearing.toleranced import Tolerances, numbers_of

        _check_loaded(solution, life)
        with self._name_keys("fit"):
            ranges = clearance_ranges(self.fit, self.bearing.rows[0].bearing, self._inner_speed)
        if ranges.known:
            return None
        if solution.method not in self.at_limits:
            ends = (self.at(end)._attempt(solution.method) for end in ("least", "greatest"))
            self.at_limits[solution.method] = [numbers_of(*attempt) for attempt in ends]
        least, greatest = self.at_limits[solution.method]
        return Tolerances.of(ranges, least, numbers_of(solution, life), greatest)

    @cached_property
    def at_limits(self) -> dict[str, list[Numbers]]:
        """Numbers at the least and the greatest clearance that have been computed so far, by method."""
        return {}

    def _attempt(self, method: str) -> tuple[BearingSolution | None, BearingLife | None]:
        """Return the loaded bearing and its life; None for what cannot be computed."""
        with without_accuracy_warnings():
            try:
                solution = self.solve(method)
                return solution, self.rated(solution)[0]
            except NonhertzError:
                return None, None

    def solve(self, method: str | None = None) -> BearingSolution:
        """Return the loaded bearing; see `nonhertz.bearing.solve`.

        Parameters
        ----------
        method : {"strips", "slices"}, optional
            Method that replaces the one in the file.

        Raises
        ------
        CaseError
            If the bearing or its loads are refused; the sentence names the key in the file.
        ConvergenceError
            If no equilibrium is found.
        """
        from nonhertz.bearing.verb import solve

        solver = self.solver.keywords | ({} if method is None else {"method": method})
        with self._name_keys():
            return solve(self.mounted, **self.prescribed.keywords, turning=self.life.turning, **solver)

    def assess(self, solution: BearingSolution) -> BearingLife:
        """Return the life of the bearing, under the spectrum if there is one; see `nonhertz.bearing.assess`.

        Raises
        ------
        CaseError
            If an input of the life is refused; the sentence names its key.
        ConvergenceError
            If no equilibrium is found under a load of the spectrum.
        InputError
            If such a bearing has no rating.
        """
        from nonhertz.bearing.assessed import assess

        with self._name_keys("life", fields={*LifeConditions.descriptions, *Lubrication.descriptions, *_OF_SPEED}):
            oil = self.lubrication.in_place.keywords
            # In thrust bearings an oil serves its films only, unless a modified life is requested.
            if isinstance(self.bearing.rows[0].bearing, CylindricalThrustBearing) and len(oil) == 1:
                oil = {}
            conditions = oil | self.life.keywords
            for name in ("spectrum", "turning"):  # the solutions know their ring
                conditions.pop(name)
            return assess(self._states or solution, **conditions)

    def rated(self, solution: BearingSolution) -> tuple[BearingLife | None, str]:
        """Return the life and "", or None and the reason why such a bearing has no rating.

        Raises
        ------
        CaseError
            If an input of the life is refused.
        """
        try:
            return self.assess(solution), ""
        except InputError as error:
            if error.field in {"bearing", "solution"}:
                return None, f"the bearing must {error.condition}"
            raise with_file_path(error, self.document, "life") from None

    def contact_case(self, solution: BearingSolution, roller: int, ring: str = "inner") -> Case:
        """Return the contact of a roller with a ring as a case of its own, with its load and tilt in the bearing.

        Its bodies are those of the bearing, cut along their common generator, with y along the roller. Other actions on
        the roller, of ribs, speed, out-of-round raceways and the other ring, are contained in load and tilt. Its
        solution is `BearingSolution.contact`.

        Parameters
        ----------
        solution : BearingSolution
            This bearing, solved by strips or by slices; load and tilt are by the same method.
        roller : int
            Index of the roller, from 0; sentences count rollers from 1.
        ring : {"inner", "outer"}
            The ring; in thrust bearings the shaft washer or the housing washer.

        Raises
        ------
        InputError
            If there is no such contact, or it is not loaded.

        Examples
        --------
        >>> import tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     path = Path(folder, "nu206.toml")
        ...     _ = path.write_text(starting_bearing())
        ...     bearing = read_bearing(path)
        >>> case = bearing.contact_case(bearing.solve("slices"), 0, "outer")
        >>> case.title, round(case.prescribed.load, -1)
        ('NU 206, roller 1 on the outer ring, by slices', 3720.0)
        """
        from nonhertz.bearing.section import RINGS

        _check_loaded(solution)
        roller = whole("roller", roller, 0, solution.angle.size - 1, "count from 0")
        one_of("ring", ring, RINGS, "name one of both")
        side = RINGS.index(ring)
        load, tilt = float(solution.load[roller, side]), float(solution.tilt[roller, side])
        if not load > 0.0:
            condition = f"be a roller that the {ring} ring loads"
            raise InputError("roller", roller, condition, "choose one within the load zone")
        row = next(other for other in solution.bearing.rows if roller < other.rollers.stop)
        method = "" if solution.method == "strips" else f", by {solution.method}"
        return Case(
            contact=row.bearing.contacts[side],
            prescribed=Prescription(load=load, tilt=tilt),
            title=f"{self.title}, roller {roller + 1} on the {ring} ring{method}".removeprefix(", "),
            path=Path(f"{self.path.stem}-{roller + 1}-{ring}.toml"),
            title_block=self.title_block,
        )


def read_bearing(path: str | Path, changes: Mapping[str, Any] | None = None) -> BearingCase:
    """Return the bearing in a file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see docs/reference/bearing-file.md.
    changes : mapping of str to object, optional
        Values in place of those in the file, by dotted path, such as ``{"load.radial": "5 kN"}``; None removes a key. A
        comment in the case's text lists them.

    Returns
    -------
    BearingCase
        The bearing and its loads.

    Raises
    ------
    CaseError
        With every mistake in the file, one sentence each.
    InputError
        If ``path`` is not the name of a file, or ``changes`` not a mapping.
    """
    return BearingCase.read(path, changes)


def new_bearing(template: str | None = None, changes: Mapping[str, Any] | None = None) -> BearingCase:
    """Return a bearing with loads to start from, the one that ``nonhertz new --bearing`` writes as a file.

    Parameters
    ----------
    template : str, optional
        One of ``BEARING_TEMPLATES``, each an example of a kind of bearing.
    changes : mapping of str to object, optional
        Values in place of those in the template, by dotted path, such as ``{"load.radial": "5 kN"}``; None removes one.

    Raises
    ------
    CaseError
        With every mistake in the changes, one sentence each.
    InputError
        If there is no such template, or ``changes`` is not a mapping.

    Examples
    --------
    >>> nu206 = new_bearing().bearing
    >>> nu206.rollers, nu206.roller.diameter
    (13, 9.0)
    """
    text = starting_bearing(template)
    return BearingCase.of(tomllib.loads(text), Path("bearing.toml"), text, changes=changes)
