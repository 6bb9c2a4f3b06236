"""Reports in US units: what they refuse, what stays, and figures with ticks that are round in those units."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest
from matplotlib.contour import ContourSet
from matplotlib.figure import Figure

from nonhertz import plot
from nonhertz.amounts import read_in
from nonhertz.cli import main
from nonhertz.files.bearingfile import read_bearing
from nonhertz.files.casefile import read_case
from nonhertz.report import compose
from nonhertz.show.analysis import largest_stresses, solved

EXAMPLES = Path(__file__).parents[2] / "examples"
CASE = EXAMPLES / "roller-15x20.toml"
INCH, KSI, POUND = 25.4, 1e3 * 4.4482216152605 / 25.4**2, 4.4482216152605
#: What labels of axes end in, and the sizes of these units in those of SI figures: mm, µm, MPa, kN.
SIZES = {"[in]": INCH, "[µin]": 1e-3 * INCH, "[ksi]": KSI, "[lbf]": 1e-3 * POUND}
MANTISSAS = (1.0, 2.0, 2.5, 4.0, 5.0, 10.0)


def ticks(figure: Figure) -> list[tuple[str, list[tuple[float, float]]]]:
    """Return label, and place and number of every tick that is seen, of each axis that has a unit."""
    figure.draw_without_rendering()
    found = []
    for axes in figure.axes:
        for axis, (low, high) in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
            if not axis.get_label_text().endswith("]"):
                continue
            seen = [
                (place, tick.label1.get_text() or tick.label2.get_text())
                for tick, place in zip(axis.get_major_ticks(), axis.get_majorticklocs(), strict=False)
                if min(low, high) <= place <= max(low, high)
            ]
            numbers = [(place, float(text.replace("−", "-"))) for place, text in seen if text]
            found.append((axis.get_label_text(), numbers))
    return found


def figures_in(units: str) -> dict[str, Figure]:
    """Return figures of a contact and of a bearing."""
    with read_in(units):
        solution = solved(read_case(CASE))
        found = plot.figures(solution) | plot.stress_figures(solution, *largest_stresses(solution))
        of_bearing = plot.bearing_figures(read_bearing(EXAMPLES / "nu206.toml").solve())
        return found | {f"bearing-{name}": figure for name, figure in of_bearing.items()}


@pytest.fixture(scope="module", name="figures")
def figures_once() -> dict[str, Figure]:
    return figures_in("us")


@pytest.fixture(scope="module", name="usual")
def usual_once() -> dict[str, Figure]:
    return figures_in("si")


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    [
        *("pressure", "footprint", "profile", "axial-plane", "cross-section"),
        *("bearing-pressure", "bearing-roller", "bearing-displacement"),
    ],
)
def test_ticks_are_round_and_where_they_say(figures: dict[str, Figure], usual: dict[str, Figure], name: str) -> None:
    found = ticks(figures[name])
    assert len(found) >= 2
    for (label, places), (_, before) in zip(found, ticks(usual[name]), strict=True):
        assert any(label.endswith(unit) for unit in SIZES), label
        for place, number in [*places, *before]:
            assert place == pytest.approx(number, rel=1e-9, abs=1e-9), label
        step = min(np.diff(sorted(number for _, number in places)))
        assert step / 10.0 ** math.floor(math.log10(step) + 1e-9) == pytest.approx(
            min(MANTISSAS, key=lambda each: abs(each - step / 10.0 ** math.floor(math.log10(step) + 1e-9)))
        ), label


@pytest.mark.slow
def test_what_is_drawn_is_what_is_drawn_in_si_units(figures: dict[str, Figure], usual: dict[str, Figure]) -> None:
    compared = 0
    for name, figure in figures.items():
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


def test_contours_are_labelled_with_round_numbers(figures: dict[str, Figure]) -> None:
    contours = [each for each in figures["cross-section"].findobj(ContourSet) if each.labelTexts]
    assert contours
    for lines in contours:
        assert all(abs(level - round(level)) < 1e-9 for level in lines.levels)
        assert {float(text.get_text()) for text in lines.labelTexts} <= {float(f"{each:.4g}") for each in lines.levels}


def test_rings_of_loads_are_round(figures: dict[str, Figure]) -> None:
    axes = next(each for each in figures["bearing-loads"].axes if each.name == "polar")
    rings = [text for text in axes.texts if re.fullmatch(r"\d+ lbf", text.get_text()) and text.get_position()[1] > 0.0]
    assert len(rings) >= 2
    for text in rings:
        number = float(text.get_text().removesuffix(" lbf"))
        assert text.get_position()[1] == pytest.approx(number)
        assert number % 50.0 == 0.0


def test_no_unit_of_a_figure_is_left(figures: dict[str, Figure]) -> None:
    from matplotlib.text import Text

    for name, figure in figures.items():
        for text in figure.findobj(Text):
            assert not re.search(r"(?<![\w/])(mm|um|µm|MPa|kN|N)(?![\w])", text.get_text()), (name, text.get_text())


@pytest.mark.slow
def test_figures_of_files_stay_in_si(tmp_path: Path) -> None:
    for units in ("si", "us"):
        assert main(["stress", str(CASE), "--out", str(tmp_path / units), "--units", units]) == 0
    for path in (tmp_path / "si").iterdir():
        assert (tmp_path / "us" / path.name).read_bytes() == path.read_bytes()


@pytest.mark.slow
def test_the_files_in_a_report_stay_in_si() -> None:
    def files(page: str) -> list[str]:
        return re.findall(r'<ul class="files">.*?</details>', page, re.DOTALL)

    cases = [read_case(CASE)]
    us, si = compose(cases, units="us", stress=False), compose(cases, stress=False)
    assert files(us) == files(si)
    assert "Units are in, lbf, ksi and rad" in us
    assert "Units are mm" not in us


@pytest.mark.slow
def test_what_the_user_wrote_stays(tmp_path: Path) -> None:
    text = CASE.read_text(encoding="utf-8").replace("Roller 15 x 20 on a ring of 80", "Roller 20 mm, 5 kN")
    (tmp_path / "case.toml").write_text(text, encoding="utf-8")
    case = read_case(tmp_path / "case.toml")
    page = compose([case], units="us", stress=False)
    assert page.count("Roller 20 mm, 5 kN") == compose([case], stress=False).count("Roller 20 mm, 5 kN") > 1
    assert "<small>written 15 kN</small>" in page
