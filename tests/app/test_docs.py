"""The documents: all within reach, no link into nothing, and what they show is what happens.

The site itself is built by `make docs`, with warnings as errors.
"""

import doctest
import functools
import importlib
import re
import tomllib
import warnings
from fnmatch import fnmatch
from pathlib import Path

import numpy as np
import pytest

import nonhertz as nh
from nonhertz.cli import main

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
GENERATED = {DOCS / "gallery", DOCS / "reference" / "api" / "classes"}
API = DOCS / "reference" / "api"
SHOWN_ELSEWHERE = [
    ROOT / name for name in ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "examples/README.md")
]
WRITTEN = (path for path in DOCS.rglob("*") if GENERATED.isdisjoint(path.parents))
PAGES = sorted(path for path in WRITTEN if path.suffix in {".md", ".rst"})
MARKDOWN = [path for path in (*PAGES, *SHOWN_ELSEWHERE) if path.suffix == ".md"]
HOW_TOS = [*sorted((DOCS / "how-to").glob("*.md")), *sorted((DOCS / "tutorials").glob("bearing-*.md"))]

FENCED = re.compile(r"^```.*?^```$", re.MULTILINE | re.DOTALL)
TOCTREE = re.compile(r"^```\{toctree\}\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")


def name_of(path):
    return path.relative_to(ROOT).as_posix()


def names_in_toctrees(page):
    """Return the patterns in a page's tables of contents, relative to the documents."""
    folder = page.parent.relative_to(DOCS).as_posix()
    for tree in TOCTREE.findall(page.read_text(encoding="utf-8")):
        for line in tree.splitlines():
            if line and not line.startswith(":"):
                yield f"{folder}/{line}".removeprefix("./")


def test_every_page_can_be_reached():
    patterns = {pattern for page in PAGES for pattern in names_in_toctrees(page)}
    names = {page.relative_to(DOCS).with_suffix("").as_posix() for page in PAGES} - {"index"}
    # A star does not reach into folders.
    lost = [n for n in names if not any(fnmatch(n, p) and n.count("/") == p.count("/") for p in patterns)]
    assert lost == []
    assert {p for p in patterns if "*" not in p} <= names | {"gallery/index"}


def test_every_page_is_linked_where_there_is_no_table_of_contents():
    # GitHub shows a table of contents as it is written, without links.
    for folder in ("how-to", "explain", "reference", "tutorials", "validation", "benchmarks"):
        index = DOCS / folder / "index.md"
        linked = {link.partition("#")[0] for link in LINK.findall(index.read_text(encoding="utf-8"))}
        assert {page.name for page in index.parent.glob("*.md")} - {"index.md"} <= linked, folder


def test_every_script_of_the_gallery_is_listed_too():
    examples = ROOT / "examples"
    linked = set(LINK.findall((examples / "README.md").read_text(encoding="utf-8")))
    assert {f"./gallery/{script.name}" for script in (examples / "gallery").glob("*.py")} <= linked


