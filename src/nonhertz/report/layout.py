"""The page around all reports: templates, style sheet, links, and what identifies a report."""

from __future__ import annotations

import functools
import platform
import re
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import metadata, resources
from typing import TYPE_CHECKING, Any, NamedTuple

from nonhertz import __version__
from nonhertz.amounts import chosen
from nonhertz.files.title_block import TitleBlock
from nonhertz.report.figures import ReportFigure

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup

#: Identifies a report; it is near the beginning of the file.
MARK = '<meta name="generator" content="nonhertz report">'

_PACKAGES = ("numpy", "scipy", "numba", "matplotlib")
_ADDRESS = re.compile(r"doi:(10\.\S+?)(?=[.,;:]?(?:\s|$))|(https?://\S+?)(?=[.,;:]?(?:\s|$))")


#: What the template lays out by a macro of its own: the macro's name, and what it is given.
Block = tuple[str, dict[str, Any]]


class Section(NamedTuple):
    """A heading, empty where none is due, and what stands below it; nothing is shown of one without blocks."""

    title: str
    blocks: Sequence[Block]


@dataclass(frozen=True)
class Words:
    """What a page says of all cases in it.

    Attributes
    ----------
    kind : str
        The line above the title.
    what : str
        What it reports on, in the plural.
    here : str
        One of them, as the head of a column.
    file, command : str
        What it is read from, and the command that solves that.
    conventions : str
        Axes and signs.
    """

    kind: str
    what: str
    here: str
    file: str
    command: str
    conventions: str


def laid_out(title: str, words: Words, block: TitleBlock, opening: str, parts: Sequence[dict[str, Any]]) -> str:
    """Return the text of a page, which begins with a sentence on what was solved."""
    page = (
        _environment()
        .get_template("report.html")
        .render(
            title=title,
            mark=_safe(MARK),
            style=_safe(resources.files("nonhertz.report").joinpath("templates", "style.css").read_text("utf-8")),
            words=words,
            stated=chosen().stated,
            block=block,
            opening=opening,
            parts=parts,
            versions={"nonhertz": __version__, "Python": platform.python_version()}
            | {name: metadata.version(name) for name in _PACKAGES},
        )
    )
    return page.strip() + "\n"


def marked(picture: ReportFigure) -> dict[str, Any]:
    """Return a figure as templates show it."""
    return {"number": picture.number, "svg": _safe(picture.svg), "caption": picture.caption}


def merged(rows: Sequence[tuple[str, str, str]]) -> list[tuple[str, list[tuple[str, str]]]]:
    """Return names with their values and remarks; a row without a name continues the one before."""
    found: list[tuple[str, list[tuple[str, str]]]] = []
    for name, value, remark in rows:
        if name or not found:
            found.append((name.strip(), []))
        found[-1][1].append((value, remark))
    return found


def linked(text: str) -> Markup:
    """Return a reference with its DOIs and URLs as links."""
    from markupsafe import Markup, escape

    shown, at = Markup(), 0
    for found in _ADDRESS.finditer(text):
        address = found[2] or f"https://doi.org/{found[1]}"
        shown += escape(text[at : found.start()])
        shown += Markup('<a href="{}" rel="noreferrer">{}</a>').format(address, found[0])
        at = found.end()
    return shown + escape(text[at:])


@functools.cache
def _environment() -> Environment:
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("nonhertz.report"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["linked"] = linked
    return environment


def _safe(text: str) -> Markup:
    """Return trusted text as HTML that is not escaped."""
    from markupsafe import Markup

    return Markup(text)
