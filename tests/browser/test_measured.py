"""A measured profile: uploaded, looked at step by step, used."""

import math
from pathlib import Path

import pytest
from desk import Desk
from numpy.testing import assert_allclose

pytestmark = pytest.mark.browser

SAME = 1e-9  # a prescribed load is met to the rounding of a sum over strips


def trace() -> str:
    """A roller's relief as a tracer may write it: tilted, off the middle, rough, with a spike."""
    rows = ["position [mm]; height [um]"]
    for number in range(1401):
        y = -10.5 + 21.0 * number / 1400
        crown = -4.0 * abs(y / 10.0) ** 4 - 60.0 * max(0.0, abs(y) - 9.8)
        roughness = 0.15 * math.sin(2.1 * number) + 0.1 * math.sin(5.7 * number)
        spike = 8.0 if number == 500 else 0.0
        rows.append(f"{y + 10.5:.4f}; {crown + 0.6 * y + roughness + spike:.4f}")
    return "\n".join(rows) + "\n"


@pytest.fixture
def path(tmp_path):
    made = tmp_path / "roller 7.csv"
    made.write_text(trace(), encoding="utf-8")
    return made


def upload(desk: Desk, path: Path, body: str = "a") -> None:
    desk.page.locator(f'[data-measured="{body}"]').click()
    desk.page.locator("#measured-file").set_input_files(path)
    desk.page.locator("#measured-use").wait_for()


def steps(desk: Desk) -> list[str]:
    shown = desk.page.locator("#measured .steps figure")
    names: list[str] = shown.evaluate_all("all => all.map(each => each.dataset.figure)")
    return names


def test_a_measured_profile_is_prepared_and_used(desk, path):
    ideal = desk.numbers["Maximum pressure"]
    upload(desk, path)
    everything = steps(desk)
    assert {"level", "align", "outliers", "smooth", "profile", "corner-low"} <= set(everything)
    drawings = desk.page.locator("#measured .steps svg[role=img]")
    assert drawings.count() == len(everything)
    room = desk.page.locator("#measured .steps .drawing").first.bounding_box()["width"]
    assert drawings.first.bounding_box()["width"] == pytest.approx(room, abs=2.0)
    name, content = desk.saved(desk.page.locator('#measured [data-figure="level"] .savers button', has_text="CSV"))
    assert name == "level.csv"
    assert content.decode().splitlines()[0] == "panel,line,y [mm],value,unit"
    desk.photograph("measured")
    # A step is switched off and on again.
    words = desk.page.locator('[data-figure="smooth"] .remark').inner_text()
    desk.page.locator("#step-smooth").uncheck()
    desk.page.locator('[data-figure="smooth"]').wait_for(state="detached")
    assert steps(desk) != everything
    desk.page.locator("#step-smooth").check()
    desk.page.locator('[data-figure="smooth"]').wait_for()
    assert steps(desk) == everything
    assert desk.page.locator('[data-figure="smooth"] .remark').inner_text() == words
    desk.press("#measured-use")
    assert not desk.page.locator("#measured").is_visible()
    assert desk.field("body.a.profile[1].kind").input_value() == "tabulated"
    assert desk.mistakes == []
    assert desk.numbers["Maximum pressure"] != ideal
    desk.photograph("measured-used")


def test_what_is_no_trace_is_refused_in_a_sentence(desk, tmp_path):
    nonsense = tmp_path / "picture.png"
    nonsense.write_bytes(bytes(range(256)) * 20)
    desk.page.locator('[data-measured="b"]').click()
    desk.page.locator("#measured-file").set_input_files(nonsense)
    sentence = desk.page.locator("#measured [role=alert] li").inner_text()
    assert sentence.endswith(".")
    assert "must" in sentence
    assert desk.page.locator("#measured-use").count() == 0
    desk.page.keyboard.press("Escape")
    assert not desk.page.locator("#measured").is_visible()
    desk.write("load.load", "21000")
    assert_allclose(desk.numbers["Load"], 21000.0, rtol=SAME)


def test_a_file_dropped_on_a_body_is_a_measured_profile(desk):
    desk.drop('fieldset[data-group="body.b.profile"]', "plate.csv", trace())
    desk.page.locator("#measured-use").wait_for()
    assert "body b" in desk.page.locator("#measured-title").inner_text()
    desk.press("#measured-use")
    assert desk.field("body.b.profile[1].kind").input_value() == "tabulated"
