"""Logos: PNG and SVG files that a report shows, checked and cleaned so that they can do nothing but be looked at.

Of an SVG file only elements and attributes that draw are kept, from a list, so that what is unknown is left out:
scripts, handlers of events, foreign content and whatever is loaded from elsewhere.
"""

from __future__ import annotations

import base64
import binascii
import errno
import re
from dataclasses import dataclass
from pathlib import Path
from typing import Final
from xml.etree import ElementTree as ET

from nonhertz.errors import InputError
from nonhertz.inputs.files import content

LARGEST: Final = 200_000
"""Bytes; a report shows a logo 2 cm high, and case files of at most 1 MB hold it as text."""
_PNG_BEGINS: Final = b"\x89PNG\r\n\x1a\n"
_KINDS: Final = {"png": "image/png", "svg": "image/svg+xml"}
_DATA: Final = re.compile(r"data:(image/[a-z+]+);base64,([A-Za-z0-9+/=\s]*)")
_SVG: Final = "http://www.w3.org/2000/svg"
_LINK: Final = "http://www.w3.org/1999/xlink"
_ELEMENTS: Final = frozenset(
    (
        *("svg", "g", "defs", "symbol", "use", "switch", "title", "desc", "style", "image", "marker", "pattern"),
        *("path", "rect", "circle", "ellipse", "line", "polyline", "polygon", "text", "tspan", "textPath"),
        *("linearGradient", "radialGradient", "stop", "clipPath", "mask"),
    )
)
# What refers to something other than a part of the same file, in attributes and in style sheets.
_ELSEWHERE: Final = re.compile(r"url\(\s*['\"]?(?!\s*#)|@import|javascript:|expression\(|\\", re.IGNORECASE)
_PICTURE: Final = re.compile(r"data:image/(?:png|jpeg|gif);base64,[A-Za-z0-9+/=\s]*")
_REMEDY: Final = "save it as PNG or plain SVG"


@dataclass(frozen=True)
class Logo:
    """A picture for the head of a report.

    Attributes
    ----------
    kind : {"png", "svg"}
        What the content is.
    content : bytes
        Of the file; of an SVG file what is left after cleaning.
    """

    kind: str
    content: bytes

    @property
    def address(self) -> str:
        """The content as a data URI, for the ``src`` of an image."""
        return f"data:{_KINDS[self.kind]};base64,{base64.b64encode(self.content).decode('ascii')}"


def logo_from(text: str, folder: Path | None, field: str = "logo") -> Logo:
    """Return the logo in a file, or in a data URI.

    Parameters
    ----------
    text : str
        Name of a PNG or SVG file of at most 200 kB, or a data URI with its content in base64.
    folder : Path or None
        Directory that the name is relative to; None where no file may be read.
    field : str
        What an error calls it.

    Raises
    ------
    InputError
        If it is neither, or larger, or an SVG file with entities, which may expand without limit.
    """
    if text.startswith("data:"):
        return _checked(field, f"{text[:30]}...", _decoded(field, text))
    if folder is None:
        raise InputError(field, text, "not be read here", "give its content as a data URI")
    try:
        data = content(folder / text, LARGEST)
    except OSError as error:
        if error.errno == errno.EFBIG:
            raise _too_large(field, text) from None
        reason = (error.strerror or str(error)).lower()
        raise InputError(field, text, f"be a file that can be read ({reason})", "check the name") from None
    except ValueError:  # such as a name with a null character
        raise InputError(field, text, "be the name of a file", "check the name") from None
    return _checked(field, text, data)


def _decoded(field: str, text: str) -> bytes:
    found = _DATA.fullmatch(text)
    try:
        data = base64.b64decode(found[2], validate=False) if found else None
    except binascii.Error:
        data = None
    if data is None:
        remedy = "write data:image/png;base64,... or data:image/svg+xml;base64,..."
        raise InputError(field, f"{text[:30]}...", "be a data URI in base64", remedy)
    return data


def _checked(field: str, name: str, data: bytes) -> Logo:
    if len(data) > LARGEST:
        raise _too_large(field, name)
    if data.startswith(_PNG_BEGINS):
        return Logo("png", data)
    # Text in UTF-16 would hide entities.
    if b"<!ENTITY" in data or b"\0" in data:
        raise InputError(field, name, "be a PNG file, or an SVG file in UTF-8 without entities", _REMEDY)
    try:
        root = ET.fromstring(data)
    except (ET.ParseError, ValueError, LookupError):  # the latter two for an unknown encoding
        raise InputError(field, name, "be a PNG or SVG file", _REMEDY) from None
    if root.tag != f"{{{_SVG}}}svg":
        raise InputError(field, name, "be a PNG or SVG file", _REMEDY)
    return Logo("svg", _cleaned(root))


def _too_large(field: str, name: str) -> InputError:
    return InputError(field, name, f"have at most {LARGEST / 1e3:g} kB", "save it with fewer points or pixels")


def _cleaned(root: ET.Element) -> bytes:
    """Return an SVG file with nothing but what draws."""
    for parent in list(root.iter()):
        for child in list(parent):
            if not _draws(child):
                parent.remove(child)
        for name, value in list(parent.attrib.items()):
            if not _harmless(parent, name, value):
                del parent.attrib[name]
    ET.register_namespace("", _SVG)
    ET.register_namespace("xlink", _LINK)
    cleaned: bytes = ET.tostring(root, encoding="utf-8")
    return cleaned


def _draws(element: ET.Element) -> bool:
    space, _, name = str(element.tag).rpartition("}")
    is_style = name == "style"
    return space == f"{{{_SVG}" and name in _ELEMENTS and not (is_style and _ELSEWHERE.search(element.text or ""))


def _harmless(element: ET.Element, name: str, value: str) -> bool:
    if name in {"href", f"{{{_LINK}}}href"}:
        return value.startswith("#") or (str(element.tag).endswith("}image") and bool(_PICTURE.fullmatch(value)))
    return not name.startswith("{") and not name.lower().startswith("on") and not _ELSEWHERE.search(value)
