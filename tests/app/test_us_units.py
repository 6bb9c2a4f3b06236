"""Results in US units: numbers converted, words as they were, figures with ticks that are round; files stay in SI."""

import html
import re
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pint
import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text
from rich.console import Console

import nonhertz as nh
from nonhertz import plot
from nonhertz.amounts import display_units
from nonhertz.cli import main, printing
from nonhertz.files.bearingfile import read_bearing
from nonhertz.files.casefile import Case, read_case
from nonhertz.files.toml import parse
from nonhertz.report import compose
from nonhertz.show import bearing as of_bearing
from nonhertz.show import stresses
from nonhertz.show.analysis import assess_lives, choose_models, largest_stresses, solve_loads
from nonhertz.show.lives import sections as life_sections
from nonhertz.show.sections import Section, Table, with_columns_of_remarks
from nonhertz.show.solving import solve_case

EXAMPLES = Path(__file__).parents[2] / "examples"
CASE = EXAMPLES / "roller-15x20.toml"
PINT = pint.UnitRegistry()
#: US units as they are printed, and what they are of in files.
UNITS = {
    "in": ("inch", "mm"), "µin": ("microinch", "mm"), "lbf": ("lbf", "N"), "ksi": ("ksi", "MPa"), "psi": ("psi", "MPa"),
    "lbf in": ("lbf * inch", "N * mm"), "lbf/µin": ("lbf / microinch", "N / mm"), "lbf/mrad": ("lbf / mrad", "N / rad"),
    "lbf in/mil": ("lbf * inch / thou", "N * mm / mm"), "lbf in/mrad": ("lbf * inch / mrad", "N * mm / rad"),
}  # fmt: skip


def rounding(text: str) -> float:
    """Half a unit of the last digit."""
    mantissa, _, power = text.partition("e")
    return 0.5 * 10.0 ** (int(power or 0) - len(mantissa.partition(".")[2]))


# Words


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


ANY = re.compile(r"(?<![\w.^])(?:\+-)?[-+−±]?\d+\.?\d*(?:e[-+]?\d+)?(?!\w)")


def once(function: Callable[..., Any]) -> Callable[..., Any]:
    """Return a search below the surface that is made once for the same contact under the same load.

    What it returned while a case was read in SI units is used in US units, too: a unit in it would be noticed there.
    """
    made: dict[str, Any] = {}

    def found(solution: Any, *arguments: Any, **options: Any) -> Any:
        wanted = {name: each for name, each in options.items() if name not in ("threads", "callback")}
        key = repr((solution.contact, solution.load, solution.tilt, arguments, wanted))
        if key not in made:
            made[key] = function(solution, *arguments, **options)
        return made[key]

    return found


EXTREMES, EXPOSURE = once(nh.subsurface.extremes), once(nh.life.exposure)


@pytest.fixture(name="printed")
def printed_to(capsys, run, monkeypatch, tmp_path):
    """Return what a command prints, on lines as long as need be: otherwise cells would break in different places."""

    def wide(**how: Any) -> Console:
        return Console(**{**how, "width": 4000})

    monkeypatch.setattr(printing, "Console", wide)
    for module in ("show.analysis", "subsurface"):
        monkeypatch.setattr(f"nonhertz.{module}.extremes", EXTREMES)
    monkeypatch.setattr("nonhertz.life.assessment.exposure", EXPOSURE)
    monkeypatch.setattr("nonhertz.report.layout.image", lambda *_: b"<svg></svg>")  # whose words are not read here
    monkeypatch.chdir(tmp_path)

    def run(*words: str) -> str:
        capsys.readouterr()
        assert main([*words]) == 0
        return capsys.readouterr().out

    return run


