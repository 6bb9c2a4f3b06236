"""The rows of a study on disk, in a form that survives being stopped at any moment.

A database takes portions of rows, each whole or not at all, together with the note that it is there. What is missing
after a crash is therefore known, and nothing is in it twice. It also holds what the rows were made from: a study that
has changed since is refused, with what differs.
"""

from __future__ import annotations

import contextlib
import csv
import json
import math
import sqlite3
import weakref
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.result.brief import shortened
from nonhertz.study.rows import Row

FILE = "rows.sqlite3"
_PAGE = 10_000  # rows read at a time
_TABLES = """
create table made_from (place text primary key, value text not null) without rowid;
create table portions (number integer primary key);
"""


class Store:
    """Rows of a study, in a directory or in memory.

    Parameters
    ----------
    directory : Path or None
        Where they are kept; created if it does not exist. None keeps them in memory.
    made_from : mapping
        What decides the rows: the case, what is varied, the numbers asked for. Anything that JSON can hold.
    paths, names : sequence of str
        What is varied, and the numbers of a row.

    Raises
    ------
    InputError
        If the directory holds the rows of something else, is in use, or cannot be written to.
    """

    def __init__(
        self, directory: Path | None, made_from: Mapping[str, Any], paths: Sequence[str], names: Sequence[str]
    ) -> None:
        self._directory, self.paths, self.names = directory, tuple(paths), tuple(names)
        self._rows = _opened(directory)
        weakref.finalize(self, _closed, self._rows)
        try:
            self._begin(dict(_leaves("", made_from)))
        except BaseException:
            self._rows.close()
            raise

    def _begin(self, made_from: Mapping[str, str]) -> None:
        if self._rows.execute("select 1 from sqlite_master").fetchone() is None:
            columns = ", ".join(f"v{k}" for k in range(len(self.paths)))
            numbers = ", ".join(f"n{k} real" for k in range(len(self.names)))
            with self._changes() as rows:
                for statement in _TABLES.split(";"):
                    rows.execute(statement)
                rows.execute(f"create table rows (number integer primary key, {columns}, {numbers}, failure text)")
                rows.executemany("insert into made_from values (?, ?)", made_from.items())
            return
        before = dict(self._rows.execute("select place, value from made_from").fetchall())
        different = [place for place in {**before, **made_from} if before.get(place) != made_from.get(place)]
        if different:
            raise self._changed(different, before, made_from)

    def _changed(self, places: Sequence[str], before: Mapping[str, str], now: Mapping[str, str]) -> InputError:
        said = [
            f"{place} was {shortened(before.get(place, 'not given'))}, is {shortened(now.get(place, 'not given'))}"
            for place in places[:3]
        ]
        more = f"; and {len(places) - 3} more" if len(places) > 3 else ""
        condition = f"hold rows of the same plan, but {'; '.join(said)}{more}"
        remedy = "choose another directory, or put the plan back as it was"
        return InputError("--out", str(self._directory), condition, remedy)

    @contextlib.contextmanager
    def _changes(self) -> Iterator[sqlite3.Connection]:
        """Make changes that are kept whole, or not at all."""
        self._rows.execute("begin immediate")
        try:
            yield self._rows
        except BaseException:
            self._rows.rollback()
            raise
        self._rows.commit()

    def release(self) -> None:
        """Let others use the directory; what is there can still be read."""
        self._rows.execute("pragma locking_mode = normal")
        self._rows.execute("select count(*) from portions").fetchone()

    def portions(self) -> set[int]:
        """Return the numbers of the portions that are there."""
        return {number for (number,) in self._rows.execute("select number from portions")}

    def add(self, portion: int, numbers: Iterable[int], values: Iterable[Sequence[Any]], rows: Iterable[Row]) -> None:
        """Keep the rows of a portion; one that is there already is left as it is."""
        entries = [
            (number, *of_row, *(None if math.isnan(each) else each for each in row.numbers), row.failure)
            for number, of_row, row in zip(numbers, values, rows, strict=True)
        ]
        marks = ", ".join("?" * (2 + len(self.paths) + len(self.names)))
        with self._changes() as changing:
            if changing.execute("insert or ignore into portions values (?)", (portion,)).rowcount:
                changing.executemany(f"insert into rows values ({marks})", entries)

    def __len__(self) -> int:
        (count,) = self._rows.execute("select count(*) from rows").fetchone()
        return int(count)

    def failures(self, most: int) -> list[tuple[str, int, int]]:
        """Return why rows failed, the commonest reason first: sentence, how many rows, the first of them."""
        asked = (
            "select failure, count(*) as times, min(number) from rows where failure is not null "
            "group by failure order by times desc, 3 limit ?"
        )
        return self._rows.execute(asked, (most,)).fetchall()

    def failed_count(self) -> int:
        """Return how many rows have failed."""
        (count,) = self._rows.execute("select count(failure) from rows").fetchone()
        return int(count)

    def failed(self) -> dict[int, str]:
        """Return the sentence of every row that failed, by its number."""
        return dict(self._rows.execute("select number, failure from rows where failure is not null order by number"))

    def column(self, name: str) -> NDArray[Any]:
        """Return a column of all rows in the order of their numbers; nan where a row has no number."""
        place = f"v{self.paths.index(name)}" if name in self.paths else f"n{self.names.index(name)}"
        found = [value for (value,) in self._rows.execute(f"select {place} from rows order by number")]
        if any(isinstance(value, str) for value in found):
            return np.array(found, dtype=object)
        return np.array([math.nan if value is None else value for value in found], dtype=float)

    def extremes(self, name: str) -> tuple[float, float] | None:
        """Return the smallest and the largest number of a column; None if it has none."""
        place = f"n{self.names.index(name)}"
        low, high = self._rows.execute(f"select min({place}), max({place}) from rows").fetchone()
        return None if low is None else (float(low), float(high))

    def head(self, units: Sequence[str]) -> list[str]:
        """Return the head of the table of all rows."""
        names = (*self.paths, *self.names)
        return [
            "row",
            *(f"{name} [{unit}]" if unit else name for name, unit in zip(names, units, strict=True)),
            "failure",
        ]

    def cells(self) -> Iterator[tuple[Any, ...]]:
        """Yield the cells of every row, with numbers to the last bit; a row that failed has its sentence."""
        found = self._rows.execute("select * from rows order by number")
        while page := found.fetchmany(_PAGE):
            yield from page

    def write_csv(self, path: Path, units: Sequence[str]) -> None:
        """Write all rows as CSV."""
        with path.open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(self.head(units))
            writer.writerows(self.cells())


