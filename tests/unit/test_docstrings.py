"""Examples in docstrings print what they say, and docstrings name the parameters that functions have."""

import ast
import doctest
import importlib
import re
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


FUNCTIONS = [
    pytest.param(node, id=f"{path.relative_to(ROOT).as_posix()}:{node.name}")
    for path in sorted(ROOT.glob("nonhertz/**/*.py"))
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
    if isinstance(node, ast.FunctionDef) and "\nParameters\n---" in (ast.get_docstring(node) or "")
]


@pytest.mark.parametrize("function", FUNCTIONS)
def test_parameters_in_docstrings_are_those_of_the_function(function):
    section = re.split(r"\n\n.*\n-{3,}", ast.get_docstring(function).split("\nParameters\n", 1)[1])[0]
    heads = [line.partition(" :")[0] for line in section.splitlines() if re.match(r"[*\w]+(, [*\w]+)*( :|$)", line)]
    documented = {name.strip(" *") for head in heads for name in head.split(",")}
    assert documented
    # A name that is indented as a description is set into it.
    assert not re.search(r"^ +\w+(, \w+)* : \w", section, re.MULTILINE)
    assert documented <= {node.arg for node in ast.walk(function.args) if isinstance(node, ast.arg)}
