"""What all commands do alike: they refuse in a sentence, leave nothing half done, and say what they are doing."""

import json
from pathlib import Path
from typing import Any

import pytest
from crowned_roller import CASE
from few_rollers import SIX, changed
from test_design_command import PLAN

import nonhertz as nh
import nonhertz.cli.stress
import nonhertz.comparison.methods
import nonhertz.report.layout
import nonhertz.solver.one
from nonhertz.files.bearingfile import BearingCase
from nonhertz.selfcheck import Claim

CELLS = ("--cells", "24", "48")
QUICK = ("--model", "iso-16281")
TOLERANCE = """
case = "case.toml"
[tolerance]
"load.load" = "normal(nominal, 1 kN)"
"""
#: Commands that solve, with as little as they need.
SOLVING = {
    "solve": ("solve", "case.toml"),
    "stress": ("stress", "case.toml"),
    "life": ("life", "case.toml", *QUICK),
    "compare": ("compare", "case.toml", *CELLS),
    "bearing": ("bearing", "sliced.toml"),
}


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    six = changed(SIX, ('clearance = "12 um"\n', ""))
    texts = {"case": CASE, "six": six, "sliced": f'{six}[solver]\nmethod = "slices"\n', "plan": TOLERANCE}
    texts |= {"roller": CASE, "design": PLAN}
    texts["broken"] = "[bearing\n"
    for name, text in texts.items():
        Path(f"{name}.toml").write_text(text, encoding="utf-8")
    return tmp_path


def instead_of_solving(monkeypatch: pytest.MonkeyPatch, act: Any) -> None:
    for module in (nonhertz.solver.one, nonhertz.comparison.methods):
        monkeypatch.setattr(module, "solve", act)
    monkeypatch.setattr(BearingCase, "solve", act)


REFUSED = [
    ("new --template needles", "--template = 'needles' must be one of"),
    ("new --template cam --bearing", "--template = 'cam' must be one of 'cylindrical', 'needle', 'tapered-pair'"),
    ("new --template cam --plan", "--template = 'cam' must not be given with --plan"),
    ("new --plan --bearing", "--plan must not be given with --bearing"),
    ("compare case.toml --cells 3 3", "--cells = (3, 3) must be whole numbers of at least 4: "),
    ("compare case.toml --cells 200000 200000", "--cells = (200000, 200000) must need less than the "),
    ("compare case.toml --cells 10", 'Command "compare" parameter --cells requires 2 positional arguments'),
    (
        "life case.toml --model zaretzky",
        "--model = 'zaretzky' must be a fatigue model: choose from lundberg-palmgren",
    ),
    ("life case.toml --compare nothing.toml", "nothing.toml must exist: "),
    ("stress case.toml --station nan", "--station = nan must be finite: give a position along the contact in mm."),
    ("stress case.toml --body c", "--body = 'c' must be one of the two bodies: write a or b."),
    ("map case.toml", "--load must be given if --approach is not"),
    ("map case.toml --load 1kN", "--load = '1kN' must be a range"),
    ("map case.toml --load 2kN:1kN", "--load = '2kN:1kN' must ascend"),
    ("map case.toml --load 0:1", "--load = '1' must have a unit: append a unit, such as 1N"),
    ("map case.toml --load 0:1kN:1", "must have a whole number from 2"),
    ("map case.toml --load 0:1kN --tilt 2rad", "--tilt = 2.0 must hold small angles"),
    ("map case.toml --load 0:1kN --out k.txt", "--out = 'k.txt' must be a file ending in .csv, "),
    ("map case.toml --load 0:1kN --out case.toml/k.csv", "--out = 'case.toml' must be a directory, not a file"),
    ("map case.toml --approach -9um:-5um", "--approach = -0.005 must exceed"),
    (
        "sweep case.toml --over load.laod=1kN:2kN:3",
        "Unknown key load.laod. Did you mean load.load?",
    ),
    ("sweep case.toml --over load.load", "--over = 'load.load' must have an equals sign between name and"),
    ("sweep case.toml --over load.load=5", "--over load.load = '5' must have a unit: append a unit, such as 5N."),
    ("sweep case.toml --over load.load=1kN,2kN --quantities presure", "did you mean 'max_pressure'?"),
    ("sweep case.toml", "--over must vary something: give values for a path of the case, such as"),
    ("sweep case.toml --over load.load=-1N,2kN", "must be valid in the case (at -1.0000 N: load.load"),
    ("tolerance case.toml --over load.load=5kN,6kN", "must be a distribution"),
    ("tolerance plan.toml --over load.load=normal(1kN,1N)", "write it into the plan"),
    ("report", "Give CASE, as in 'nonhertz report roller.toml'"),
    ("bearing six.toml --contact 0 inner", "--contact = 0 must be a whole number from 1 to 6"),
    ("bearing six.toml --contact 4 inner", "--contact = 4 must be a roller that the inner ring loads"),
    ("bearing six.toml --contact 1 inner --json", "must be given without --json and --out"),
    (
        "bearing six.toml --compare --over clearance=0:9um",
        "--over = 'clearance=0:9um' must not be given with --compare",
    ),
    ("bearing six.toml --over clearence=0:9um", "Unknown key clearence. Did you mean bearing.clearance?"),
    ("bearing six.toml --over clearance=9um:5um", "--over bearing.clearance = '9um:5um' must ascend"),
    ("bearing six.toml --over clearance", "--over = 'clearance' must have an equals sign"),
    ("materials unobtainium", "NAME = 'unobtainium' must be a known material: 'nonhertz materials' lists all."),
    *(
        (
            f"design {kind}.toml",
            f"{kind}.toml must be a plan, and holds a {held}: begin with one from 'nonhertz new --pl",
        )
        for kind, held in (("case", "case"), ("six", "bearing"))
    ),
    ("bearing broken.toml", "broken.toml must be valid TOML: "),
    ("bearing nowhere.toml", "nowhere.toml must exist: give the path of a bearing file, or begin with one from"),
    ("bearing case.toml", "case.toml must hold a bearing, not a single contact: use 'nonhertz solve case.toml'."),
    *(
        (f"{command} six.toml", "six.toml must hold a single contact, not a bearing: use 'nonhertz bearing six.toml'.")
        for command in ("solve", "compare", "stress", "life", "map --load 0:1kN")
    ),
    ("serve --port 65536 --no-browser", "must lie between 0 and 65535"),
    (
        "schema cases",
        "KIND = 'cases' must be a known kind of file with a schema: did you mean 'case'?",
    ),
]


