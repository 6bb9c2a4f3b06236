"""A measured profile on one sheet: a panel for every step, and the resulting relief."""

from __future__ import annotations

from nonhertz.figures.measured import measured_steps
from nonhertz.measured import Measured, ProfileFit
from nonhertz.plot.axes import Figure
from nonhertz.plot.drawer import sheet_of
from nonhertz.plot.style import sheet_style


def measured_figure(measured: Measured, title: str = "", fit: ProfileFit | None = None) -> Figure:
    """Return a sheet of the steps of a measured profile, from the raw trace to the relief.

    See `nonhertz.figures.measured.measured_steps` for what it shows.

    Parameters
    ----------
    measured : Measured
        The trace and its steps.
    title : str
        Heading; none if empty.
    fit : ProfileFit or None
        A profile of the catalogue to draw beside the relief.

    Returns
    -------
    matplotlib.figure.Figure
        ``nonhertz.plot.save`` writes it.
    """
    with sheet_style():
        return sheet_of(measured_steps(measured, fit), title)
