"""What commands return: a value that is printed in one place, for people or as JSON."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from nonhertz.cli.exit_codes import FINE, NOT_JUDGED, NOT_MET, STRAINED

if TYPE_CHECKING:
    from nonhertz.show.sections import Section
    from nonhertz.verdict import Verdict


@dataclass(frozen=True)
class Answer:
    """The result of a command. A command that returns one has the options ``--units`` and ``--json``."""

    title: str
    sections: Iterable[Section]
    json: Callable[[], str]
    verdict: Verdict | None = None
    warnings: Iterable[object] = ()
    written: Iterable[Path] = ()
    complaints: Sequence[str] = ()  # to standard error
    code: int = FINE
    wide: int | None = 120  # columns without a terminal; None for COLUMNS, or else 80

    def print(self, *, as_json: bool, judge: bool = False) -> int:
        """Print the answer; return the exit code: that of the verdict if ``judge`` is set and nothing else failed."""
        if as_json:
            print(self.json())
        else:
            from nonhertz.cli.printing import print_result

            print_result(self.title, self.sections, self.verdict, self.warnings, self.written, piped=self.wide)
        if self.complaints:
            sys.stdout.flush()
            print(*self.complaints, sep="\n", file=sys.stderr)
        return self._code_of_verdict if judge and self.code == FINE else self.code

    @property
    def _code_of_verdict(self) -> int:
        from nonhertz.verdict import Level

        level = Level.NOT_JUDGED if self.verdict is None else self.verdict.level
        exceeded = dict.fromkeys((Level.NOT_MET, Level.UNLIMITED), NOT_MET)
        return (exceeded | {Level.NOT_JUDGED: NOT_JUDGED, Level.STRAINED: STRAINED}).get(level, FINE)
