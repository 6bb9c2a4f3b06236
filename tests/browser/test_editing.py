"""Typing, dragging, choosing: the result follows, and is what `nonhertz.solve` gives."""

import csv
import re
import statistics
import tomllib
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from desk import Desk, packed
from numpy.testing import assert_allclose

import nonhertz as nh
from nonhertz.files.casefile import Case
from nonhertz.files.starting import starting_case

pytestmark = pytest.mark.browser

SAME = 1e-9  # the same solve of the same numbers, through JSON, which keeps all digits


def solution_of(**changes: Any) -> nh.Solution:
    document = tomllib.loads(starting_case())
    document["load"] |= changes
    case = Case.of(document, Path("case.toml"))
    return nh.solve(case.contact, **case.prescribed.keywords, **case.solver.keywords)


def assert_shows(desk: Desk, solution: nh.Solution) -> None:
    shown = desk.numbers
    assert_allclose(shown["Maximum pressure"], solution.max_pressure, rtol=SAME)
    assert_allclose(shown["Approach"], solution.approach, rtol=SAME)
    assert_allclose(shown["Load"], solution.load, rtol=SAME)
    assert_allclose(shown["Half-width"], solution.half_width.max(), rtol=SAME)


def test_a_number_that_is_typed_changes_the_result(desk):
    assert_shows(desk, solution_of())
    before = desk.page.locator('[data-figure="pressure"] svg').inner_html()
    desk.write("load.load", "26500")
    assert_shows(desk, solution_of(load=26500.0))
    assert desk.page.locator('[data-figure="pressure"] svg').inner_html() != before
    desk.write("load.load", "26.5 kN")
    assert_shows(desk, solution_of(load=26500.0))
    spoken = desk.page.locator("#spoken")
    desk.page.locator("#spoken", has_text="maximum pressure").wait_for(state="attached")
    assert "approach" in spoken.inner_text()


def test_dragging_a_slider_shows_results_on_the_way_and_ends_with_the_last(desk):
    slider = desk.slider("load.load")
    box = slider.bounding_box()
    before, trips = desk.answers, len(desk.round_trips())
    mouse, y = desk.page.mouse, box["y"] + box["height"] / 2
    mouse.move(box["x"] + 0.5 * box["width"], y)
    mouse.down()
    for step in range(40):
        mouse.move(box["x"] + (0.5 + 0.003 * step) * box["width"], y)
        desk.page.wait_for_timeout(15)
    mouse.up()
    desk.settle()
    measured = desk.round_trips()[trips:]
    print(f"\nround trip while dragging: median {statistics.median(measured):.0f} ms of {len(measured)} answers")
    assert desk.answers - before >= 3
    assert_shows(desk, solution_of(load=desk.value("load.load")))


def handle_of(desk: Desk, side: str) -> Any:
    return desk.page.get_by_role("slider", name=f"Tilt, by the {side} end")


def middle_of(handle: Any) -> tuple[float, float]:
    box = handle.bounding_box()
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def test_a_body_is_tilted_by_the_ends_of_its_surface(desk):
    before = desk.value("load.tilt")
    for side, sign in (("right", 1.0), ("left", -1.0)):
        tilt = desk.value("load.tilt")
        handle = handle_of(desk, side)
        handle.scroll_into_view_if_needed()
        x, y = middle_of(handle)
        mouse = desk.page.mouse
        mouse.move(x, y)
        mouse.down()
        for step in range(1, 16):
            mouse.move(x + 2 * step, y + step)
            desk.page.wait_for_timeout(15)
        desk.page.wait_for_timeout(600)  # a rest within the drag is no end of it
        mouse.move(x, y + 30)
        desk.settle()
        assert abs(middle_of(handle)[1] - y - 30) < 4.0  # the end is where the pointer is
        mouse.up()
        desk.settle()
        assert sign * (desk.value("load.tilt") - tilt) > 1e-5  # downwards it goes deeper: the tilt grows at the right
        assert_shows(desk, solution_of(tilt=desk.value("load.tilt")))
        desk.page.locator("#undo:enabled").wait_for()
        desk.press("#undo")
        assert_allclose(desk.value("load.tilt"), before, rtol=SAME)
        desk.press("#units")  # the other end in US units


