"""Results on disk: NPZ without pickles, with a kind, a version and a digest, checked as they are read."""

from __future__ import annotations

import contextlib
import hashlib
import io
import os
import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from nonhertz.errors import InputError
from nonhertz.inputs.files import is_special_file, read_bytes

MOST_PIPED = 200_000_000  # bytes
Entries = dict[str, np.ndarray[Any, Any]]


@dataclass(frozen=True)
class Archive:
    """A kind of file that the package writes and reads again.

    Attributes
    ----------
    kind : str
        Kind stated in the file.
    version : int
        The version that is written, and the only one that can be read.
    contents, undamaged : str
        Names of the contents in messages: ``"a map"``, ``"an undamaged map"``.
    most : int
        Largest size in bytes.
    remedy : str
        What to do about a file of another kind.
    again : str
        What to do about a file that is damaged or of another version.
    """

    kind: str
    version: int
    contents: str
    undamaged: str
    most: int
    remedy: str
    again: str

    def save(self, path: str | os.PathLike[str], fields: Mapping[str, Any]) -> None:
        """Write arrays into a file, which appears under its name only when it is complete."""
        if not isinstance(path, str | os.PathLike):
            raise InputError("file", path, "be the name of a file", "give the name of the file to write")
        arrays = {name: np.asarray(value) for name, value in fields.items()}
        arrays |= {"kind": np.asarray(self.kind), "version": np.asarray(self.version)}
        if is_special_file(path):  # a pipe cannot be replaced or searched
            buffer = io.BytesIO()
            np.savez(buffer, **arrays)  # type: ignore[arg-type]
            Path(path).write_bytes(buffer.getvalue())
            return
        target = Path(os.path.realpath(path))
        draft = target.with_name(f".{target.name}.{os.getpid()}.part")
        try:
            with draft.open("wb") as file:
                np.savez(file, **arrays)  # type: ignore[arg-type]
            os.replace(draft, target)  # noqa: PTH105  (says that it replaces)
        except BaseException:
            with contextlib.suppress(OSError):
                draft.unlink()
            raise

    def load(self, path: str | os.PathLike[str]) -> Entries:
        """Return the arrays in a file.

        Raises
        ------
        InputError
            If the file cannot be read, is of another kind or of another version.
        """
        if not isinstance(path, str | os.PathLike):
            raise InputError("file", path, "be the name of a file", self.remedy)
        name = str(path)
        try:
            # Memory is reserved at once for the largest size possible; a file on disk states its size.
            size = MOST_PIPED if is_special_file(path) else Path(path).stat().st_size
            data = read_bytes(path, min(self.most, size))
        except (OSError, ValueError) as error:
            reason = (getattr(error, "strerror", None) or str(error)).lower()
            raise InputError("file", name, f"be a file that can be read ({reason})", self.remedy) from None
        entries = _entries(data, self.most)
        if entries is None or text(entries, "kind") != self.kind:
            raise InputError("file", name, f"hold {self.contents} of nonhertz", self.remedy)
        version = entries.get("version", np.asarray(0))
        if version.shape != () or version.dtype.kind not in "iu" or int(version) != self.version:
            raise InputError("file", name, f"hold {self.contents} of version {self.version}", self.again)
        return entries

    def damaged_error(self, path: str | os.PathLike[str]) -> InputError:
        """Return the error about incomplete or inconsistent contents."""
        return InputError("file", str(path), f"hold {self.undamaged}", self.again)


def text(entries: Mapping[str, np.ndarray[Any, Any]], name: str) -> str:
    """Return a text among the arrays, empty if there is none of that name."""
    value = entries.get(name, np.asarray(0))
    return str(value) if value.shape == () and value.dtype.kind == "U" else ""


def digest(fields: Mapping[str, np.ndarray[Any, Any]]) -> str:
    """Return a digest of arrays, which differs if any name, shape, type or value does."""
    hashed = hashlib.sha256()
    for name in sorted(fields):
        array = np.ascontiguousarray(fields[name])
        hashed.update(f"{name} {fields[name].shape} {array.dtype.str} ".encode())
        hashed.update(array.data if array.size and array.dtype.kind != "U" else array.tobytes())
    return hashed.hexdigest()


def _entries(data: bytes, most: int) -> Entries | None:
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            if sum(member.file_size for member in archive.infolist()) > most:
                return None
        with np.load(io.BytesIO(data), allow_pickle=False) as archive:
            # A member that is not an array is returned as bytes.
            return {name: np.asarray(archive[name]) for name in archive.files}
    # A damaged archive can raise anything, from the unpacker's own errors to a MemoryError over a damaged shape.
    except Exception:  # noqa: BLE001
        return None