def _closed(rows: sqlite3.Connection) -> None:
    with contextlib.suppress(sqlite3.ProgrammingError):  # in another thread, which must not close it
        rows.close()


def _opened(directory: Path | None) -> sqlite3.Connection:
    if directory is None:
        return sqlite3.connect(":memory:", isolation_level=None)
    try:
        directory.mkdir(parents=True, exist_ok=True)
        with contextlib.ExitStack() as if_refused:
            rows = sqlite3.connect(directory / FILE, isolation_level=None, timeout=1.0)
            if_refused.callback(rows.close)
            # Held until it is closed, or the process ends, however it ends.
            rows.execute("pragma locking_mode = exclusive")
            rows.execute("begin exclusive")
            rows.commit()
            if_refused.pop_all()
    except (OSError, sqlite3.Error) as error:
        locked = "locked" in str(error)
        reason = "a study that is under way uses it" if locked else (getattr(error, "strerror", None) or str(error))
        remedy = "wait until it has ended, or choose another" if locked else "choose another"
        condition = f"be a directory to write to ({reason.lower()})"
        raise InputError("--out", str(directory), condition, remedy) from None
    return rows


def _leaves(place: str, value: Any) -> Iterator[tuple[str, str]]:
    """Yield the single values in nested tables, by dotted path, each as JSON."""
    if isinstance(value, Mapping) and value:
        for key, entry in value.items():
            yield from _leaves(f"{place}.{key}" if place else str(key), entry)
    else:
        yield place, json.dumps(value, sort_keys=True, default=str)
