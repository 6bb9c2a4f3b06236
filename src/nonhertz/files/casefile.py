"""Case files: from TOML to a `Contact` with its loads.

All mistakes in a file are found at once and raised together, in the wording of the Python classes.
"""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, ClassVar

from nonhertz.errors import CaseError, InputError
from nonhertz.files.document import CaseBase
from nonhertz.files.mistakes import case_error
from nonhertz.files.reading import read_input
from nonhertz.files.sections import CaseDocument, Life, OverrolledDent, Solver, locate_body_error, read_context
from nonhertz.files.starting import starting_case
from nonhertz.files.writing import document_of
from nonhertz.inputs.fields import Input
from nonhertz.model.body import BODIES
from nonhertz.model.contact import Contact
from nonhertz.model.prescription import Prescription

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
class Case(CaseBase):
    """Two bodies, their load, the method of solution, and the conditions of their life.

    Attributes
    ----------
    contact : Contact
        The two bodies.
    prescribed : Prescription
        Load or approach, tilt or moment; a dictionary of its keywords is accepted too, as for ``solver`` and ``life``.
    solver : Solver
        Element, strips and accuracy; semi-elliptic strips on an automatic grid by default.
    life : Life
        Fatigue models and a load spectrum.
    title, path, title_block, origin
        As of `CaseBase`.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder, "case.toml")
    ...     _ = path.write_text(starting_case())
    ...     case = read_case(path)
    >>> case.prescribed.load, case.contact.interval
    (20000.0, (-10.0, 10.0))
    >>> round(case.solve().load)
    20000
    """

    contact: Contact
    prescribed: Prescription
    solver: Solver = field(default_factory=Solver)
    life: Life = field(default_factory=Life)

    contents: ClassVar = CaseDocument

    @staticmethod
    def contents_of(document: dict[str, Any], folder: Path | None) -> CaseDocument:
        """Return the contents of a document."""
        return read_input(CaseDocument, document, read_context(document, folder))

    @property
    def parts(self) -> dict[str, Input]:
        """The inputs with defaults that are reported as assumptions, by their places in the file."""
        return {f"body.{name}": body for name, body in self.contact.bodies.items()}

    def sections(self) -> dict[str, Any]:
        """Return the sections of its file."""
        body = {}
        for which in BODIES:
            try:
                body[which] = document_of(getattr(self.contact, which))
            except InputError as error:
                raise error.within(f"body.{which}") from None
        parts = {"life": self.life, "report": self.title_block}
        rest = {name: table for name, part in parts.items() if (table := document_of(part, defaults=False))}
        return {"body": body, "load": document_of(self.prescribed), "solver": document_of(self.solver)} | rest

    def solve(self) -> Solution:
        """Return the solution of the case; see `nonhertz.solve`.

        Raises
        ------
        CaseError
            If the solver rejects the case; the sentence names the key in the file.
        ConvergenceError
            If the solver stops short of a solution.

        Warns
        -----
        AccuracyWarning
            If the result strains the model's validity.
        """
        from nonhertz.solver.one import solve

        try:
            return solve(self.contact, **self.prescribed.keywords, **self.solver.keywords)
        except InputError as error:
            raise with_file_path(error, self.document) from None


def read_case(path: str | Path, changes: Mapping[str, Any] | None = None) -> Case:
    """Return the case in a file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see docs/reference/case-file.md.
    changes : mapping of str to object, optional
        Values in place of those in the file, by dotted path, such as ``{"load.load": "5 kN"}``; None removes a key. A
        comment in the case's text lists them.

    Returns
    -------
    Case
        The contact with its loads.

    Raises
    ------
    CaseError
        With every mistake in the file, one sentence each.
    InputError
        If ``path`` is not the name of a file, or ``changes`` not a mapping.
    """
    return Case.read(path, changes)


def new_case(template: str | None = None, changes: Mapping[str, Any] | None = None) -> Case:
    """Return a case to start from, the one that ``nonhertz new`` writes as a file.

    Parameters
    ----------
    template : str, optional
        One of ``TEMPLATES``, each an example of a machine element.
    changes : mapping of str to object, optional
        Values in place of those in the template, by dotted path, such as ``{"load.load": "5 kN"}``; None removes a key.

    Raises
    ------
    CaseError
        With every mistake in the changes, one sentence each.
    InputError
        If there is no such template, or ``changes`` is not a mapping.

    Examples
    --------
    >>> case = new_case("wheel-on-rail", {"load.load": "90 kN"})
    >>> round(case.solve().max_pressure, -1)
    1350.0
    """
    text = starting_case(template)
    return Case.of(tomllib.loads(text), Path("case.toml"), text, changes=changes)


def with_file_path(error: InputError, document: Mapping[str, Any] = MappingProxyType({})) -> CaseError:
    """Return an error from `nonhertz.solve` as one about the case file, with field and value as in its document."""
    if error.field in _OF_BOTH_BODIES:
        return case_error([locate_body_error(error).within("body")])
    section = next((section for section, fields in _SECTIONS.items() if error.field in fields), None)
    return case_error([error.within(section) if section else error], document)
