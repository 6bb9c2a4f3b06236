"""Several cases solved by one command, as JSON and as one table; a case that fails is a row with its reason."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonhertz.amounts import display_units
from nonhertz.files.contact_results import as_object
from nonhertz.files.results import plain
from nonhertz.inputs.files import printable_name
from nonhertz.result.quantities import QUANTITIES
from nonhertz.result.tables import heading
from nonhertz.verdict import Verdict, judge_contact

if TYPE_CHECKING:
    from nonhertz.files.casefile import Case
    from nonhertz.result.solution import Solution

#: Head of the table, with units.
HEAD = (
    *("case", "title", "status"),
    *(heading(name, quantity.unit) for name, quantity in QUANTITIES.items()),
    *("warnings", "complaint"),
)
_NOT_SOLVED = "not-solved"


@dataclass(frozen=True)
class Attempt:
    """A case that was solved, or why it was not.

    Attributes
    ----------
    path : Path
        Its file.
    case : Case or None
        None if the file has mistakes.
    solution : Solution or None
        The state in which the solver stopped; None if the case was refused.
    complaints : tuple of str
        Why there is no converged solution, one sentence each; empty if there is one.
    """

    path: Path
    case: Case | None = None
    solution: Solution | None = None
    complaints: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """Its file, as given."""
        return printable_name(str(self.path))

    @property
    def title(self) -> str:
        """The title of the case; empty if its file could not be read."""
        return "" if self.case is None else self.case.title

    @property
    def verdict(self) -> Verdict | None:
        """Whether limits are met; None if the case was not solved."""
        return None if self.solution is None or self.complaints else judge_contact(self.solution)

    @property
    def sentences(self) -> list[str]:
        """Its complaints, each with the name of its file."""
        return [words if words.startswith(self.name) else f"{self.name}: {words}" for words in self.complaints]

    @property
    def warnings(self) -> list[str]:
        """Its warnings, each with the name of its file."""
        return [] if self.solution is None else [f"{self.name}: {warning}" for warning in self.solution.warnings]

    @property
    def status(self) -> str:
        """How the solve ended, as written in files."""
        return _NOT_SOLVED if self.solution is None else self.solution.status.label


def name_folders(attempts: Sequence[Attempt]) -> list[str]:
    """Return distinct names for the folders of cases: those of their files, numbered if they are the same.

    Examples
    --------
    >>> name_folders([Attempt(Path(name)) for name in ("a.toml", "b/A.toml", "a-2.toml", "...toml")])
    ['a', 'A-2', 'a-2-2', 'case']
    """
    names: list[str] = []
    taken: set[str] = set()
    for attempt in attempts:
        # A name of dots only would lead out of the directory.
        stem = printable_name(attempt.path.stem) if attempt.path.stem.strip(". ") else "case"
        name, number = stem, 1
        # Some file systems are not case-sensitive.
        while name.lower() in taken:
            number += 1
            name = f"{stem}-{number}"
        taken.add(name.lower())
        names.append(name)
    return names


@display_units("si")
def objects(attempts: Sequence[Attempt]) -> list[dict[str, Any]]:
    """Return an object for each case: its file, complaints, and the result or None."""
    return [
        {
            "file": attempt.name,
            "complaints": list(attempt.complaints),
            "result": as_object(attempt.solution, attempt.case) if attempt.solution and attempt.case else None,
        }
        for attempt in attempts
    ]


@display_units("si")
def rows(attempts: Sequence[Attempt]) -> list[list[Any]]:
    """Return the cells of a row of the table for each case; None without a number."""
    return [_row(attempt) for attempt in attempts]


def _row(attempt: Attempt) -> list[Any]:
    solution = attempt.solution
    numbers = [None if solution is None else plain(quantity.get(solution)) for quantity in QUANTITIES.values()]
    warnings = () if solution is None else solution.warnings
    return [attempt.name, attempt.title, attempt.status, *numbers, " ".join(warnings), " ".join(attempt.complaints)]
