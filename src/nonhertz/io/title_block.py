"""The title block of a report: who made it, for which project, in which revision, as on a drawing."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Final

from nonhertz.errors import InputError
from nonhertz.inputs.checks import one_line
from nonhertz.io.logo import Logo

LINE: Final = 200
"""Letters of a field."""
REMARKS: Final = 5000
"""Letters of the remarks."""
_OF_ONE_LINE: Final = ("project", "author", "revision", "date")


@dataclass(frozen=True)
class TitleBlock:
    """What the head of a report says beside the title; what is empty is not shown.

    Attributes
    ----------
    project, author, revision, date : str
        A line each; a report has no date but this one.
    remarks : str
        Text of one or more lines; a blank line begins a paragraph.
    logo : Logo or None
        A picture beside the title; see `nonhertz.io.logo.logo_from`.

    Raises
    ------
    InputError
        If one of them is not text, or is too long.

    Examples
    --------
    >>> TitleBlock(project="Gearbox", revision="B").lines
    (('project', 'Gearbox'), ('revision', 'B'))
    """

    project: str = ""
    author: str = ""
    revision: str = ""
    date: str = ""
    remarks: str = ""
    logo: Logo | None = None

    def __post_init__(self) -> None:
        for name in (*_OF_ONE_LINE, "remarks"):
            self._check(name, getattr(self, name))
        if not (self.logo is None or isinstance(self.logo, Logo)):
            remedy = "make one with nonhertz.report.logo_from"
            raise InputError("logo", self.logo, "be a Logo", remedy)

    def _check(self, name: str, value: object) -> None:
        if not isinstance(value, str):
            raise InputError(name, value, "be text", f'write {name} = "..." in quotation marks')
        most = LINE if name in _OF_ONE_LINE else REMARKS
        if len(value) > most:
            raise InputError(name, f"{value[:30]}...", f"have at most {most} letters", "shorten it")
        for line in [value] if name in _OF_ONE_LINE else value.replace("\t", " ").splitlines():
            one_line(name, line, "write plain text")

    @property
    def lines(self) -> tuple[tuple[str, str], ...]:
        """Names and values of project, author, revision and date, as far as they are given."""
        return tuple((name, getattr(self, name).strip()) for name in _OF_ONE_LINE if getattr(self, name).strip())

    @property
    def paragraphs(self) -> tuple[str, ...]:
        """The remarks by paragraphs."""
        parts = "\n".join(self.remarks.splitlines()).split("\n\n")
        return tuple(" ".join(part.split()) for part in parts if part.strip())

    @property
    def table(self) -> dict[str, str]:
        """What a case file holds of it, without what is empty."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        if isinstance(self.logo, Logo):
            values["logo"] = self.logo.address
        return {name: value for name, value in values.items() if value}

    def over(self, other: TitleBlock) -> TitleBlock:
        """Return this one, with what is empty taken from another.

        Examples
        --------
        >>> TitleBlock(revision="C").over(TitleBlock(project="Gearbox", revision="B")).lines
        (('project', 'Gearbox'), ('revision', 'C'))
        """
        return TitleBlock(**{f.name: getattr(self, f.name) or getattr(other, f.name) for f in fields(self)})
