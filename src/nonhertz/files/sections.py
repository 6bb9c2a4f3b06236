"""The sections of a case file that are not inputs in Python by themselves, and the whole file."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.files.bounds import FORMAT, LOADS, MISTAKES
from nonhertz.files.profiles import read_profile
from nonhertz.files.reading import INVALID, ReadContext, read_input
from nonhertz.files.title_block import TitleBlock
from nonhertz.inputs.assumed import Assumed
from nonhertz.inputs.checks import not_negative, one_line, positive
from nonhertz.inputs.descriptions import Count, Custom, Part, Quantity, Several, Word
from nonhertz.inputs.fields import Input, cross_check, input_class
from nonhertz.life.capacity import ANGLE_REMEDY, contact_angle_at_most
from nonhertz.life.catalogue import MODELS, SLOPE_REMEDY, Model, model, weibull_slope
from nonhertz.life.lamina import EDGE_STRESS, FEWEST, LINE_LOADS, MOST
from nonhertz.life.required import REQUIRED, million_revolutions
from nonhertz.life.spectrum import ContactLoadCase, refuse_other_than_whole
from nonhertz.model.body import BODIES, Body, BodyName
from nonhertz.model.contact import Contact
from nonhertz.model.diameter import convex
from nonhertz.model.prescription import Prescription
from nonhertz.patch.features import Dent
from nonhertz.solver.one import FEWEST_STRIPS, GOALS, MOST_STRIPS, refuse_accuracy
from nonhertz.strip.element import ELEMENTS

_FAR_AWAY = 1e3  # mm; extent to which an unbounded contact is checked before it is solved


@input_class(kw_only=True)
class Bodies(Input):
    """The two bodies."""

    a: Annotated[Body, Part("one body", Body, "give its table")]
    b: Annotated[Body, Part("the other body", Body, "give its table")]

    @cross_check("a", "b")
    def _check_contact(self) -> None:
        try:
            contact = Contact(self.a, self.b)
            contact.curvature(sample_interval(contact.interval))
        except InputError as error:
            raise locate_body_error(error) from None


def locate_body_error(error: InputError) -> InputError:
    """Return an error about both bodies as one in the key of the body that has to change."""
    if error.field != "diameter" or not isinstance(error.value, tuple):
        return error.within("a" if error.field == "length" else "b")
    diameters = dict(zip(BODIES, error.value, strict=True))
    concave = [name for name, diameter in diameters.items() if diameter is not None and not convex(diameter)]
    if not concave:
        remedy = "the bodies are both flat, so give the diameter of one of them in mm"
        return InputError("a.diameter", None, "be given", remedy)
    name, other = concave[0], "b" if concave[0] == "a" else "a"
    against = f"body.{other}, which is flat" if diameters[other] is None else f"body.{other}.diameter"
    if isinstance(diameters[other], float):
        against += f" = {diameters[other]}"
    return InputError(f"{name}.diameter", diameters[name], f"{error.condition} with {against}", error.remedy)


def read_context(document: Any, folder: Path | None) -> ReadContext:
    """Return the context of the tables of a document, valid or not, while they are read.

    Parameters
    ----------
    document : object
        The whole document.
    folder : Path or None
        Directory to which the names of files are relative; None if no file may be read.
    """
    bodies = document.get("body") if isinstance(document, dict) else None
    by_name = bodies if isinstance(bodies, dict) else {}
    return ReadContext(folder, combined_radius(by_name.get("a"), by_name.get("b")), read_profile)


def combined_radius(*bodies: Any) -> Any:
    """Return the combined radius across the contact [mm] at the middles of two bodies, None if they have none.

    It is needed before the bodies are read one by one, since the profile of one may depend on both.
    """
    curvature = 0.0
    for body in bodies:
        if not isinstance(body, dict):
            return INVALID
        try:
            sizes = {name: body[name] for name in ("diameter",) if name in body}
            curvature += float(read_input(Body, sizes, likely=lambda _: Body).curvature(0.0))
        except InputError:
            return INVALID
    return 1.0 / curvature if curvature > 0.0 else None


def sample_interval(interval: tuple[float, float]) -> NDArray[np.float64]:
    """Return positions at which to check a contact; the solver checks again at its own strips."""
    low, high = (min(max(end, -_FAR_AWAY), _FAR_AWAY) for end in interval)
    return np.linspace(low, high, 1001)


@input_class(kw_only=True)
class Solver(Input):
    """The method of solution."""

    element: Annotated[
        str, Word("strip element: 'semi-elliptic' or 'parabolic'", "choose one of them", tuple(ELEMENTS))
    ] = "semi-elliptic"
    strips: Annotated[
        int | str,
        Count(
            "number of strips of equal width",
            FEWEST_STRIPS,
            MOST_STRIPS,
            "leave it out for an automatic grid",
            {"auto": "an automatic grid, as fine as the accuracy requires"},
        ),
    ] = "auto"
    accuracy: Annotated[
        float | None,
        Quantity("", "target relative error of approach or load on the automatic grid; 1e-4 if left out"),
    ] = None
    accuracy_of: Annotated[
        str | None,
        Word(
            "quantity of the accuracy: 'approach' (or load), or 'pressure', the maximum, whose default is 1e-3",
            "leave it out for the accuracy of the approach",
            GOALS,
        ),
    ] = None

    @cross_check("strips", "accuracy", "accuracy_of")
    def _check_accuracy(self) -> None:
        refuse_accuracy(self.strips, self.accuracy, self.accuracy_of)


@input_class(kw_only=True)
class OverrolledDent(Input):
    """A dent in the raceway that is rolled over."""

    depth: Annotated[float, Dent.descriptions["depth"]]
    diameter: Annotated[float, Dent.descriptions["diameter"]]
    shoulder: Annotated[float, Dent.descriptions["shoulder"]] = 0.0
    shoulder_diameter: Annotated[float | None, Dent.descriptions["shoulder_diameter"]] = None
    y: Annotated[float, Dent.descriptions["y"]] = 0.0
    body: Annotated[
        BodyName, Word("the body with the dent, 'a' or 'b'", "name the body whose raceway has the dent", BODIES)
    ] = "b"
    dents: Annotated[
        int, Count("number of dents around the raceway at that y", 1, math.inf, "give the number of dents")
    ] = 1
    per_area: Annotated[
        float | None,
        Quantity(
            "",
            "instead, number of dents per square millimetre",
            positive,
            "give a positive number, or leave it out",
        ),
    ] = None
    raceway_diameter: Annotated[
        float | None,
        Quantity(
            "mm",
            "diameter of the raceway, that of the body if left out",
            positive,
            "give a positive number, or leave it out",
        ),
    ] = None

    @cross_check("diameter", "depth", "shoulder", "shoulder_diameter", "y")
    def _check_shape(self) -> None:
        _ = self.dent

    @property
    def dent(self) -> Dent:
        """The dent itself."""
        names = ("depth", "diameter", "shoulder", "shoulder_diameter", "y")
        return Dent(**{name: getattr(self, name) for name in names})

    @property
    def number(self) -> dict[str, Any]:
        """The number of dents, as keywords of `nonhertz.life.Overrolled.relative_life`."""
        density = {"dents": self.dents} if self.per_area is None else {"per_area": self.per_area}
        return density | ({} if self.raceway_diameter is None else {"raceway_diameter": self.raceway_diameter})


def _uses_any(*names: str) -> Callable[[Life], bool]:
    """Return a function that tells whether lives use one of these models."""
    return lambda life: not life.models or not set(names).isdisjoint(life.models)


@input_class(kw_only=True)
class Life(Input):
    """The conditions of the bodies' lives."""

    rollers: Annotated[
        int | None,
        Count(
            "number of rollers in the bearing, for absolute lives",
            1,
            math.inf,
            "give the number of rollers in the bearing",
        ),
    ] = None
    contact_angle: Annotated[
        float | None,
        Quantity(
            "rad",
            "contact angle of the bearing, for absolute lives of tapered rollers",
            contact_angle_at_most,
            ANGLE_REMEDY,
        ),
    ] = None
    models: Annotated[
        tuple[str, ...],
        Several(
            Word(
                "names of the fatigue models; all of them if left out",
                "name fatigue models, such as ['zaretsky']",
                tuple(MODELS),
            ),
            MISTAKES,
        ),
    ] = ()
    slope: Annotated[
        float | None,
        Quantity("", "Weibull's slope e of the volume models, 9/8 if left out", weibull_slope, SLOPE_REMEDY),
        Assumed("slope of 9/8", "lives by stressed volume", _uses_any(*(set(MODELS) - {"iso-16281"}))),
    ] = None
    fatigue_limit: Annotated[
        float | None,
        Quantity(
            "MPa",
            "fatigue limit of ioannides-harris, 360 if left out",
            not_negative,
            "give a limit in MPa, 0 for none",
        ),
        Assumed("usual fatigue limit of bearing steel", "the life by ioannides-harris", _uses_any("ioannides-harris")),
    ] = None
    laminae: Annotated[
        int | None,
        Count("number of laminae of iso-16281, 60 if left out", FEWEST, MOST, "give the number of slices, such as 60"),
    ] = None
    edge_stress: Annotated[
        str | None,
        Word(
            "edges of iso-16281: 'pressure' as solved, 'standard' or 'none'",
            "use 'pressure' for what was solved",
            EDGE_STRESS,
        ),
        Assumed("edge stress as solved", "the life by iso-16281", _uses_any("iso-16281")),
    ] = None
    line_loads: Annotated[
        str | None,
        Word(
            "line loads of iso-16281: those of the 'solution' or of the 'standard'",
            "use 'solution' for what was solved",
            LINE_LOADS,
        ),
        Assumed("line loads as solved", "the life by iso-16281", _uses_any("iso-16281")),
    ] = None
    required: Annotated[float | str | None, REQUIRED] = None
    spectrum: Annotated[
        tuple[ContactLoadCase, ...],
        Several(
            Part(
                "loads with their shares of the revolutions, in place of [load]",
                ContactLoadCase,
                "write each load under a heading [[life.spectrum]]",
            ),
            LOADS,
        ),
    ] = ()
    dent: Annotated[
        OverrolledDent | None, Part("a dent that is rolled over", OverrolledDent, "give its depth and diameter")
    ] = None

    @cross_check("spectrum")
    def _check_shares(self) -> None:
        if self.spectrum:
            remedy = "give all loads with their shares of the revolutions"
            refuse_other_than_whole("spectrum.share", self.spectrum, remedy)

    @cross_check("spectrum", "dent")
    def _check_dent(self) -> None:
        if self.dent is not None and self.spectrum:
            raise InputError("dent", "with a spectrum", "be under one load", "leave out the spectrum, or the dent")

    @cross_check("required")
    def _check_required(self) -> None:
        _ = self.required_revolutions

    @property
    def required_revolutions(self) -> float | None:
        """The required life [10^6 revolutions]; a contact has no speed for hours."""
        return None if self.required is None else million_revolutions(self.required, None)

    @property
    def steps(self) -> int:
        """The number of steps that an assessment announces: both bodies under each load, and the dent."""
        return 2 * max(1, len(self.spectrum)) + (self.dent is not None)

    def build_models(self, names: Iterable[str] = ()) -> tuple[Model, ...]:
        """Return models by name, each with the given parameters that it has.

        Parameters
        ----------
        names : iterable of str
            Names in place of ``models``.

        Raises
        ------
        InputError
            If a name is not that of a model.
        """
        names = tuple(names) or self.models or tuple(MODELS)
        values = {name: value for name, value in vars(self).items() if value is not None}
        taken = {name: inspect.signature(MODELS[name]).parameters if name in MODELS else {} for name in names}
        return tuple(model(name, **{key: values[key] for key in taken[name] if key in values}) for name in names)