#: The same of files with something else in them: words, what is changed, and what is said.
CHANGED = [
    ("design design.toml", '"1500 mm : 30 m"', '"30 m : 1500 mm"', "must ascend"),
    ("design design.toml", "profile.radius", "profile.radios", "Did you mean body.a.profile.radius?"),
    ("design design.toml", "starts = 2", "starts = 0", "starts = 0 must be"),
    ("design design.toml", "starts = 2", 'goal = "price"', "goal = 'price' must be one of"),
    ("design design.toml", "starts = 2", 'model = "lundberg"', "design.model = 'lundberg' must be one of 'lundberg-pa"),
    ("design design.toml", "starts = 2", 'where = { approach = "30 um" }', "begin with 'at most'"),
    ("design design.toml", '{ load = "20 kN" }', '{ load = "20 kN", share = 0.2 }', "share"),
    ("design design.toml", "[vary]", "[varied]", "varied"),
    ("design design.toml --front 3", ', tilt = "2 arcmin"', "", "must include loads without tilt and loads with tilt"),
    ("design design.toml --front 3", "starts = 2", 'goal = "life"', "goal = 'life' must be 'pressure' for a front"),
    ("design design.toml --front 2", "starts = 2", "starts = 1", "--front = 2 must be a whole number from 3 to 50"),
    (
        "design design.toml",
        'case = "roller.toml"\n[vary]\n"body.a.profile.radius" = "1500 mm : 30 m"',
        'case = "six.toml"\n[vary]\n"load.radial" = "1 kN : 2 kN"',
        "a bearing can only be swept",
    ),
    ("compare case.toml", 'load = "20 kN"', "approach = -0.02", "load.approach = -0.02 must exceed "),
    ("compare case.toml", "length = 20.0", "length = -1", "body.a.length = -1.0 must be positive"),
    ("compare case.toml", 'depth = "none"', "depth = 0.2", "body.a.depth = 0.2 must be large compared with the half-"),
]


