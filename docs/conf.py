"""How the site is built from these documents, the docstrings and the gallery's scripts: `make docs`.

Warnings are errors. Nothing on the site is loaded from elsewhere, so that it can be read without a network.
"""

from __future__ import annotations

import sys
from pathlib import Path

DOCS = Path(__file__).parent
GALLERY = DOCS.parent / "examples" / "gallery"
sys.path[:0] = [str(DOCS / "extensions"), str(DOCS.parent / "src")]

# The page of commands would call the program as Python calls this one, "-m sphinx".
sys.argv[0] = "nonhertz"

from figure_scraper import FigureScraper  # noqa: E402  (after the path)

import nonhertz  # noqa: E402

project = "nonhertz"
author = "The nonhertz authors"
copyright = f"2026, {author}"  # noqa: A001  (Sphinx's name)
version = release = nonhertz.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx_copybutton",
    "sphinx_gallery.gen_gallery",
    "cyclopts.ext.sphinx",
    "case_file_keys",
    "material_library",
    "mathml",
    "public_names",
    "repository_links",
    "result_file_keys",
    "rexs_attributes",
    "self_contained",
]

source_suffix = {".md": "markdown", ".rst": "restructuredtext"}
nitpicky = True
default_role = "py:obj"
html_math_renderer = "mathml"
pages_of_files = {
    "../CHANGELOG.md": "changelog",
    "../CONTRIBUTING.md": "contributing",
    "../examples/README.md": "examples",
    "../examples/gallery/GALLERY_HEADER.rst": "gallery/index",
} | {f"../examples/gallery/{script.name}": f"gallery/{script.stem}" for script in GALLERY.glob("*.py")}

# What GitHub draws, MyST reads.
myst_enable_extensions = ["dollarmath"]
myst_fence_as_directive = ["math"]
myst_heading_anchors = 4

# NumPy docstrings say types in words; signatures show names and defaults.
autodoc_typehints = "none"
autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
napoleon_google_docstring = False
napoleon_use_ivar = True

# Types are told in words, "ndarray, shape (n,)".
nitpick_ignore_regex = [("py:class", r"(?!nonhertz\.).*")]
nitpick_ignore = [("py:obj", "differences")]
# The same attribute of two results is no mistake.
suppress_warnings = ["ref.python"]

sphinx_gallery_conf = {
    "examples_dirs": str(GALLERY),
    "gallery_dirs": "gallery",
    "filename_pattern": r"\.py$",
    "within_subsection_order": "ExampleTitleSortKey",
    "image_scrapers": (FigureScraper(),),
    "reset_modules": (),
    "abort_on_example_error": True,
    "run_stale_examples": True,  # a script's pictures change with the package too
    "download_all_examples": False,
    "show_memory": False,
    "min_reported_time": 600,  # s; how long a script ran says more of the machine than of the script
    "show_signature": False,
    "write_computation_times": False,
    "remove_config_comments": True,
}

copybutton_prompt_text = r"\$ |>>> |\.\.\. "
copybutton_prompt_is_regexp = True
copybutton_only_copy_prompt_lines = True

html_theme = "furo"
html_title = f"nonhertz {release}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_show_sphinx = False
html_copy_source = False
