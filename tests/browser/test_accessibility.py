"""axe finds nothing to complain of, in any state of the page."""

from collections.abc import Callable
from typing import Any

import pytest
from desk import Desk

axe = pytest.importorskip("axe_playwright_python.sync_playwright")
pytestmark = pytest.mark.browser


def violations(desk: Desk) -> list[str]:
    # What is dimmed for a moment is that of the case before.
    found = axe.Axe().run(desk.page, context={"exclude": [".stale"]}).response["violations"]
    return [f"{each['id']}: {each['help']} {[node['target'] for node in each['nodes']]}" for each in found]


def curve(desk: Desk) -> None:
    desk.page.locator("#curve-on").check()
    desk.page.locator("#curve[data-state=done]").wait_for(state="attached")


def measured(desk: Desk) -> None:
    desk.page.locator('button:has-text("Measured")').first.click()
    desk.page.locator("#measured[open]").wait_for()


def pinned(desk: Desk) -> None:
    desk.page.locator("#pin").click()
    desk.write("load.load", "30 kN")


def unfolded(desk: Desk) -> None:
    for fold in desk.page.locator("#case details > summary").all():
        fold.click()


def pointed(desk: Desk) -> None:
    desk.page.locator('[data-figure="pressure"] .drawing svg').hover()
    desk.page.locator('[data-figure="pressure"] .drawing svg text:has-text("p₀")').last.wait_for()


def sharp(desk: Desk) -> None:
    desk.press('button[data-action="remove"][data-path="body.a.profile[1]"]')


#: What is done to one page, thing by thing; a mistake is mended again.
DONE: dict[str, Callable[[Desk], Any]] = {
    "as it opens": lambda desk: None,
    "pointed at": pointed,
    "unfolded": unfolded,
    "menu": lambda desk: desk.page.locator('[popovertarget="templates"]').click(),
    "downloads": lambda desk: desk.page.locator('[popovertarget="downloads"]').click(),
    "closed again": lambda desk: desk.page.keyboard.press("Escape"),
    "curve": curve,
    "pinned": pinned,
    "sharp ends": sharp,
    "US units": lambda desk: desk.press("#units"),
    "mistake": lambda desk: desk.write("load.load", "30 kg"),
    "mended": lambda desk: desk.write("load.load", "30 kN"),
    "dark": lambda desk: desk.page.locator("#theme").click(),
    "measured": measured,
}


def test_of_a_contact(desk):
    for name, do in DONE.items():
        do(desk)
        assert violations(desk) == [], name


def test_of_a_contact_on_a_phone(open_desk):
    desk = open_desk(viewport={"width": 390, "height": 844})
    assert violations(desk) == []
    desk.page.locator("#editor > summary").click()
    assert violations(desk) == []


@pytest.mark.parametrize("width", [1400, 390])
def test_of_a_bearing(open_desk, width):
    desk = open_desk("bearing", viewport={"width": width, "height": 900})
    assert desk.page.evaluate("() => document.documentElement.scrollWidth") <= width
    assert violations(desk) == []
    desk.page.locator("#theme").click()
    assert violations(desk) == []
