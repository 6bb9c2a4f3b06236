"""The page's own pure functions, run where they are at home."""

import hashlib
import re
from importlib import resources
from typing import Any

import pytest
from desk import Desk, packed, unpacked

pytestmark = pytest.mark.browser


def calling(desk: Desk, module: str, name: str, *arguments: Any) -> Any:
    """Return what a function of one of the page's modules returns; undefined is None."""
    return desk.page.evaluate(
        "async ([module, name, given]) => (await import(`/static/${module}.js`))[name](...given) ?? null",
        [module, name, list(arguments)],
    )


@pytest.fixture(scope="module")
def anywhere(browser, address, tmp_path_factory):
    page = browser.new_page()
    page.goto(address)
    yield Desk(page, tmp_path_factory.mktemp("pictures"))
    page.close()


CALLS = {
    "numbers quantity": [
        ("20", 20), (" -1.5e-3 ", -0.0015), (".5", 0.5), ("20 kN", "20 kN"), ("0,5", "0,5"), ("", None), ("   ", None),
        ("0x10", "0x10"), ("Infinity", "Infinity"), ("1e999", "1e999"), ("NaN", "NaN"), ("auto", "auto"),
    ],
    "numbers list": [
        ("1 2 3", [1, 2, 3]), ("8 mm, 9 mm", ["8 mm", "9 mm"]), ("1; 2", [1, 2]), ("", None),
        ("zaretsky weibull", ["zaretsky", "weibull"]),
    ],
    "numbers columns": [
        ("1\n2\n3", [[1, 2, 3]]),
        ("-1\t0.5\r\n0\t0\r\n1\t0.5\r\n", [[-1, 0, 1], [0.5, 0, 0.5]]),
        ("y [mm];relief [mm]\n-1,5;0,02\n0;0", [[-1.5, 0], [0.02, 0]]),
        ("-1.5,0.02\n0,0", [[-1.5, 0], [0.02, 0]]),
        ("-1.5, 0.02\n0, 0", [[-1.5, 0], [0.02, 0]]),
        ("-1,5 0,02\n0 0", [[-1.5, 0], [0.02, 0]]),
        ("1e-3 2\n3 4", [[1e-3, 3], [2, 4]]),
        ("1 2 3", None), ("1\n2 3", None), ("a\nb", None), ("1\n\n2", None), ("", None), ("1\nx", None),
    ],
    "numbers split": [
        ("20", None), ("auto", None), ("", None), ("1e3", None),
        *((text, {"number": number, "unit": unit}) for text, number, unit in (
            ("4.2 kN", "4.2", "kN"), ("12um", "12", "um"), ("12 \u00b5m", "12", "um"), ("2\u00b0", "2", "deg"),
            ("5 Nm", "5", "N m"), ("-.5e-3 mrad", "-.5e-3", "mrad"), ("8 um/25 mm", "8", "um/25 mm"),
        )),
    ],
    "numbers digits": [
        (2086.34, "2086"), (0.029063, "0.02906"), (-5.0, "\u22125.000"), (0, "0"), (None, "none"),
        (123456.7, "123457"), (3e-7, "3.000e-7"),
    ],
    "numbers difference": [
        (2337, 2086, "+12.0 %"), (99, 100, "\u22121.00 %"), (100, 100, "same"), (1, 0, ""), (None, 2, ""),
        (-2, -1, "\u2212100 %"),
    ],
    "paths parts": [
        ("load.load", ["load", "load"]), ("body.a.profile[2].radius", ["body", "a", "profile", 1, "radius"]),
        ('body.a."odd key"[1]', ["body", "a", "odd key", 0]), ('"a.b".c', ["a.b", "c"]),
    ],
    "paths pathOf": [
        (["body", "a", "profile", 2, "radius"], "body.a.profile[2].radius"), (["a.b", "c"], '"a.b".c'), ([], ""),
    ],
    "paths differences": [
        ({"a": {"b": [1, 2]}, "c": 1}, {"a": {"b": [1, 3]}, "d": 1}, ["a.b[2]", "c", "d"]),
        ({}, {}, []), ([1], {}, [""]),
    ],
    "paths outer": [("a.b[2]", "a.b"), ("a.b", "a"), ("a", ""), ('a."x.y"', "a")],
}  # fmt: skip


@pytest.mark.parametrize("function", CALLS)
def test_what_functions_return(anywhere, function):
    for *arguments, expected in CALLS[function]:
        assert calling(anywhere, *function.split(), *arguments) == expected, arguments


