"""The page around all reports: templates, style sheet, links, and the mark that identifies a report."""

from __future__ import annotations

import platform
import re
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import metadata
from itertools import count
from typing import TYPE_CHECKING, Any, NamedTuple
from urllib.parse import quote

from nonhertz import __version__
from nonhertz.amounts import current_units
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.casefile import Case
from nonhertz.files.title_block import TitleBlock
from nonhertz.plot.sheets import image
from nonhertz.report.downloads import Download
from nonhertz.report.results import Results
from nonhertz.show.sections import Block, Picture, Row, Section, shown_columns

if TYPE_CHECKING:
    from markupsafe import Markup

#: Identifies a report; it is near the beginning of the file.
MARK = '<meta name="generator" content="nonhertz report">'

_DOTS = 110  # dots per inch of raster parts of a figure
_LONG_NUMBER = re.compile(r"(?<=\d)(\.\d\d)\d+(?=[ \n\"])")
_UNCHANGED = " !$()*+,-./:;=?@[]_~"  # characters that need no escaping in an address and in HTML
_PACKAGES = ("numpy", "scipy", "matplotlib")
_ADDRESS = re.compile(r"doi:(10\.\S+?)(?=[.,;:]?(?:\s|$))|(https?://\S+?)(?=[.,;:]?(?:\s|$))")


@dataclass(frozen=True)
class Files(Block):
    """A block of a page: the files embedded in it, and the text of the first.

    Attributes
    ----------
    case : Case or BearingCase
        What was solved.
    downloads : sequence of Download
        The files.
    """

    case: Case | BearingCase
    downloads: Sequence[Download]

    @property
    def left_out(self) -> list[str]:
        """The files that the case names but the page does not include."""
        origin = self.case.origin
        return [] if origin is None else [name for name in origin.files if name not in self.case.attachments]


@dataclass(frozen=True, eq=False)
class Part:
    """The part of a page on one result, or on several side by side.

    Attributes
    ----------
    result : CaseResults or BearingResults or None
        The result; None for several.
    sections : sequence of Section
        Always shown.
    folded : sequence of Section
        Shown once unfolded.
    numbers : sequence of rows
        Name, value and remark of the key figures.
    anchor : str
        Identifier of the result, if it is one of several.
    opening : str
        What was solved, if it is one of several.
    """

    result: Results | None
    sections: Sequence[Section] = ()
    folded: Sequence[Section] = ()
    numbers: Sequence[Row] = ()
    anchor: str = ""
    opening: str = ""


class Words(NamedTuple):
    """The words of a page for one kind of case: its name, the command that solves it, heading, and axes and signs."""

    one: str
    command: str
    heading: str
    conventions: str


def render_page(title: str, words: Words, block: TitleBlock, opening: str, parts: Sequence[Part]) -> str:
    """Return the text of a page; ``opening`` is a sentence on what was solved."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    options: dict[str, Any] = {"autoescape": True, "trim_blocks": True, "lstrip_blocks": True}
    environment = Environment(loader=PackageLoader("nonhertz.report"), undefined=StrictUndefined, **options)
    environment.filters |= {"with_links": with_links, "svg_address": _svg_address, "css_string": css_string}
    page = environment.get_template("report.html").render(
        title=title,
        mark=MARK,
        words=words,
        stated=current_units().stated,
        block=block,
        opening=opening,
        parts=parts,
        kind_of=lambda block: type(block).__name__,
        numbers=count(1),  # of figures, in the order of the page
        columns=shown_columns,
        versions={"nonhertz": __version__, "Python": platform.python_version()}
        | {name: metadata.version(name) for name in _PACKAGES},
    )
    return page.strip() + "\n"


def _svg_address(picture: Picture) -> str:
    """Return a figure as a data URL: a document of its own, whose identifiers clash with no others.

    It is half as long as the file of the figure: lengths are rounded to a hundredth of a point, and raster parts have
    the resolution of screens.
    """
    text = _LONG_NUMBER.sub(r"\1", image(picture.figure, "svg", _DOTS).decode())
    return f"data:image/svg+xml,{quote(' '.join(text.split()), safe=_UNCHANGED)}"


def css_string(text: str) -> Markup:
    r"""Return a text as a CSS string within a page.

    Examples
    --------
    >>> print(css_string('a "b" </style>'))
    "a \22 b\22  \3c /style\3e "
    """
    from markupsafe import Markup

    return Markup('"' + re.sub(r'["\\<>&\x00-\x1f]', lambda match: f"\\{ord(match[0]):x} ", text) + '"')


def with_links(text: str) -> Markup:
    """Return a reference with its DOIs and URLs as links."""
    from markupsafe import Markup, escape

    shown, at = Markup(), 0
    for match in _ADDRESS.finditer(text):
        address = match[2] or f"https://doi.org/{match[1]}"
        shown += escape(text[at : match.start()])
        shown += Markup('<a href="{}" rel="noreferrer">{}</a>').format(address, match[0])
        at = match.end()
    return shown + escape(text[at:])
