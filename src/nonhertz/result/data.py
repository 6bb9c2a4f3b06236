"""Solutions in other libraries: pandas with one row per case, xarray with one dimension per axis of the map."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
from numpy.typing import NDArray

from nonhertz.result.quantities import QUANTITIES

if TYPE_CHECKING:
    import pandas as pd
    import xarray as xr


class ManySolved(Protocol):
    """The part of `nonhertz.Solutions` that the conversions read."""

    shape: tuple[int, ...]
    singular: NDArray[np.bool_]

    @property
    def converged(self) -> NDArray[np.bool_]:
        """Which cases have a solution."""

    def column(self, name: str) -> NDArray[np.float64]:
        """Return a quantity for all cases."""


def dataframe(solutions: ManySolved) -> pd.DataFrame:
    """Return a DataFrame with a row for each case; see `nonhertz.Solutions.to_dataframe`."""
    pandas, names = library("pandas", "to_dataframe"), _axes(solutions)
    index = pandas.MultiIndex.from_product([range(length) for length in solutions.shape], names=names)
    if len(names) == 1:
        index = index.get_level_values(0)
    frame = pandas.DataFrame({name: column.ravel() for name, column in _columns(solutions).items()}, index=index)
    frame.attrs["units"] = {name: quantity.unit for name, quantity in QUANTITIES.items()}
    return frame


def dataset(solutions: ManySolved) -> xr.Dataset:
    """Return a Dataset with a variable for each quantity; see `nonhertz.Solutions.to_xarray`."""
    xarray, names = library("xarray", "to_xarray"), _axes(solutions)
    data: xr.Dataset = xarray.Dataset(
        {name: (names, column, _attributes(name)) for name, column in _columns(solutions).items()},
        coords={name: range(length) for name, length in zip(names, solutions.shape, strict=True)},
    )
    return data


def _axes(solutions: ManySolved) -> list[str]:
    several = len(solutions.shape) > 1
    return [f"axis_{number}" for number in range(len(solutions.shape))] if several else ["case"]


def _columns(solutions: ManySolved) -> dict[str, Any]:
    """Return all quantities by name, and which cases have singular ends and which a solution."""
    columns = {name: solutions.column(name) for name in QUANTITIES}
    return {**columns, "singular": solutions.singular, "converged": solutions.converged}


def _attributes(name: str) -> dict[str, str]:
    quantity = QUANTITIES.get(name)
    return {} if quantity is None else {"units": quantity.unit, "long_name": quantity.label}


def library(name: str, caller: str, extra: str = "data", package: str | None = None) -> Any:
    """Return an optional library, imported now.

    Parameters
    ----------
    name : str
        The library.
    asked : str
        What needs it, for the error.
    extra : str
        The extra of this package that installs it.
    package : str, optional
        What it is installed as, if not by its name.

    Raises
    ------
    ImportError
        If it is not installed.
    """
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(
            f"{caller} needs {package or name}: install it, or nonhertz with the extra '{extra}'."
        ) from error
