"""The head of a report beside its title: project, author and date."""

from __future__ import annotations

import datetime
from dataclasses import replace
from typing import Annotated

from nonhertz.inputs.checks import one_line
from nonhertz.inputs.descriptions import Word
from nonhertz.inputs.fields import Input, input_class


@input_class()
class TitleBlock(Input):
    """What the head of a report says beside the title; what is left out is not shown.

    Raises
    ------
    InputError
        If one of them is not a line of text.

    Examples
    --------
    >>> TitleBlock(project="Gearbox", author="M. Muster").lines
    {'project': 'Gearbox', 'author': 'M. Muster'}
    """

    project: Annotated[str, Word("project that the report belongs to", "write plain text", condition=one_line)] = ""
    author: Annotated[str, Word("who made it", "write plain text", condition=one_line)] = ""
    date: Annotated[
        str,
        Word("date of the report, in quotation marks; no other date is shown", "write plain text", condition=one_line),
    ] = ""

    @property
    def lines(self) -> dict[str, str]:
        """Names and values, as far as they are given."""
        return {name: value.strip() for name, value in vars(self).items() if value.strip()}

    def dated(self) -> TitleBlock:
        """Return this one, with today's date if it has none."""
        return self if self.date.strip() else replace(self, date=datetime.date.today().isoformat())

    def over(self, other: TitleBlock) -> TitleBlock:
        """Return this one, with what is empty taken from another."""
        return replace(other, **self.lines)
