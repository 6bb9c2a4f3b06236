"""The bearing page at work: dragged, clicked and typed into."""

import tomllib
from pathlib import Path
from typing import Any

import pytest
from conftest import desks, served
from desk import Desk
from few_rollers import SIX, changed
from numpy.testing import assert_allclose

from nonhertz.bearing.series import series_table
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.catalogue import guess_of_catalogue, text_of_guess

pytestmark = pytest.mark.browser

FEW = "# Six rollers.\n" + changed(SIX, ("radius = 1200", 'drop = "30 um"'))
SAME = 1e-9  # the same solve of the same numbers, through JSON or TOML, which keep all digits


@pytest.fixture(scope="module")
def bearing_address(tmp_path_factory):
    path = tmp_path_factory.mktemp("bearing") / "six.toml"
    path.write_text(FEW, encoding="utf-8")
    yield from served(str(path))


@pytest.fixture
def open_bearing(browser, usual, bearing_address):
    yield from desks(browser, usual, bearing_address)


@pytest.fixture
def bearing(open_bearing):
    return open_bearing()


def text_of(desk: Desk) -> str:
    return desk.download("bearing.toml").decode()


def method_of(desk: Desk) -> str:
    words: str = desk.page.locator('[data-figure="polar"] .remark').inner_text()
    return words


def bar(desk: Desk, roller: int, ring: str) -> str:
    shape: str = desk.page.locator(f'[data-roller="{roller}"] .{ring}-load').get_attribute("d")
    return shape


def test_it_shows_what_the_solver_finds(bearing):
    found, shown = BearingCase.of(tomllib.loads(FEW), Path("six.toml")).solve(), bearing.numbers
    assert method_of(bearing) == "by strips"
    assert_allclose(shown["Largest roller load"], found.load.max(), rtol=SAME)
    assert_allclose(shown["Maximum pressure"], found.max_pressure.max(), rtol=SAME)
    assert_allclose(shown["Displacement"], abs(found.displacement[1]), rtol=1e-6)  # along y but for rounding
    assert text_of(bearing) == FEW
    assert bearing.page.locator("#rollers tbody tr").count() == 6
    bearing.photograph("bearing")


def test_dragging_redraws_by_slices_and_strips_follow(bearing):
    slider = bearing.slider("load.radial")
    box = slider.bounding_box()
    across = lambda share: box["x"] + (0.05 + 0.9 * share) * box["width"]  # noqa: E731
    before, answers, pressure = bar(bearing, 0, "inner"), bearing.answers, bearing.numbers["Maximum pressure"]
    mouse, middle = bearing.page.mouse, box["y"] + 0.5 * box["height"]
    mouse.move(across(0.2), middle)
    mouse.down()
    for step in range(1, 9):
        mouse.move(across(0.2 + 0.05 * step), middle)
        bearing.page.wait_for_timeout(60)
    bearing.page.locator(f'html:not([data-answers="{answers}"])').wait_for(state="attached")
    bearing.page.locator('[data-figure="polar"] .remark', has_text="by slices").wait_for()
    assert "stale" in bearing.page.locator('[data-figure="pressure"]').get_attribute("class")
    assert "strips follow" in bearing.page.locator(".state").inner_text()
    assert bearing.numbers["Maximum pressure"] == pressure, "that by strips stays, and is said to be older"
    kept = bearing.page.locator('[data-key="Maximum pressure"].stale')
    assert kept.locator(".where").inner_text().startswith("before the change, roller 1")
    assert bearing.page.locator("#verdict.stale").inner_text().startswith("Before the change: ")
    bearing.page.wait_for_timeout(800)
    assert method_of(bearing) == "by slices", "strips wait until the slider is let go"
    mouse.up()
    bearing.settle()
    assert bar(bearing, 0, "inner") != before
    assert bearing.numbers["Maximum pressure"] > pressure
    assert not bearing.page.locator(".key-number.stale, #verdict.stale").count()
    bearing.page.locator('[data-figure="polar"] .remark', has_text="by strips").wait_for()
    assert bearing.answers - answers >= 2, "the picture was drawn again while the slider moved"
    load = bearing.shown("load.radial")
    assert text_of(bearing) == FEW.replace('radial = "5 kN"', f'radial = "{load}"'), "its comments are kept"
    assert bearing.round_trips()


