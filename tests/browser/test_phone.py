"""The report on a phone: nothing makes the page scroll sideways, and figures fit until they are touched."""

import pytest

from nonhertz.files.casefile import read_case
from nonhertz.files.starting import starting_bearing, starting_case
from nonhertz.report import TitleBlock, compose

pytestmark = pytest.mark.browser

PHONE = {"width": 390, "height": 844}
# Elements that reach beyond the screen, but for what scrolls within itself.
BEYOND = """() => [...document.querySelectorAll("body *")]
    .filter((each) => !each.closest("svg, .wide, pre") && each.getBoundingClientRect().right > innerWidth + 1)
    .map((each) => each.outerHTML.slice(0, 80))"""
ASIDE = "document.documentElement.scrollWidth - innerWidth"
WIDTHS = """() => [...document.querySelectorAll(".sheet")].map((each) => [each.scrollWidth, each.clientWidth])"""


@pytest.fixture(scope="module")
def reports(tmp_path_factory):
    """A folder with reports of a contact, of two compared, and of a bearing."""
    from nonhertz.files.bearingfile import read_bearing

    folder = tmp_path_factory.mktemp("reports")
    (folder / "a-case-with-a-rather-long-name.toml").write_text(starting_case(), encoding="utf-8")
    (folder / "b.toml").write_text(starting_case().replace("20 kN", "30 kN"), encoding="utf-8")
    (folder / "bearing.toml").write_text(starting_bearing(), encoding="utf-8")
    cases = [read_case(folder / name) for name in ("a-case-with-a-rather-long-name.toml", "b.toml")]
    block = TitleBlock(project="P" * 120, author="A. Author")
    texts = {
        "one": compose(cases[:1], life=True, title_block=block),
        "two": compose(cases, life=True, stress=False),
        "bearing": compose([read_bearing(folder / "bearing.toml")], compare=True),
    }
    for name, text in texts.items():
        (folder / f"{name}.html").write_text(text, encoding="utf-8")
    return folder


@pytest.fixture
def phone(browser):
    page = browser.new_page(viewport=PHONE)
    yield page
    page.close()


@pytest.mark.parametrize("name", ["one", "two", "bearing"])
def test_a_phone_shows_it_without_scrolling_sideways(name, reports, phone):
    phone.goto((reports / f"{name}.html").as_uri())
    assert phone.evaluate(ASIDE) <= 0
    assert phone.evaluate(BEYOND) == []
    assert all(inner <= outer for inner, outer in phone.evaluate(WIDTHS))
    sheet = phone.locator(".sheet").first
    sheet.click()
    inner, outer = phone.evaluate(WIDTHS)[0]
    assert inner > 1.5 * outer
    assert phone.evaluate(ASIDE) <= 0
