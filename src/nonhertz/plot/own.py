"""Drawings that are given no axes: each makes a figure of its own."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from typing import Any, ParamSpec, TypeVar

from nonhertz.plot.style import sheet_style

P = ParamSpec("P")
T = TypeVar("T")

#: Axes that a drawing is not given, so that it makes a figure of its own.
OWN: Any = None
OWN_SIZE = 6.7, 3.7  # inch


def drawing(draw: Callable[P, T], projection: str | None = None) -> Callable[P, T]:
    """Let a function that draws on ``ax`` do so in a figure of its own, in the style of the sheets, if it has none."""
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

    return drawn
