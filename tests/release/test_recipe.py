"""The recipe for conda asks for what pyproject.toml asks for."""

import re
import tomllib
from pathlib import Path
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
PROJECT = PYPROJECT["project"]
RECIPE: dict[str, Any] = yaml.safe_load((ROOT / "recipe/recipe.yaml").read_text(encoding="utf-8"))
# Packages of conda that are called otherwise: matplotlib's brings a graphical toolkit, too.
CONDA = {"matplotlib": "matplotlib-base"}
# What nobody is known to pack for conda, and what an extra asks for that has no place in the recipe.
UNPACKED = {"x3pio"}
LEFT_OUT = {"ross"}


def bounds(requirements: list[str]) -> dict[str, str]:
    """Return the bounds on versions by the name of the package, as conda would call it."""
    found = {}
    for each in requirements:
        name, bound = re.fullmatch(r"([\w.-]+?) ?((?:[<>=!~]=?[\w.${} ]+,?)*)", each).groups()  # type: ignore[union-attr]
        found[CONDA.get(name, name).lower()] = bound
    return found


def extra(name: str) -> dict[str, str]:
    return bounds([each for each in PROJECT["optional-dependencies"][name] if not each.startswith("nonhertz[")])


def test_it_brings_what_core_command_line_and_page_need():
    needed = bounds(PROJECT["dependencies"]) | extra("cli") | extra("web")
    python = {"python": ""}  # whose version conda adds, since the package is built for it
    assert bounds(RECIPE["requirements"]["run"]) == python | {k: v for k, v in needed.items() if k not in UNPACKED}


def test_it_bounds_what_the_other_extras_need():
    needed: dict[str, str] = {name: extra("cli")[name] for name in UNPACKED}
    for name in set(PROJECT["optional-dependencies"]) - {"cli", "web"} - LEFT_OUT:
        needed |= extra(name)
    assert bounds(RECIPE["requirements"]["run_constraints"]) == needed


def test_it_is_built_by_what_builds_the_wheel():
    host = bounds(RECIPE["requirements"]["host"][1:])
    assert host == {"pip": ""} | bounds(PYPROJECT["build-system"]["requires"])
    tools = {**host, **bounds([each for each in RECIPE["requirements"]["build"] if re.match("cmake|ninja", str(each))])}
    assert tools == {"pip": ""} | bounds(PYPROJECT["dependency-groups"]["build"])
    assert PROJECT["requires-python"] == f">={RECIPE['context']['python_min']}"


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        (RECIPE["context"]["version"], PROJECT["version"]),
        (RECIPE["package"]["name"], PROJECT["name"]),
        (RECIPE["about"]["license"], PROJECT["license"]),
        (RECIPE["about"]["license_file"], PROJECT["license-files"]),
        (RECIPE["about"]["summary"], PROJECT["description"]),
    ],
    ids=["version", "name", "licence", "texts", "summary"],
)
def test_it_says_the_same_of_the_package(said, meant):
    assert said == meant