def wait_for_lines(desk: Desk, words: str) -> None:
    desk.page.locator("#roller-name").get_by_text(words, exact=True).wait_for()


def test_a_clicked_roller_is_drawn(bearing):
    wait_for_lines(bearing, "Roller 1 at 0.0 degrees, the most loaded")
    pressure = bearing.page.locator('[data-figure="pressure"] svg').first
    before = pressure.get_attribute("aria-label")
    bearing.page.locator('[data-roller="1"] .mark').click()
    wait_for_lines(bearing, "Roller 2 at 60.0 degrees")
    assert pressure.get_attribute("aria-label") != before
    assert bearing.page.locator("#rollers tr.chosen td").first.inner_text() == "2"
    bearing.page.keyboard.press("ArrowRight")
    wait_for_lines(bearing, "Roller 3 at 120.0 degrees")
    assert "no load" in bearing.page.locator('[data-figure="pressure"] .drawing').inner_text()
    bearing.page.locator('[data-roller-row="5"]').click()
    wait_for_lines(bearing, "Roller 6 at 300.0 degrees")
    bearing.page.locator("#most").click()
    wait_for_lines(bearing, "Roller 1 at 0.0 degrees, the most loaded")


def test_of_many_rollers_chosen_in_a_row_the_last_is_asked_for(bearing):
    asked: list[Any] = []

    def hold(route: Any) -> None:
        asked.append(route)

    bearing.page.route("**/bearing/roller", hold, times=1)
    bearing.page.locator('[data-roller="1"] .mark').click()
    for _ in range(4):
        bearing.page.keyboard.press("ArrowRight")
    bearing.page.wait_for_timeout(200)
    assert [route.request.post_data_json["roller"] for route in asked] == [1]
    with bearing.page.expect_request("**/bearing/roller") as last:
        asked[0].continue_()
    assert last.value.post_data_json["roller"] == 5
    wait_for_lines(bearing, "Roller 6 at 300.0 degrees")


def test_the_pressures_of_all_rollers_are_seen_in_perspective(bearing):
    ridges = bearing.page.locator('[data-figure="ridges-inner"]')
    assert ridges.locator("figcaption .heading").inner_text() == "Pressure at the inner ring in perspective"
    loaded = sum(load > 0.0 for load in BearingCase.of(tomllib.loads(FEW), Path("six.toml")).solve().load[:, 0])
    assert ridges.locator('.drawing g[stroke="var(--first)"] path').count() == loaded
    assert ridges.locator('.drawing g[stroke="var(--faint)"] path').count() == 6


def opened(desk: Desk, text: str) -> None:
    before = desk.answers
    desk.page.locator("#open-file").set_input_files({"name": "b.toml", "mimeType": "", "buffer": text.encode()})
    desk.wait_for_answer(before)


def test_a_file_is_read_with_all_its_mistakes(bearing):
    opened(bearing, FEW.replace("rollers = 6", "rollers = 0").replace("37.5", '"x"'))
    assert len(bearing.mistakes) == 2
    right = FEW.replace("rollers = 6", "rollers = 8").replace("tilt =", "# tilt =")
    opened(bearing, right)
    assert bearing.mistakes == []
    assert bearing.page.locator("#rollers tbody tr").count() == 8
    assert bearing.field("load.tilt").input_value() == ""
    assert text_of(bearing) == right


def test_another_kind_is_made_on_the_page_alone(bearing):
    before = bearing.answers
    bearing.field("bearing.kind").select_option("thrust")
    bearing.wait_for_answer(before)
    assert bearing.mistakes == []
    bearing.write("bearing.rollers", "6")
    bearing.write("load.axial", "8 kN")
    assert bearing.mistakes == []
    assert bearing.numbers["Loaded rollers"] == 6
    bearing.slider("load.axial").wait_for()  # such a bearing bears axial loads


def test_points_are_dropped_on_a_ring(bearing):
    before = bearing.answers
    bearing.page.locator('[data-additions="inner.profile"]').select_option("tabulated")
    bearing.page.locator('[data-action="add"][data-path="inner.profile"]').click()
    bearing.wait_for_answer(before)
    before = bearing.answers
    bearing.drop('[data-group="inner.profile[1]"]', "points.csv", "-5,0.01\n0,0\n5,0.01\n")
    bearing.wait_for_answer(before)
    assert bearing.field("inner.profile[1].relief").input_value() == "0.01 0 0.01"
    bearing.drop('[data-group="outer"]', "trace.csv", "".join(f"{0.1 * n},{1e-3 * n * n}\n" for n in range(-50, 51)))
    bearing.page.locator("#measured[open]").wait_for()
    assert bearing.page.locator("#measured-title").inner_text() == "Measured profile for outer ring"


