"""The rows of a study on disk, in a form that survives an interruption at any moment.

A database stores portions of rows, each completely or not at all, together with a record of the portion. So the rows
that are missing after a crash are known, and none is stored twice. It also contains the origin of the rows: a study
that has changed since is refused, and the differences are named.
"""

from __future__ import annotations

import contextlib
import csv
import json
import math
import re
import sqlite3
import weakref
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.inputs.short_repr import shorten
from nonhertz.study.rows import Row

FILE = "rows.sqlite3"
_DIGEST = re.compile('"[0-9a-f]{64}"')
# Errors of SQLite for a directory that cannot be written to; all other errors mean damage.
_PLACE = ("SQLITE_IOERR", "SQLITE_READONLY", "SQLITE_CANTOPEN", "SQLITE_PERM", "SQLITE_AUTH")
_TABLES = """
create table made_from (place text primary key, value text not null) without rowid;
create table portions (number integer primary key);
"""


class Store:
    """Rows of a study, in a directory or in memory.

    Parameters
    ----------
    directory : Path or None
        The directory of the rows; created if it does not exist. None keeps them in memory.
    made_from : mapping
        Origin of the rows, as JSON values: the case, the varied inputs, the quantities.
    paths, names : sequence of str
        Varied paths, and quantities of a row.

    Raises
    ------
    InputError
        If the directory has rows of another plan or a damaged file, is in use, or cannot be written to. Every method
        raises the same error if the disk is full or the file is damaged.
    """

    def __init__(
        self, directory: Path | None, made_from: Mapping[str, Any], paths: Sequence[str], names: Sequence[str]
    ) -> None:
        self._directory, self.paths, self.names = directory, tuple(paths), tuple(names)
        self._rows = _open(directory)
        weakref.finalize(self, _close, self._rows)
        try:
            with _refuse_damage(directory):
                self._begin(dict(_leaves("", made_from)))
        except BaseException:
            self._rows.close()
            raise

    def _begin(self, made_from: Mapping[str, str]) -> None:
        if self._rows.execute("select 1 from sqlite_master").fetchone() is None:
            columns = ", ".join(f"v{k}" for k in range(len(self.paths)))
            numbers = ", ".join(f"n{k} real" for k in range(len(self.names)))
            with self._transaction() as rows:
                for statement in _TABLES.split(";"):
                    rows.execute(statement)
                rows.execute(f"create table rows (number integer primary key, {columns}, {numbers}, failure text)")
                rows.executemany("insert into made_from values (?, ?)", made_from.items())
            return
        self._check()
        before = dict(self._read("select place, value from made_from"))
        different = [place for place in {**before, **made_from} if before.get(place) != made_from.get(place)]
        if different:
            raise self._changed_error(different, before, made_from)

    def _check(self) -> None:
        """Raise the error of SQLite for a damaged file if this one is damaged."""
        answer = self._read("pragma quick_check(1)")[0][0]
        other = " or ".join(f"typeof(n{k}) not in ('real', 'null')" for k in range(len(self.names)))
        if answer != "ok" or self._read(f"select 1 from rows where {other} limit 1"):
            raise sqlite3.DatabaseError(answer if answer != "ok" else "text where numbers belong")

    def _read(self, statement: str, *values: Any) -> list[tuple[Any, ...]]:
        with _refuse_damage(self._directory):
            return self._rows.execute(statement, values).fetchall()

    def _changed_error(self, places: Sequence[str], before: Mapping[str, str], now: Mapping[str, str]) -> InputError:
        changes = []
        for place in places[:3]:
            was, is_now = (shorten(contents.get(place, "not given")) for contents in (before, now))
            same_kind = all(_DIGEST.fullmatch(contents.get(place, "")) for contents in (before, now))
            change = "has other contents" if same_kind else f"was {was}, is {is_now}"
            changes.append(f"{place.removesuffix('.digest')} {change}")
        more = f"; and {len(places) - 3} more" if len(places) > 3 else ""
        condition = f"hold rows of the same plan, but {'; '.join(changes)}{more}"
        remedy = "choose another directory, or put the plan back as it was"
        return InputError("out", str(self._directory), condition, remedy)

    @contextlib.contextmanager
    def _transaction(self) -> Iterator[sqlite3.Connection]:
        """Make changes that are kept whole, or not at all."""
        with _refuse_damage(self._directory):
            self._rows.execute("begin immediate")
            try:
                yield self._rows
                self._rows.commit()
            except BaseException:
                if self._rows.in_transaction:  # SQLite has ended it if the disk is full
                    self._rows.rollback()
                raise

    def release(self) -> None:
        """Let others use the directory; the stored rows can still be read."""
        self._read("pragma locking_mode = normal")
        self._read("select count(*) from portions")

    def portions(self) -> set[int]:
        """Return the numbers of the stored portions."""
        return {number for (number,) in self._read("select number from portions")}

    def add(self, portion: int, numbers: Iterable[int], values: Iterable[Sequence[Any]], rows: Iterable[Row]) -> None:
        """Store the rows of a portion; one that is already stored is left unchanged."""
        entries = [
            (number, *of_row, *(None if math.isnan(value) else value for value in row.numbers), row.failure)
            for number, of_row, row in zip(numbers, values, rows, strict=True)
        ]
        marks = ", ".join("?" * (2 + len(self.paths) + len(self.names)))
        with self._transaction() as changing:
            if changing.execute("insert or ignore into portions values (?)", (portion,)).rowcount:
                changing.executemany(f"insert into rows values ({marks})", entries)

    def __len__(self) -> int:
        return int(self._read("select count(*) from rows")[0][0])

    def failures(self, most: int) -> list[tuple[str, int, int]]:
        """Return why rows failed, the commonest reason first: sentence, how many rows, the first of them."""
        statement = (
            "select failure, count(*) as times, min(number) from rows where failure is not null "
            "group by failure order by times desc, 3 limit ?"
        )
        return [(why, times, first) for why, times, first in self._read(statement, most)]

    def failed_count(self) -> int:
        """Return how many rows have failed."""
        return int(self._read("select count(failure) from rows")[0][0])

    def failed(self) -> dict[int, str]:
        """Return the sentence of every row that failed, by its number."""
        return dict(self._read("select number, failure from rows where failure is not null order by number"))

    def column(self, name: str) -> NDArray[Any]:
        """Return a column of all rows in the order of their numbers; NaN where a row has no number."""
        place = f"v{self.paths.index(name)}" if name in self.paths else f"n{self.names.index(name)}"
        values = [value for (value,) in self._read(f"select {place} from rows order by number")]
        if any(isinstance(value, str) for value in values):
            return np.array(values, dtype=object)
        return np.array([math.nan if value is None else value for value in values], dtype=float)

    def row_numbers(self) -> NDArray[np.int64]:
        """Return the numbers of all rows that are there, ascending."""
        return np.array([number for (number,) in self._read("select number from rows order by number")], dtype=np.int64)

    def extremes(self, name: str) -> tuple[float, float] | None:
        """Return the smallest and the largest number of a column; None if it has none."""
        place = f"n{self.names.index(name)}"
        low, high = self._read(f"select min({place}), max({place}) from rows")[0]
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
        with _refuse_damage(self._directory):
            yield from self._rows.execute("select * from rows order by number")

    def write_csv(self, path: Path, units: Sequence[str]) -> None:
        """Write all rows as CSV."""
        with path.open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(self.head(units))
            writer.writerows(self.cells())


