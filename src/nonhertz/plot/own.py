"""Drawings that are given no axes: each makes a figure of its own."""

from __future__ import annotations

import functools
import inspect
import re
from collections.abc import Callable
from typing import Any, ParamSpec, TypeVar

from nonhertz.plot.style import sheet_style

P = ParamSpec("P")
T = TypeVar("T")

#: Axes that a drawing is not given, so that it makes a figure of its own.
OWN: Any = None
OWN_SIZE = 6.7, 3.7  # inch

_SECTION = re.compile(r"\n\n[A-Z][a-z]+\n-+\n")


def drawing(draw: Callable[P, T], projection: str | None = None) -> Callable[P, T]:
    """Let a function that draws on ``ax`` do so in a figure of its own, in the style of the sheets, if it has none.

    Its docstring says of ``ax`` only what is particular; that it is optional, and returned, is the same for all.
    """
    signature = inspect.signature(draw)

    @functools.wraps(draw)
    def drawn(*args: P.args, **kwargs: P.kwargs) -> T:
        given = signature.bind(*args, **kwargs)
        if given.arguments.get("ax") is not None:
            return draw(*args, **kwargs)
        from matplotlib.figure import Figure

        with sheet_style():
            given.arguments["ax"] = Figure(figsize=OWN_SIZE, layout="constrained").add_subplot(projection=projection)
            return draw(*given.args, **given.kwargs)

    drawn.__doc__ = _with_axes(inspect.cleandoc(draw.__doc__ or ""), [*signature.parameters], projection)
    return drawn


def _with_axes(text: str, names: list[str], projection: str | None) -> str:
    """Return a docstring with what all drawings say of ``ax``, in its place among the parameters, and of the result."""
    kind = "matplotlib.projections.polar.PolarAxes" if projection == "polar" else "matplotlib.axes.Axes"
    head, mark, rest = text.partition("\n\nParameters\n----------\n")
    section = _SECTION.search(rest)
    parameters, others = (rest[: section.start()], rest[section.start() :]) if section else (rest, "")
    if not re.search(r"^ax : ", parameters, re.MULTILINE):
        later = "|".join(names[names.index("ax") + 1 :]) or "$^"
        place = re.search(rf"^({later})\b.* : ", f"{parameters}\n", re.MULTILINE)
        at = place.start() if place else len(parameters) + 1
        said = f"ax : {kind}, optional\n    Where to draw; if left out, in a figure of its own, ``ax.figure``.\n"
        parameters = (f"{parameters}\n"[:at] + said + f"{parameters}\n"[at:]).rstrip("\n")
    return f"{head}{mark}{parameters}\n\nReturns\n-------\n{kind}\n    ``ax``.{others}"
