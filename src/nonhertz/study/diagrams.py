"""Diagrams of a bearing: life, pressure, stiffness and film over one of its inputs, all others fixed."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.amounts import of_dimension
from nonhertz.bearing.fits import Range
from nonhertz.bearing.quantities import QUANTITIES
from nonhertz.errors import InputError
from nonhertz.figures.value import Across, Axis, Figure, Line, Mark, Panel, Points, Span
from nonhertz.files.bearingfile import BearingCase, read_bearing
from nonhertz.files.paths import Parameter, find_parameter
from nonhertz.files.planfile import Plan
from nonhertz.files.spreads import parse_number
from nonhertz.files.studies import DIAGRAM, as_text
from nonhertz.inputs.checks import is_number
from nonhertz.plot import save_all
from nonhertz.plot.drawer import sheets_of
from nonhertz.result.brief import HasHtml, plain_text
from nonhertz.result.quantities import Quantity
from nonhertz.study.figures import in_words
from nonhertz.study.sweeps import Progress, Sweep, sweep

Array = NDArray[np.float64]

POINTS = 41
#: The quantities of a diagram: the first one in each line that has numbers.
SHOWN = (
    ("modified_life", "reference_life", "basic_life"),
    ("max_pressure", "max_load"),
    ("stiffness_y", "stiffness_z"),
    ("stiffness_x",),
    ("film_parameter", "least_film"),
)
LIFE = SHOWN[0]
#: Tables in which a key without a path is searched.
_PAIR = "bearing.pair."
TABLES = ("load.", _PAIR, "bearing.", "lubrication.")
_WAY_OUT = "change the range, or related inputs of the file"


@dataclass(frozen=True, eq=False, repr=False)
class Diagram(HasHtml):
    """Numbers of a bearing over one of its inputs, made by `diagram`.

    Attributes
    ----------
    sweep : Sweep
        The rows, each with a value of the input in its base unit.
    """

    sweep: Sweep

    def __repr__(self) -> str:
        amount = of_dimension(self.values[[0, -1]].tolist(), self.sweep.unit(self.path))
        lines = [f"{len(self.sweep)} rows over {self.path}, {amount:g}"]
        for quantity in self.quantities:
            low, high = self.sweep.extremes(quantity.name) or (np.nan, np.nan)
            lines.append(f"{quantity.label} {quantity.amount(low, high, between=' to '):4}")
        return plain_text("Diagram", lines)

    @property
    def path(self) -> str:
        """The input that is varied."""
        return self.sweep.paths[0]

    @property
    def values(self) -> Array:
        """Its values, shape (n,), ascending, in the base unit."""
        return np.asarray(self.sweep[self.path], dtype=float)

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The quantities shown: life, pressure (load by slices), stiffness and film, if they are known."""
        known = {quantity.name: quantity for quantity in self.sweep.quantities}
        shown = (next((known[name] for name in names if name in known and self._has(name)), None) for names in SHOWN)
        return tuple(quantity for quantity in shown if quantity is not None)

    @property
    def present(self) -> float | None:
        """The value in the file; None if it has none, or a class."""
        plan = self.sweep.plan
        return _value(plan.template.known[self.path], plan.template.document)

    @property
    def class_limits(self) -> Range | None:
        """The limits of the input by the class in the file, a group of clearance; None if it has none."""
        case = self.sweep.plan.case
        assert isinstance(case, BearingCase)
        if self.path != "bearing.clearance":
            return None
        limits = case.bearing.rows[0].bearing.clearance_range
        return None if limits.known else limits

    @property
    def longest_life(self) -> tuple[float, float] | None:
        """The value with the longest life, and that life [10^6 revolutions]; None without a life."""
        for quantity in self.quantities:
            if quantity.name in LIFE:
                lives = self.sweep[quantity.name]
                best = int(np.nanargmax(lives))
                return float(self.values[best]), float(lives[best])
        return None

    def figure(self) -> Figure:
        """Return the diagram as a figure: a panel for each quantity over the input."""
        amount = of_dimension(self.values.tolist(), self.sweep.unit(self.path))
        label = in_words(self.path)
        along = Axis(label, label.lower(), amount.unit, amount.read, (float(self.values[0]), float(self.values[-1])))
        panels = [self._panel(quantity, along, first=not k) for k, quantity in enumerate(self.quantities)]
        names = ", ".join(quantity.label for quantity in self.quantities)
        case = self.sweep.plan.case
        assert isinstance(case, BearingCase)
        conditions = f"by {case.solver.method}, other inputs as in the file"
        return Figure(along, panels, conditions, f"{names[:1].upper()}{names[1:]} over the {label.lower()}.")

    def save(self, folder: str | Path) -> tuple[Path, ...]:
        """Write diagram.json, all rows as rows.csv and, with polars, as rows.parquet, and the figure ``diagram``.

        Parameters
        ----------
        folder : str or Path
            Created if it does not exist; files of these names are replaced, all of them or none.

        Raises
        ------
        InputError
            If the folder cannot be written to.
        """

        def draw(drafts: Path) -> None:
            (drafts / "diagram.json").write_text(self.to_json() + "\n", encoding="utf-8")
            save_all(sheets_of({"diagram": self.figure()}, self.sweep.plan.case.title), drafts)

        return self.sweep.save(folder, draw)

    def to_json(self) -> str:
        """Return all numbers as JSON text."""
        return as_text(DIAGRAM, diagram=self, sweep=self.sweep)

    def _panel(self, quantity: Quantity, along: Axis, *, first: bool) -> Panel:
        numbers = np.asarray(self.sweep[quantity.name], dtype=float)
        marks: list[Mark] = [Line(self.values, numbers)]
        if self.class_limits is not None:
            group = str(self.sweep.plan.template.document["bearing"]["clearance"])
            marks.insert(
                0, Span(self.class_limits.least, self.class_limits.greatest, name=group * first, colour="faint")
            )
        if self.present is not None and along.range is not None and along.range[0] <= self.present <= along.range[1]:
            marks.insert(0, Across(self.present, "in the file" * first, colour="faint", dash="dashed"))
        if quantity.name in LIFE and self.longest_life is not None:
            value, life = self.longest_life
            at = f"{of_dimension([value], along.unit):.3g}"
            marks.append(Points(np.array([value]), np.array([life]), name=f"longest life, at {at}"))
        low, high = (quantity.amount(float(end(numbers))) for end in (np.nanmin, np.nanmax))
        words = quantity.label[:1].upper() + quantity.label[1:]
        return Panel(
            quantity.name, words, Axis(words, quantity.symbol, quantity.unit, quantity.shown_unit), marks,
            f"{words} over the {along.label.lower()}: from {low:.4g} to {high:.4g}.", height=190,
        )  # fmt: skip

    def _has(self, name: str) -> bool:
        """Return whether a quantity has numbers other than zero; stiffness along a free direction has not."""
        ends = self.sweep.extremes(name)
        return ends is not None and max(map(abs, ends)) > 0.0


