r"""Formulas as MathML, which every browser draws by itself: no script and nothing loaded from elsewhere.

The documents are written for GitHub, which has forms of its own: a formula in a line may stand between ``$`` and a
backtick. latex2mathml turns TeX into MathML; what it does not do as TeX does is put right before.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.util import logging

if TYPE_CHECKING:
    from sphinx.application import Sphinx
    from sphinx.writers.html5 import HTML5Translator

# GitHub refuses \operatorname, so that the documents write what it stands for.
OPERATOR = re.compile(r"\\mathop\{\\mathrm\{(\w+)\}\}")
# One letter without braces: only with them comes the character that is bold or upright by itself.
ONE_LETTER = re.compile(r"\\(mathbf|mathrm) (\w)")
# A prime as a superscript is drawn too small by most fonts; as a letter it is raised by itself.
PRIMES = re.compile(r"(\\[A-Za-z]+|\w)('+)")
# TeX sets a thin space between a function and an argument without brackets, MathML none.
BARE_ARGUMENT = re.compile(r"(\\(?:ln|sin|cos|cot|exp|operatorname\{\w+\}))\s*(?=[\w\\])(?!\\left|\\,)")


def mathml(tex: str, display: str = "inline") -> str:
    """Return a formula in TeX as an element of MathML, ``display`` being ``"inline"`` or ``"block"``."""
    tex = OPERATOR.sub(r"\\operatorname{\1}", tex.strip().strip("`"))
    tex = ONE_LETTER.sub(r"\\\1{\2}", tex)
    tex = PRIMES.sub(lambda found: "{" + found[1] + len(found[2]) * r"\prime" + "}", tex)
    tex = BARE_ARGUMENT.sub(r"\1\\,", tex)
    return convert(tex, display=display)


def inline(translator: HTML5Translator, node: nodes.math) -> None:
    """Write a formula in a line."""
    translator.body.append(_checked(node, "inline"))
    raise nodes.SkipNode


def block(translator: HTML5Translator, node: nodes.math_block) -> None:
    """Write a formula on lines of its own, in a box that scrolls where the page is narrower."""
    translator.body.append(f'<div class="formula">{_checked(node, "block")}</div>\n')
    raise nodes.SkipNode


def _checked(node: nodes.Element, display: str) -> str:
    found = mathml(node.astext(), display)
    # latex2mathml writes commands that it does not know as they are.
    if "\\" in found:
        logging.getLogger(__name__).warning("formula not understood: %s", node.astext(), location=node)
    return found


def setup(app: Sphinx) -> dict[str, bool]:
    """Make this the way in which formulas are written."""
    app.add_html_math_renderer("mathml", inline_renderers=(inline, None), block_renderers=(block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
