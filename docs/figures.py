"""Make the pictures in docs/figures and the terminal output in the tutorial.

    python docs/figures.py

Pictures are those that `nonhertz solve --out` writes. In the tutorial every line that begins with `$ nonhertz` is
run and what it prints put below it; a comment `<!-- edit: `old` to `new` -->` edits the case file in between.
"""

from __future__ import annotations

import contextlib
import io
import os
import re
import shlex
import tempfile
import warnings
from pathlib import Path

import nonhertz as nh
from nonhertz.cli import main as nonhertz
from nonhertz.io.casefile import Case, read_case
from nonhertz.plot import figures, save

ROOT = Path(__file__).parents[1]
FIGURES = ROOT / "docs" / "figures"
TUTORIAL = ROOT / "docs" / "tutorials" / "first-solve.md"
# Picture's name to the example it is of, and which of its figures the documents show.
EXAMPLES = {
    "bearing": ("cylindrical-roller-bearing", ("pressure", "footprint", "profile")),
    "crown": ("crowned-roller", ("pressure",)),
    "tabulated": ("tabulated-profile", ("pressure",)),
}

STEP = re.compile(r"<!-- edit: `(?P<old>.*?)` to `(?P<new>.*?)` -->|```console\n(?P<lines>.*?)```", re.DOTALL)


def main() -> None:
    """Make everything."""
    FIGURES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder, "first-solve.toml")
        nonhertz_quietly(["new", str(page)])
        draw("first-solve", read_case(page), ("pressure", "footprint", "profile"))
    for stem, (example, names) in EXAMPLES.items():
        draw(stem, read_case(ROOT / "examples" / f"{example}.toml"), names)
    TUTORIAL.write_text(with_output(TUTORIAL.read_text(encoding="utf-8")), encoding="utf-8")
    print(f"wrote {TUTORIAL.relative_to(ROOT)}")


def draw(stem: str, case: Case, names: tuple[str, ...]) -> None:
    """Write the figures of a case as ``stem``-pressure.svg and so on."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        solution = nh.solve(case.contact, **case.prescribed, **case.solver)
    drawn = figures(solution, case.title)
    for name in names:
        vector, pixels = save(drawn[name], FIGURES / f"{stem}-{name}")
        # One copy is enough for the documents.
        vector.unlink()
        print(f"wrote {pixels.relative_to(ROOT)}")


def with_output(page: str) -> str:
    """Return a page with what its commands print, run one after the other in an empty directory."""
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        return STEP.sub(_step, page)


def _step(found: re.Match[str]) -> str:
    if found["lines"] is None:
        (case,) = Path().glob("*.toml")
        text = case.read_text(encoding="utf-8")
        if found["old"] not in text:
            raise ValueError(f"{case} has no {found['old']!r}")
        case.write_text(text.replace(found["old"], found["new"]), encoding="utf-8")
        return found[0]
    commands = [line for line in found["lines"].splitlines() if line.startswith("$ nonhertz ")]
    shown = [f"{line}\n{nonhertz_quietly(shlex.split(line)[2:])}" for line in commands]
    return "```console\n" + "".join(shown) + "```"


def nonhertz_quietly(words: list[str]) -> str:
    """Run the command line and return what it prints."""
    printed = io.StringIO()
    # The width of the table's lines must not depend on whose terminal this runs in.
    os.environ["COLUMNS"] = "100"
    with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
        nonhertz(words)
    return "".join(f"{line.rstrip()}\n" for line in printed.getvalue().splitlines())


if __name__ == "__main__":
    main()
