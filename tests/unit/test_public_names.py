"""The names at the top of the package: all there, documented, and free until asked for."""

import importlib
import inspect
import pkgutil

import pytest

import nonhertz as nh
from nonhertz.files.starting import starting_bearing, starting_case


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


@pytest.mark.parametrize("template", [None, "wheel-on-rail"])
def test_a_new_case_is_that_of_the_file_that_new_writes(template, tmp_path):
    path = tmp_path / "case.toml"
    path.write_text(starting_case(template), encoding="utf-8")
    assert nh.new_case(template).contact == nh.read_case(path).contact
    assert nh.new_case(template, {"load.load": "5 kN"}).prescribed.load == 5e3


@pytest.mark.parametrize("template", [None, "tapered-pair"])
def test_a_new_bearing_is_that_of_the_file_that_new_writes(template, tmp_path):
    path = tmp_path / "bearing.toml"
    path.write_text(starting_bearing(template), encoding="utf-8")
    assert nh.new_bearing(template).bearing == nh.read_bearing(path).bearing
    with pytest.raises(nh.InputError, match="template"):
        nh.new_bearing("ball")


def _packages():
    modules = pkgutil.walk_packages(nh.__path__, "nonhertz.")
    return ["nonhertz", *(module.name for module in modules if module.ispkg)]


@pytest.mark.parametrize("name", _packages())
def test_no_public_name_of_a_package_is_that_of_one_of_its_modules(name):
    package = importlib.import_module(name)
    modules = {module.name: importlib.import_module(f"{name}.{module.name}") for module in _modules_of(package)}
    public = {*dir(package), *vars(package)} & set(modules)
    assert not [short for short in public if getattr(package, short) is not modules[short]]


def _modules_of(package):
    return [module for module in pkgutil.iter_modules(package.__path__) if module.name[0] not in "_0123456789"]


def test_a_name_that_was_renamed_works_for_one_release():
    with pytest.warns(DeprecationWarning, match=r"nonhertz\.bearing\.LoadCase is now nonhertz\.bearing\.BearingLoadC"):
        assert nh.bearing.LoadCase is nh.bearing.BearingLoadCase
    assert "LoadCase" not in dir(nh.bearing)


def test_every_function_takes_a_body_as_the_same_keyword():
    verbs = [value for module in (nh.life, nh.strength, nh.subsurface) for value in _functions_of(module).values()]
    takes_body = [inspect.signature(verb).parameters for verb in verbs]
    bodies = [each["body"] for each in takes_body if "body" in each]
    assert {(body.kind, body.default) for body in bodies} == {(inspect.Parameter.KEYWORD_ONLY, "a")}
    assert len(bodies) == 4


def _functions_of(module):
    return {name: getattr(module, name) for name in dir(module) if inspect.isfunction(getattr(module, name))}