def test_a_finger_tilts_a_body(open_desk):
    desk = open_desk(viewport={"width": 390, "height": 844}, has_touch=True)
    if desk.is_firefox:
        pytest.skip("playwright moves no finger in Firefox")
    handle = handle_of(desk, "left")
    handle.evaluate("each => each.scrollIntoView({block: 'center'})")
    x, y = middle_of(handle)
    tilt, scrolled = desk.value("load.tilt"), desk.page.evaluate("() => window.scrollY")
    touch = desk.page.context.new_cdp_session(desk.page)
    for step in range(12):
        kind = "touchMove" if step else "touchStart"
        touch.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y - 2 * step}]})
        desk.page.wait_for_timeout(20)
    touch.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
    desk.settle()
    assert desk.value("load.tilt") - tilt > 1e-5
    assert desk.page.evaluate("() => window.scrollY") == scrolled
    assert_shows(desk, solution_of(tilt=desk.value("load.tilt")))


def test_a_template_is_where_to_start_from(desk):
    desk.page.locator('[popovertarget="templates"]').click()
    desk.press('[data-template="needle"]')
    assert desk.page.locator("h1").inner_text() == "Needle 3 x 15.8 on a shaft of 25"
    assert desk.shown("body.a.diameter") == "3 mm"
    assert not desk.page.locator("#templates [data-template]").first.is_visible()
    desk.press("#undo")
    assert_shows(desk, solution_of())


def test_what_was_drawn_goes_when_another_case_is_begun_and_comes_with_its_answer(desk):
    held: list[Any] = []

    def hold(route: Any) -> None:
        held.append(route)

    desk.page.route("**/solve", hold, times=1)
    desk.page.locator('[popovertarget="templates"]').click()
    with desk.page.expect_request("**/solve"):
        desk.page.locator('[data-template="needle"]').click()
    desk.page.locator(".results.empty").wait_for()
    assert not desk.page.locator(".key-numbers, .figures, #summary, #verdict").locator("visible=true").count()
    assert desk.page.locator("#state").inner_text() == "solving"
    desk.page.wait_for_timeout(100)
    held[0].continue_()
    desk.page.locator('[data-figure="pressure"] svg').first.wait_for()
    desk.settle()


def test_a_sketch_shows_what_is_pressed_on_what_and_marks_what_is_changed(desk):
    sketch, marked = desk.page.locator("#sketch > svg"), desk.page.locator("#sketch .changed")
    bodies = "body a, diameter 20.00 mm, 20.00 mm long pressed on body b, flat"
    assert sketch.get_attribute("aria-label") == f"At scale: {bodies}."
    assert marked.count() == 0
    desk.write("body.a.diameter", "30 mm")
    assert sketch.get_attribute("aria-label") == f"At scale: {bodies.replace('diameter 20', 'diameter 30')}."
    assert marked.get_attribute("class") == "body a changed"
    width, height = (
        marked.locator("path").nth(view).evaluate(f"shape => shape.getBBox().{side}")
        for view, side in ((1, "width"), (0, "height"))
    )
    assert_allclose(width / height, 20.0 / 30.0, rtol=1e-3)
    desk.write("load.load", "10 kN")
    assert marked.get_attribute("class") == "load changed"
    desk.page.locator('[popovertarget="templates"]').click()
    desk.press('[data-template="spherical"]')
    assert "hollow, diameter" in sketch.get_attribute("aria-label")
    assert marked.count() == 0
    desk.photograph("sketch")