def diagram(
    case: BearingCase | str | Path,
    over: str,
    values: str | Sequence[float],
    *,
    workers: int | None = None,
    callback: Callable[[Progress], object] | None = None,
) -> Diagram:
    """Solve a bearing for many values of one input.

    Parameters
    ----------
    case : BearingCase or str or Path
        The bearing, or its file.
    over : str
        The input: a path of the file, or the last word of a path in its tables of the load, the pair or the bearing,
        such as ``"clearance"``, which for a pair is that of the pair; ``"load"`` is the radial load.
    values : str or sequence of float
        Its values: a range such as ``"0 : 60 um"``, with 41 values, or ``"0 : 60 um : 21"``, or numbers in the base
        unit.
    workers, callback
        As for `nonhertz.sweep`; by slices one process by default.

    Returns
    -------
    Diagram

    Raises
    ------
    CaseError
        If the file has mistakes.
    InputError
        If it is not a bearing, there is no such input, values are invalid, or no value has a solution.

    Examples
    --------
    >>> import nonhertz as nh
    >>> case = nh.new_bearing(changes={"solver.method": "slices"})
    >>> made = nh.study.diagram(case, "clearance", "0 : 60 um : 4")
    >>> [quantity.name for quantity in made.quantities]
    ['modified_life', 'max_load', 'stiffness_y', 'least_film']
    >>> clearance, life = made.longest_life
    >>> round(1e3 * clearance), round(life)
    (0, 107)
    """
    if not isinstance(case, BearingCase | str | Path):
        condition = "be a BearingCase, or the name of a bearing file"
        raise InputError("case", case, condition, "make one with nonhertz.BearingCase or nonhertz.new_bearing")
    case = read_bearing(case) if isinstance(case, str | Path) else case
    plan = Plan(case)
    if workers is None and case.solver.method == "slices":
        workers = 1  # slices take less time than starting a process
    names = tuple(name for names in SHOWN for name in names if name in QUANTITIES)
    if isinstance(values, str) and values.count(":") == 1:
        values = f"{values} : {POINTS}"
    rows = sweep(plan, over={_path(over, plan): values}, quantities=names, workers=workers, callback=callback)
    made = Diagram(rows)
    if not made.quantities:
        reason = next((why for why, _, _ in rows.reasons()), "no row has a number")
        raise InputError(over, values, f"have a solution at one of its values ({reason.rstrip('.')})", _WAY_OUT)
    return made


def _path(word: str, plan: Plan) -> str:
    """Return the path of an input, which may be given by its last word."""
    document, known = plan.template.document, plan.template.known
    if isinstance(word, str) and "." not in word:
        word = {"load": "radial"}.get(word, word)
        tables = (table for table in TABLES if table != _PAIR or "pair" in document.get("bearing", {}))
        word = next((table + word for table in tables if table + word in known), word)
    return find_parameter(word, known).path


def _value(read: Parameter, document: Mapping[str, Any]) -> float | None:
    """Return the number at a path of a document; None if there is none."""
    value = read.value_in(document)
    if isinstance(value, str):
        with contextlib.suppress(InputError):
            return parse_number(read.path, value, read.unit or "")
    return float(value) if is_number(value) else None
