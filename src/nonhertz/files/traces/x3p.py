"""X3P containers (ISO 25178-72): a zip archive of a description in XML and heights in binary.

x3pio reads them: it verifies the checksums, leaves out points marked invalid, and parses XML through defusedxml, so
that entities cannot expand. It limits neither the unpacked size of an archive nor the number of elements in a
description, of which 60 kB can hold ten million. So the archive is unpacked here, piece by piece and up to a limit; the
elements of the description are counted in a stream, without keeping any; and x3pio is given a new archive of what
passed. The sizes that an archive declares are not relied on, as they may be wrong too.
"""

from __future__ import annotations

import io
import zipfile
from typing import TYPE_CHECKING
from xml.parsers import expat

import numpy as np

from nonhertz.errors import InputError
from nonhertz.files.traces.line import MOST_POINTS, Line, Request

if TYPE_CHECKING:
    import x3pio

_LARGEST_UNPACKED = 32_000_000  # bytes: the most points in three coordinates, and more than as much again of XML
_MOST_MEMBERS = 1000
# Bytes of the description. A point written as text is an element of thirty characters: the most points take 3 MB.
_LARGEST_DESCRIPTION, _MOST_ELEMENTS, _DEEPEST, _LONGEST_TEXT = 8_000_000, 100_000, 50, 100_000
_PIECE = 65_536  # bytes
# Signature of each member's entry in the archive's directory.
_ENTRY = b"PK\x01\x02"
_AGAIN = "export the profile again, as X3P or as text"
_FEWER = "export fewer points; a few thousand are enough"


def is_container(data: bytes) -> bool:
    """Return whether data begins as a zip archive does."""
    return data.startswith(b"PK")


def read_container(data: bytes, request: Request) -> Line:
    """Return the measured line in an X3P container.

    Raises
    ------
    InputError
        If it is damaged, too large, or holds anything other than a profile.
    """
    request.refuse_choices("an X3P file")
    try:
        profile = _read_profile(repack(data, request), request)
    except InputError:
        raise
    except Exception as error:  # noqa: BLE001  (zip, XML and x3pio raise a dozen kinds of errors over damaged files)
        raise request.error(f"be an intact X3P file ({describe_reason(error)})", _AGAIN) from None
    layer = profile.layers[0]
    notes = ["An X3P profile, converted from m to mm."]
    if len(profile.layers) > 1:
        notes.append(f"The file holds {len(profile.layers)} layers; the first one was read.")
    y = (
        np.broadcast_to(np.asarray(layer.x_values, dtype=float), np.shape(layer.z))
        if layer.is_regular_grid
        else layer.x
    )
    return Line(1e3 * np.asarray(y, dtype=float), 1e3 * np.asarray(layer.z, dtype=float), tuple(notes))


def _read_profile(archive: bytes, request: Request) -> x3pio.Profile:
    """Return what x3pio reads from an archive; the description is checked before any arrays of points are allocated."""
    import x3pio

    try:
        described = x3pio.info(io.BytesIO(archive))
        if described.feature_type is not x3pio.FeatureType.PROFILE:
            what = "an area" if described.feature_type is x3pio.FeatureType.SURFACE else "a cloud of points"
            condition = f"hold a profile (feature type PRF), not {what}"
            raise request.error(condition, "extract one line along the body in the measuring software and export that")
        if described.layer_count * described.shape[0] > MOST_POINTS:
            raise request.error(f"hold no more than {MOST_POINTS:,} points", _FEWER)
        profile = x3pio.read(io.BytesIO(archive))
    except x3pio.X3pChecksumError:
        raise request.error("match its checksum (it was changed or damaged)", _AGAIN) from None
    if not isinstance(profile, x3pio.Profile):
        raise request.error("hold a profile (feature type PRF)", _AGAIN)
    return profile


def repack(data: bytes, request: Request) -> bytes:
    """Return a new archive of members that were unpacked within the limits, with a description that was checked.

    Raises
    ------
    InputError
        If it exceeds a limit.
    """
    if data.count(_ENTRY) > _MOST_MEMBERS:
        raise request.error(f"hold no more than {_MOST_MEMBERS:,} files", _AGAIN)
    room, stream = _LARGEST_UNPACKED, io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as old, zipfile.ZipFile(stream, "w") as new:
        for member in old.infolist():
            if member.compress_type not in {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}:
                raise request.error("be compressed by deflate, as such archives are", _AGAIN)
            content = _unpack(old, member, room, request)
            room -= len(content)
            if member.filename.replace("\\", "/").rsplit("/", 1)[-1] == "main.xml":
                _look_through(content, request)
            new.writestr(zipfile.ZipInfo(member.filename), content)
    return stream.getvalue()


def _unpack(archive: zipfile.ZipFile, member: zipfile.ZipInfo, most: int, request: Request) -> bytes:
    content = bytearray()
    with archive.open(member) as packed:
        while piece := packed.read(_PIECE):
            content += piece
            if len(content) > most:
                raise request.error(f"unpack to no more than {_LARGEST_UNPACKED // 1_000_000} MB", _FEWER)
    return bytes(content)


def _look_through(description: bytes, request: Request) -> None:
    """Refuse an XML description that could not be parsed into a tree in reasonable time and memory."""
    if len(description) > _LARGEST_DESCRIPTION:
        condition = f"have a description of no more than {_LARGEST_DESCRIPTION // 1_000_000} MB"
        raise request.error(condition, "export the points in binary, or fewer of them")
    parser, seen = expat.ParserCreate(), _XmlLimits(request)
    parser.StartElementHandler, parser.EndElementHandler = seen.start, seen.end
    parser.CharacterDataHandler, parser.StartDoctypeDeclHandler = seen.text, seen.doctype
    for begin in range(0, len(description), _PIECE):
        parser.Parse(description[begin : begin + _PIECE], False)
    parser.Parse(b"", True)


class _XmlLimits:
    """Counters of a description: number of elements, their depth, and the characters between two tags."""

    def __init__(self, request: Request) -> None:
        self.request, self.elements, self.depth, self.characters = request, 0, 0, 0

    def start(self, name: str, attributes: dict[str, str]) -> None:
        self.elements, self.depth, self.characters = self.elements + 1, self.depth + 1, 0
        if self.elements > _MOST_ELEMENTS:
            condition = f"have a description of no more than {_MOST_ELEMENTS:,} elements"
            raise self.request.error(condition, "export the points in binary, or fewer of them")
        if self.depth > _DEEPEST:
            raise self.request.error(f"have a description nested no deeper than {_DEEPEST} elements", _AGAIN)
        if len(attributes) > _DEEPEST or len(name) + sum(map(len, attributes.values())) > _LONGEST_TEXT:
            raise self.request.error("have a description with shorter names and attributes", _AGAIN)

    def end(self, name: str) -> None:
        self.depth, self.characters = self.depth - 1, 0

    def text(self, text: str) -> None:
        self.characters += len(text)
        if self.characters > _LONGEST_TEXT:
            condition = f"have a description whose texts are no longer than {_LONGEST_TEXT:,} characters"
            raise self.request.error(condition, _AGAIN)

    def doctype(self, *_: object) -> None:
        raise self.request.error("have a description without definitions of its own (DOCTYPE)", _AGAIN)


def describe_reason(error: Exception) -> str:
    """Return a library's message on a damaged file, to be put in brackets."""
    text = " ".join(str(error).split()).rstrip(".") or type(error).__name__
    return text[:1].lower() + text[1:120]