def compare(said: str, read: str) -> None:
    """Assert that nothing changes but units, all of them, and numbers, which are converted to those behind them."""
    before, after = (ANY.sub("#", INITIAL.sub("", each)).split() for each in (said, read))
    assert len(before) == len(after)
    for one, other in zip(before, after, strict=True):
        unit = UNIT.fullmatch(one)
        if unit is None:
            assert one == other
        else:
            assert other in {one.replace(unit[1], word, 1) for word in WORDS[unit[1]]}, (one, other)
    units = "|".join(sorted({"mm", "µm", "in", "µin", "N", "kN", "lbf", "MPa", "ksi", "psi"}, key=len, reverse=True))
    pattern = re.compile(rf"({ANY.pattern}) ({units})(?![\w/^ ]|\Z)")
    pairs = [pattern.findall(each) for each in (said, read)]
    assert len(pairs[0]) == len(pairs[1])
    for before, after in zip(*pairs, strict=True):
        assert_same(before, after)


def report_text(*words: str) -> str:
    """Return the text of a report, without what is not converted: files, formulas, what the user wrote, versions."""
    assert main([*words, "--out", "report.html"]) == 0
    page = Path("report.html").read_text(encoding="utf-8")
    for left_out in (
        *(r"<style>.*?</style>", r"<pre.*?</pre>", r"<i>Source:.*?</i>", r'<ul class="references".*?</ul>'),
        *(r"<small>written.*?</small>", r'<ul class="files">.*?</ul>', r"<footer>.*?</footer>", r"<title>.*?</title>"),
    ):
        page = re.sub(left_out, "", page, flags=re.DOTALL)
    return html.unescape(re.sub(r"<[^>]+>", " ", page))


@pytest.mark.slow
@pytest.mark.parametrize(
    "words",
    [
        ["solve", "crowned-roller", "elliptical-point-contact"],
        ["stress", "roller-15x20"],
        ["life", "roller-15x20"],
        ["bearing", "nu206-mounted"],
        ["bearing", "nu206", "--compare"],
        ["materials", "100Cr6"],
        ["sweep", "roller-15x20-sweep"],
        ["report", "roller-15x20", "--life"],
    ],
    ids=" ".join,
)
def test_every_unit_is_converted_with_its_numbers(words, printed):
    words = [str(EXAMPLES / f"{each}.toml") if (EXAMPLES / f"{each}.toml").exists() else each for each in words]
    run = report_text if words[0] == "report" else printed
    compare(run(*words), run(*words, "--units", "us"))


def assert_same(*pairs: tuple[str, str]) -> None:
    """Assert that two numbers with their units are the same but for rounding."""
    (value, slack), (other, more) = (
        (size * float(text.removeprefix("+-").replace("−", "-").replace("±", "")), 1.2 * size * rounding(text))
        for text, unit in pairs
        for size in [PINT.Quantity(1.0, UNITS[unit][0] if unit in UNITS else unit).to_base_units().magnitude]
    )
    assert abs(value - other) <= slack + more, pairs


# Columns of tables, whose heads have the units


def columns(sections: list[Section]) -> Iterator[tuple[str, str, list[str]]]:
    """Yield head, unit and cells of every column that has a unit; the next ones of a ring have that of the first."""
    tables = (block for section in sections for block in section.blocks if isinstance(block, Table))
    for block in map(with_columns_of_remarks, tables):
        for at, head in enumerate(block.heads):
            found = re.search(r"\[(.*)\]", head)
            if found and found[1] not in ("deg", "10^6 rev"):
                yield head, found[1], [str(row[at]).partition(",")[0] for row in block.rows if len(row) > at]


def sections_in(units: str, made: Callable[[], list[Section]]) -> list[Section]:
    with display_units(units):
        return made()


@pytest.mark.slow
def test_columns_are_converted_with_their_heads():
    contact, nu206 = solve_case(read_case(CASE)), read_bearing(EXAMPLES / "nu206.toml")
    strips, slices = nu206.solve("strips"), nu206.solve("slices")
    largest, text = largest_stresses(contact), CASE.read_text(encoding="utf-8")
    for load in (9e3, 5e3):
        text += f"[[life.spectrum]]\nload = {load}\ntilt = 1e-4\nshare = 0.5\n"
    spectrum = Case.of(parse(text, "case.toml"), CASE)
    lives = assess_lives(spectrum, solve_loads(spectrum), choose_models(spectrum, ("iso-16281",))[0])
    seen = 0
    for made in (
        lambda: stresses.sections(contact, *largest, ()),
        lambda: of_bearing.sections(nu206, strips, *nu206.rated(strips)),
        lambda: of_bearing.compared_sections(nu206, strips, slices),
        lambda: life_sections(lives),
    ):
        for (_, unit, cells), (_, other, converted) in zip(
            *(columns(sections_in(units, made)) for units in ("si", "us")), strict=True
        ):
            for one, two in zip(cells, converted, strict=True):
                assert bool(one) == bool(two)
                if one:
                    assert_same((one.removeprefix("+-"), unit), (two.removeprefix("+-"), other))
                    seen += 1
    assert seen > 120


