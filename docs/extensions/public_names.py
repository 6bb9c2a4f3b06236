"""The reference of Python, from the docstrings: the directive ``public-names`` for one module.

First a table of the names with a line each, then every function and constant in full; each class has a page of its own,
written to reference/api/classes before the sources are read. Without a list of its own the directive takes all public
names of the module, so that none can be forgotten.
"""

from __future__ import annotations

import importlib
import inspect
import pydoc
import re
import sys
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from docutils.statemachine import StringList
from sphinx import addnodes
from sphinx.pycode import ModuleAnalyzer
from sphinx.util.docutils import SphinxDirective

import nonhertz

if TYPE_CHECKING:
    from collections.abc import Iterable

    from docutils import nodes
    from sphinx.application import Sphinx
    from sphinx.environment import BuildEnvironment


CLASSES = "classes"  # folder of their pages, beside the pages of the modules
DIRECTIVE = re.compile(r"^\.\. public-names:: (\S+)\n((?:\n|   .*\n)*)", re.MULTILINE)
SEVERAL = re.compile(r"\w+(?:, \w+)+(?= : )")

_HELD: dict[str, list[str]] = {}


def public_names(module: ModuleType) -> list[str]:
    """Return the names that a module offers: what it lists, or else what is defined in it or in a module below it."""
    listed = getattr(module, "__all__", None)
    if listed is not None:
        return sorted(listed, key=str.lower)
    return sorted((name for name in dir(module) if _offered(module, name)), key=str.lower)


def _offered(module: ModuleType, name: str) -> bool:
    value: Any = getattr(module, name)
    if name.startswith("_") or inspect.ismodule(value):
        return False
    return name.isupper() or getattr(value, "__module__", "").startswith(module.__name__)


class PublicNames(SphinxDirective):
    """``.. public-names:: nonhertz.hertz``, with names in lines below where not all are wanted here."""

    required_arguments = 1
    has_content = True

    def run(self) -> list[nodes.Node]:
        """Return the table and the entries."""
        home = self.arguments[0]
        module = importlib.import_module(home)
        names = _listed(module, self.content)
        lines = [f".. currentmodule:: {home}", "", ".. autosummary::", "   :nosignatures:", ""]
        lines += [f"   {name}" for name in names if _documented(module, name)]
        classes = [name for name in names if _has_page(module, name)]
        if classes:
            lines += ["", ".. toctree::", "   :hidden:", "", *(f"   {CLASSES}/{home}.{name}" for name in classes)]
        for name in names:
            if name not in classes:
                lines += ["", *_entry(module, name)]
        return self.parse_text_to_nodes(StringList(lines, source=self.get_source_info()[0]))


def write_class_pages(app: Sphinx) -> None:
    """Write a page for each class that a directive lists, and delete those of classes that are gone."""
    folder = Path(app.srcdir, "reference", "api")
    pages = {}
    for page in folder.glob("*.rst"):
        for home, names in DIRECTIVE.findall(page.read_text(encoding="utf-8")):
            module = importlib.import_module(home)
            for name in filter(lambda name: _has_page(module, name), _listed(module, names.splitlines())):
                title = f"{home}.{name}"
                lines = [title, "=" * len(title), "", f".. currentmodule:: {home}", "", *_entry(module, name), ""]
                pages[folder / CLASSES / f"{title}.rst"] = "\n".join(lines)
    (folder / CLASSES).mkdir(exist_ok=True)
    for old in set((folder / CLASSES).iterdir()) - set(pages):
        old.unlink()
    for path, text in pages.items():
        # A page that is left as it was is not built again.
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.write_text(text, encoding="utf-8")


def _listed(module: ModuleType, lines: Iterable[str]) -> list[str]:
    return [line.strip() for line in lines if line.strip()] or public_names(module)


def _has_page(module: ModuleType, name: str) -> bool:
    value = getattr(module, name)
    return inspect.isclass(value) and not issubclass(value, BaseException)


def _documented(module: ModuleType, name: str) -> bool:
    value = getattr(module, name)
    return inspect.isclass(value) or inspect.isroutine(value)