def test_a_slow_answer_is_waited_for_and_given_up(desk):
    before = desk.numbers
    desk.page.route("**/solve", lambda route: None, times=1)
    desk.field("load.load").fill("25 kN")  # a single edit, in Firefox too
    desk.page.locator("#state", has_text="still solving").wait_for()
    assert not desk.mistakes
    assert "outdated" in desk.page.locator("#results").get_attribute("class")
    desk.page.locator("#cancel").click()
    desk.settle()
    assert desk.page.locator(".state").inner_text().strip() == "last good result cancelled"
    assert desk.numbers == before
    desk.write("load.load", "26 kN")
    assert_shows(desk, solution_of(load=26000.0))


def test_what_is_written_with_a_unit_is_taken_apart_when_the_field_is_left(desk):
    # A table that holds nothing any more is left out.
    desk.page.locator("details[data-details='report'] > summary").click()
    desk.write("report.author", "A. Author")
    assert b"[report]" in desk.download("case.toml")
    desk.write("report.author", "")
    assert b"[report]" not in desk.download("case.toml")
    desk.write("load.load", "4.2 kN")
    assert desk.field("load.load").input_value() == "4.2 kN"  # while it is being written
    desk.field("load.load").press("Tab")
    assert desk.shown("load.load") == "4.2 kN"
    assert desk.field("load.load").input_value() == "4.2"
    assert_shows(desk, solution_of(load=4200.0))
    desk.write("load.tilt", "2 °")
    desk.field("load.tilt").press("Tab")
    assert desk.shown("load.tilt") == "2 deg"
    desk.write("load.load", "4.2 kg")
    desk.field("load.load").press("Tab")
    assert desk.field("load.load").input_value() == "4.2 kg"
    assert "force" in " ".join(desk.mistakes)


def test_profiles_are_added_removed_and_changed(desk):
    profiles = desk.page.locator('fieldset[data-group^="body.a.profile["]')
    pressure = desk.numbers["Maximum pressure"]
    desk.page.locator('[data-additions="body.a.profile"]').select_option("crown")
    desk.press('button[data-action="add"][data-path="body.a.profile"]')
    assert profiles.count() == 2
    assert desk.field("body.a.profile[2].radius").input_value()
    crowned = desk.numbers["Maximum pressure"]
    assert crowned > pressure  # a crown on top takes the ends' share of the load to the middle

    before = desk.answers
    desk.field("body.a.profile[2].kind").select_option("conical")
    desk.wait_for_answer(before)
    assert desk.field("body.a.profile[2].angle").count() == 1
    assert desk.field("body.a.profile[2].radius").count() == 0

    desk.press('button[data-action="remove"][data-path="body.a.profile[2]"]')
    assert profiles.count() == 1
    assert_allclose(desk.numbers["Maximum pressure"], pressure, rtol=SAME)


def test_arrow_keys_move_a_slider_and_are_undone_and_redone(desk):
    first, slider = desk.numbers["Maximum pressure"], desk.slider("load.tilt")
    slider.focus()
    before = desk.answers
    slider.press("ArrowLeft")
    desk.wait_for_answer(before)
    assert 0.0 < desk.value("load.tilt") < 0.0005
    assert_shows(desk, solution_of(tilt=desk.value("load.tilt")))
    desk.page.locator("#undo:enabled").wait_for()
    second = desk.numbers["Maximum pressure"]
    desk.press("#undo")
    assert_allclose(desk.numbers["Maximum pressure"], first, rtol=SAME)
    before = desk.answers
    desk.page.locator("#stress-on").focus()
    desk.page.keyboard.press("Control+Shift+Z")
    desk.wait_for_answer(before)
    assert_allclose(desk.numbers["Maximum pressure"], second, rtol=SAME)


