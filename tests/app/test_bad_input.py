"""Bad input through the command line: each mistake one sentence, exit code 2, and nothing solved."""

import pytest

import nonhertz as nh
from nonhertz.files.casefile import Case, with_file_path
from nonhertz.files.toml import parse

A = "[body.a]\ndiameter = 20.0\nlength = 20.0\n"
B = "[body.b]\n"
LOAD = "[load]\nload = 20000.0\n"
REST = f"{B}{LOAD}"
FACES = "must be one of 'free', 'mirror', 'calibrated', 'none' or a number"
NOT_CONVEX = "must only be used for a convex body, which has a diameter"


def profile(table: str) -> str:
    return f"{A}profile = [{table}]\n{REST}"


MISTAKES = [
    # Numbers and units
    (f"[body.a]\nlength = '-5 um'\n{B}diameter = 20\n{LOAD}", "body.a.length = '-5 um' must be positive"),
    (f"[body.a]\nlength = true\n{B}diameter = 20\n{LOAD}", "body.a.length = True must be a finite number"),
    (f"[body.a]\ndiameter = 0\n{REST}", "body.a.diameter = 0.0 must not be zero"),
    (f"[body.a]\ndiameter = 1e-320\nlength = 20\n{REST}", "body.a.diameter = 1e-320 must be at least 1e-100 in mag"),
    (f"{A}effective_length = 21\n{REST}", "body.a.effective_length = 21.0 must not exceed the length of 20 mm"),
    (f"[body.a]\ndiameter = 'twenty'\n{REST}", "body.a.diameter = 'twenty' must be a number with a unit"),
    (f"[body.a]\ndiameter = '20'\n{REST}", "body.a.diameter = '20' must have a unit: write 20 without quotes"),
    (f"[body.a]\ndiameter = '20 mmm'\n{REST}", "body.a.diameter = '20 mmm' must have a known unit"),
    (f"{A}{REST}moment = '5 N'\n", "load.moment = '5 N' must have a unit of moment"),
    # Materials
    (f"{A}material = 'Stel'\n{REST}", "body.a.material = 'Stel' must be a known material: did you mean 'steel'?"),
    (f"{A}material = {{ modulus = 207000 }}\n{REST}", "body.a.material.poisson must be given"),
    (f"{A}material = 207000\n{REST}", "body.a.material = 207000 must be a name or a table"),
    (
        f"{A}material = {{ modulus = 1, poisson = 0, x = 2 }}\n{REST}",
        "Unknown key body.a.material.x: choose from 'modulus', ",
    ),
    (
        f"{A}case_depth = -1\nmaterial = {{ modulus = 1, poisson = 0.51, hardness = '60', yield_strength = 0 }}\n"
        f"{REST}",
        "body.a.case_depth = -1.0 must be positive",
        "body.a.material.poisson = 0.51 must lie in (-1, 0.5]",
        "body.a.material.hardness = '60' must be a number with its scale, HV, HRC or HBW",
        "body.a.material.yield_strength = 0.0 must be positive",
    ),
    # Profiles
    (profile("{ kind = 'crwon', radius = 4000 }"), "body.a.profile[1].kind = 'crwon' must be a known profile"),
    (profile("{ kind = 'straight' }, { radius = 4000 }"), "body.a.profile[2].kind must be given"),
    (
        profile("{ kind = 'crown', radus = 4000 }"),
        "Unknown key body.a.profile[1].radus. Did you mean body.a.profile[1].radius?",
    ),
    (profile("{ kind = 'crown' }"), "body.a.profile[1].radius must be given"),
    (f"[body.a]\ndiameter = 20\nprofile = {{ kind = 'iso-thrust' }}\n{REST}", "body.a.profile.length must be given"),
    (f"{A}profile = 'crown'\n{REST}", "body.a.profile = 'crown' must be a list of tables"),
    (profile("{ kind = 'tabulated', file = 'empty.csv' }"), "body.a.profile[1].file = 'empty.csv' must name a file of"),
    (
        profile("{ kind = 'tabulated', file = 'word.csv' }"),
        "body.a.profile[1].file, line 2 of word.csv = '1,x' must ho",
    ),
    (profile("{ kind = 'tabulated', file = 'two.csv', y = [0, 1] }"), "body.a.profile[1].y = [0, 1] must not be given"),
    (profile("{ kind = 'tabulated' }"), "body.a.profile[1].y must be given", "body.a.profile[1].relief must be given"),
    # Load and solver
    (f"{A}{REST}approach = 0.01\n", "load.approach = 0.01 must not be given together with load"),
    (f"{A}{REST}moment = 1.0\ntilt = 0.0\n", "load.moment = 1.0 must not be given together with tilt"),
    (f"{A}{B}[load]\ntilt = 0.0\n", "load.load must be given"),
    (f"{A}{REST}[solver]\nelement = 'parabola'\n", "solver.element = 'parabola' must be one of 'semi-elliptic', 'para"),
    (f"{A}{REST}[solver]\nstrips = 'many'\n", "solver.strips = 'many' must be 'auto' or a whole number from 1 to 2000"),
    # Keys and sections
    (f"{A}{REST}[sovler]\n", "Unknown key sovler. Did you mean solver?"),
    (f"{A}{B}[body.c]\n{LOAD}", "Unknown key body.c: choose from 'a', 'b'."),
    (f"{A}{LOAD}", "body.b must be given: write it under a heading [body.b]"),
    ("", "body must be given", "load must be given"),
    (f"body = 3\n{LOAD}", "body = 3 must be a section"),
    (f'title = "a\\u0007"\n{A}{REST}', r"title = 'a\x07' must be one line of text without control characters"),
    (f"title = 3\n{A}{REST}", "title = 3 must be text"),
    # Side faces, images, depth
    (f"{A}side_faces = '1'\n{REST}", "body.a.side_faces = '1' must be a plain number"),
    (f"{A}side_faces = {{}}\n{REST}", f"body.a.side_faces {FACES}"),
    (f"{A}side_faces = [1, 2, 3]\n{REST}", "body.a.side_faces = [1, 2, 3] must be one value or two"),
    (
        f"{A}side_faces = ['miror', '1']\n{REST}",
        f"body.a.side_faces[1] = 'miror' {FACES}",
        "body.a.side_faces[2] = '1' must be a plain number",
    ),
    (f"[body.a]\ndiameter = 20\nside_faces = 'calibrated'\n{REST}", "body.a.length must be given where side_faces ="),
    (
        f"[body.a]\ndiameter = 20\nlenght = 20\nside_faces = 'mirror'\n{REST}",
        "Unknown key body.a.lenght. Did you mean body.a.length?",
    ),
    (f"{A}images = '3'\n{REST}", "body.a.images = '3' must be 'series' or a whole number from 1 to 100"),
    (f"{A}kind = 'body'\nimages = 'series'\n{REST}", "body.a.images = 'series' must only be used for a body with a de"),
    (f"{A}depth = '-1 mm'\n{REST}", "body.a.depth = '-1 mm' must be positive"),
    (f"{A}depth = '8'\n{REST}", "body.a.depth = '8' must have a unit"),
    (f"{A}{B}diameter = -120\ndepth = 'diameter'\n{LOAD}", f"body.b.depth = 'diameter' {NOT_CONVEX}"),
    (f"{A}{B}kind = 'plate'\ndepth = 'plane-strain'\n{LOAD}", f"body.b.depth = 'plane-strain' {NOT_CONVEX}"),
    # Kinds of body, and two that do not go together
    (
        f"{A}kind = 'rollr'\nimages = 'series'\n{REST}",
        "body.a.kind = 'rollr' must be a known kind of body: did you mean 'roller'?",
    ),
    (f"{A}kind = 1\n{REST}", "body.a.kind = 1 must be a known kind of body: choose from 'roller', 'ring', 'plate', 'b"),
    (f"[body.a]\nkind = 'roller'\n{REST}", "body.a.diameter must be positive", "body.a.length must be given"),
    (
        f"[body.a]\nkind = 'roller'\ndiametr = 20\nlength = 20\n{REST}",
        "Unknown key body.a.diametr. Did you mean body.a.diameter?",
    ),
    (f"{A}{B}kind = 'ring'\n{LOAD}", "body.b.diameter must be given"),
    (f"{A}{B}kind = 'plate'\ndiameter = 20\n{LOAD}", "body.b.diameter = 20.0 must be left out"),
    (f"{A}{B}position = 30\nlength = 5\n{LOAD}", "body.b.position = 30.0 must let the bodies overlap along y"),
    (f"{A}{B}diameter = -20\n{LOAD}", "body.b.diameter = -20.0 must leave a positive combined curvature with body.a.d"),
    (f"[body.a]\ndiameter = -20\nlength = 5\n{REST}", "body.a.diameter = -20.0 must leave a positive combined curvatu"),
    (
        f"[body.a]\ndiameter = {{ y = [-10, 10], diameter = [-30, -19] }}\n{B}diameter = 20\n{LOAD}",
        "body.a.diameter must leave a positive combined curvature with body.b.diameter = 20.0",
    ),
    (f"[body.a]\nlength = 20\n{REST}", "body.a.diameter must be given: the bodies are both flat"),
    (
        f"{A}lenght = 3\n{B}material = 'bras'\n[load]\nload = -1\ntilt = '5 kg'\n",
        "Unknown key body.a.lenght. Did you mean body.a.length?",
        "body.b.material = 'bras' must be a known material: give modulus and poisson",
        "load.load = -1.0 must be positive",
        "load.tilt = '5 kg' must have a unit of angle",
    ),
]


