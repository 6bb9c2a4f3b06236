"""X3P containers (ISO 25178-72): a zip archive of a description in XML and heights in binary.

x3pio reads them: it checks the checksums, leaves out points that are marked invalid, and takes XML through defusedxml,
so that a description cannot unfold. What it does not bound is how much an archive unpacks to; that is done here before
it sees the data, by the sizes that the archive declares and beyond which zipfile does not read.
"""

from __future__ import annotations

import io
import zipfile

import numpy as np

from nonhertz.io.traces.line import Line, Request

_LARGEST_UNPACKED = 200_000_000  # bytes, of two million points in three coordinates and as much XML again
_MOST_MEMBERS = 1000
_AGAIN = "export the profile again, as X3P or as text"


def is_container(data: bytes) -> bool:
    """Return whether data begins as a zip archive does."""
    return data.startswith(b"PK")


def read_container(data: bytes, request: Request) -> Line:
    """Return the measured line in an X3P container.

    Raises
    ------
    InputError
        If it is damaged, too large, or holds something else than a profile.
    """
    request.refuse_choices("an X3P file")
    _check_size(data, request)
    import x3pio  # noqa: PLC0415  (few files are of this kind)

    try:
        held = x3pio.read(io.BytesIO(data))
    except x3pio.X3pChecksumError:
        raise request.refuse("be what its checksum says (it was changed or damaged)", _AGAIN) from None
    except (x3pio.X3pError, zipfile.BadZipFile, ValueError, OSError, NotImplementedError, EOFError) as error:
        raise request.refuse(f"be a sound X3P file ({_reason(error)})", _AGAIN) from None
    if not isinstance(held, x3pio.Profile):
        what = "an area" if isinstance(held, x3pio.Surface) else "a cloud of points"
        condition = f"hold a profile (feature type PRF), not {what}"
        raise request.refuse(condition, "extract one line along the body in the measuring software and export that")
    layer = held.layers[0]
    notes = ["An X3P profile, converted from m to mm."]
    if len(held.layers) > 1:
        notes.append(f"The file holds {len(held.layers)} layers; the first one was read.")
    y = (
        np.broadcast_to(np.asarray(layer.x_values, dtype=float), np.shape(layer.z))
        if layer.is_regular_grid
        else layer.x
    )
    return Line(1e3 * np.asarray(y, dtype=float), 1e3 * np.asarray(layer.z, dtype=float), tuple(notes))


def _check_size(data: bytes, request: Request) -> None:
    try:
        members = zipfile.ZipFile(io.BytesIO(data)).infolist()
    except (zipfile.BadZipFile, ValueError, OSError) as error:
        raise request.refuse(f"be a sound X3P file ({_reason(error)})", _AGAIN) from None
    if len(members) > _MOST_MEMBERS or sum(member.file_size for member in members) > _LARGEST_UNPACKED:
        condition = f"unpack to no more than {_LARGEST_UNPACKED // 1_000_000} MB"
        raise request.refuse(condition, "export fewer points; a few thousand are enough")


def _reason(error: Exception) -> str:
    text = " ".join(str(error).split()).rstrip(".") or type(error).__name__
    return text[:1].lower() + text[1:120]
