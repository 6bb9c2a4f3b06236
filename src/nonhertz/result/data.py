"""Solutions in other libraries: pandas with one row per case, xarray with one dimension per axis of the map."""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Protocol, cast

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
    axes: Mapping[str, NDArray[Any]]

    @property
    def converged(self) -> NDArray[np.bool_]:
        """Which cases have a solution."""

    def column(self, name: str) -> NDArray[np.float64]:
        """Return a quantity for all cases."""


def dataframe(solutions: ManySolved) -> pd.DataFrame:
    """Return a DataFrame with a row for each case; see `nonhertz.Solutions.to_dataframe`."""
    pandas, axes = library("pandas", "to_dataframe"), solutions.axes
    columns = {name: column.ravel() for name, column in _columns(solutions).items() if name not in axes}
    frame = pandas.DataFrame(columns, index=product_index(pandas, axes))
    frame.attrs["units"] = {name: quantity.unit for name, quantity in QUANTITIES.items()}
    return frame


def dataset(solutions: ManySolved) -> xr.Dataset:
    """Return a Dataset with a variable for each quantity; see `nonhertz.Solutions.to_xarray`."""
    xarray, axes = library("xarray", "to_xarray"), solutions.axes
    columns = {name: column for name, column in _columns(solutions).items() if name not in axes}
    data: xr.Dataset = xarray.Dataset(
        {name: (list(axes), column, _attributes(name)) for name, column in columns.items()},
        coords={name: (name, values, _attributes(name)) for name, values in axes.items()},
    )
    return data


def name_axes(
    inputs: Mapping[str, NDArray[Any]], shape: tuple[int, ...], other: str = "case"
) -> dict[str, NDArray[Any]]:
    """Return the axes of broadcast inputs by the name of the one that varies along each, with its values.

    An axis along which none varies, or several, or one that also varies along another axis, is named ``other``,
    numbered if there are several such axes, and its values count from 0.

    Parameters
    ----------
    inputs : mapping of str to ndarray, shape (...)
        The inputs, broadcast.
    shape : tuple of int
        The shape of the axes, "(...)" above.
    other : str
        Name of an axis without an input.
    """
    varying = {
        name: [axis for axis in range(len(shape)) if np.any(values != np.take(values, [0], axis))]
        for name, values in inputs.items()
    }
    axes: dict[str, NDArray[Any]] = {}
    for axis, length in enumerate(shape):
        along = [name for name, varies in varying.items() if axis in varies]
        if len(along) == 1 and varying[along[0]] == [axis]:
            first = tuple(slice(None) if number == axis else 0 for number in range(len(shape)))
            axes[along[0]] = inputs[along[0]][first]
        else:
            axes[other if len(shape) == 1 else f"{other}_{axis}"] = np.arange(length)
    return axes


def product_index(pandas: Any, axes: Mapping[str, NDArray[Any]]) -> pd.Index[Any]:
    """Return the pandas index of all combinations of axes: a level for each, or a plain index of one or none."""
    if not axes:
        return cast("pd.Index[Any]", pandas.RangeIndex(1))
    if len(axes) == 1:
        ((name, values),) = axes.items()
        return cast("pd.Index[Any]", pandas.Index(values, name=name))
    return cast("pd.Index[Any]", pandas.MultiIndex.from_product(axes.values(), names=list(axes)))


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
    caller : str
        Name of the caller, for the error.
    extra : str
        The extra of this package that installs it.
    package : str, optional
        Name of its package, if that differs.

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
