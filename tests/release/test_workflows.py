"""What a forge runs: the files can be read, and all that they name exists."""

import re
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / ".github"
TEXTS = {path.name: path.read_text(encoding="utf-8") for path in sorted((FOLDER / "workflows").iterdir())}
# YAML 1.1 reads the key "on" as true.
WORKFLOWS: dict[str, dict[Any, Any]] = {name: yaml.safe_load(text) for name, text in TEXTS.items()}
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
MAKEFILE = (ROOT / "Makefile").read_text(encoding="utf-8")
MARKERS = {line.partition(":")[0] for line in PYPROJECT["tool"]["pytest"]["ini_options"]["markers"]}
EACH = pytest.mark.parametrize("name", TEXTS)


def jobs(name: str) -> dict[str, dict[str, Any]]:
    found: dict[str, dict[str, Any]] = WORKFLOWS[name]["jobs"]
    return found


def commands(name: str) -> Iterator[str]:
    """Give the commands of a workflow, with every value of its matrix in its place."""
    for job in jobs(name).values():
        matrix: dict[str, list[str]] = job.get("strategy", {}).get("matrix", {})
        for step in job.get("steps", []):
            lines = [step["run"]] if "run" in step else []
            for key, values in matrix.items():
                lines = [line.replace(f"${{{{ matrix.{key} }}}}", str(value)) for line in lines for value in values]
            yield from set(lines)


@EACH
def test_targets_files_groups_and_markers_exist(name):
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    targets = set(re.search(r"^\.PHONY: (.*)$", makefile, re.MULTILINE)[1].split())  # type: ignore[index]
    seen = 0
    for command in commands(name):
        words = command.split()
        if words[0] == "make":
            assert words[1] in targets, command
        else:
            assert words[0] == "python", "Windows has nothing else that is the same everywhere"
        for file in re.findall(r"[\w./-]+\.(?:py|txt|toml)\b", command):
            assert (ROOT / file).is_file(), command
        assert set(re.findall(r"--group (\w+)", command)) <= set(PYPROJECT["dependency-groups"]), command
        assert set(re.findall(r"\[(\w+)\]", command)) <= set(PYPROJECT["project"]["optional-dependencies"]), command
        for expression in re.findall(r'pytest .*-m "?([^"]+)"?$', command):
            assert set(re.findall(r"\w+", expression)) - {"not", "and", "or"} <= MARKERS, command
        seen += 1
    assert seen


@EACH
def test_no_job_may_do_more_than_it_needs(name):
    assert WORKFLOWS[name]["permissions"] == {"contents": "read"}
    granted = {job: content["permissions"] for job, content in jobs(name).items() if "permissions" in content}
    assert granted == ({"publish": {"id-token": "write"}} if name == "release.yml" else {})
    # Texts that others choose, such as titles, may not become part of a command.
    inserted = {match for command in commands(name) for match in re.findall(r"\$\{\{ (.*?) \}\}", command)}
    assert inserted <= {"github.run_number"}


def test_a_release_waits_for_everything():
    assert set(jobs("release.yml")["publish"]["needs"]) == set(jobs("release.yml")) - {"publish"}


def test_all_supported_pythons_are_tested():
    prefix = "Programming Language :: Python :: 3."
    claimed = {each.rpartition(" ")[2] for each in PYPROJECT["project"]["classifiers"] if each.startswith(prefix)}
    for job in ("systems", "versions"):
        assert claimed <= set(jobs("tests.yml")[job]["strategy"]["matrix"]["python"])
    (tested,) = re.findall(r"^PYTHONS \?= (.*)$", MAKEFILE, re.MULTILINE)
    assert {each.removeprefix("python") for each in tested.split()} == claimed
    assert f">={min(claimed, key=lambda each: int(each.partition('.')[2]))}" == PYPROJECT["project"]["requires-python"]