def _close(rows: sqlite3.Connection) -> None:
    with contextlib.suppress(sqlite3.ProgrammingError):  # in another thread, which must not close it
        rows.close()


def _open(directory: Path | None) -> sqlite3.Connection:
    if directory is None:
        return sqlite3.connect(":memory:", isolation_level=None)
    with _refuse_damage(directory), contextlib.ExitStack() as if_refused:
        directory.mkdir(parents=True, exist_ok=True)
        rows = sqlite3.connect(directory / FILE, isolation_level=None, timeout=1.0)
        if_refused.callback(rows.close)
        # Held until it is closed, or the process ends, however it ends.
        rows.execute("pragma locking_mode = exclusive")
        rows.execute("begin exclusive")
        rows.commit()
        if_refused.pop_all()
    return rows


@contextlib.contextmanager
def _refuse_damage(directory: Path | None) -> Iterator[None]:
    """Refuse a directory of which the system or SQLite reports that it is in use, full, not writable or damaged."""
    try:
        yield
    except sqlite3.ProgrammingError:  # ours
        raise
    except (OSError, sqlite3.Error, UnicodeDecodeError) as error:  # the last from a damaged schema
        kind = getattr(error, "sqlite_errorname", "")
        reason = " ".join(str(getattr(error, "strerror", None) or error).lower().split())
        condition, remedy = f"be a directory to write to ({reason})", "choose another"
        if kind.startswith(("SQLITE_BUSY", "SQLITE_LOCKED")):
            condition = "be a directory to write to (a running study uses it)"
            remedy = "wait until it ends, or choose another"
        elif kind.startswith("SQLITE_FULL"):
            condition = "be a directory with space for more rows (no space left on device)"
            remedy = "free some space and repeat: the rows so far are kept"
        elif not isinstance(error, OSError) and not kind.startswith(_PLACE):
            condition = f"hold an intact {FILE} (the store is damaged: {shorten(reason)})"
            remedy = f"delete {FILE} to solve all rows anew, or choose another directory"
        raise InputError("out", str(directory), condition, remedy) from None


def _leaves(place: str, value: Any) -> Iterator[tuple[str, str]]:
    """Yield the single values in nested tables, by dotted path, each as JSON."""
    if isinstance(value, Mapping) and value:
        for key, entry in value.items():
            yield from _leaves(f"{place}.{key}" if place else str(key), entry)
    else:
        yield place, json.dumps(value, sort_keys=True, default=str)
