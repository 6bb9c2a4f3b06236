"""Maps on disk: NPZ without pickles, checked as it is read."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import astuple, fields
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
    remedy="give a file that ContactMap.save or the command line wrote",
    again="make the map again with this nonhertz",
)
_TEXTS, _ARRAYS = ("description", "given"), ("numbers", "breaks", "mean_approach", "others", "stations")
_NUMBERS, _COUNTS = ("half_length", "accuracy"), ("cases", "failed")


def save(path: str | os.PathLike[str], made: ContactMap) -> None:
    """Write a map."""
    entries = {name: getattr(made, name) for name in (*_TEXTS, *_ARRAYS, *_NUMBERS, *_COUNTS, "pressed")}
    ARCHIVE.save(path, entries | {"sampled_error": np.array(astuple(made.sampled_error), dtype=float)})


def load(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Return the fields of a map."""
    known = _fields(ARCHIVE.load(path))
    if known is None:
        raise ARCHIVE.damaged_error(path)
    return known


def _fields(entries: Mapping[str, np.ndarray[Any, Any]]) -> dict[str, Any] | None:
    """Return the fields of a map, or None if they are incomplete or inconsistent."""
    known: dict[str, Any] = {"description": text(entries, "description"), "given": text(entries, "given")}
    errors = (len(fields(SampledErrors)),)
    shapes = {**dict.fromkeys((*_NUMBERS, *_COUNTS), ()), "pressed": (2,), "sampled_error": errors}
    for name in (*_ARRAYS, *shapes):
        values = entries.get(name, np.asarray(""))
        if values.dtype != (np.int64 if name in _COUNTS else np.float64):
            return None
        if not np.all(np.isfinite(values)) or values.shape != shapes.get(name, values.shape):
            return None
        known[name] = np.ascontiguousarray(values) if name in _ARRAYS else values.tolist()
    if not known["description"] or known["given"] not in {"load", "approach"} or not _fits(known):
        return None
    *of_quantities, points = known["sampled_error"]
    return known | {
        "pressed": tuple(known["pressed"]),
        "sampled_error": SampledErrors(*of_quantities, points=int(points)),  # type: ignore[misc]
    }


def _fits(arrays: Mapping[str, np.ndarray[Any, Any]]) -> bool:
    """Return whether the arrays have the sizes and order of a map: compiled code does not check them."""
    numbers, breaks, stations = arrays["numbers"], arrays["breaks"], arrays["stations"]
    if numbers.shape != (TILT_CELLS + 1,):
        return False
    counts = numbers[[LOAD_CELLS, TILT_CELLS]]
    if np.any((counts != np.floor(counts)) | (counts < 1)):
        return False
    loads, tilts = map(int, counts)
    shape = loads + DEGREE, tilts + DEGREE
    shapes = {
        "breaks": (loads + tilts + 2,), "mean_approach": shape, "others": (QUANTILES + 2, *shape),
        "stations": (max(stations.size, 2),),
    }  # fmt: skip
    if any(arrays[name].shape != size for name, size in shapes.items()):
        return False
    ascending = (breaks[: loads + 1], breaks[loads + 1 :], stations, numbers[[TILT_LOW, TILT_HIGH]])
    positive = np.all(numbers[[MOST_LOAD, NARROW]] > 0.0) and numbers[WIDENING] >= 0.0
    reaches = stations[0] <= numbers[LOW_END] < numbers[HIGH_END] <= stations[-1]
    return bool(positive and reaches and all(np.all(np.diff(column) > 0.0) for column in ascending))
