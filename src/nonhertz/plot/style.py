"""The look that all figures share: colours, line widths and the settings of the finished sheets.

The colours are distinguishable with any colour vision (Okabe and Ito's blue and vermilion, and the viridis map),
and every pair of lines also differs in dash pattern, for printing in grey.
"""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

FIRST, SECOND = "#0072B2", "#D55E00"
INK, FAINT_INK, PALE = "#222222", "#777777", "#E9EEF2"
COLOUR_MAP = "viridis"

#: By the names that figures give them.
COLOURS = {
    "first": FIRST, "second": SECOND, "third": "#009E73", "fourth": "#CC79A7", "fifth": "#B08A00", "ink": INK,
    "faint": FAINT_INK, "paper": "white",
}  # fmt: skip

LINE, THIN, HAIR = 1.3, 0.7, 0.4
END_DASHES = (0, (7, 2, 1.5, 2))  # the dash-dot line of engineering drawings
HINT_DASHES = (0, (1, 2))

# Background of text that may lie on a thin line.
BACKING: dict[str, Any] = {"facecolor": "white", "alpha": 0.85, "edgecolor": "none", "pad": 1.0}

SIZE, SMALL_SIZE, TITLE_SIZE = 8.5, 7.5, 10.0

# Differences from matplotlib's own settings. DejaVu Sans comes with matplotlib: a figure looks the same on every
# machine. Letters become outlines in SVG for the same reason. The salt makes the identifiers in an SVG file, random by
# default, a function of its content.
SETTINGS: Any = {
    "font.family": "DejaVu Sans",
    "font.size": SIZE,
    "axes.labelsize": SIZE,
    "axes.titlesize": SIZE,
    "axes.linewidth": 0.6,
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "text.color": INK,
    "xtick.labelsize": SIZE,
    "ytick.labelsize": SIZE,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.major.size": 3.0,
    "ytick.major.size": 3.0,
    "legend.fontsize": SMALL_SIZE,
    "legend.frameon": False,
    "svg.fonttype": "path",
    "svg.hashsalt": "nonhertz",
}

# matplotlib's settings belong to the whole process. Two threads that change and restore them at the same time
# (two requests to the web page) could each restore the other's.
_LOCK = threading.RLock()


@contextmanager
def sheet_style() -> Iterator[None]:
    """Draw the body of a ``with`` statement in the style of the sheets, whatever is set, then put all back."""
    from matplotlib import style

    with _LOCK, style.context(["default", SETTINGS]):
        yield
