"""By keyboard alone, on a narrow screen, in the dark: everything is within reach."""

import pytest
from numpy.testing import assert_allclose

pytestmark = pytest.mark.browser

SAME = 1e-9  # a prescribed load is met to the rounding of a sum over strips

WALK = """() => {
  const active = document.activeElement;
  const box = active.getBoundingClientRect();
  const style = getComputedStyle(active);
  return {
    name: active.name || active.id || active.ariaLabel || active.dataset.action || active.tagName,
    seen: box.width > 0 && box.height > 0,
    outlined: active === document.body || style.outlineStyle !== "none",
  };
}"""


def test_everything_is_reached_with_tab_in_the_order_of_the_page(desk):
    walked = []
    for _ in range(120):
        desk.page.keyboard.press("Tab")
        walked.append(desk.page.evaluate(WALK))
        if walked[-1]["name"] == "BODY":
            break
    names = [each["name"] for each in walked]
    assert names[0] == "A"  # the link that skips to the results
    wanted = ["open", "share", "pin", "theme", "title", "load.load", "body.a.diameter", "body.b.kind", "stress-on"]
    places = [names.index(each) for each in wanted]
    assert places == sorted(places)
    assert names.index("load, slider") > names.index("load.load")
    assert all(each["seen"] for each in walked[:-1])
    assert all(each["outlined"] for each in walked)


# Whether the control in focus lies under its meaning at the foot of the form, or the numbers above the results.
COVERED = """() => {
  const active = document.activeElement;
  const box = active.getBoundingClientRect();
  const strips = [...document.querySelectorAll(".help, .above")]
    .filter(each => !each.contains(active) && each.offsetHeight > 1);
  const fixed = (each) => getComputedStyle(each).position === "fixed";
  if (box.height > 0.5 * innerHeight) return { name: active.tagName, under: 0 }; // the page, or a table
  const under = strips.filter(each => active.closest(".editor, .results")?.contains(each) || fixed(each))
    .map(each => each.getBoundingClientRect())
    .filter(each => box.bottom > each.top + 0.5 && box.top < each.bottom - 0.5);
  return { name: active.name || active.id || active.tagName, under: under.length };
}"""


@pytest.mark.parametrize("size", [(1440, 900), (390, 844)], ids=["desk", "phone"])
@pytest.mark.parametrize("key", ["Tab", "Shift+Tab"])
def test_nothing_in_focus_lies_under_what_stays_in_place(desk, key, size):
    desk.page.set_viewport_size(dict(zip(("width", "height"), size, strict=True)))
    walked = []
    for _ in range(120):
        desk.page.keyboard.press(key)
        walked.append(desk.page.evaluate(COVERED))
        if walked[-1]["name"] == "BODY":
            break
    assert len({each["name"] for each in walked}) > 30
    assert [each["name"] for each in walked if each["under"]] == []


def test_the_first_link_skips_to_the_results_and_menus_and_dialogs_are_left_with_escape(desk):
    desk.page.keyboard.press("Tab")
    desk.page.keyboard.press("Enter")
    assert desk.page.evaluate("() => document.activeElement.id") == "results"
    assert_allclose(desk.numbers["Load"], 20000.0, rtol=SAME)
    desk.page.locator('[popovertarget="downloads"]').focus()
    desk.page.keyboard.press("Enter")
    assert desk.page.locator('[data-download="case.toml"]').is_visible()
    desk.page.keyboard.press("Escape")
    assert not desk.page.locator('[data-download="case.toml"]').is_visible()
    desk.page.locator('[data-measured="a"]').focus()
    desk.page.keyboard.press("Enter")
    assert desk.page.locator("#measured").is_visible()
    desk.page.keyboard.press("Escape")
    assert desk.page.evaluate("() => document.activeElement.dataset.measured") == "a"


def test_the_focus_stays_where_the_form_is_made_anew(desk):
    where = "() => document.activeElement.name || document.activeElement.dataset.action"
    kind = desk.field("body.a.profile[1].kind")
    kind.focus()
    before = desk.answers
    kind.select_option("crown")
    desk.wait_for_answer(before)
    assert desk.page.evaluate(where) == "body.a.profile[1].kind"
    remove = desk.page.locator('button[data-action="remove"][data-path="body.a.profile[1]"]')
    remove.focus()
    before = desk.answers
    desk.page.keyboard.press("Enter")
    desk.wait_for_answer(before)
    assert desk.page.evaluate(where) == "add"


def test_every_input_has_a_name_and_every_figure_words(desk):
    nameless = desk.page.locator("input:not([type=hidden]):not([hidden]), select").evaluate_all(
        "all => all.filter(each => !each.labels.length && !each.getAttribute('aria-label')).map(each => each.outerHTML)"
    )
    assert nameless == []
    labels = desk.page.locator("main [role=img]").evaluate_all(
        "all => all.map(each => each.getAttribute('aria-label'))"
    )
    assert len(labels) == 9  # the sketch, four figures along the contact, two of stress, two profiles
    assert all(label.endswith(".") for label in labels)
    identifiers = desk.page.locator("[id]").evaluate_all("all => all.map(each => each.id)")
    assert len(set(identifiers)) == len(identifiers)


def test_a_narrow_screen_shows_results_first_and_the_form_on_demand(open_desk):
    desk = open_desk(viewport={"width": 390, "height": 844})
    assert desk.page.evaluate("() => document.documentElement.scrollWidth") <= 390
    assert not desk.field("load.load").is_visible()
    assert desk.page.locator('[data-figure="pressure"]').bounding_box()["y"] < 844
    desk.photograph("narrow", whole=True)
    desk.page.locator("#editor > summary").click()
    desk.write("load.load", "25000")
    assert_allclose(desk.numbers["Load"], 25000.0, rtol=SAME)
    assert desk.page.evaluate("() => document.documentElement.scrollWidth") <= 390
    desk.photograph("narrow-form")
