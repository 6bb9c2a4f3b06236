"""The sweep: a case or a bearing solved for all points of a plan, and saved on disk meanwhile."""

from __future__ import annotations

import contextlib
import json
import math
import time
from collections.abc import Callable, Container, Iterator, Mapping
from dataclasses import asdict, dataclass, replace
from functools import partial
from hashlib import sha256
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from nonhertz import __version__
from nonhertz.amounts import SI, current_units, display_units
from nonhertz.errors import InputError, Interrupted
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.folder import refuse_unwritable, write_files
from nonhertz.files.planfile import Plan, read_plan
from nonhertz.files.sampling import Sampling
from nonhertz.files.spreads import Distribution
from nonhertz.files.workbooks import INPUTS, inputs_table, refuse_too_many, write_workbook
from nonhertz.findings import Finding
from nonhertz.inputs.checks import check_callback, thread_count
from nonhertz.inputs.descriptions import unknown_key_error
from nonhertz.inputs.short_repr import shorten
from nonhertz.result.brief import HasHtml, plain_text
from nonhertz.result.data import library
from nonhertz.result.quantities import Quantity
from nonhertz.study.points import Points
from nonhertz.study.quantities import choose_quantities
from nonhertz.study.rows import Row, Work
from nonhertz.study.store import Store
from nonhertz.study.workers import LostError, Workers
from nonhertz.verdict import Verdict, judge_rows

if TYPE_CHECKING:
    import pandas as pd

# Rows in a portion, which one process solves and which is saved at once: the most that is lost when a study is stopped.
OF_CONTACTS, OF_BEARINGS = 256, 16  # for fewer rows, other processes would take longer to start
PORTIONS = 64  # least number of portions, for several processes to share, in a study of that many rows
WORTH_TIMING, TIMED = 16, 0.3  # rows above which their time is measured first, and the least duration of that [s]
REASONS = 5
SAMPLE = "sample"  # the level of a data frame that counts samples
_FEW_VALUES = 6

Portion = tuple[int, list[int], list[tuple[Any, ...]]]  # its number, those of its rows, and their values


@dataclass(frozen=True)
class Progress:
    """The progress of a study, which is passed to ``callback``.

    Attributes
    ----------
    done, total : int
        Number of solved rows, and of all rows.
    resumed : int
        Rows of an earlier run, from which it continues.
    seconds : float or None
        Only before the first row: estimated time of the missing rows, measured on a few of them; None if there are few,
        or on a cluster.
    """

    done: int
    total: int
    resumed: int
    seconds: float | None = None


