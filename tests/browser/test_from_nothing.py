"""A bearing made on the page alone, by keyboard."""

import pytest
from conftest import STARTING
from desk import Desk

pytestmark = pytest.mark.browser

MOST_TABS = 300


def tab_to(desk: Desk, selector: str) -> None:
    """Go on with the tabulator until what is looked for has the focus."""
    for _ in range(MOST_TABS):
        desk.page.keyboard.press("Tab")
        if desk.page.evaluate("selector => document.activeElement.matches(selector)", selector):
            return
    pytest.fail(f"the tabulator does not lead to {selector}")


def in_form(path: str) -> str:
    return f'#case [name="{path}"]'


def assert_bears(desk: Desk, rollers: int) -> None:
    desk.page.locator('[data-figure="polar"] .remark', has_text="by strips").wait_for()
    assert desk.mistakes == []
    assert desk.numbers["Loaded rollers"] == rollers
    assert 500.0 < desk.numbers["Maximum pressure"] < 4000.0
    assert desk.page.locator("#rollers tbody tr").count() == rollers


def test_by_keyboard_alone(desk):
    keys = desk.page.keyboard
    tab_to(desk, "a.other")
    keys.press("Enter")
    desk.page.wait_for_url("**/bearing*")
    desk.settle(within=STARTING)
    tab_to(desk, '[popovertarget="templates"]')
    keys.press("Enter")
    tab_to(desk, '[data-template="cylindrical"]')
    before = desk.answers
    keys.press("Enter")
    desk.wait_for_answer(before)
    tab_to(desk, in_form("bearing.kind"))
    before = desk.answers
    keys.type("thrust")
    desk.wait_for_answer(before)
    for path, text in (("bearing.rollers", "12"), ("load.axial", "15 kN")):
        tab_to(desk, in_form(path))
        before = desk.answers
        keys.press("Control+A")
        keys.type(text)
        desk.wait_for_answer(before)
    assert_bears(desk, 12)
    desk.photograph("keyboard")
    tab_to(desk, "#undo")
    before = desk.answers
    keys.press("Enter")
    desk.wait_for_answer(before)
    assert desk.shown("load.axial") != "15 kN"
