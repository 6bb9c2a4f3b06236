"""The names at the top of the package: all there, documented, and free until asked for."""

import importlib
import inspect

import pytest

import nonhertz as nh


def test_every_public_name_resolves():
    assert all(getattr(nh, name) is not None for name in dir(nh))


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="no attribute 'sovle'"):
        _ = nh.sovle


@pytest.mark.parametrize("name", [*nh._MODULES.values(), "nonhertz.files.traces", "nonhertz.files.force_tables"])
def test_dir_of_a_public_module_shows_what_is_public_and_nothing_else(name):
    module = importlib.import_module(name)
    values = {name: getattr(module, name) for name in dir(module)}
    assert values
    assert not [name for name, value in values.items() if name.startswith("_") or inspect.ismodule(value)]
    ours = [value for value in values.values() if inspect.isclass(value) or inspect.isroutine(value)]
    assert all(value.__module__.startswith("nonhertz.") and value.__doc__ for value in ours)
    assert dir(module) == sorted(getattr(module, "__all__", values))
