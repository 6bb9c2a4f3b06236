"""Measured profiles of a case: what each step did to the points."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.measured import KIND, checked, measured_from, trace_from
from nonhertz.files.origin import body_tables
from nonhertz.files.profiles import profile_tables
from nonhertz.measured import Measured


@dataclass(frozen=True, eq=False)
class Measurement:
    """A measured profile.

    Attributes
    ----------
    place : str
        Where the case file has it, such as ``"body.a.profile[1]"``.
    file : str
        The name of the measured file.
    measured : Measured
        The points, and the steps from them to the profile.
    """

    place: str
    file: str
    measured: Measured

    @property
    def rows(self) -> list[tuple[str, str]]:
        """Name and sentence of every step, the raw points first."""
        return [(state.name, state.words) for state in self.measured.states]


def measurements(case: Case | BearingCase) -> Iterator[Measurement]:
    """Yield the measured profiles of a case whose files are available."""
    for place, body in body_tables(case.document):
        for number, table in enumerate(profile_tables(body), start=1):
            content = case.attachments.get(str(table.get("file")))
            if table.get("kind") == KIND and content is not None:
                values = {key: checked(key, value) for key, value in table.items() if key != "kind"}
                trace = trace_from(content, values, table["file"])
                yield Measurement(f"{place}.profile[{number}]", table["file"], measured_from(trace, values))
