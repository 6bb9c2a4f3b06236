"""The parameter curve: drawn while it is worked out, and kept while the slider is dragged."""

import re

import pytest
from desk import Desk

pytestmark = pytest.mark.browser


def drawn(desk: Desk) -> None:
    desk.page.locator("#curve[data-state=done]").wait_for(state="attached")


def points(desk: Desk) -> int:
    return desk.page.locator('[data-figure="curve"] circle').count()


def words(desk: Desk) -> str:
    return desk.page.locator('[data-figure="curve"] svg[role=img]').get_attribute("aria-label")


def test_a_slider_becomes_a_curve_and_another_one_the_next(desk):
    assert desk.page.locator("#curve-choices").is_hidden()
    desk.page.locator("#curve-on").check()
    drawn(desk)
    assert desk.page.locator("#curve-path").input_value() == "load.load"
    assert points(desk) == 33 + 1  # and the case that is shown
    assert re.match(
        r"Maximum pressure over load: least 15\d\d MPa at 10.00 kN, largest 28\d\d MPa at 40.00 kN\.", words(desk)
    )
    desk.page.locator("#curve-quantity").select_option("approach")
    assert words(desk).startswith("Approach over load")
    desk.photograph("curve", whole=True)
    # While its slider is dragged the curve stays and the mark moves.
    asked: list[str] = []
    desk.page.on("request", lambda request: asked.append(request.url))
    mark = desk.page.locator('[data-figure="curve"] circle').last
    before = mark.get_attribute("cx")
    desk.write("load.load", "15000")
    assert mark.get_attribute("cx") != before
    assert not [url for url in asked if url.endswith("/curve")]
    # Another one that is dragged is the next curve.
    desk.slider("load.tilt").press("ArrowRight")
    assert desk.page.locator("#curve-path").input_value() == "load.tilt"
    drawn(desk)
    assert "over tilt" in words(desk)
    assert [url for url in asked if url.endswith("/curve")]


def test_values_without_a_solution_are_told(desk):
    desk.page.locator("#curve-on").check()
    drawn(desk)
    desk.page.locator("#curve-path").select_option("body.a.profile[1].fraction")
    desk.type(desk.page.locator("#curve-low"), "0.9")
    desk.type(desk.page.locator("#curve-high"), "1.5")
    desk.page.locator("#curve-high").press("Tab")
    desk.page.wait_for_timeout(100)
    drawn(desk)
    assert "have no solution" in desk.page.locator("#curve-note").inner_text()


def test_curves_that_are_superseded_keep_no_answer_waiting(desk):
    """Whoever answers is busy with points of curves that nobody waits for any more."""
    statuses = []
    desk.page.on("response", lambda response: statuses.append(response.status))
    desk.page.locator("#curve-on").check()
    desk.page.locator("#curve-path").select_option("load.tilt")
    desk.page.locator('#case summary:text-is("Solver")').click()
    desk.write("solver.strips", "300")
    for load in range(21, 27):
        desk.write("load.load", f"{load} kN")
    desk.settle(within=120.0)
    assert set(statuses) == {200}
