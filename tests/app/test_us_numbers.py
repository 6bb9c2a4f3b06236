"""In US units, every number that is printed with a unit is one of the JSON of the same result, converted by pint."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pint
import pytest

from nonhertz.cli import main

EXAMPLES = Path(__file__).parents[2] / "examples"
PINT = pint.UnitRegistry()
#: US units as they are printed, and what they are of in files.
UNITS = {
    "in": ("inch", "mm"), "µin": ("microinch", "mm"), "lbf": ("lbf", "N"), "ksi": ("ksi", "MPa"), "psi": ("psi", "MPa"),
    "lbf in": ("lbf * inch", "N * mm"), "lbf/µin": ("lbf / microinch", "N / mm"), "lbf/mrad": ("lbf / mrad", "N / rad"),
    "lbf in/mil": ("lbf * inch / thou", "N * mm / mm"), "lbf in/mrad": ("lbf * inch / mrad", "N * mm / rad"),
}  # fmt: skip
#: How many numbers follow from others and are in no file: the range of a stress, the pitch circle, a diameter in the
#: middle of a cone, the size of cells.
DERIVED = {
    "stress crowned-roller.toml": 1, "bearing nu206-mounted.toml": 1, "bearing tapered-pair.toml": 2,
    "compare elliptical-point-contact.toml": 2,
}  # fmt: skip
NUMBER = r"-?\d+\.?\d*(?:e[+-]\d+)?"
IN_A_ROW = r"-?(?:\d+\.\d+|0)(?:e[+-]\d+)?"  # a count before a size is none of its numbers
SHOWN = re.compile(
    rf"((?:{IN_A_ROW}(?: to |, | and | x ))*{NUMBER}) ({'|'.join(sorted(UNITS, key=len)[::-1])})(?![\w/^]| in\^)"
)


def numbers(found: Any) -> Iterator[float]:
    if isinstance(found, dict):
        for name, value in found.items():
            if name != "numbers":
                yield from numbers(value)
            else:
                yield from (each for one in value.values() if isinstance(one, dict) for each in numbers(one["value"]))
    elif isinstance(found, list):
        for value in found:
            yield from numbers(value)
    elif isinstance(found, int | float):
        yield float(found)


def rounding(text: str) -> float:
    """Half a unit of the last digit."""
    mantissa, _, power = text.partition("e")
    return 0.5 * 10.0 ** (int(power or 0) - len(mantissa.partition(".")[2]))


@pytest.mark.slow
@pytest.mark.parametrize(
    "words",
    [
        ["solve", "roller-15x20.toml"],
        ["solve", "crowned-roller.toml"],
        ["stress", "crowned-roller.toml"],
        ["life", "crowned-roller.toml"],
        ["bearing", "nu206-mounted.toml"],
        ["bearing", "tapered-pair.toml"],
        ["compare", "elliptical-point-contact.toml"],
    ],
    ids=" ".join,
)
def test_printed_numbers_are_those_of_the_json(words, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "300")
    command = [words[0], str(EXAMPLES / words[1])]
    assert main([*command, "--json"]) == 0
    known = [abs(each) for each in numbers(json.loads(capsys.readouterr().out))]
    assert main([*command, "--units", "us"]) == 0
    printed = capsys.readouterr().out
    seen = [(each, unit) for texts, unit in SHOWN.findall(printed) for each in re.findall(NUMBER, texts)]
    assert len(seen) > 5
    strange = []
    for text, unit in seen:
        us, si = UNITS[unit]
        size = PINT.Quantity(1.0, us).to(si).magnitude
        value, off = size * abs(float(text)), 1.0001 * size * rounding(text)
        if not any(abs(each - value) <= off for each in known):
            strange.append(f"{text} {unit}")
    assert len(strange) <= DERIVED.get(" ".join(words), 0), strange


def test_a_table_of_several_cases_stays_in_si(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for units in ("si", "us"):
        cases = [str(EXAMPLES / f"{name}.toml") for name in ("crowned-roller", "roller-15x20")]
        assert main(["solve", *cases, "--out", f"{units}.csv", "--units", units]) == 0
    assert Path("us.csv").read_text("utf-8") == Path("si.csv").read_text("utf-8")
    assert "mm wide" in Path("us.csv").read_text("utf-8")