@pytest.mark.parametrize(("words", "old", "new", "sentence"), CHANGED)
def test_what_cannot_be_in_a_file_is_refused_in_a_sentence(words, old, new, sentence, folder, run):
    path = Path(words.split()[1])
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    test_what_cannot_be_is_refused_in_a_sentence(words, sentence, folder, run)


@pytest.mark.parametrize(("words", "sentence"), REFUSED, ids=[words for words, _ in REFUSED])
def test_what_cannot_be_is_refused_in_a_sentence(words, sentence, folder, run):
    before = sorted(folder.rglob("*"))
    printed = run(*words.split(), code=2)
    assert printed.out == ""
    (line,) = printed.err.splitlines()
    assert sentence in line
    assert sorted(folder.rglob("*")) == before


@pytest.mark.parametrize("words", [*SOLVING.values(), ("bearing", "six.toml", "--compare")], ids=" ".join)
def test_a_file_in_the_place_of_a_directory_is_refused_before_anything_runs(words, run, monkeypatch):
    if words[0] != "solve":  # one case alone is solved first
        instead_of_solving(monkeypatch, lambda *_, **__: pytest.fail("it ran"))
    printed = run(*words, "--out", "plan.toml", code=2)
    assert printed.out == ""
    assert printed.err.startswith("--out = 'plan.toml' must be a directory, not a file")
    assert Path("plan.toml").read_text(encoding="utf-8") == TOLERANCE


@pytest.mark.parametrize("words", [SOLVING["solve"], SOLVING["bearing"], ("report", "case.toml", "--no-stress")])
@pytest.mark.slow
def test_nothing_is_left_behind_when_drawing_fails(words, run, monkeypatch):
    def fail(*_: object, **__: object) -> None:
        raise RuntimeError("the pen broke")

    monkeypatch.setattr("nonhertz.plot.sheets.save", fail)
    monkeypatch.setattr(nonhertz.report.layout, "image", fail)
    assert run(*words, "--out", "new/report.html" if words[0] == "report" else "new/folder", code=3).out == ""
    assert not Path("new").exists()


@pytest.mark.parametrize(
    "words",
    [
        *(words for name, words in SOLVING.items() if name != "solve"),  # which shows the state in which it stopped
        ("bearing", "six.toml", "--compare"),
        ("bearing", "six.toml", "--json"),
    ],
    ids=" ".join,
)
def test_without_a_solution_there_is_a_sentence_and_no_file(words, run, monkeypatch):
    def stop(*_: object, **__: object) -> None:
        raise nh.ConvergenceError("It stopped.", None)

    instead_of_solving(monkeypatch, stop)
    printed = run(*words, "--out", "folder", code=1)
    assert printed.out == ""
    assert printed.err in {"It stopped.\n", "On semi-elliptic strips: It stopped.\n"}
    assert not Path("folder").exists()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (SOLVING["life"], ["1/2 body a ...", "2/2 body b ..."]),
        (SOLVING["compare"], ["1/3 semi-elliptic strips ...", "3/3 plane grid ..."]),
        (SOLVING["stress"], ["1/2 whole body ...", "2/2 cross-section ..."]),
        (("verify",), ["1/1 Counting ..."]),
    ],
)
@pytest.mark.slow
def test_a_terminal_sees_what_is_being_done(words, said, run, monkeypatch):
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    claim = Claim("two", "fingers", 2.0, 1e-6, lambda: 2.0)
    monkeypatch.setattr("nonhertz.selfcheck.SECTIONS", {"Counting": lambda: [claim]})
    shown = run(*words, "--json").err
    assert all(each in shown for each in said)
    assert shown.endswith("\r")


@pytest.mark.parametrize("name", ["stress", "life", "compare", "bearing"])
@pytest.mark.slow
def test_json_is_one_object_and_that_of_the_file(name, run):
    printed = run(*SOLVING[name], "--json", "--out", "new/folder")
    assert printed.err == ""
    file = {"bearing": "result", "compare": "comparison"}.get(name, name)
    assert json.loads(Path(f"new/folder/{file}.json").read_text(encoding="utf-8")) == json.loads(printed.out)