def _format(name: str, value: Any, remedy: str) -> int:
    if value != FORMAT or isinstance(value, bool):
        raise InputError(name, value, f"be {FORMAT}, the newest format this release reads", remedy)
    return FORMAT


#: The format of a file, the same for all kinds of files.
FORMAT_FIELD = Custom(
    "format of the file; older files that leave it out are read",
    _format,
    {"const": FORMAT},
    "use the release of nonhertz that wrote it, or a later one",
)


def describe_title(what: str) -> Word:
    """Return the description of the title in a kind of file."""
    return Word(f"title of the {what} in tables and figures", "write a short name", condition=one_line)


@input_class(kw_only=True)
class CaseDocument(Input):
    """A case file."""

    format: Annotated[int, FORMAT_FIELD] = FORMAT
    title: Annotated[str, describe_title("case")] = ""
    body: Annotated[Bodies, Part("the two bodies", Bodies, "give both")]
    load: Annotated[Prescription, Part("load or approach, tilt or moment", Prescription, "give it")]
    solver: Annotated[Solver, Part("method of solution", Solver, "give a table")] = Solver()
    life: Annotated[Life, Part("conditions of the bodies' lives", Life, "give a table")] = Life()
    report: Annotated[TitleBlock, Part("head of a report", TitleBlock, "give a table")] = TitleBlock()

    @property
    def contact(self) -> Contact:
        """Both bodies."""
        return Contact(self.body.a, self.body.b)
