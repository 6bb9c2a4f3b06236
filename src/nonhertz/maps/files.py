"""Maps on disk: NPZ without pickles, checked as it is read."""

from __future__ import annotations

import dataclasses
import io
import os
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from nonhertz.errors import InputError
from nonhertz.inputs.files import content
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
from nonhertz.maps.misses import Bounds
from nonhertz.maps.spline import DEGREE

if TYPE_CHECKING:
    from nonhertz.maps.value import ContactMap

KIND, VERSION = "nonhertz map", 1
MOST_BYTES = 200_000_000
_REMEDY = "give a file that ContactMap.save or 'nonhertz map --out k.npz' wrote"
_TEXTS, _ARRAYS = ("description", "given"), ("numbers", "breaks", "mean_approach", "others", "stations")
_NUMBERS, _COUNTS = ("half_length", "accuracy"), ("cases", "failed")


def save(path: str | os.PathLike[str], made: ContactMap) -> None:
    """Write a map."""
    fields = {name: np.asarray(getattr(made, name)) for name in (*_TEXTS, *_ARRAYS, *_NUMBERS, *_COUNTS, "pressed")}
    bound = np.array(dataclasses.astuple(made.bound), dtype=float)
    buffer = io.BytesIO()
    np.savez(buffer, kind=np.asarray(KIND), version=np.asarray(VERSION), bound=bound, **fields)  # type: ignore[arg-type]
    Path(path).write_bytes(buffer.getvalue())


def load(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Return the fields of a map."""
    if not isinstance(path, str | os.PathLike):
        raise InputError("file", path, "be the name of a file", _REMEDY)
    name = str(path)
    try:
        data = content(path, MOST_BYTES)
    except (OSError, ValueError) as error:
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        raise InputError("file", name, f"be a file that can be read ({reason})", _REMEDY) from None
    entries = _entries(data)
    if entries is None or _text(entries, "kind") != KIND:
        raise InputError("file", name, "hold a map of nonhertz", _REMEDY)
    version = entries.get("version", np.asarray(0))
    if version.shape != () or version.dtype.kind not in "iu" or int(version) != VERSION:
        raise InputError("file", name, f"hold a map of version {VERSION}", "make the map again with this nonhertz")
    fields = _fields(entries)
    if fields is None:
        raise InputError("file", name, "hold an undamaged map", "make the map again")
    return fields


def _entries(data: bytes) -> dict[str, np.ndarray[Any, Any]] | None:
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            if sum(member.file_size for member in archive.infolist()) > MOST_BYTES:
                return None
        with np.load(io.BytesIO(data), allow_pickle=False) as archive:
            # A member that is no array comes as bytes.
            return {name: np.asarray(archive[name]) for name in archive.files}
    # A damaged archive can raise anything, from the unpacker's own errors to a MemoryError over a damaged shape.
    except Exception:  # noqa: BLE001
        return None


def _fields(entries: Mapping[str, np.ndarray[Any, Any]]) -> dict[str, Any] | None:
    """Return the fields of a map, or None if they are incomplete or do not fit together."""
    floats = {*_ARRAYS, *_NUMBERS, "pressed", "bound"}
    for name in (*floats, *_COUNTS):
        values = entries.get(name)
        if values is None or values.dtype != (np.int64 if name in _COUNTS else np.float64):
            return None
        if not np.all(np.isfinite(values)) or (name not in _ARRAYS and values.shape != _shape(name)):
            return None
    texts = {name: _text(entries, name) for name in _TEXTS}
    if (
        not texts["description"]
        or texts["given"] not in {"load", "approach"}
        or not _fits({name: entries[name] for name in _ARRAYS})
    ):
        return None
    bounds = dict(zip((each.name for each in dataclasses.fields(Bounds)), entries["bound"].tolist(), strict=True))
    low, high = entries["pressed"].tolist()
    return {
        **texts,
        **{name: np.ascontiguousarray(entries[name]) for name in _ARRAYS},
        **{name: entries[name].item() for name in (*_NUMBERS, *_COUNTS)},
        "pressed": (low, high),
        "bound": Bounds(**bounds | {"points": int(bounds["points"])}),
    }


def _shape(name: str) -> tuple[int, ...]:
    return {"pressed": (2,), "bound": (len(dataclasses.fields(Bounds)),)}.get(name, ())


def _text(entries: Mapping[str, np.ndarray[Any, Any]], name: str) -> str:
    value = entries.get(name, np.asarray(0))
    return str(value) if value.shape == () and value.dtype.kind == "U" else ""


def _fits(arrays: Mapping[str, np.ndarray[Any, Any]]) -> bool:
    """Return whether sizes and order of the arrays are those of a map: compiled code does not check them."""
    numbers, breaks, stations = arrays["numbers"], arrays["breaks"], arrays["stations"]
    if numbers.shape != (TILT_CELLS + 1,) or breaks.ndim != 1 or stations.ndim != 1:
        return False
    counts = numbers[[LOAD_CELLS, TILT_CELLS]]
    if np.any(counts != np.floor(counts)) or np.any(counts < 1) or breaks.size > MOST_BYTES:
        return False
    loads, tilts = (int(each) for each in counts)
    shape = loads + DEGREE, tilts + DEGREE
    if breaks.size != loads + tilts + 2 or stations.size < 2:
        return False
    if arrays["mean_approach"].shape != shape or arrays["others"].shape != (QUANTILES + 2, *shape):
        return False
    ascending = (breaks[: loads + 1], breaks[loads + 1 :], stations, numbers[[TILT_LOW, TILT_HIGH]])
    positive = numbers[MOST_LOAD] > 0.0 and numbers[NARROW] > 0.0 and numbers[WIDENING] >= 0.0
    reaches = stations[0] <= numbers[LOW_END] < numbers[HIGH_END] <= stations[-1]
    return bool(positive and reaches and all(np.all(np.diff(each) > 0.0) for each in ascending))
