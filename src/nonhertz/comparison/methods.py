"""`compare`: one case, solved three times."""

from __future__ import annotations

import functools
import statistics
import time
from collections.abc import Callable
from typing import Any, TypeVar

from nonhertz.comparison.quantities import quantities, stations
from nonhertz.comparison.value import Comparison, Seconds
from nonhertz.errors import ConvergenceError, InputError, without_accuracy_warnings
from nonhertz.inputs.checks import check_callback, thread_count
from nonhertz.model.contact import Contact
from nonhertz.patch import solve as solve_patch
from nonhertz.patch.resources import check_cells
from nonhertz.result.solution import Solution
from nonhertz.solver.one import Goal, Strips, solve
from nonhertz.strip.element import PARABOLIC, SEMI_ELLIPTIC, Element

RUNS = 5
Outcome = TypeVar("Outcome")


def compare(
    contact: Contact,
    *,
    approach: float | None = None,
    load: float | None = None,
    tilt: float | None = None,
    moment: float | None = None,
    cells: tuple[int, int] | None = None,
    strips: Strips = None,
    accuracy: float | None = None,
    accuracy_of: Goal | None = None,
    threads: int | None = None,
    callback: Callable[[str], object] | None = None,
) -> Comparison:
    """Solve a contact with strips of both elements and on a plane grid, and compare them.

    Parameters
    ----------
    contact : Contact
        The two bodies.
    approach, load, tilt, moment : float, optional
        Prescribed quantities, as in `nonhertz.solve`.
    cells : tuple of int, optional
        Number of cells (across, along) of the plane grid, as in `nonhertz.patch.solve`.
    strips : int or array_like or "auto", optional
        As in `nonhertz.solve`.
    accuracy, accuracy_of : optional
        As in `nonhertz.solve`.
    threads : int, optional
        Threads for the plane grid.
    callback : callable or None
        Called with the name of each method before it runs.

    Returns
    -------
    Comparison
        Comparison with the solutions, which contain their warnings; none are issued here.

    Raises
    ------
    InputError
        If one of the methods rejects the input, or nothing touches.
    ConvergenceError
        If one of the methods fails; the message says which.

    Examples
    --------
    >>> from nonhertz.model.body import Plate, Roller
    >>> from nonhertz.model.profile import crown
    >>> contact = Contact(Roller(diameter=20, length=20, profile=crown(radius=4000)), Plate())
    >>> compared = compare(contact, load=6e3, cells=(48, 96))
    >>> semi_elliptic, parabolic = compared.quantity("approach").differences
    >>> abs(semi_elliptic) < 1e-3 < abs(parabolic)
    True
    """
    check_callback(callback)
    if cells is not None:  # checked before the strips are solved
        check_cells(cells)
    if threads is not None:
        thread_count(threads)
    prescribed: dict[str, Any] = {"approach": approach, "load": load, "tilt": tilt, "moment": moment}

    def time_run(name: str, again: int, run: Callable[[], Outcome]) -> tuple[Outcome, float]:
        """Return an outcome and the median time of ``again`` further runs, or that of the first if there are none."""
        if callback is not None:
            callback(name)
        times = []
        try:
            for _ in range(1 + again):
                begin = time.perf_counter()
                outcome = run()
                times.append(time.perf_counter() - begin)
        except ConvergenceError as error:
            raise ConvergenceError(f"On {name}: {error}", error.solution) from None
        return outcome, statistics.median(times[1:] or times)

    def on_strips(element: Element) -> tuple[Solution, float]:
        aim: dict[str, Any] = {"strips": strips, "accuracy": accuracy, "accuracy_of": accuracy_of}
        return time_run(f"{element.name} strips", RUNS, lambda: solve(contact, **prescribed, element=element, **aim))

    with without_accuracy_warnings():
        (semi, of_semi), (parabola, of_parabola) = on_strips(SEMI_ELLIPTIC), on_strips(PARABOLIC)
        on_grid = functools.partial(solve_patch, contact, **prescribed, cells=cells, threads=threads)
        patch, of_patch = time_run("plane grid", 0, on_grid)
    if not patch.footprint.any():
        # An approach so small that strips touch but no cell centre does.
        raise InputError("approach", approach, "bring the bodies into contact", "give a larger one, or a load")
    return Comparison(
        semi_elliptic=semi,
        parabolic=parabola,
        patch=patch,
        seconds=Seconds(of_semi, of_parabola, of_patch, RUNS),
        quantities=quantities(semi, parabola, patch),
        stations=stations(semi, patch),
    )
