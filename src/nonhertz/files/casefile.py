"""Case files: from TOML to a `Contact` and what to solve it for.

All mistakes in a file are found at once and raised together, in the wording of the Python classes.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar

from nonhertz.errors import CaseError, InputError
from nonhertz.files.held import HeldCase, starting_text
from nonhertz.files.mistakes import case_error
from nonhertz.files.reading import read
from nonhertz.files.sections import CaseDocument, Life, OverrolledDent, Solver, of_both, surroundings
from nonhertz.files.title_block import TitleBlock
from nonhertz.files.writing import document_of
from nonhertz.model.body import BODIES
from nonhertz.model.contact import Contact
from nonhertz.model.prescription import Prescription
from nonhertz.solver.one import element_of
from nonhertz.strip.element import SEMI_ELLIPTIC

if TYPE_CHECKING:
    from nonhertz.result.solution import Solution

_OF_BOTH_BODIES = ("diameter", "length", "position")
_SECTIONS = {
    "life.dent": tuple(OverrolledDent.descriptions),
    "life": (*Life.descriptions, "share"),
    "load": tuple(Prescription.descriptions),
    "solver": tuple(Solver.descriptions),
}


@dataclass(frozen=True, repr=False)
class Case(HeldCase):
    """Two bodies, what presses them together, how that is solved, and how long the bodies last.

    Attributes
    ----------
    contact : Contact
        The two bodies.
    prescribed : dict
        Load or approach, tilt or moment: keywords for `nonhertz.solve`.
    solver : dict
        Element, strips and accuracy: keywords for `nonhertz.solve`; semi-elliptic and automatic where left out.
    life : Life
        How long the bodies last: models and a spectrum of loads.
    title, path, title_block, origin
        As of `HeldCase`.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder, "case.toml")
    ...     _ = path.write_text(starting_case())
    ...     case = read_case(path)
    >>> case.prescribed["load"], case.contact.interval
    (20000.0, (-10.0, 10.0))
    >>> round(case.solve().load)
    20000
    """

    contact: Contact
    prescribed: dict[str, Any]
    solver: dict[str, Any] = field(default_factory=dict)
    life: Life = field(default_factory=Life)

    parts: ClassVar = {"contact": Contact, "life": Life, "title_block": TitleBlock}
    contents: ClassVar = CaseDocument
    keywords: ClassVar = {"prescribed": Prescription.descriptions, "solver": Solver.descriptions}

    def __post_init__(self) -> None:
        super().__post_init__()
        if len({"load", "approach"} & set(self.prescribed)) != 1:
            condition = "hold either load or approach"
            raise InputError("prescribed", self.prescribed, condition, 'write {"load": 20e3}, say, in N')
        element = element_of(self.solver.get("element") or SEMI_ELLIPTIC)
        solver = {"element": element, "strips": "auto", "accuracy": None}
        object.__setattr__(self, "solver", solver | self.solver | {"element": element})

    @staticmethod
    def given_in(document: dict[str, Any], folder: Path | None) -> dict[str, Any]:
        """Return the title and the fields of a case in a document."""
        found = read(CaseDocument, document, surroundings(document, folder))
        return {
            "title": found.title,
            "contact": Contact(found.body.a, found.body.b),
            "prescribed": found.load.keywords,
            "solver": found.solver.keywords,
            "life": found.life,
            "title_block": found.report,
        }

    def sections(self) -> dict[str, Any]:
        """Return the sections of its file."""
        body = {}
        for which in BODIES:
            try:
                body[which] = document_of(getattr(self.contact, which))
            except InputError as error:
                raise error.within(f"body.{which}") from None
        strips = "auto" if self.solver["strips"] is None else self.solver["strips"]
        if not isinstance(strips, str | int):
            condition, remedy = "be 'auto' or a number to go into a case file", "give the number of strips"
            raise InputError("strips", "edges", condition, remedy)
        solver = Solver(element=self.solver["element"].name, strips=strips, accuracy=self.solver["accuracy"])
        load = {name: float(value) for name, value in self.prescribed.items()}
        parts = {"life": self.life, "report": self.title_block}
        rest = {name: given for name, part in parts.items() if (given := document_of(part, defaults=False))}
        return {"body": body, "load": load, "solver": document_of(solver)} | rest

    def solve(self) -> Solution:
        """Return the solution of the case, as `nonhertz.solve` does.

        Raises
        ------
        CaseError
            If the solver rejects the case; the sentence names the key in the file.
        ConvergenceError
            If it stops short of a solution.

        Warns
        -----
        AccuracyWarning
            If the result strains the model's validity.
        """
        from nonhertz.solver.one import solve

        try:
            return solve(self.contact, **self.prescribed, **self.solver)
        except InputError as error:
            raise placed(error) from None


def read_case(path: str | Path, changes: Mapping[str, Any] | None = None) -> Case:
    """Return the case in a file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see docs/reference/case-file.md.
    changes : mapping of str to object, optional
        Values in place of those in the file, by dotted path, such as ``{"load.load": "5 kN"}``; None takes a key out.
        The text names them.

    Returns
    -------
    Case
        The contact and what to solve it for.

    Raises
    ------
    CaseError
        With every mistake in the file, one sentence each.
    InputError
        If ``path`` is not the name of a file, or ``changes`` not a mapping.
    """
    return Case.read(path, changes)


#: Machine elements whose cases `starting_case` returns, by name, in words.
TEMPLATES = {
    "cylindrical": "cylindrical roller on a ring",
    "tapered": "tapered roller on a ring",
    "spherical": "barrel of a spherical roller bearing",
    "needle": "needle on a shaft",
    "wheel-on-rail": "crowned wheel on a rail",
    "gear-flank": "flanks of spur gears",
    "cam": "cam and roller follower",
}


def starting_case(template: str | None = None) -> str:
    """Return a commented case file to start from.

    Parameters
    ----------
    template : str, optional
        One of `TEMPLATES`, each an example of a machine element; one with all that a case may hold if left out.

    Raises
    ------
    InputError
        If there is no such template.
    """
    return starting_text("starting_case.toml", template, TEMPLATES, "templates")


def placed(error: InputError) -> CaseError:
    """Return an error from `nonhertz.solve` as one about the case file, with the field named as in the file."""
    if error.field in _OF_BOTH_BODIES:
        return case_error([of_both(error).within("body")])
    section = next((section for section, fields in _SECTIONS.items() if error.field in fields), None)
    return case_error([error.within(section) if section else error])
