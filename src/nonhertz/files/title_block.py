"""The head of a report beside its title: project, author and date."""

from __future__ import annotations

from dataclasses import fields
from typing import Annotated, Any, Final

from nonhertz.errors import InputError
from nonhertz.inputs.checks import one_line
from nonhertz.inputs.fields import Input, Word, described

LINE: Final = 200
"""Letters of a field."""


def _line(name: str, value: Any, remedy: str) -> None:
    if not isinstance(value, str):
        raise InputError(name, value, "be text", f'write {name} = "..." in quotation marks')
    if len(value) > LINE:
        raise InputError(name, f"{value[:30]}...", f"have at most {LINE} letters", "shorten it")
    one_line(name, value, remedy)


@described()
class TitleBlock(Input):
    """What the head of a report says beside the title; what is left out is not shown.

    Raises
    ------
    InputError
        If one of them is not a line of text, or is too long.

    Examples
    --------
    >>> TitleBlock(project="Gearbox", author="M. Muster").lines
    (('project', 'Gearbox'), ('author', 'M. Muster'))
    """

    project: Annotated[str, Word("project that the report belongs to", "write plain text", condition=_line)] = ""
    author: Annotated[str, Word("who made it", "write plain text", condition=_line)] = ""
    date: Annotated[
        str,
        Word("date of the report, in quotation marks; no other date is shown", "write plain text", condition=_line),
    ] = ""

    @property
    def lines(self) -> tuple[tuple[str, str], ...]:
        """Names and values, as far as they are given."""
        return tuple((name, value.strip()) for name, value in vars(self).items() if value.strip())

    def over(self, other: TitleBlock) -> TitleBlock:
        """Return this one, with what is empty taken from another.

        Examples
        --------
        >>> TitleBlock(author="B").over(TitleBlock(project="Gearbox", author="A")).lines
        (('project', 'Gearbox'), ('author', 'B'))
        """
        return TitleBlock(**{f.name: getattr(self, f.name) or getattr(other, f.name) for f in fields(self)})