@functools.cache
def anchors(path):
    """Return the anchors of a page's headings, as GitHub and MyST make them."""
    headings = re.findall(r"^#+ (.*)$", FENCED.sub("", path.read_text(encoding="utf-8")), re.MULTILINE)
    plain = (re.sub(r"[^\w\- ]", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", each)).lower() for each in headings)
    return {each.strip().replace(" ", "-") for each in plain}


def test_links_lead_somewhere():
    for page in MARKDOWN:
        text = re.sub(r"`[^`\n]*`", "", FENCED.sub("", page.read_text(encoding="utf-8")))
        for link in LINK.findall(re.sub(r"\$[^$\n]*\$", "", text)):
            if not link.startswith("http"):
                file, _, anchor = link.partition("#")
                target = page.parent / file if file else page
                assert target.exists(), (page, link)
                assert not anchor or anchor in anchors(target), (page, link)


@pytest.mark.parametrize("page", HOW_TOS, ids=name_of)
@pytest.mark.slow
def test_how_to_shows_what_happens(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = page.read_text(encoding="utf-8")
    assert "```python" not in text, "write ```pycon, with what it prints"
    blocks = re.findall(r"^```pycon\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    # Blocks go on where the one before stopped; a blank line ends what is printed, dots stand for lines not shown.
    test = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, page.stem, str(page), 0)
    runner = doctest.DocTestRunner(optionflags=doctest.REPORT_ONLY_FIRST_FAILURE | doctest.ELLIPSIS)
    said = []
    with warnings.catch_warnings():
        # A reader would see warnings that the page does not show.
        warnings.simplefilter("error")
        runner.run(test, out=said.append)
    assert runner.summarize(verbose=False).failed == 0, "".join(said)


@pytest.mark.slow
def test_the_readme_prints_what_it_says_and_its_bearing_is_that_of_the_file(tmp_path, capsys):
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    script, bearing = re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    (printed,) = re.findall(r"^```\n\n((?:    .*\n)+)\nOr from files", text, re.MULTILINE)
    names: dict[str, object] = {}
    exec(script, names)
    assert capsys.readouterr().out == re.sub(r"^    ", "", printed, flags=re.MULTILINE)
    exec(bearing, names)
    file = tmp_path / "nu206.toml"
    assert main(["new", "--bearing", str(file)]) == 0
    np.testing.assert_allclose(nh.read_bearing(file).solve().max_pressure, names["solution"].max_pressure, rtol=1e-9)


def plans():
    """Return the plans printed in the documents, by the page and their number on it."""
    for page in PAGES:
        for number, text in enumerate(re.findall(r"^```toml\n(.*?)^```$", page.read_text("utf-8"), re.M | re.S)):
            if re.search(r'^case = "', text, re.M):
                yield pytest.param(text, id=f"{name_of(page)}-{number}")


@pytest.mark.parametrize("text", list(plans()))
def test_plans_fit_the_file_that_new_writes(text, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (name,) = re.findall(r'^case = "(\S+)"', text, re.M)
    assert main(["new", *(["--bearing"] if "[bearing]" in text or "bearing" in name else []), name]) == 0
    Path("plan.toml").write_text(text, encoding="utf-8")
    assert main(["check", "plan.toml"]) == 0, capsys.readouterr().err


@pytest.mark.slow
def test_the_commands_of_a_design_run_as_written_and_write_the_plan_shown(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    text = (ROOT / "docs" / "how-to" / "design.md").read_text(encoding="utf-8")
    commands = re.findall(r"^    nonhertz (.*)$", text, re.M)
    assert [each.split()[0] for each in commands] == ["new", "new", "design"]
    for command in commands:
        assert main(command.split()) == 0, capsys.readouterr().err
    (shown,) = re.findall(r"^```toml\n(.*?)^```$", text, re.M | re.S)
    written = tomllib.loads(Path("plan.toml").read_text(encoding="utf-8"))
    for name, table in tomllib.loads(shown).items():
        assert written[name] == table
    for name in re.findall(r"`([\w.]+)`", text.partition("It writes ")[2].partition("and a figure")[0]):
        assert Path("plan-design", name).exists()


def test_what_new_says_to_try_works_where_there_is_no_case(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["new", "--plan", "plan.toml"]) == 0
    way = "nonhertz new case.toml, then nonhertz design plan.toml"
    assert capsys.readouterr().out == f"wrote plan.toml, for case.toml; try it with: {way}\n"
    assert main(["new", "case.toml"]) == 0
    assert main(["check", "plan.toml"]) == 0, capsys.readouterr().err


def test_the_nodes_of_the_how_to_lie_in_the_contact(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    page = (DOCS / "how-to" / "finite-elements.md").read_text(encoding="utf-8")
    block = re.search(r"^    node;.*\n(?:    .*\n)+", page, re.MULTILINE)
    Path("surface.csv").write_text(re.sub(r"^    ", "", block[0], flags=re.MULTILINE), encoding="utf-8")
    assert main(["new", "roller.toml"]) == main(["nodes", "roller.toml", "surface.csv"]) == 0
    pressures = [float(row.split(",")[4]) for row in Path("surface-pressure.csv").read_text("utf-8").splitlines()[1:]]
    assert min(pressures) > 1000.0, capsys.readouterr()


MODULES = {"nonhertz.profile": nh.profile} | {
    f"nonhertz.{name}": importlib.import_module(f"nonhertz.{name}")
    for name in (
        "bearing",
        "hertz",
        "files.casefile",
        "files.force_tables",
        "files.bearingfile",
        "files.document",
        "life",
        "maps",
        "measured",
        "patch",
        "plot",
        "strength",
        "study",
        "subsurface",
    )
}


def directives():
    """Return what the pages of the reference ask of `public-names`: a module, and names if not all."""
    found = re.compile(r"^\.\. public-names:: (\S+)\n((?:\n|   .*\n?)*)", re.MULTILINE)
    return [match for page in API.glob("*.rst") for match in found.findall(page.read_text(encoding="utf-8") + "\n")]


def test_the_reference_has_every_public_name():
    whole = {module for module, names in directives() if not names.strip()}
    assert whole == set(MODULES)
    listed = [name for module, names in directives() if module == "nonhertz" for name in names.split()]
    modules = {module.removeprefix("nonhertz.").partition(".")[0] for module in MODULES} | {"design"}
    # What stands on the page of its own module does not stand here again.
    elsewhere = {name for name in dir(nh) if getattr(getattr(nh, name), "__module__", "") in MODULES}
    assert sorted(listed) == sorted(set(dir(nh)) - modules - elsewhere - {"ContactMap", "contact_map", "__version__"})
