"""The table of commands, and how one of them is run.

A command is a function in a module of its own, which is imported when it runs; ``--help`` prints its docstring.
"""

from __future__ import annotations

import ast
import contextlib
import contextvars
import itertools
import re
import sys
import warnings
from collections.abc import Iterator, Sequence
from importlib import resources
from pathlib import Path

from cyclopts import App, CycloptsError, UnusedCliTokensError

from nonhertz import __version__
from nonhertz.amounts import choose_units
from nonhertz.cli import BAD_INPUT, FINE, NOT_CONVERGED
from nonhertz.errors import ConvergenceError, InputError

#: A command is a module, and a function in it of the same name unless another is named here.
COMMANDS = (
    *("solve", "bearing", "compare", "stress", "life", "report", "profile", "map", "nodes", "design", "sweep"),
    *("tolerance", "check", "materials", "new", "schema", "serve", "warm", "verify"),
)
_FUNCTIONS = {"map": "contact_map", "sweep": "sweep_plan", "tolerance": "study_tolerance"}
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
    for name in COMMANDS:
        function = _FUNCTIONS.get(name, name)
        more = {"help": _first_line(name, function)} if listed else {}
        found.command(f"nonhertz.cli.{name}:{function}", name=name, **more)
    return found


def _first_line(module: str, function: str) -> str:
    """Return the first line of a command's docstring, without importing what it is in."""
    source = resources.files("nonhertz.cli").joinpath(f"{module}.py").read_text("utf-8")
    (found,) = (each for each in ast.parse(source).body if isinstance(each, ast.FunctionDef) and each.name == function)
    return (ast.get_docstring(found) or "").partition("\n")[0]


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
