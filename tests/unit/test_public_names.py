"""The names at the top of the package: all there, documented, and free until asked for."""

import subprocess
import sys

import pytest

import nonhertz as nh


def test_every_public_name_resolves():
    assert all(getattr(nh, name) is not None for name in dir(nh))


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="no attribute 'sovle'"):
        _ = nh.sovle


def test_the_verb_is_not_hidden_by_a_module_once_that_is_imported():
    code = "import nonhertz.solver.one, nonhertz as nh; assert callable(nh.solve)"
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("module", ["nonhertz", "nonhertz.cli", "nonhertz.cli.commands"])
def test_importing_loads_nothing_heavy(module):
    heavy = {"numpy", "scipy", "numba", "pint", "matplotlib"}
    code = f"import sys, {module}; print(*(sys.modules.keys() & {heavy!r}))"
    done = subprocess.run([sys.executable, "-c", code], check=True, capture_output=True, text=True)
    assert done.stdout.split() == []
