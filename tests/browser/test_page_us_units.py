"""The page in US units: everything that is read, and nothing else."""

import re
import tomllib

import pytest
from desk import Desk
from numpy.testing import assert_allclose

pytestmark = pytest.mark.browser

MPA_PER_KSI, N_PER_LBF, MM_PER_IN = 6.894757293, 4.4482216152605, 25.4
#: Units after a number, in brackets, or alone beside it.
OF_SI = re.compile(r"(?:\d ?|\[|^)(?:mm|[uµ]m|MPa|GPa|k?N|N m|micrometres)(?![\w])", re.MULTILINE)


def switch(desk: Desk) -> None:
    desk.press("#units")


def everything(desk: Desk, within: str) -> str:
    """All text of a part of the page, what is only heard included."""
    text: str = desk.page.locator(within).evaluate(
        """(part) => {
          const heard = [...part.querySelectorAll("[aria-label], [aria-valuetext], [title]")]
            .flatMap((each) => ["aria-label", "aria-valuetext", "title"].map((name) => each.getAttribute(name) ?? ""));
          const drawn = [...part.querySelectorAll("text, td, th, li, span, dd, figcaption")]
            .filter((each) => each.children.length === 0).map((each) => each.textContent);
          return [part.innerText, ...heard, ...drawn].join("\\n");
        }"""
    )
    return text


def tile(desk: Desk, name: str) -> tuple[float, str]:
    """Number and unit of a key number, as they are read."""
    shown = desk.page.locator(f'.key-number[data-key="{name}"]')
    number = shown.locator(".value").inner_text().replace("\u2212", "-")
    return float(number), shown.locator(".unit").inner_text()


def test_all_that_is_read_of_a_contact(desk):
    desk.page.locator("#curve-on").check()
    desk.page.locator('#curve[data-state="done"]').wait_for()
    before, words = desk.numbers, everything(desk, "#results")
    assert OF_SI.search(words)
    switch(desk)
    desk.page.locator('#curve[data-state="done"]').wait_for()
    desk.page.locator('#strength[data-state="done"]').wait_for()
    desk.settle()
    words = everything(desk, "#results")
    assert [found[0] for found in OF_SI.finditer(words)] == []
    for unit in ("[ksi]", "[in]", "[µin]", "lbf", "microinches"):
        assert unit in words
    assert {name: value for name, value in desk.numbers.items() if name != "von Mises stress"} == {
        name: value for name, value in before.items() if name != "von Mises stress"
    }
    for name, unit, size in (
        *(("Maximum pressure", "ksi", MPA_PER_KSI), ("Approach", "µin", 1e-6 * MM_PER_IN)),
        *(("Load", "lbf", N_PER_LBF), ("Half-width", "in", MM_PER_IN), ("von Mises stress", "ksi", MPA_PER_KSI)),
    ):
        number, shown = tile(desk, name)
        assert shown == unit
        assert_allclose(number * size, desk.numbers[name], rtol=6e-4, err_msg=name)
    desk.photograph("us-units", whole=True)
    switch(desk)
    desk.page.locator('#strength[data-state="done"]').wait_for()
    assert not re.search(r"ksi|lbf|\bin\b(?= |$)", " ".join(tile(desk, name)[1] for name in ("Load", "Half-width")))


def test_the_last_good_result_is_read_in_other_units_as_well(desk):
    desk.write("load.load", "-1")
    assert OF_SI.search(everything(desk, "#figures"))
    switch(desk)
    desk.page.locator("#results.outdated").wait_for()
    assert OF_SI.search(everything(desk, "#figures")) is None
    assert OF_SI.search(everything(desk, "#stress-figures")) is None
    assert desk.page.locator("#state").inner_text() == "last good result"
    assert len(desk.mistakes) == 1


def test_fields_follow_and_the_case_stays(desk):
    before = desk.numbers
    document = desk.download("case.toml")
    switch(desk)
    assert desk.shown("load.load") == "4496.18 lbf"
    assert desk.shown("body.a.diameter") == "0.787402 in"
    assert desk.download("case.toml") == document
    assert desk.page.locator("#undo").is_disabled()
    # Another unit shows what the case says, not what the field rounds it to.
    answers = desk.answers
    desk.page.locator('#case .field[data-path="body.a.diameter"] select.unit').select_option("mm")
    desk.wait_for_answer(answers)
    assert desk.shown("body.a.diameter") == "20 mm"
    assert_allclose(desk.numbers["Maximum pressure"], before["Maximum pressure"], rtol=1e-12)
    # A plain number is in what stands beside it.
    answers = desk.answers
    desk.type(desk.field("load.load"), "5000")
    desk.wait_for_answer(answers)
    assert_allclose(desk.numbers["Load"], 5000.0 * N_PER_LBF, rtol=1e-9)
    assert tomllib.loads(desk.download("case.toml").decode())["load"]["load"] == "5000 lbf"


def test_the_choice_is_kept_and_is_that_of_both_pages(open_desk):
    desk = open_desk()
    assert desk.page.locator("#units").inner_text() == "US units"
    switch(desk)
    assert desk.page.locator("#units").inner_text() == "SI units"
    desk.page.reload()
    desk.settle()
    assert tile(desk, "Load")[1] == "lbf"
    bearing = open_desk("bearing")
    words = everything(bearing, "#results")
    assert [found[0] for found in OF_SI.finditer(words)] == []
    assert {"lbf", "ksi", "µin"} <= set(re.findall(r"\w+", words))
    rings = bearing.page.locator("#polar .of-ring").all_text_contents()
    assert rings
    assert all(re.fullmatch(r"\d+ lbf", ring) and int(ring.split()[0]) % 100 == 0 for ring in rings)
    units = [bearing.shown(path).split()[1] for path in ("load.radial", "bearing.clearance")]
    assert units == ["lbf", "uin"]
    before = tile(bearing, "Displacement")[0]
    number = bearing.numbers["Displacement"]
    assert_allclose(before * 1e-6 * MM_PER_IN, number, rtol=6e-4)
    bearing.write("load.radial", "3000 lbf")
    assert tomllib.loads(bearing.download("bearing.toml").decode())["load"]["radial"] == "3000 lbf"
    bearing.photograph("us-units-bearing", whole=True)
    switch(bearing)
    assert "kN" in everything(bearing, "#results")


WORDS = [
    ("amount", [2000, "MPa"], "2000 MPa", "290.1 ksi"),
    ("amount", [5, "MPa"], "5.000 MPa", "725.2 psi"),  # less than one ksi
    ("amount", [-25.4, "mm", 3], "\u221225.4 mm", "\u22121.00 in"),
    ("amount", [None, "mm"], "none mm", "none in"),
    ("amount", [3, "mrad"], "3.000 mrad", "3.000 mrad"),
    ("spelled", [2.54, "µm", 3], "2.54 micrometres", "100 microinches"),
    ("force", [999], {"value": "999.0", "unit": "N"}, {"value": "224.6", "unit": "lbf"}),
    ("force", [4448.2216], {"value": "4.448", "unit": "kN"}, {"value": "1000", "unit": "lbf"}),
]


def test_words(desk):
    # The module asks what is kept when it is loaded; under another address it is loaded again.
    for name, arguments, *expected in WORDS:
        found = [
            desk.page.evaluate(
                """async ([name, given, code]) => {
                  localStorage.setItem("nonhertz-units", code);
                  const made = (await import(`/static/units.js?${code}`))[name](...given);
                  return JSON.parse(JSON.stringify(made));
                }""",
                [name, arguments, code],
            )
            for code in ("si", "us")
        ]
        assert found == expected, (name, arguments)
