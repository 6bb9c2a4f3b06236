"""The table of commands, and how one of them is run.

A command is a function in a module of its own, which is imported when it runs; ``--help`` prints its docstring.
"""

from __future__ import annotations

import contextlib
import contextvars
import itertools
import re
import sys
import warnings
from collections.abc import Iterator, Sequence
from pathlib import Path

from cyclopts import App, CycloptsError, UnusedCliTokensError

from nonhertz import __version__
from nonhertz.amounts import choose_units
from nonhertz.cli import BAD_INPUT, FINE, NOT_CONVERGED
from nonhertz.errors import ConvergenceError, InputError

#: Module and function of each command, and the first line of its docstring, for the list of all without importing any.
COMMANDS = {
    "solve": ("solve:solve", "Solve case files and print a summary, or a table of several."),
    "bearing": ("bearing:bearing", "Solve a bearing file and print loads, pressures and life of the whole bearing."),
    "compare": (
        "compare:compare",
        "Solve a case file with strips of both elements and on a plane grid, and compare them.",
    ),
    "stress": ("stress:stress", "Solve a case file and find the largest stresses below the surface."),
    "life": ("life:life", "Solve a case file and assess how long both bodies last by several fatigue models."),
    "report": (
        "report:report",
        "Solve case files or bearing files and write one HTML report that anyone can open in a browser.",
    ),
    "profile": ("profile:profile", "Prepare a measured profile step by step, and say what each step did."),
    "map": (
        "map:contact_map",
        "Make a map of a case: load, moment and stiffness over approach and tilt, for other programs.",
    ),
    "nodes": (
        "nodes:nodes",
        "Solve a case file and find pressures and forces at the nodes of a finite element mesh.",
    ),
    "design": (
        "design:design",
        "Find the profile or the dimensions with the least largest pressure, or the longest life.",
    ),
    "sweep": ("sweep:sweep_plan", "Solve a case or a bearing for many values of what its file holds."),
    "tolerance": (
        "tolerance:study_tolerance",
        "Find how results are distributed when dimensions and loads are, and which tolerance matters.",
    ),
    "check": ("check:check", "List all mistakes in a case file, a bearing file or a plan."),
    "materials": ("materials:materials", "List the materials that a case file may name, with what they bear."),
    "new": ("new:new", "Write a commented case file, bearing file or plan to start from."),
    "schema": (
        "schema:schema",
        "Print the JSON schema of case, bearing, plan or result files, by which editors and other programs check them.",
    ),
    "serve": (
        "serve:serve",
        "Open a page in the browser on which to change a case or a bearing and see it solved as you type.",
    ),
    "warm": ("warm:warm", "Compile everything now, so that no later command has to: for containers and CI."),
    "verify": ("verify:verify", "Compare with publications, exact solutions and other methods."),
}
_CHANGE = re.compile(r"[A-Za-z][\w.\[\]-]*=")


def _application(listed: bool) -> App:
    """Return all commands; where they are ``listed`` alone, none is imported."""
    found = App(
        name="nonhertz",
        help="Elastic contact of rollers, raceways, gear teeth and wheels whose shape no Hertz formula fits.",
        help_epilogue="Exit codes: 0 success, 1 not converged or not verified, 2 bad input, 3 internal error.",
        version=__version__,
        exit_on_error=False,
        print_error=False,
        suppress_keyboard_interrupt=False,
    )
    for name, (place, line) in COMMANDS.items():
        found.command(f"nonhertz.cli.{place}", name=name, **({"help": line} if listed else {}))
    return found


app = _application(listed=False)


def run(words: Sequence[str]) -> int:
    """Run one command and return its exit code."""
    if ("--out", "") in itertools.pairwise(words) or "--out=" in words:
        raise InputError("--out", "", "name a directory or a file", "write --out . for the current directory")
    try:
        with _plain_warnings():
            # In a context of its own, which ends with the units that the command has chosen.
            return contextvars.copy_context().run(_run, _each_with_option(words))
    except UnusedCliTokensError as error:
        unused = ", ".join(repr(word) for word in error.unused_tokens or ())
        print(f"This command takes no {unused}; see 'nonhertz --help'.", file=sys.stderr)
    except CycloptsError as error:
        print(f"{' '.join(str(error).split()).rstrip('.')}; see 'nonhertz --help'.", file=sys.stderr)
    return BAD_INPUT


def _run(words: Sequence[str]) -> int:
    """Run one command in the units that it is asked to show; JSON is in SI units."""
    known = app if words and words[0] in COMMANDS else _application(listed=True)
    try:
        command, bound, _ = known.parse_args(words, exit_on_error=False, print_error=False)
    except ImportError as error:
        raise error.__cause__ or error from None  # which says what is not installed
    given = bound.arguments
    choose_units("si" if given.get("as_json") else given.get("units", "si"))
    try:
        code = command(*bound.args, **bound.kwargs)
    except ConvergenceError as error:
        sys.stdout.flush()
        print(error, file=sys.stderr)
        return NOT_CONVERGED
    return code if isinstance(code, int) else FINE


def _each_with_option(words: Sequence[str]) -> list[str]:
    """Return the words of a command line, with ``--set`` again before each further change that follows one."""
    found: list[str] = []
    after = False  # a change, so that another may follow
    for word in words:
        is_change = _CHANGE.match(word) is not None and not Path(word).exists()
        if after and is_change:
            found.append("--set")
        after = is_change and found[-1:] == ["--set"]
        found.append(word)
    return found


@contextlib.contextmanager
def _plain_warnings() -> Iterator[None]:
    """Show warnings, such as those about a measured profile, as sentences without source lines."""
    with warnings.catch_warnings():
        warnings.showwarning = lambda message, *_, **__: print(f"warning: {message}", file=sys.stderr)
        yield