def test_values_are_set_and_taken_away_in_a_copy(anywhere):
    document = {"body": {"a": {"material": "steel", "profile": [{"kind": "crown"}, {"kind": "straight"}]}}}
    changed = calling(anywhere, "paths", "withValue", document, "body.a.material.modulus", 1.0)
    assert changed["body"]["a"]["material"] == {"modulus": 1.0}
    changed = calling(anywhere, "paths", "withValue", document, "life.spectrum[1].share", 1)
    assert changed["life"] == {"spectrum": [{"share": 1}]}
    calls = "async document => (await import('/static/paths.js')).withValue(document, 'body.a.profile[1]', undefined)"
    assert anywhere.page.evaluate(calls, document)["body"]["a"]["profile"] == [{"kind": "straight"}]


def test_links_are_deflated_json(anywhere):
    document = {"title": "Käfig µm \u2028 💡", "load": {"load": 20000.0}}
    fragment = calling(anywhere, "link", "fragment", document)
    assert unpacked(fragment.removeprefix("#c=")) == document
    found = calling(anywhere, "link", "shared", f"#c={packed(document)}&p={packed({'title': 'b'})}")
    assert found == {"document": document, "pinned": [{"document": {"title": "b"}, "name": ""}], "text": ""}
    pinned = [{"document": {"title": name}, "name": f"{name} µm"} for name in "bc"]
    both = calling(anywhere, "link", "fragment", document, pinned)
    assert calling(anywhere, "link", "shared", both)["pinned"] == pinned
    text = "# of the catalogue\n[load]\nload = 1\n"
    both = calling(anywhere, "link", "fragment", document, [], text)
    assert calling(anywhere, "link", "shared", both) == {"document": document, "pinned": [], "text": text}
    assert calling(anywhere, "link", "fragment", document, [], "a = 1") == fragment, "without comments it says nothing"
    assert calling(anywhere, "link", "shared", "#results") is None


DRAGGED = """async ([delays, bodies]) => {
  const { Live } = await import("/static/live.js");
  const asked = [];
  let [delay, body] = [0, bodies[0]];
  const real = window.fetch;
  // A clock of its own: a busy machine must not make answers slow that are not.
  let now = 0;
  performance.now = () => now;
  window.fetch = async (place, request) => {
    if (place !== "solve") return real(place, request); // the page itself asks what its body bears
    const { stress, body: of } = JSON.parse(request.body);
    asked.push(stress ? of : "");
    now += delay;
    await new Promise((done) => window.setTimeout(done));
    body = bodies[asked.length] ?? body;
    return new Response(JSON.stringify({ ok: true }), { status: 200 });
  };
  const shown = [];
  await new Promise((done) => {
    const next = () => {
      if (!delays.length) return done();
      delay = delays.shift();
      live.want({});
    };
    const live = new Live({
      request: (document, stress, body) => ["solve", { document, stress, body }],
      together: true,
      rest: 120,
      answered: (answer, wanted, stress) => stress && shown.push(answer.wish),
      more: (answer) => {
        shown.push(answer.wish);
        window.setTimeout(next);
      },
      waiting() {},
      rested: (complete) => complete && next(),
      wish: () => body,
    });
    next();
  });
  window.fetch = real;
  delete performance.now;
  return [asked, shown];
}"""


def test_stresses_come_with_every_answer_while_that_is_quick(anywhere):
    asked, shown = anywhere.page.evaluate(DRAGGED, [[0, 0, 0], ["a"]])
    assert asked == shown == ["a", "a", "a"]
    # Slow three times after the first, which does not count; then without, and for themselves once the hand rests.
    asked, _ = anywhere.page.evaluate(DRAGGED, [[0, 80, 80, 80, 80], ["a"]])
    assert asked == ["a", "a", "a", "a", "", "a"]
    # One that is very slow is enough; at rest it was quick again.
    asked, _ = anywhere.page.evaluate(DRAGGED, [[0, 400, 0, 0], ["a"]])
    assert asked == ["a", "a", "", "a", "a"]


def test_stresses_of_a_body_that_is_chosen_meanwhile_are_asked_for(anywhere):
    asked, shown = anywhere.page.evaluate(DRAGGED, [[0], ["a", "b"]])
    assert asked == shown == ["a", "b"]


def test_libraries_are_those_that_their_readme_names():
    folder = resources.files("nonhertz.web").joinpath("static", "vendor")
    named = dict(
        re.findall(r"^\| `([^`]+\.js)` .*`([0-9a-f]{64})` \|$", folder.joinpath("README.md").read_text(), re.MULTILINE)
    )
    found = {each.name: each.read_bytes() for each in folder.iterdir() if each.name.endswith(".js")}
    assert {name: hashlib.sha256(content).hexdigest() for name, content in found.items()} == named
