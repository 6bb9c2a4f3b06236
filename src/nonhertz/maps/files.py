"""Maps on disk: NPZ without pickles, checked as it is read."""

from __future__ import annotations

import dataclasses
import os
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from nonhertz.inputs.archives import Archive, text
from nonhertz.maps.evaluation import (
    HIGH_END,
    LOAD_CELLS,
    LOW_END,
    MOST_LOAD,
    NARROW,
    QUANTILES,
    TILT_CELLS,
    TILT_HIGH,
    TILT_LOW,
    WIDENING,
)
from nonhertz.maps.misses import SampledErrors
from nonhertz.maps.spline import DEGREE

if TYPE_CHECKING:
    from nonhertz.maps.value import ContactMap

ARCHIVE = Archive(
    kind="nonhertz map",
    version=1,
    contents="a map",
    undamaged="an undamaged map",
    most=200_000_000,
    remedy="give a file that ContactMap.save or 'nonhertz map' wrote",
    again="make the map again with this nonhertz",
)
_TEXTS, _ARRAYS = ("description", "given"), ("numbers", "breaks", "mean_approach", "others", "stations")
_NUMBERS, _COUNTS = ("half_length", "accuracy"), ("cases", "failed")


def save(path: str | os.PathLike[str], made: ContactMap) -> None:
    """Write a map."""
    fields = {name: getattr(made, name) for name in (*_TEXTS, *_ARRAYS, *_NUMBERS, *_COUNTS, "pressed")}
    ARCHIVE.save(path, fields | {"sampled_error": np.array(dataclasses.astuple(made.sampled_error), dtype=float)})


def load(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Return the fields of a map."""
    fields = _fields(ARCHIVE.load(path))
    if fields is None:
        raise ARCHIVE.damaged_error(path)
    return fields


def _fields(entries: Mapping[str, np.ndarray[Any, Any]]) -> dict[str, Any] | None:
    """Return the fields of a map, or None if they are incomplete or do not fit together."""
    floats = {*_ARRAYS, *_NUMBERS, "pressed", "sampled_error"}
    for name in (*floats, *_COUNTS):
        values = entries.get(name)
        if values is None or values.dtype != (np.int64 if name in _COUNTS else np.float64):
            return None
        shape = {"pressed": (2,), "sampled_error": (len(dataclasses.fields(SampledErrors)),)}.get(name, ())
        if not np.all(np.isfinite(values)) or (name not in _ARRAYS and values.shape != shape):
            return None
    texts = {name: text(entries, name) for name in _TEXTS}
    if (
        not texts["description"]
        or texts["given"] not in {"load", "approach"}
        or not _fits({name: entries[name] for name in _ARRAYS})
    ):
        return None
    *errors, points = entries["sampled_error"].tolist()
    return {
        **texts,
        **{name: np.ascontiguousarray(entries[name]) for name in _ARRAYS},
        **{name: entries[name].item() for name in (*_NUMBERS, *_COUNTS)},
        "pressed": tuple(entries["pressed"].tolist()),
        "sampled_error": SampledErrors(*errors, points=int(points)),  # type: ignore[misc]
    }


def _fits(arrays: Mapping[str, np.ndarray[Any, Any]]) -> bool:
    """Return whether sizes and order of the arrays are those of a map: compiled code does not check them."""
    numbers, breaks, stations = arrays["numbers"], arrays["breaks"], arrays["stations"]
    if numbers.shape != (TILT_CELLS + 1,) or breaks.ndim != 1 or stations.ndim != 1:
        return False
    counts = numbers[[LOAD_CELLS, TILT_CELLS]]
    if np.any(counts != np.floor(counts)) or np.any(counts < 1) or breaks.size > ARCHIVE.most:
        return False
    loads, tilts = (int(count) for count in counts)
    shape = loads + DEGREE, tilts + DEGREE
    if breaks.size != loads + tilts + 2 or stations.size < 2:
        return False
    if arrays["mean_approach"].shape != shape or arrays["others"].shape != (QUANTILES + 2, *shape):
        return False
    ascending = (breaks[: loads + 1], breaks[loads + 1 :], stations, numbers[[TILT_LOW, TILT_HIGH]])
    positive = numbers[MOST_LOAD] > 0.0 and numbers[NARROW] > 0.0 and numbers[WIDENING] >= 0.0
    reaches = stations[0] <= numbers[LOW_END] < numbers[HIGH_END] <= stations[-1]
    return bool(positive and reaches and all(np.all(np.diff(column) > 0.0) for column in ascending))
