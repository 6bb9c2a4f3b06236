"""US units of everything that is printed: each number is converted as its dimension says, each unit with its numbers.

The dimension of a number is not taken from the unit beside it. It is found by solving a similar case as well: with all
lengths longer by one factor and all moduli larger by another, a number of dimension length^p stress^q grows by the
product of their powers. Converted to US units it must change by the same powers of inch and ksi, up to a power of ten.
"""

from __future__ import annotations

import html
import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from rich.console import Console

import nonhertz as nh
from nonhertz.cli import main, printing

pytestmark = pytest.mark.xdist_group("units")  # by one worker, that what is read in both units is computed once
EXAMPLES = Path(__file__).parents[2] / "examples"
LENGTH, STRESS = 1.25, 1.07  # by which a similar case is larger
INCH, KSI = 25.4, 1e3 * 4.4482216152605 / 25.4**2

#: Powers of length and stress of what is printed: a number, length, curvature, stress, force, moment, force by length,
#: and the strength of a pressure that is singular as the root of the distance.
DIMENSIONS = ((0.0, 0.0), (1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (2.0, 1.0), (3.0, 1.0), (1.0, 1.0), (0.5, 1.0))
NUMBER = re.compile(r"(?<![\w.^])(?:\+-)?[-+−±]?\d+\.?\d*(?:e[-+]?\d+)?(?!\w)")
#: Words of units, and those that stand for them.
WORDS = {
    "mm": {"in"}, "µm": {"µin"}, "nm": {"µin"}, "#/mm": {"#/in"},
    "N": {"lbf"}, "kN": {"lbf"}, "MPa": {"ksi", "psi"}, "GPa": {"ksi"}, "m": {"in"},
    "g": {"lb"}, "t/mm^3": {"lb/in^3"},
    "N/µm": {"lbf/µin"}, "N/mrad": {"lbf/mrad"}, "N/mm": {"lbf/in"},
    "mm/µm": {"in/mil"}, "m/mrad": {"in/mrad"},
}  # fmt: skip
INITIAL = re.compile(r"\b[A-Z]\. (?=[A-Z])")  # of an author, who may be called N.
UNIT = re.compile(rf"[\[(]?({'|'.join(sorted(map(re.escape, WORDS), key=len, reverse=True))})(?:[\])^.,;:][^/]*)?")

#: No powers of length and stress: what stands for a gram and for a tonne per cubic millimetre.
MASSES = {"g": 1e-3 / 0.45359237, "t/mm^3": 1e3 / 0.45359237 * INCH**3}

ROLLER = """
title = "A roller"
[body.a]
kind = "roller"
diameter = {L15}
length = {L20}
corner_radius = {L05}
material = {{ modulus = {E}, poisson = 0.3 }}
profile = [{{ kind = "logarithmic", length = {L20}, fraction = 0.95, amplitude = {A} }}]
[body.b]
kind = "ring"
diameter = {L80}
length = {L24}
material = {{ modulus = {E}, poisson = 0.3 }}
[load]
load = {F15000}
{more}
"""
SHARP = """
title = "Sharp ends"
[body.a]
diameter = {L20}
length = {L20}
side_faces = "none"
material = {{ modulus = {E}, poisson = 0.3, yield_strength = {S1200}, pressure_limit = {S4000} }}
[body.b]
material = {{ modulus = {E}, poisson = 0.3 }}
[load]
load = {F20000}
tilt = 0.5e-3
"""
BEARING = """
title = "A bearing"
[bearing]
kind = "cylindrical"
rollers = 13
clearance = {C}
density = {D}
[roller]
diameter = {L9}
length = {L10}
effective_length = {L88}
material = {{ modulus = {E}, poisson = 0.3 }}
profile = [{{ kind = "crown", radius = {L1500} }}]
[inner]
diameter = {L375}
length = {L16}
depth = {L3}
material = {{ modulus = {E}, poisson = 0.3 }}
[outer]
diameter = -{L555}
length = {L16}
depth = {L3}
material = {{ modulus = {E}, poisson = 0.3 }}
[load]
radial = {F11000}
tilt = 1e-3
speed = 3000
"""


def similar(text: str, length: float, stress: float, **others: str) -> str:
    """Return a file with all lengths, moduli, forces and moments of a similar case."""
    force = stress * length**2
    lengths = {"05": 0.5, "15": 15, "20": 20, "80": 80, "24": 24, "9": 9, "10": 10, "88": 8.8, "1500": 1500.0}
    lengths |= {"375": 37.5, "555": 55.5, "16": 16, "3": 3.5}
    values = {f"L{name}": length * value for name, value in lengths.items()}
    values |= {"A": 0.004 * length, "C": 0.0184 * length, "E": 250e3 * stress, "D": 7.85e-9 * stress / length**2}
    values |= {f"F{value}": force * value for value in (11000, 15000, 20000)}
    values |= {"S1200": 1200 * stress, "S4000": 4000 * stress, "T": 8e3 * force * length}
    shown: dict[str, Any] = {name: f"{value:.12g}" for name, value in values.items()}
    return text.format(**shown, **{name: each.format(**shown) for name, each in others.items()})


def once(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a search below the surface that is made once for the same contact under the same load.

    What it returned while a case was read in SI units is used in US units, too: a unit in it would be noticed there.
    """
    made: dict[str, Any] = {}

    def found(solution: Any, *arguments: Any, **options: Any) -> Any:
        wanted = {name: each for name, each in options.items() if name not in ("threads", "announce")}
        key = repr((solution.contact, solution.load, solution.tilt, arguments, wanted))
        if key not in made:
            made[key] = function(solution, *arguments, **options)
        return made[key]

    return found


EXTREMES, EXPOSURE = once(nh.subsurface.extremes), once(nh.life.exposure)


@pytest.fixture(name="printed")
def printed_to(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> Callable[..., str]:
    """Return what a command prints, on lines as long as need be: otherwise cells would break in different places."""

    def wide(**how: Any) -> Console:
        return Console(**{**how, "width": 4000})

    monkeypatch.setattr(printing, "Console", wide)
    for module in ("show.analysis", "strength"):
        monkeypatch.setattr(f"nonhertz.{module}.extremes", EXTREMES)
    monkeypatch.setattr("nonhertz.life.assessment.exposure", EXPOSURE)
    monkeypatch.chdir(tmp_path)

    def run(*words: str) -> str:
        capsys.readouterr()
        assert main([*words]) == 0
        return capsys.readouterr().out

    return run


def compare_words(said: str, read: str) -> None:
    """Assert that nothing but numbers and units changes, and that all units do."""
    before, after = (NUMBER.sub("#", INITIAL.sub("", each)).split() for each in (said, read))
    assert len(before) == len(after)
    for one, other in zip(before, after, strict=True):
        unit = UNIT.fullmatch(one)
        if unit is None:
            assert one == other
        else:
            assert other in {one.replace(unit[1], word, 1) for word in WORDS[unit[1]]}, (one, other)


def compare_numbers(said: str, larger: str, read: str) -> set[tuple[float, float]]:
    """Assert that every number changes as its dimension says, and return which dimensions were found."""
    assert NUMBER.sub("#", said).split() == NUMBER.sub("#", larger).split()
    found = set()
    finds = [list(NUMBER.finditer(each)) for each in (said, larger, read)]
    assert len(finds[0]) == len(finds[1]) == len(finds[2])
    for one, two, three in zip(*finds, strict=True):
        here = f"{said[max(0, one.start() - 60) : one.end() + 20]!r} -> {three[0]!r}"
        value, grown, us = (value_of(each[0]) for each in (one, two, three))
        if value == 0.0 or grown == 0.0:
            assert (us == 0.0) == (value == 0.0), here
            continue
        slack = spacing(one[0]) + spacing(two[0])
        fitting = [(p, q) for p, q in DIMENSIONS if near(grown / value, LENGTH**p * STRESS**q, slack)]
        own = re.match(r" (\S+)", said[one.end() :])
        if own is not None and own[1].startswith("%"):
            # An error that was found may be another one in a similar case, but no unit changes it.
            assert three[0] == one[0], here
            continue
        if own is not None and own[1] in MASSES:
            assert us == pytest.approx(value * MASSES[own[1]], rel=1e-3), here
            continue
        with_unit = own is not None and UNIT.fullmatch(own[1]) is not None
        if not fitting or fitting == [(0.0, 0.0)]:
            # Numbers of standards and limits have a unit beside them; lives and angles have none.
            assert with_unit or three[0] == one[0], here
            continue
        ratios = [INCH**-p * KSI**-q for p, q in fitting if (p, q) != (0.0, 0.0)]
        tens = [us / value / ratio for ratio in ratios]
        rounded = spacing(one[0]) + spacing(three[0])
        same = (0.0, 0.0) in fitting and three[0] == one[0]
        good = any(each > 0.0 and near(each, 10.0 ** round(math.log10(each)), rounded) for each in tens)
        assert good or same, here
        found |= set(fitting) if len(fitting) == 1 else set()
    return found


def value_of(text: str) -> float:
    return float(text.removeprefix("+-").replace("−", "-").replace("±", ""))


def spacing(text: str) -> float:
    """Return the largest relative error of a number that was rounded to these digits."""
    mantissa = text.removeprefix("+-").partition("e")[0].strip("+-−±")
    decimals = len(mantissa.partition(".")[2])
    return 0.6 * 10.0**-decimals / abs(float(mantissa))


def near(one: float, other: float, slack: float) -> bool:
    return abs(one / other - 1.0) <= slack


LENGTHS, STRESSES, FORCES, MOMENTS, STIFFNESSES = (1.0, 0.0), (0.0, 1.0), (2.0, 1.0), (3.0, 1.0), (1.0, 1.0)
CASES = {
    "solve": (["solve"], ROLLER, {"more": "tilt = 0.3e-3"}, {LENGTHS, STRESSES, FORCES, MOMENTS, STIFFNESSES}),
    "solve under a moment": (["solve"], ROLLER, {"more": "moment = {T}"}, {LENGTHS, MOMENTS}),
    "solve, sharp ends": (["solve"], SHARP, {}, {LENGTHS, STRESSES, (0.5, 1.0)}),
    "stress": (["stress"], ROLLER, {"more": "tilt = 0.3e-3"}, {LENGTHS, STRESSES}),
    "stress, sharp ends": (["stress", "--body", "a"], SHARP, {}, {LENGTHS, STRESSES}),
    "map": (
        ["map", "--load", "0:{F15000} N:5", "--tilt", "0", "--accuracy", "0.1", "--set",
         *(f"body.{body}.{name}=none" for body in "ab" for name in ("side_faces", "depth"))],
        ROLLER, {"more": ""}, {LENGTHS},
    ),
    "bearing": (["bearing"], BEARING, {}, {LENGTHS, STRESSES, FORCES, MOMENTS, STIFFNESSES}),
}  # fmt: skip


#: That take seconds each: the whole body is searched for its stresses, or a map refined.
LONG = ("stress", "stress, sharp ends", "map")


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.slow] if name in LONG else []) for name in CASES]
)
def test_every_number_is_converted_as_its_dimension_says(name: str, printed: Callable[..., str]) -> None:
    command, text, others, dimensions = CASES[name]
    Path("one.toml").write_text(similar(text, 1.0, 1.0, **others), encoding="utf-8")
    Path("two.toml").write_text(similar(text, LENGTH, STRESS, **others), encoding="utf-8")
    first, *one = (similar(word, 1.0, 1.0) for word in command)
    two = [similar(word, LENGTH, STRESS) for word in command[1:]]
    said, larger = printed(first, "one.toml", *one), printed(first, "two.toml", *two)
    read = printed(first, "one.toml", *one, "--units", "us")
    compare_words(said, read)
    assert compare_numbers(said, larger, read) >= dimensions


COMMANDS = [
    *(["solve", name] for name in ("crowned-roller", "measured-roller", "tabulated-profile", "roller-15x20")),
    ["solve", "crowned-roller", "elliptical-point-contact"],
    ["stress", "roller-15x20"],
    ["life", "roller-15x20"],
    ["bearing", "nu206-mounted"],
    ["bearing", "tapered-pair"],
    ["bearing", "nu206", "--compare"],
    ["materials"],
    ["materials", "100Cr6"],
    ["sweep", "roller-15x20-sweep"],
]


def report_text(*words: str) -> str:
    """Return the text of a report, without what is not converted: files, formulas, what the user wrote, versions."""
    assert main(["report", *words, "--out", "report.html"]) == 0
    page = Path("report.html").read_text(encoding="utf-8")
    for left_out in (
        *(r"<style>.*?</style>", r"<pre.*?</pre>", r"<i>Source:.*?</i>", r'<ul class="references".*?</ul>'),
        *(r"<small>written.*?</small>", r'<ul class="files">.*?</ul>', r"<footer>.*?</footer>", r"<title>.*?</title>"),
    ):
        page = re.sub(left_out, "", page, flags=re.DOTALL)
    return html.unescape(re.sub(r"<[^>]+>", " ", page))


REPORTS = {
    "roller": (ROLLER, {"more": "tilt = 0.3e-3"}, {LENGTHS, STRESSES, FORCES, MOMENTS, STIFFNESSES, (-1.0, 0.0)}),
    "sharp ends": (SHARP, {}, {LENGTHS, STRESSES, (0.5, 1.0)}),
    "bearing": (BEARING, {}, {LENGTHS, STRESSES, FORCES, MOMENTS, STIFFNESSES}),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", REPORTS)
def test_every_number_of_a_report_is_converted_as_its_dimension_says(name: str, printed: Callable[..., str]) -> None:
    text, others, dimensions = REPORTS[name]
    Path("one.toml").write_text(similar(text, 1.0, 1.0, **others), encoding="utf-8")
    said = report_text("one.toml")
    read = report_text("one.toml", "--units", "us")
    Path("one.toml").write_text(similar(text, LENGTH, STRESS, **others), encoding="utf-8")
    larger = report_text("one.toml")
    compare_words(said, read)
    assert compare_numbers(said, larger, read) >= dimensions


@pytest.mark.slow
@pytest.mark.parametrize(
    "names",
    [["roller-15x20", "--life"], ["nu206-mounted", "--compare"], ["tapered-pair"],
     ["roller-15x20", "measured-roller"], ["nu206", "nu206-mounted"]],
    ids=" ".join,
)  # fmt: skip
def test_every_unit_of_reports_is_converted_with_its_numbers(names: list[str], printed: Callable[..., str]) -> None:
    names = [str(EXAMPLES / f"{each}.toml") if not each.startswith("-") else each for each in names]
    said, read = report_text(*names), report_text(*names, "--units", "us")
    compare_words(said, read)
    compare_beside(said, read)


@pytest.mark.slow
@pytest.mark.parametrize("words", COMMANDS, ids=" ".join)
def test_every_unit_of_the_examples_is_converted_with_its_numbers(
    words: list[str], printed: Callable[..., str]
) -> None:
    words = [str(EXAMPLES / f"{each}.toml") if (EXAMPLES / f"{each}.toml").exists() else each for each in words]
    said, read = printed(*words), printed(*words, "--units", "us")
    compare_words(said, read)
    compare_beside(said, read)


def compare_beside(said: str, read: str) -> None:
    """Assert that numbers directly before a unit are converted to it, and that all others that change share one."""
    sizes = {
        "mm": 1.0,
        "µm": 1e-3,
        "in": INCH,
        "µin": 1e-6 * INCH,
        "N": 1.0,
        "kN": 1e3,
        "lbf": KSI * INCH**2 / 1e3,
    }
    sizes |= {"MPa": 1.0, "ksi": KSI, "psi": 1e-3 * KSI}
    pattern = re.compile(rf"({NUMBER.pattern}) ({'|'.join(sizes)})(?![\w/^ ]|\Z)")
    pairs = [pattern.findall(each) for each in (said, read)]
    assert len(pairs[0]) == len(pairs[1])
    for (one, unit), (other, word) in zip(*pairs, strict=True):
        value, us = value_of(one) * sizes[unit], value_of(other) * sizes[word]
        slack = 0.0 if value == 0.0 else spacing(one) + spacing(other)
        assert us == pytest.approx(value, rel=slack, abs=0.0), (one, unit, other, word)


@pytest.mark.slow
def test_json_and_files_never_change_units(printed: Callable[..., str]) -> None:
    case = str(EXAMPLES / "roller-15x20.toml")
    assert printed("solve", case, "--json", "--units", "us") == printed("solve", case, "--json")
    printed("solve", case, "--out", "si")
    printed("solve", case, "--out", "us", "--units", "us")
    for name in ("result.json", "table.csv"):
        assert Path("us", name).read_bytes() == Path("si", name).read_bytes()
