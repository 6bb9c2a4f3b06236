"""Pictures for the gallery: the matplotlib figures that a script holds by name, since none of ours uses pyplot."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from matplotlib.figure import Figure
from sphinx_gallery.scrapers import figure_rst

from nonhertz.plot.style import sheet_style

DPI = 200


class FigureScraper:
    """Save every figure that a block of a script has made and named."""

    def __init__(self) -> None:
        self._seen: set[int] = set()
        self._kept: list[Figure] = []

    def __repr__(self) -> str:
        return "FigureScraper()"  # sphinx-gallery compares configurations by their text

    def __call__(self, block: Any, block_vars: dict[str, Any], gallery_conf: dict[str, Any]) -> str:
        """Return the reST that shows the figures of one block."""
        paths = []
        for figure in self._new(block_vars["example_globals"]):
            path = Path(next(block_vars["image_path_iterator"]))
            with sheet_style():
                figure.savefig(path, dpi=DPI)
            paths.append(str(path))
        return str(figure_rst(paths, gallery_conf["src_dir"]))

    def _new(self, names: dict[str, Any]) -> list[Figure]:
        found = [value for value in names.values() if isinstance(value, Figure) and id(value) not in self._seen]
        self._seen.update(map(id, found))
        # Kept, so that no later figure can have the same identity.
        self._kept.extend(found)
        return found