class Sweep(HasHtml):
    """The rows of a plan.

    Attributes
    ----------
    plan : Plan
        The plan of the rows.
    paths : tuple of str
        The paths that are varied.
    quantities : tuple of Quantity
        The quantities in a row.
    shape : tuple of int
        Number of values of each path with a list, and of samples.
    """

    def __init__(self, plan: Plan, points: Points, quantities: tuple[Quantity, ...], store: Store) -> None:
        self.plan, self.paths, self.quantities = plan, points.paths, quantities
        self.shape = points.shape
        self._points, self._store = points, store
        self._verdicts: dict[int, Verdict | None] = {}

    def __len__(self) -> int:
        return len(self._points)

    def __repr__(self) -> str:
        rows = "row" if len(self) == 1 else "rows"
        title = f" of {self.plan.title!r}" if self.plan.title else ""
        lines = [f"{len(self)} {rows}{title} over {', '.join(self.paths)}"]
        if not self.complete:
            lines.append(f"{len(self._store)} of them are there")
        for quantity in self.quantities:
            ends = self.extremes(quantity.name)
            if ends is not None:
                lines.append(f"{quantity.label} {quantity.amount(*dict.fromkeys(ends), between=' to ')}")
        lines += [f"failed: {times} from row {first}: {shorten(why)}" for why, times, first in self.reasons()]
        return plain_text("Sweep", lines)

    @property
    def complete(self) -> bool:
        """Whether all rows are solved."""
        return len(self._store) == len(self)

    def __getitem__(self, name: str) -> NDArray[Any]:
        """Return the values of a path or a quantity for all rows, in its base unit; NaN where a row has failed.

        The shape is that of the sweep once all rows are solved; until then it is one-dimensional.

        Raises
        ------
        KeyError
            If the rows have no such column.
        """
        column = self._store.column(self._known(name, *self.paths))
        return column.reshape(self.shape) if self.complete else column

    @property
    def given(self) -> frozenset[str]:
        """Names of load quantities that the case or the plan gives, such as load and tilt: they are not results."""
        varied = {path.partition(".")[2] for path in self.paths if path.startswith("load.")}
        names = varied.union(self.plan.template.document.get("load", {}))
        return frozenset(names if "moment" in names else names | {"tilt"})

    @property
    def assumed(self) -> tuple[Finding, ...]:
        """The assumptions for inputs that the case leaves out, that decide results, and that are not varied."""
        varied = [f"{path} " for path in self.paths]
        notes = ((note, f"{dict(note.numbers)['keys']} ".replace(",", " ")) for note in self.plan.case.assumed)
        return tuple(note for note, keys in notes if not any(path in keys for path in varied))

    @property
    def verdict(self) -> Verdict | None:
        """Whether limits are met: the verdict on the row with the maximum pressure, which is solved once more.

        With several materials, the worst verdict on such a row of each. None if rows are missing, or have no pressure.
        """
        names = {quantity.name for quantity in self.quantities}
        if "max_pressure" not in names or not self.complete:
            return None
        varied = [self._store.column(path).tolist() for path in self.paths if ".material" in path]
        warned = self._store.column("warnings") if "warnings" in names else ()
        pressures = self._store.column("max_pressure")
        return judge_rows(pressures, self._verdict_on, list(zip(*varied, strict=True)), warned)

    def _verdict_on(self, row: int) -> Verdict | None:
        if row not in self._verdicts:
            values = dict(zip(self.paths, self._points.values([row])[0], strict=True))
            self._verdicts[row] = _work(self.plan, self.quantities).verdict(values)
        return self._verdicts[row]

    @property
    def failures(self) -> dict[int, str]:
        """The reasons why rows have failed, by number of the row, with the last axis changing fastest."""
        return self._store.failed()

    def reasons(self) -> list[tuple[str, int, int]]:
        """Return the commonest reasons why rows have failed: sentence, number of rows, the first of them.

        Stored sentences are in SI units: for other display units, the first row is solved once more.
        """
        failures = self._store.failures(REASONS)
        if current_units() is SI:
            return failures
        lost = str(LostError())
        return [(why if why == lost else self._reason(first, why), times, first) for why, times, first in failures]

    def _reason(self, row: int, failure: str) -> str:
        """Return why a row fails, in the display units."""
        (again,) = _work(self.plan, self.quantities).rows(self.paths, self._points.values([row]))
        return again.failure or failure

    @property
    def failed(self) -> int:
        """The number of failed rows."""
        return self._store.failed_count()

    def extremes(self, name: str) -> tuple[float, float] | None:
        """Return the smallest and the largest number of a quantity, in its base unit; None if no row has one.

        Raises
        ------
        KeyError
            If the rows have no such quantity.
        """
        return self._store.extremes(self._known(name))

    def unit(self, name: str) -> str:
        """Return the base unit of a path or a quantity; empty if it has none.

        Raises
        ------
        KeyError
            If the rows have no such column.
        """
        name = self._known(name, *self.paths)
        units = {quantity.name: quantity.unit for quantity in self.quantities}
        varied = self.plan.template.known[name].unit if name in self.paths else None
        return units.get(name) or varied or ""

    def _known(self, name: str, *others: str) -> str:
        known = (*others, *(quantity.name for quantity in self.quantities))
        if not isinstance(name, str) or name not in known:
            raise KeyError(str(unknown_key_error(str(name), name, known, "column")))
        return name

    def to_dataframe(self) -> pd.DataFrame:
        """Return a pandas DataFrame: a row for each point, a column for each quantity and one for the failure.

        The index has a level for each path that has a list of values and, with distributions, one for the number of the
        sample, whose values are columns. Units are in ``attrs["units"]``. Rows that are not solved yet are left out.

        Raises
        ------
        ImportError
            If pandas is not installed.
        """
        pandas = library("pandas", "to_dataframe")
        names = (*self.paths, *(quantity.name for quantity in self.quantities))
        frame = pandas.DataFrame({name: self._store.column(name) for name in names})
        failures, rows = self.failures, self._store.row_numbers()
        frame["failure"] = [failures.get(number, "") for number in rows.tolist()]
        axes = [*self.paths[: len(self._points.lists)]]
        if self._points.distributions:
            frame[SAMPLE] = rows % self.shape[-1]
            axes.append(SAMPLE)
        frame = frame.set_index(axes)
        frame.attrs["units"] = {name: self.unit(name) for name in names}
        return frame

    def save(
        self,
        folder: str | Path,
        draw_more: Callable[[Path], object] = lambda folder: None,
        *,
        excel: bool = False,
    ) -> tuple[Path, ...]:
        """Write all rows as rows.csv and, where polars is installed, as rows.parquet; return the files.

        Parameters
        ----------
        folder : str or Path
            Directory for the files; created if it does not exist.
        draw_more : callable
            Writes further files into the folder passed to it.
        excel : bool
            Whether to write rows.xlsx as well, with the varied inputs and the case on a second sheet.

        Raises
        ------
        InputError
            If the folder cannot be written to, or there are more rows than a sheet holds.
        ModuleNotFoundError
            If openpyxl is not installed, with ``excel``.
        """
        if excel:
            refuse_too_many("excel", len(self._store))
        names = (*self.paths, *(quantity.name for quantity in self.quantities))
        units = [self.unit(name) for name in names]

        def draw(into: Path) -> None:
            self._store.write_csv(into / "rows.csv", units)
            if excel:
                head, values = inputs_table([(self.plan.case.title, self.plan.case.document)])
                varied = (("varied", path, str(spread)) for path, spread in self.plan.over.items())
                rows = self._store.head(units), self._store.cells()
                write_workbook(into / "rows.xlsx", {"rows": rows, INPUTS: (head, chain(varied, values))})
            with contextlib.suppress(ImportError):
                import polars

                # As a stream: a study may have more rows than fit into memory.
                polars.scan_csv(into / "rows.csv", infer_schema_length=None).sink_parquet(into / "rows.parquet")
            draw_more(into)

        return write_files(folder, {}, draw)


