"""Examples in docstrings print what they say."""

import doctest
import importlib
from pathlib import Path

import pytest

import nonhertz

ROOT = Path(nonhertz.__file__).parents[1]
WITH_EXAMPLES = [
    ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")
    for path in sorted(ROOT.glob("nonhertz/**/*.py"))
    if ">>> " in path.read_text(encoding="utf-8")
]


LONG = ("bearing.fatigue", "life.assessment", "life.overrolling", "maps.verb", "strength", "study.design", "search")


@pytest.mark.parametrize(
    "module", [pytest.param(each, marks=pytest.mark.slow if each.endswith(LONG) else ()) for each in WITH_EXAMPLES]
)
def test_examples_in_docstrings(module):
    found = doctest.testmod(importlib.import_module(module))
    assert found.attempted > 0
    assert found.failed == 0
