"""Pinning, links, files: what is on the page can be kept, compared and carried elsewhere."""

import json
import tomllib

import pytest
from desk import Desk, packed, unpacked
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz.files.starting import starting_case

pytestmark = pytest.mark.browser

SAME = 1e-9  # the same solve of the same numbers, through JSON or TOML, which keep all digits


def row(desk: Desk, number: int) -> dict[str, str]:
    """What a row of the table of pinned cases has below its heads; 0 is the first, -1 the case in the form.

    The stress of all of a body follows later than that below the maximum pressure: it is left out.
    """
    heads = desk.page.locator("#pins thead th").all_inner_texts()
    cells = desk.page.locator("#pins tbody tr").nth(number).locator("th, td").all_inner_texts()
    return {head: cell for head, cell in zip(heads, cells, strict=True) if head != "von Mises stress"}


def pinned(desk: Desk) -> list[str]:
    """The names of what is pinned."""
    names: list[str] = desk.page.locator("#pins input").evaluate_all("all => all.map(each => each.value)")
    return names


def test_pinned_cases_stay_beside_the_next(desk):
    before = desk.numbers
    desk.page.locator("#pin").click()
    desk.write("load.load", "26 kN")
    assert row(desk, 0)["Load"] == "20.00 kN"
    assert desk.page.locator('[data-key="Load"] .pinned-number').text_content().strip() == "+30.0 % from the pinned one"
    assert row(desk, -1)["Load"] == "26.00 kN\n+30.0 %"
    now = desk.numbers
    change = 100.0 * (now["Maximum pressure"] / before["Maximum pressure"] - 1.0)
    words = desk.page.locator('[data-key="Maximum pressure"] .pinned-number b').inner_text()
    assert_allclose(float(words.removesuffix(" %")), change, atol=0.051)  # written with one decimal, or two
    # It rises with the load, since that of the ideal profile falls faster.
    assert desk.page.locator('[data-key="Life"] .pinned-number b').inner_text() == "under another load"
    for figure in ("pressure", "half-width", "gap"):
        caption = desk.page.locator(f'[data-figure="{figure}"] figcaption')
        assert "pinned" in caption.inner_text()
        assert "first pinned" not in caption.inner_text()

    desk.page.locator("#pin").click()
    desk.write("body.a.length", "19")
    assert pinned(desk) == [tomllib.loads(starting_case())["title"], "load 26 kN"]
    assert row(desk, 1)["Load"] == "26.00 kN\n+30.0 %"
    for figure in ("pressure", "half-width", "gap"):
        assert "first pinned" in desk.page.locator(f'[data-figure="{figure}"] figcaption').inner_text()
    assert "first pinned" in desk.page.locator('[data-figure="profile-a"] figcaption').inner_text()
    desk.photograph("pinned")
    # Back to the first, by the keyboard; one is taken away, then the other.
    desk.page.locator("#pins button").first.focus()
    answers = desk.answers
    desk.page.keyboard.press("Enter")
    desk.wait_for_answer(answers)
    assert desk.numbers == before
    desk.page.locator("#pins button", has_text="Unpin").first.click()
    assert pinned(desk) == ["load 26 kN"]
    assert row(desk, -1)["Load"] == "20.00 kN\n−23.1 %"
    assert desk.page.evaluate("() => document.activeElement.textContent") == "Go back"
    desk.page.locator("#pins button", has_text="Unpin").click()
    assert not desk.page.locator("#pins").is_visible()
    assert desk.page.locator(".pinned-number").count() == 0
    assert desk.page.evaluate("() => document.activeElement.id") == "pin"


def test_a_link_brings_the_case_and_the_pinned_ones(desk, open_desk):
    desk.page.locator("#pin").click()
    desk.page.locator("#pins input").fill("As built")
    desk.write("load.load", "31 kN")
    desk.page.locator("#pin").click()
    desk.write("body.a.profile[1].amplitude", "6 um")
    desk.page.locator("#share").click()
    desk.page.locator("#share", has_not_text="Copy link").wait_for()
    fragment = desk.page.evaluate("() => location.hash")
    other = open_desk(fragment)
    other.page.locator(".pinned-number").first.wait_for()
    assert other.numbers == desk.numbers
    assert other.shown("body.a.profile[1].amplitude") == "6 um"
    assert pinned(other) == ["As built", "load 31 kN"]
    assert [row(other, number) for number in (0, 1, -1)] == [row(desk, number) for number in (0, 1, -1)]
    document = unpacked(fragment.removeprefix("#c=").partition("&")[0])
    assert document["load"]["load"] == "31 kN"
    assert document["body"]["b"] == tomllib.loads(starting_case())["body"]["b"]


def test_going_back_loses_no_work(desk):
    desk.write("load.load", "31 kN")
    desk.page.wait_for_url(lambda url: "#c=" in url)
    before = desk.numbers
    desk.page.reload()
    desk.settle()
    assert desk.numbers == before


@pytest.mark.parametrize("fragment", ["#c=%%%", "#c=" + packed({"title": "x" * 2_000_000})])
def test_a_link_that_was_cut_says_so_and_the_page_goes_on(open_desk, fragment):
    desk = open_desk(fragment)
    assert_allclose(desk.numbers["Load"], 20000.0, rtol=SAME)
    assert "copy it again" in desk.page.locator("#notice").inner_text()


def test_the_downloaded_case_solves_to_what_the_page_shows(desk, tmp_path):
    desk.write("load.load", "23.5 kN")
    desk.write("body.a.profile[1].amplitude", "0.004")
    path = tmp_path / "case.toml"
    path.write_bytes(desk.download("case.toml"))
    found, shown = nh.read_case(path).solve(), desk.numbers
    assert_allclose(shown["Maximum pressure"], found.max_pressure, rtol=SAME)
    assert_allclose(shown["Approach"], found.approach, rtol=SAME)
    assert_allclose(shown["Half-width"], found.half_width.max(), rtol=SAME)
    assert_allclose(json.loads(desk.download("result.json"))["centre_pressure"], found.centre_pressure, rtol=SAME)


def test_a_case_file_is_opened_or_dropped(desk, tmp_path):
    text = starting_case().replace("load = 20000.0", 'load = "12 kN"')
    path = tmp_path / "another.toml"
    path.write_text(text, encoding="utf-8")
    before = desk.answers
    desk.page.locator("#open-file").set_input_files(path)
    desk.wait_for_answer(before)
    assert_allclose(desk.numbers["Load"], 12000.0, rtol=SAME)
    assert desk.shown("load.load") == "12 kN"
    before = desk.answers
    desk.drop("#results", "third.toml", text.replace("12 kN", "13 kN"))
    desk.wait_for_answer(before)
    assert_allclose(desk.numbers["Load"], 13000.0, rtol=SAME)