def test_an_edit_right_after_an_undo_is_kept(desk):
    tilt = desk.value("load.tilt")
    desk.write("load.tilt", "0.0001")
    desk.page.locator("#undo:enabled").wait_for()
    waiting: list[Any] = []
    desk.page.route("**/form", lambda route: waiting.append(route))  # noqa: PLW0108  (playwright counts its arguments)
    before = desk.answers
    with desk.page.expect_request("**/form"):
        desk.page.locator("#undo").click()
    assert_allclose(desk.value("load.tilt"), tilt, rtol=SAME)  # no answer is waited for
    desk.type(desk.field("load.load"), "30 kN")
    desk.wait_for_answer(before)
    for route in waiting:
        route.continue_()
    desk.page.unroute("**/form")
    assert_shows(desk, solution_of(load=30e3, tilt=tilt))
    assert_allclose(desk.value("load.tilt"), tilt, rtol=SAME)
    desk.press("#undo")
    assert_shows(desk, solution_of(tilt=tilt))


def test_stress_of_either_body_or_none(desk):
    of_a = desk.numbers["von Mises stress"]
    section = desk.page.locator('[data-figure="section"]')
    assert (
        section.locator("[role=img]")
        .get_attribute("aria-label")
        .startswith("Von Mises stress across the contact in body a")
    )
    desk.page.get_by_label("body b", exact=True).check()
    desk.page.locator('[data-figure="section"] [aria-label*="body b"]').wait_for()
    desk.settle()
    # Both bodies have one steel and the same pressure; only the side faces of the roller tell them apart.
    assert_allclose(desk.numbers["von Mises stress"], of_a, rtol=0.05)
    desk.page.locator("#stress-on").uncheck()
    assert not section.is_visible()
    assert desk.page.locator('[data-key="von Mises stress"] .value').inner_text() == "–"


def test_what_a_body_bears_is_said_when_the_slider_rests(open_desk):
    document = tomllib.loads(starting_case())
    steel = {"modulus": 207000, "poisson": 0.3, "yield_strength": 1100, "pressure_limit": 4000}
    document["body"]["a"]["material"] = steel
    desk = open_desk(f"#c={packed(document)}")
    fresh = desk.page.locator("#strength[data-state=done]:not(.stale)")
    fresh.wait_for()
    desk.settle()
    pressure, yielding = fresh.locator("li").all_inner_texts()
    assert f"of {desk.numbers['Maximum pressure']:.1f} MPa" in pressure
    assert "static safety" in pressure
    assert "yields" in yielding
    assert f"{desk.numbers['von Mises stress']:.1f} MPa" in yielding  # the tile has what was found in the whole body
    planes = [desk.page.locator(f'[data-figure="{name}"] [role=img]').first for name in ("axial", "section")]
    words = [plane.get_attribute("aria-label") for plane in planes]
    (largest, along), (same, across) = (re.findall(r"largest (.*?) MPa.*?(\S+ mm deep)", each)[0] for each in words)
    assert (same, across) == (largest, along), "both planes go through that point"
    assert re.findall(r"y = (\S+) mm", words[0]) == re.findall(r"y = (\S+) mm", words[1])
    assert fresh.locator("li[data-verdict=over]").count() == 1
    desk.write("load.load", "10 kN")
    assert desk.page.locator("#strength.stale li").all_inner_texts() == [pressure, yielding]
    fresh.wait_for()
    assert "does not yield" in fresh.locator("li").nth(1).inner_text()
    desk.page.get_by_label("body b", exact=True).check()
    fresh.filter(has_text="Strength of body b").wait_for()
    desk.page.locator("#stress-on").uncheck()
    assert not desk.page.locator("#strength").is_visible()