def _entry(module: ModuleType, name: str) -> list[str]:
    """Return the lines for one name."""
    value = getattr(module, name)
    if not _documented(module, name):
        return [f".. py:data:: {name}", "", *(f"   {line}" for line in _comment(name, value))]
    if not inspect.isclass(value):
        return [f".. autofunction:: {name}"]
    if issubclass(value, BaseException):
        return [f".. autoexception:: {name}", "   :show-inheritance:"]
    return [f".. autoclass:: {name}", "   :members:"]


def _comment(name: str, value: object) -> list[str]:
    """Return what the ``#:`` above a constant says, in whichever module it is made, and the keys of a table."""
    homes = [home for home, module in sys.modules.items() if home.startswith("nonhertz") and module]
    comments = (ModuleAnalyzer.for_module(home).find_attr_docs().get(("", name)) for home in homes
                if vars(sys.modules[home]).get(name) is value)  # fmt: skip
    lines = next((comment for comment in comments if comment), [])
    if isinstance(value, dict):
        lines = [*lines, "Keys: " + ", ".join(f"``{key!r}``" for key in value) + "."]
    return lines


def hold(app: Sphinx, what: str, name: str, value: object, options: object, lines: list[str]) -> None:
    """Keep a property's sentences from napoleon, which takes what stands before a colon for a type."""
    if what == "property" and not any(line and not line.strip("-") for line in lines):
        _HELD[name] = list(lines)
        lines.clear()


def give_back(app: Sphinx, what: str, name: str, value: object, options: object, lines: list[str]) -> None:
    """Put back what `hold` kept."""
    lines[:] = _HELD.pop(name, lines)


def join_names(app: Sphinx, what: str, name: str, value: object, options: object, lines: list[str]) -> None:
    """Write ``a, b : float`` as ``a,b : float``: of several attributes, napoleon takes all but the last for types."""
    for number, line in enumerate(lines):
        names = SEVERAL.match(line)
        if names:
            lines[number] = names[0].replace(" ", "") + line[names.end() :]


def escape_bars(app: Sphinx, what: str, name: str, value: object, options: object, lines: list[str]) -> None:
    """Let ``|x|`` in a docstring be what it is, the absolute value."""
    for number, line in enumerate(lines):
        if "``" not in line and not line.lstrip().startswith(">>>"):
            lines[number] = line.replace("|", r"\|")


def leave_words(app: Sphinx, doctree: nodes.document) -> None:
    """Take no word of a type, as in ``ndarray, shape (n,)``, for the attribute of that name somewhere."""
    for node in list(doctree.findall(addnodes.pending_xref)):
        if node["reftype"] == "class" and re.fullmatch("[a-z]+", node["reftarget"]):
            node.replace_self(node.children)


def find_name(
    app: Sphinx, environment: BuildEnvironment, node: addnodes.pending_xref, text: nodes.TextElement
) -> nodes.Element | None:
    """Resolve ``Solution`` in the docstring of any module to ``nonhertz.Solution``, if there is one such name only.

    A path into the package that is none of the public ones, for readers of the code, stays as it is. One that leads
    nowhere is a warning.
    """
    if node.get("refdomain") != "py":
        return None
    domain, name = environment.domains.python_domain, node["reftarget"].removeprefix("nh.")
    found = [full for full, entry in domain.objects.items() if full.endswith(f".{name}") and not entry.aliased]
    if len(found) == 1:
        node["reftarget"] = found[0]
        return domain.resolve_xref(environment, node["refdoc"], app.builder, "obj", found[0], node, text)
    return text if name.startswith("nonhertz.") and _leads_somewhere(name) else None


def _leads_somewhere(name: str) -> bool:
    # A function may have the name of its module and hide it; the table of modules knows both.
    module = sys.modules.get(name.rpartition(".")[0])
    return hasattr(module, name.rpartition(".")[2]) or pydoc.locate(name) is not None


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive, and the way in which short names find what they mean."""
    # Users write nonhertz.profile, which lives among the models.
    sys.modules["nonhertz.profile"] = nonhertz.profile
    app.add_directive("public-names", PublicNames)
    app.connect("builder-inited", write_class_pages)
    for listener, priority in (
        (hold, 400),
        (join_names, 400),
        (give_back, 600),  # napoleon has 500
        (escape_bars, 700),
    ):
        app.connect("autodoc-process-docstring", listener, priority)
    app.connect("doctree-read", leave_words)
    app.connect("missing-reference", find_name)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