def sweep(
    plan: Plan | Case | BearingCase | str | Path,
    *,
    over: Mapping[str, Any] | None = None,
    samples: Sampling | int | None = None,
    quantities: tuple[str, ...] | None = None,
    out: str | Path | None = None,
    workers: int | None = None,
    scheduler: str | None = None,
    callback: Callable[[Progress], object] | None = None,
) -> Sweep:
    """Solve a case or a bearing for many values of its inputs.

    Parameters
    ----------
    plan : Plan or Case or BearingCase or str or Path
        A plan, or the file of one; or a case, with ``over``.
    over : mapping, optional
        The values of each path of the case's file, as in `Plan`.
    samples : Sampling or int, optional
        How samples of distributions are drawn, as in `Plan`, or their number.
    quantities : tuple of str, optional
        Names of the results, such as ``("max_pressure", "life")``; by default those of the plan, or the usual ones.
    out : str or Path, optional
        Directory for the rows, which are saved as they are solved: a sweep that was stopped, even by a crash, continues
        when it is called again. Without a directory they are kept in memory.
    workers : int, optional
        Number of processes; all cores by default. The results do not depend on it.
    scheduler : str, optional
        Address of a Dask scheduler whose workers solve the rows in place of processes on this machine.
    callback : callable, optional
        Called with a `Progress` before the first row and whenever more rows are solved.

    Returns
    -------
    Sweep
        One row for each combination of values; ``sweep["max_pressure"]`` is an array of its ``shape``.

    Raises
    ------
    CaseError
        If a file has mistakes.
    InputError
        If a path does not exist, its values are missing or invalid, or ``out`` has the rows of another plan. Rows that
        fail do not stop the others: see `Sweep.failures`.
    Interrupted
        On Ctrl-C. Its ``solutions`` is the `Sweep` with the rows solved so far.
    ImportError
        If a scheduler is given and dask.distributed is not installed.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000))
    >>> case = nh.Case(nh.Contact(roller, nh.Plate()), {"load": 20e3}, {"strips": 41})
    >>> swept = nh.sweep(case, over={"load.load": "5 kN : 20 kN : 4", "body.a.profile.radius": [4e3, 8e3]})
    >>> swept.shape, swept["max_pressure"][3].round(-1)
    ((4, 2), array([2090., 1990.]))
    """
    check_callback(callback)
    study = make_plan(plan, over, samples, quantities)
    points = Points.of(study)
    numbers = choose_quantities(study.quantities, bearing=study.template.is_bearing)
    processes = thread_count(workers)
    solving = Workers(scheduler)
    directory = _check_directory(out)
    most = OF_BEARINGS if study.template.is_bearing else OF_CONTACTS
    size = min(most, math.ceil(len(points) / PORTIONS))
    origin = _describe_origin(study, points, numbers, size)
    store = Store(directory, origin, points.paths, origin["quantities"])
    result = Sweep(study, points, numbers, store)
    work, stored = _work(study, numbers), store.portions()
    progress = Progress(len(store), len(points), len(store))
    missing = partial(_list_missing, points, size, stored)
    try:
        with contextlib.closing(solving), contextlib.ExitStack() as stack:
            stack.callback(store.release)
            processes = 1 if len(points) - len(store) <= most else processes
            solve, count, seconds = partial(_solve_portion, work, points.paths), len(points) - len(store), None
            if callback is not None:
                if count >= WORTH_TIMING and scheduler is None:
                    seconds = count * _seconds_per_row(solve, next(missing())) / processes
                callback(replace(progress, seconds=seconds))
            for portion, solved in solving.portions(solve, missing(), processes):
                store.add(*portion, _rows_or_lost(solved, len(numbers), len(portion[1])))
                progress = replace(progress, done=progress.done + len(portion[1]))
                if callback is not None:
                    callback(progress)
    except KeyboardInterrupt:
        hint = "" if directory is None else f", which are kept in {directory}; the same call continues from there"
        raise Interrupted(f"Stopped after {len(store)} of {len(points)} rows{hint}.", result) from None
    return result