def test_a_contact_is_opened_on_the_page_of_contacts(bearing):
    bearing.page.locator('[data-roller="1"]').click()
    loads = bearing.page.locator('[data-roller="1"]').get_attribute("aria-label")
    bearing.page.locator('[data-contact="outer"]').click()
    bearing.page.wait_for_url("**/contact#c=*")
    bearing.settle()
    assert bearing.page.locator("h1").inner_text() == "six, roller 2 on the outer ring"
    case = BearingCase.of(tomllib.loads(FEW), Path("six.toml"))
    loaded = case.solve()
    assert_allclose(bearing.numbers["Load"], loaded.load[1, 1], rtol=SAME)
    assert_allclose(bearing.numbers["Maximum pressure"], loaded.max_pressure[1, 1], rtol=SAME)
    bearing.page.go_back()
    bearing.settle()
    assert bearing.page.locator('[data-roller="1"]').get_attribute("aria-label") == loads
    wait_for_lines(bearing, "Roller 2 at 60.0 degrees")
    bearing.page.locator('[data-roller="3"]').click()
    assert bearing.page.locator("[data-contact]:disabled").count() == 2  # it bears no load


CATALOGUE = {"d": "30", "D": "62 mm", "B": "16", "C": "44", "C0": "36500 N", "F": "37.5"}


def started_from_catalogue(desk: Desk, data: dict[str, str], kind: str = "cylindrical") -> None:
    desk.page.locator("[popovertarget=templates]").click()
    desk.page.locator("#from-catalogue").click()
    desk.page.locator("#catalogue select").select_option(kind)
    for symbol, text in data.items():
        desk.page.locator(f'#catalogue [name="{symbol}"]').fill(text)
    desk.page.locator("#catalogue .primary").click()


def estimated(desk: Desk) -> list[str]:
    paths: list[str] = desk.page.locator("#case .estimated").evaluate_all("all => all.map(each => each.dataset.path)")
    return paths


def test_a_catalogue_begins_a_bearing_whose_estimates_are_marked(bearing):
    before = bearing.answers
    started_from_catalogue(bearing, CATALOGUE | {"C": "440"})
    bearing.page.locator("#catalogue .mistake", has_text="which ISO 281 gives").wait_for()
    bearing.page.locator('#catalogue [name="C"]').fill("44")
    bearing.page.locator("#catalogue .primary").click()
    bearing.page.locator("#catalogue").wait_for(state="hidden")
    bearing.wait_for_answer(before)
    assert bearing.mistakes == []
    data = ["d=30", "D=62", "B=16", "C=44e3", "C0=36.5e3", "F=37.5"]
    guess = guess_of_catalogue(dict(word.split("=") for word in data))
    assert text_of(bearing) == text_of_guess(guess)
    marked = ["bearing.rollers", "bearing.clearance", "roller.diameter", "roller.length", "inner.depth"]
    assert estimated(bearing) == [*marked, "outer.diameter", "outer.depth"]
    bearing.write("bearing.rollers", "12")
    assert "bearing.rollers" not in estimated(bearing)
    bearing.page.reload()
    bearing.settle()
    assert estimated(bearing) == [*marked[1:], "outer.diameter", "outer.depth"]
    assert "36.50 kN" in bearing.page.locator("#case .estimates").inner_text()


def test_undo_brings_back_the_bearing_before_a_catalogue(bearing):
    before = bearing.answers
    started_from_catalogue(
        bearing, {"d": "30", "D": "72", "B": "20.75", "C": "59.5", "C0": "60", "e": "0.31"}, "tapered"
    )
    bearing.page.locator("#catalogue").wait_for(state="hidden")
    bearing.wait_for_answer(before)
    series = bearing.field("bearing.series").locator("option").all_inner_texts()
    assert series == ["not given", *series_table()["tapered"]]
    bearing.press("#undo")
    assert text_of(bearing) == FEW
    assert estimated(bearing) == []
    bearing.press("#redo")
    assert "roller.length" in estimated(bearing)