@pytest.fixture
def folder(tmp_path, monkeypatch):
    (tmp_path / "empty.csv").write_text("", encoding="utf-8")
    (tmp_path / "word.csv").write_text("0,0\n1,x\n", encoding="utf-8")
    (tmp_path / "two.csv").write_text("0,0\n1,0\n", encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize("case", MISTAKES)
def test_each_mistake_is_one_sentence_with_a_way_out(folder, case):
    text, *beginnings = case
    with pytest.raises(nh.CaseError) as caught:
        Case.of(parse(text, "case.toml"), folder / "case.toml")
    for said, beginning in zip(caught.value.mistakes, beginnings, strict=True):
        assert said.startswith(beginning)
        assert said.endswith((".", "?"))
        assert ": " in said or said.startswith("Unknown key ")
        assert len(said.splitlines()) == 1


@pytest.mark.parametrize("beginnings", [MISTAKES[0], MISTAKES[-1]])
def test_commands_list_mistakes_and_solve_nothing(folder, run, beginnings):
    (folder / "case.toml").write_text(beginnings[0], encoding="utf-8")
    solved = run("solve", "case.toml", "--json", "--out", "results", code=2)
    assert solved.out == ""
    assert not (folder / "results").exists()
    checked = run("check", "case.toml", code=2)
    assert checked.err == ""
    single = len(beginnings) == 2
    assert solved.err == (checked.out.removeprefix("1. ") if single else checked.out)
    for number, (line, beginning) in enumerate(zip(checked.out.splitlines(), beginnings[1:], strict=True), start=1):
        assert line.startswith(f"{number}. {beginning}")


FILES = {
    "not there": (None, "must exist: give the path of a case file, or begin with one from 'nonhertz new case.toml'."),
    "not TOML": (b"[body.a]\nlength = \n", "must be valid TOML: invalid value (at line 2, column 10)."),
    "a decimal comma": (
        b"load = 20,5\n",
        "must be valid TOML: expected newline or end of document after a statement (at line 1, column 10); "
        "use a decimal point.",
    ),
    "a bare unit": (
        b"load = 20 kN  # down\n",
        "must be valid TOML: expected newline or end of document after a statement (at line 1, column 11); "
        'quote a number with its unit, "20 kN".',
    ),
    "digits of another base": (
        b"load = 0xffff g\n",
        "must be valid TOML: expected newline or end of document after a statement (at line 1, column 15).",
    ),
    "a key twice": (b"a = 1\na = 2\n", "must be valid TOML: a key is given twice (at line 2, column 6)."),
    "a key twice in a row": (b"a = {b = 1, b = 2}", "must be valid TOML: a key is given twice (at line 1, column 18)."),
    "a table twice": (
        b"[load]\nload = 1\n[load]\n",
        "must be valid TOML: table [load] is defined twice (at line 3, column 6).",
    ),
    "a table of tables twice": (
        b'[body."a b"]\n[body."a b"]\n',
        'must be valid TOML: table [body."a b"] is defined twice (at line 2, column 12).',
    ),
    "a table again as a key": (
        b"[body.a]\n[body]\na.length = 1\n",
        "must be valid TOML: table [body.a] is defined twice (at line 3, column 13).",
    ),
    "not closed": (
        b"[body",
        "must be valid TOML: expected ']' at the end of a table declaration (at end of document).",
    ),
    "not text": (
        b'title = "a"\n\xff\xfe',
        ", line 2, must be text in UTF-8: save the file with that encoding.",
    ),
    "too deep": (b"a = " + b"[" * 5000, "must be valid TOML: lists or tables are nested too deeply."),
    "too long a number": (b"a = 1" + b"0" * 5000, "must be valid TOML: a number has thousands of digits."),
}


@pytest.mark.parametrize(("content", "sentence"), FILES.values(), ids=FILES)
@pytest.mark.parametrize("command", ["solve", "check"])
def test_files_that_cannot_be_read(folder, run, command, content, sentence):
    if content is not None:
        (folder / "case.toml").write_bytes(content)
    both = run(command, "case.toml", code=2)
    if command == "check":
        sentence = sentence.replace("a case file,", "a case file, bearing file or plan file,")
    space = "" if sentence.startswith(",") else " "
    assert (both.out + both.err).removeprefix("1. ") == f"case.toml{space}{sentence}\n"


@pytest.mark.parametrize("name", ["roller.tml", "roler.toml", "roller", "Roller.toml"])
def test_a_file_of_a_name_alike_is_offered(folder, run, name):
    (folder / "roller.toml").write_text("", encoding="utf-8")
    assert run("solve", name, code=2).err == f"{name} does not exist. Did you mean roller.toml?\n"
    (folder / "in").mkdir()
    assert run("check", f"in/{name}", code=2).out.startswith(f"1. in/{name} must exist: ")


def test_a_directory_is_no_case_file(folder, run):
    assert run("solve", ".", code=2).err == ". must be a file, not a directory: give the path of a case file.\n"


def test_what_only_the_solver_sees_is_a_sentence_too(folder, run):
    # A cylinder without ends on a plane without ends: nothing ends the contact.
    (folder / "case.toml").write_text(f"[body.a]\ndiameter = 20\n{REST}", encoding="utf-8")
    sentence = run("solve", "case.toml", code=2).err
    assert sentence.startswith("body.a.length must be given where nothing else ends the contact: ")
    assert len(sentence.splitlines()) == 1
    assert run("check", "case.toml", code=2).out == f"1. {sentence}"


def test_a_complaint_of_the_solver_about_both_bodies_names_keys_of_the_file():
    with pytest.raises(nh.InputError) as caught:
        nh.Contact(nh.Roller(diameter=20.0, length=20.0), nh.Ring(diameter=-10.0)).curvature(0.0)
    complaint = with_file_path(caught.value)
    assert complaint.places == ("body.b.diameter",)
    assert str(complaint).startswith("body.b.diameter = -10.0 must leave a positive combined curvature with body.a")


@pytest.mark.parametrize(
    "keys",
    [{"side_faces": "miror"}, {"images": 0}, {"images": "series", "depth": "none"}, {"diameter": -20.0}],
    ids=str,
)
def test_a_body_is_refused_in_the_words_of_python(folder, keys):
    given = {"diameter": 20.0, "length": 20.0} | keys
    with pytest.raises(nh.InputError) as caught:
        nh.Roller(**given)
    written = "".join(f"{key} = {value!r}\n" for key, value in given.items())
    with pytest.raises(nh.CaseError) as refused:
        Case.of(parse(f"[body.a]\nkind = 'roller'\n{written}{REST}", "case.toml"), folder / "case.toml")
    assert refused.value.mistakes == (str(caught.value.within("body.a")),)


@pytest.mark.parametrize(
    ("words", "beginning"),
    [
        (["slove", "case.toml"], 'Unknown command "slove". Did you mean "solve"? See \''),
        (["case.toml"], "A command comes first, such as 'nonhertz solve case.toml'; see 'nonhertz --help'"),
        (["solve"], "Give CASE, as in 'nonhertz solve roller.toml'; see '"),
        (["report"], "Give CASE, as in 'nonhertz report roller.toml'; see '"),
        (["nodes", "a"], "Give NODES, as in 'nonhertz nodes roller.toml surface.csv'; see '"),
        (
            ["life", "--model", "iso-16281", "case.toml"],
            "--model takes all words after it, including 'case.toml'; "
            "write 'nonhertz life case.toml --model iso-16281'; see",
        ),
        (
            ["sweep", "--quantities", "load", "plan.toml"],
            "--quantities takes all words after it, including 'plan.toml'; "
            "write 'nonhertz sweep plan.toml --quantities load'; see '",
        ),
        (["stress", "a", "b"], "This command takes no 'b'; see"),
        (["solve", "a", "--jsn"], "Unknown option: --jsn. Did you mean --json?"),
        (["check"], "Give FILE, as in 'nonhertz check roller.toml plan.toml'; see '"),
    ],
)
def test_wrong_usage_is_one_sentence(run, words, beginning):
    printed = run(*words, code=2)
    assert printed.out == ""
    assert printed.err.startswith(beginning)
    of = "nonhertz" if words[0] in ("slove", "case.toml") else f"nonhertz {words[0]}"
    assert printed.err.endswith((f"; see '{of} --help'.\n", f"? See '{of} --help'.\n"))
    assert len(printed.err.splitlines()) == 1
