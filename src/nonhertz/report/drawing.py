"""Figures as inline SVG, several to a page.

matplotlib writes standalone SVG files. In a page, the identifiers of several figures would clash, their style sheets
would apply to the whole page, and their numbers have more digits than can be seen.
"""

from __future__ import annotations

import io
import re
import warnings
from typing import TYPE_CHECKING
from xml.etree import ElementTree as ET

from nonhertz.plot.style import sheet_style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_SVG, _LINK = "{http://www.w3.org/2000/svg}", "{http://www.w3.org/1999/xlink}href"
_NO_METADATA = dict.fromkeys(("Date", "Creator", "Format", "Type"))
_LONG_FRACTION = re.compile(r"(\.\d\d)\d+")  # a hundredth of a point is less than a printer's dot
_REFERENCE = re.compile(r"url\(#([^)]+)\)")
_DPI = 150.0  # of coloured areas, which are bitmaps


def inline_svg(figure: Figure, prefix: str, title: str, description: str) -> str:
    """Return a figure as an ``svg`` element.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        The figure.
    prefix : str
        Prefix of its identifiers, unique within the page; letters, digits and hyphens.
    title, description : str
        What a screen reader says about it.
    """
    root = ET.fromstring(_written(figure))
    for parent in list(root.iter()):
        parent.tag = parent.tag.removeprefix(_SVG)
    _without_styles(root)
    _made_distinct(root, prefix)
    for path in root.iter("path"):
        path.set("d", _LONG_FRACTION.sub(r"\1", path.get("d", "")).replace("\n", ""))
    view = root.get("viewBox", "")
    root.attrib.clear()
    # As in matplotlib's style sheet, which was removed.
    root.set("style", "stroke-linejoin: round; stroke-linecap: butt")
    root.set("viewBox", view)
    _named(root, prefix, title, description)
    return ET.tostring(root, encoding="unicode")


def _written(figure: Figure) -> str:
    text = io.StringIO()
    with sheet_style(), warnings.catch_warnings():
        # A file's name may have letters that the font lacks; the number beside it identifies it anyway.
        warnings.filterwarnings("ignore", "Glyph .* missing")
        figure.savefig(text, format="svg", dpi=_DPI, metadata=_NO_METADATA)
    return text.getvalue()


def _without_styles(root: ET.Element) -> None:
    for parent in root.iter():
        for child in [child for child in parent if child.tag in {"style", "metadata"}]:
            parent.remove(child)


def _made_distinct(root: ET.Element, prefix: str) -> None:
    """Put the prefix in front of identifiers that something refers to, and remove all others."""
    referred = set()
    for element in root.iter():
        for name, value in list(element.attrib.items()):
            if name == _LINK:
                del element.attrib[name]
                referred |= {value[1:]} if value.startswith("#") else set()
                element.set("href", f"#{prefix}-{value[1:]}" if value.startswith("#") else value)
            elif "url(#" in value:
                referred |= set(_REFERENCE.findall(value))
                element.set(name, _REFERENCE.sub(rf"url(#{prefix}-\1)", value))
    for element in root.iter():
        identifier = element.attrib.pop("id", None)
        if identifier in referred:
            element.set("id", f"{prefix}-{identifier}")


def _named(root: ET.Element, prefix: str, title: str, description: str) -> None:
    root.set("role", "img")
    names = {"title": title, "desc": description}
    root.set("aria-labelledby", " ".join(f"{prefix}-{name}" for name in names))
    for position, (name, words) in enumerate(names.items()):
        element = ET.Element(name, {"id": f"{prefix}-{name}"})
        element.text = words
        root.insert(position, element)