# Figures

INCH, KSI, POUND = 25.4, 1e3 * 4.4482216152605 / 25.4**2, 4.4482216152605
#: What labels of axes end in, and the sizes of these units in those of SI figures: mm, µm, MPa, kN.
SIZES = {"[in]": INCH, "[µin]": 1e-3 * INCH, "[ksi]": KSI, "[lbf]": 1e-3 * POUND}


@cache
def drawn() -> tuple[Any, ...]:
    """Return a contact, its largest stresses and a bearing."""
    solution = solve_case(read_case(CASE))
    return solution, largest_stresses(solution), read_bearing(EXAMPLES / "nu206.toml").solve()


def figures_in(units: str) -> dict[str, Figure]:
    """Return figures of a contact and of a bearing."""
    solution, largest, bearing = drawn()
    with display_units(units):
        found = plot.figures(solution) | plot.stress_figures(solution, *largest)
        others = plot.bearing_figures(bearing)
        return found | {f"bearing-{name}": figure for name, figure in others.items()}


@pytest.mark.slow
def test_what_is_drawn_is_what_is_drawn_in_si_units():
    compared, figures, usual = 0, figures_in("us"), figures_in("si")
    for name, figure in figures.items():
        for text in figure.findobj(Text):
            assert not re.search(r"(?<![\w/])(mm|um|µm|MPa|kN|N)(?![\w])", text.get_text()), (name, text.get_text())
        for axes, before in zip(figure.axes, usual[name].axes, strict=True):
            if axes.name == "polar":
                continue
            for axis, get in (("x", "get_xdata"), ("y", "get_ydata")):
                label = getattr(axes, f"get_{axis}label")()
                size = next((size for unit, size in SIZES.items() if label.endswith(unit)), None)
                through_data = [
                    pair
                    for pair in zip(axes.lines, before.lines, strict=True)
                    if pair[0].get_transform() == axes.transData
                ]
                for line, other in through_data if size else []:
                    there = np.asarray(getattr(other, get)(), dtype=float)
                    np.testing.assert_allclose(size * np.asarray(getattr(line, get)()), there, rtol=1e-9, atol=1e-12)
                    compared += 1
    assert compared > 20


# Files


@pytest.mark.slow
def test_json_and_files_never_change_units(printed):
    case = str(CASE)
    assert printed("solve", case, "--json", "--units", "us") == printed("solve", case, "--json")
    for units in ("si", "us"):
        printed("stress", case, "--out", units, "--units", units)
    for path in Path("si").iterdir():
        assert Path("us", path.name).read_bytes() == path.read_bytes()


@pytest.mark.slow
def test_the_files_in_a_report_and_what_the_user_wrote_stay(tmp_path):
    text = CASE.read_text(encoding="utf-8").replace("Roller 15 x 20 on a ring of 80", "Roller 20 mm, 5 kN")
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    cases = [read_case(tmp_path / "case.toml")]
    us, si = compose(cases, units="us", stress=False), compose(cases, stress=False)
    files = [re.findall(r'<ul class="files">.*?</details>', page, re.DOTALL) for page in (us, si)]
    assert files[0] == files[1]
    assert "Units are in, lbf, ksi and rad" in us
    assert "Units are mm" not in us
    assert us.count("Roller 20 mm, 5 kN") == si.count("Roller 20 mm, 5 kN") > 1
    assert "<small>written 15 kN</small>" in us
