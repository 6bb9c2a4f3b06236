"""The head of a report, except its title: project, author and date."""

from __future__ import annotations

import datetime
from dataclasses import replace
from typing import Annotated

from nonhertz.inputs.checks import one_line
from nonhertz.inputs.descriptions import Word
from nonhertz.inputs.fields import Input, input_class


@input_class()
class TitleBlock(Input):
    """The head of a report, except the title; parts that are left out are not shown.

    Raises
    ------
    InputError
        If one of them is not a line of text.

    Examples
    --------
    >>> TitleBlock(project="Gearbox", author="M. Muster").lines
    {'project': 'Gearbox', 'author': 'M. Muster'}
    """

    project: Annotated[str, Word("project of the report", "write plain text", condition=one_line)] = ""
    author: Annotated[str, Word("author of the report", "write plain text", condition=one_line)] = ""
    date: Annotated[
        str,
        Word("date of the report, in quotation marks; no other date is shown", "write plain text", condition=one_line),
    ] = ""

    @property
    def lines(self) -> dict[str, str]:
        """Names and values of the parts that are given."""
        return {name: value.strip() for name, value in vars(self).items() if value.strip()}

    def dated(self) -> TitleBlock:
        """Return this title block, with today's date if it has none."""
        return self if self.date.strip() else replace(self, date=datetime.date.today().isoformat())

    def over(self, other: TitleBlock) -> TitleBlock:
        """Return this title block, with empty parts taken from another."""
        return replace(other, **self.lines)