def _check_directory(out: object) -> Path | None:
    if out is None:
        return None
    if not isinstance(out, str | Path):
        raise InputError("out", out, "be the name of a directory", "give a string or a Path")
    refuse_unwritable(Path(out), "out")
    return Path(out)


def _list_missing(points: Points, size: int, stored: Container[int]) -> Iterator[Portion]:
    for portion, first in enumerate(range(0, len(points), size)):
        if portion not in stored:
            rows = points.solved_at(first, min(first + size, len(points))).tolist()
            yield portion, rows, points.values(rows)


def _rows_or_lost(solved: list[Row] | LostError, numbers: int, count: int) -> list[Row]:
    """Return solved rows, or as many without numbers where their process was lost."""
    return [Row((math.nan,) * numbers, str(solved))] * count if isinstance(solved, LostError) else solved


def _work(plan: Plan, quantities: tuple[Quantity, ...]) -> Work:
    return Work(plan.template, plan.case.attachments, tuple(quantity.name for quantity in quantities))


def _seconds_per_row(solve: Callable[[Portion], object], portion: Portion) -> float:
    """Return the time of a row, from the first rows of a portion: twice as many each time, until it can be measured."""
    number, rows, values = portion
    solve((number, rows[:1], values[:1]))  # loading modules is not counted
    count, took = 1, 0.0
    while True:
        begun = time.perf_counter()
        solve((number, rows[:count], values[:count]))
        took = (time.perf_counter() - begun) / count
        if count * took > TIMED or 2 * count > len(rows):
            return took
        count *= 2


@display_units("si")
def _solve_portion(work: Work, paths: tuple[str, ...], portion: Portion) -> list[Row]:
    """Return the rows of a portion; called in other processes."""
    return work.rows(paths, portion[2])


def make_plan(
    plan: object,
    over: Mapping[str, Any] | None,
    samples: Sampling | int | None,
    quantities: tuple[str, ...] | None,
    table: str = "over",
) -> Plan:
    """Return a plan from a plan, its file, or a case; arguments that are given replace its parts."""
    if isinstance(plan, str | Path):
        plan = read_plan(plan, table)
    if samples is not None and not isinstance(samples, Sampling):
        samples = Sampling(count=samples)
    if isinstance(plan, Plan):
        return plan.changed(over=over, samples=samples, quantities=quantities)
    if not isinstance(plan, Case | BearingCase):
        remedy = "read one with nonhertz.read_case, nonhertz.read_bearing or nonhertz.read_plan"
        raise InputError("plan", plan, "be a plan, its file, a case or a bearing case", remedy)
    return Plan(plan).changed(over=over, samples=samples, quantities=quantities)


def _describe_origin(plan: Plan, points: Points, numbers: tuple[Quantity, ...], size: int) -> dict[str, Any]:
    """Return the origin of the rows, and the size of their portions."""
    return {
        "nonhertz": __version__,
        "case": plan.template.document,
        "files": {name: sha256(content).hexdigest() for name, content in plan.case.attachments.items()},
        "over": {
            path: asdict(spread) if isinstance(spread, Distribution) else _shorten_list(spread)
            for path, spread in plan.spreads.items()
        },
        "samples": asdict(plan.samples) if points.distributions else {},
        "quantities": [quantity.name for quantity in numbers],
        "rows in a portion": size,
    }


def _shorten_list(values: tuple[Any, ...]) -> Any:
    """Return a list of values, or a summary of a long one, so that differences can be named in a few words."""
    if len(values) <= _FEW_VALUES:
        return list(values)
    whole = sha256(json.dumps(values).encode()).hexdigest()
    return {"number of values": len(values), "first": values[0], "last": values[-1], "digest": whole}