def test_points_of_a_profile_are_pasted_or_dropped(desk):
    desk.page.locator('[data-additions="body.a.profile"]').select_option("tabulated")
    desk.press('button[data-action="add"][data-path="body.a.profile"]')
    assert desk.field("body.a.profile[2].file").count() == 0
    before = desk.answers
    desk.page.evaluate(
        """text => {
          const sheet = document.body.appendChild(document.createElement("textarea"));
          sheet.id = "sheet";
          sheet.value = text;
          sheet.select();
        }""",
        "y\trelief\n-10\t0,02\n0\t0\n10\t0,02\n",
    )
    desk.page.locator("#sheet").press("Control+C")
    desk.field("body.a.profile[2].y").press("Control+V")
    desk.wait_for_answer(before)
    assert desk.field("body.a.profile[2].y").input_value() == "-10 0 10"
    assert desk.field("body.a.profile[2].relief").input_value() == "0.02 0 0.02"
    # So is a file that is dropped on it; what would take the file is outlined.
    card, outlined = 'fieldset[data-group="body.a.profile[2]"]', desk.page.locator(".drop-target")
    for over, target in (("#results", "body"), ('[data-path="body.a.diameter"]', '[data-group="body.a"]')):
        desk.page.locator(over).first.evaluate(
            """target => {
              const dataTransfer = new DataTransfer();
              dataTransfer.items.add(new File([""], "a.csv"));
              target.dispatchEvent(new DragEvent("dragover", { dataTransfer, bubbles: true, cancelable: true }));
            }"""
        )
        assert outlined.count() == 1
        assert outlined.evaluate("(each, selector) => each.matches(selector)", target)
    before = desk.answers
    desk.drop(card, "points.csv", "y;relief\n-10;0,03\n0;0\n10;0,03\n")
    desk.wait_for_answer(before)
    assert outlined.count() == 0
    assert desk.field("body.a.profile[2].y").input_value() == "-10 0 10"
    assert desk.field("body.a.profile[2].relief").input_value() == "0.03 0 0.03"
    for number, content in enumerate(("1 2 3\n4 5 6\n", "PK\x03\x04", "")):
        desk.drop(card, f"{number}.xlsx", content)
        desk.page.locator("#mistakes-list li", has_text=f"{number}.xlsx must be text with two columns").wait_for()
    assert desk.field("body.a.profile[2].y").input_value() == "-10 0 10"
    # What the program refuses is said as if it were pasted.
    before = desk.answers
    desk.drop(card, "points.csv", "0 0.03\n0 0\n-10 0.03\n")
    desk.wait_for_answer(before)
    assert any("body a, profile 2" in each for each in desk.mistakes)


def test_numbers_of_figures_are_saved(desk):
    name, content = desk.saved(desk.page.locator('[data-figure="pressure"] .savers button', has_text="CSV"))
    assert name == "pressure.csv"
    head, *rows = content.decode().splitlines()
    assert head == "panel,line,y [mm],value,unit"
    largest = max(float(row.split(",")[3]) for row in rows)
    assert largest == pytest.approx(desk.numbers["Maximum pressure"], rel=1e-3)
    _, content = desk.saved(desk.page.locator('[data-figure="footprint"] .savers button', has_text="CSV"))
    head, *rows = content.decode().splitlines()
    assert head == "panel,line,y [mm],x [mm],value,unit"
    wide, pressures = zip(*(map(float, row.split(",")[3:5]) for row in rows), strict=True)
    assert max(wide) == pytest.approx(desk.numbers["Half-width"], rel=1e-3)
    assert max(pressures) == pytest.approx(largest, rel=1e-4)
    name, content = desk.saved(desk.page.locator('[data-figure="axial"] .savers button', has_text="CSV"))
    head, *rows = csv.reader(content.decode().splitlines())
    assert (name, head) == ("axial.csv", ["panel", "line", "y [mm]", "z [mm]", "value", "unit"])
    stresses = [float(row[4]) for row in rows if row[1] == "σ"]
    assert max(stresses) == pytest.approx(desk.numbers["von Mises stress"], rel=0.05)


def test_every_figure_is_saved(desk):
    for kind in ("SVG", "PNG"):
        figures = desk.page.locator(f'figure .savers button:has-text("{kind}")')
        assert figures.count() == 8  # two of them profiles
        for number in range(figures.count()):
            name, content = desk.saved(figures.nth(number))
            assert name.endswith(f".{kind.lower()}")
            if kind == "SVG":
                assert ElementTree.fromstring(content).tag == "{http://www.w3.org/2000/svg}svg"
                assert b"var(--" not in content
            else:
                assert content.startswith(b"\x89PNG")
                assert len(content) > 5000
