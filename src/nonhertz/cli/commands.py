"""The table of commands, and how one of them is run.

A command is a function in a module of its own. Its signature and its docstring, which ``--help`` prints, are read from
the source; what it needs is imported when it runs, so that help and mistyped options are answered at once.
"""

from __future__ import annotations

import ast
import contextlib
import contextvars
import functools
import importlib
import inspect
import itertools
import re
import sys
import warnings
from collections.abc import Callable, Iterator, Sequence
from importlib import resources
from pathlib import Path
from typing import Any

from cyclopts import App, CycloptsError, Group, MissingArgumentError, UnusedCliTokensError

from nonhertz import __version__
from nonhertz.amounts import choose_units
from nonhertz.cli.answer import Answer
from nonhertz.cli.exit_codes import BAD_INPUT, FINE, NOT_CONVERGED
from nonhertz.cli.options import AsJson, Judge, UnitsRead
from nonhertz.errors import ConvergenceError, InputError

#: Commands by group, each with an example. A command is a module with a function of the same name, unless another is
#: named below.
GROUPS = {
    "Start": {
        "new": "new roller.toml, nonhertz new --bearing nu206.toml, nonhertz new --template needle needle.toml",
        "check": "check roller.toml plan.toml",
        "materials": "materials 100Cr6",
        "schema": "schema case --out nonhertz-case.schema.json",
        "serve": "serve roller.toml",
    },
    "Solve": {
        "solve": "solve roller.toml --out results --set load.load=5kN load.tilt=1mrad",
        "bearing": "bearing nu206.toml --out results",
        "stress": "stress roller.toml --body b",
        "life": "life new.toml --compare old.toml",
        "report": 'report roller.toml --life --author "M. Muster"',
    },
    "Study": {
        "sweep": "sweep roller.toml --over load.load=5kN:40kN:8 load.tilt=0,0.5mrad",
        "tolerance": "tolerance roller.toml --over 'load.load=normal(nominal,1kN)'",
        "design": "design plan.toml --front 9",
    },
    "Exchange": {
        "profile": "profile trace.txt --height-unit um --fit best --out profile",
        "map": "map roller.toml --load 0:20kN --tilt -1mrad:1mrad --out k.npz",
        "nodes": "nodes roller.toml surface.csv",
    },
    "Verify": {
        "compare": "compare roller.toml --cells 64 256",
        "verify": "verify",
    },
}
EXAMPLES = {name: example for commands in GROUPS.values() for name, example in commands.items()}
COMMANDS = tuple(EXAMPLES)
_FUNCTIONS = {"map": "contact_map", "sweep": "sweep_plan", "tolerance": "study_tolerance"}
_EXIT_CODES = "Exit codes: 0 success, 1 not converged or not verified, 2 bad input, 3 internal error."
_CHANGE = re.compile(r"[A-Za-z][\w.\[\]-]*=")


# The names that occur in signatures.
_OF_SIGNATURES = {"__future__", "cyclopts", "nonhertz.cli.answer", "nonhertz.cli.options", "pathlib", "typing"}
# The parameters of every command that returns an `Answer`.
_OF_ANSWERS = {
    name: inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)
    for name, default, annotation in (("units", "si", UnitsRead), ("as_json", False, AsJson), ("judge", False, Judge))
}


@functools.cache
def build_application(only: str | None = None) -> App:
    """Return all commands, or only one: reading the others from their sources takes longer than running it."""
    app = App(
        name="nonhertz",
        help="Elastic contact of rollers, raceways, gear teeth and wheels whose shape no Hertz formula fits.",
        help_epilogue="Start with: nonhertz new roller.toml, nonhertz solve roller.toml. "
        "Help on a command: nonhertz COMMAND --help. " + _EXIT_CODES,
        version=__version__,
        exit_on_error=False,
        print_error=False,
        suppress_keyboard_interrupt=False,
    )
    for title, commands in GROUPS.items():
        group = Group.create_ordered(title)
        for place, (name, example) in enumerate(commands.items()):
            if only not in (None, name):
                continue
            after = f"Example: nonhertz {example}\n\n{_EXIT_CODES}"
            command = _import_lazily(name, _FUNCTIONS.get(name, name))
            app.command(command, name=name, group=group, sort_key=place, help_epilogue=after)
    help_too = Group.create_ordered("Help")
    for flag in ("--help", "--version"):
        app[flag].group = help_too
    return app


def _import_lazily(name: str, function: str) -> Callable[..., Answer | int | None]:
    """Return a function with signature and docstring of a command, which imports the command when it is called."""
    source = resources.files("nonhertz.cli").joinpath(f"{name}.py")
    tree = ast.parse(source.read_text("utf-8"), str(source))
    tree.body = [node for node in tree.body if (isinstance(node, ast.ImportFrom) and node.module in _OF_SIGNATURES)
                 or (isinstance(node, ast.FunctionDef) and node.name == function)]  # fmt: skip
    scope: dict[str, Any] = {"__name__": f"nonhertz.cli.{name}"}
    exec(compile(tree, str(source), "exec"), scope)

    signature = inspect.signature(scope[function])
    own, added = signature.parameters, _OF_ANSWERS if "Answer" in signature.return_annotation else {}

    @functools.wraps(scope[function])
    def imported(*args: Any, **kwargs: Any) -> Answer | int | None:
        mine = {key: value for key, value in kwargs.items() if key in own or key not in added}
        if "changes" in mine:
            from nonhertz.files.changes import parse_changes

            mine["changes"] = parse_changes(mine["changes"])
        answer: Answer | int | None = getattr(importlib.import_module(f"nonhertz.cli.{name}"), function)(*args, **mine)
        return answer

    every = [*(parameter for key, parameter in own.items() if key not in added), *added.values()]
    vars(imported)["__signature__"] = signature.replace(parameters=every)
    return imported


def run(words: Sequence[str]) -> int:
    """Run one command and return its exit code."""
    if words[:1] == ["help"]:
        words = [*words[1:], "--help"]
    if ("--out", "") in itertools.pairwise(words) or "--out=" in words:
        raise InputError("--out", "", "name a directory or a file", "write --out . for the current directory")
    try:
        with _plain_warnings():
            # In a context of its own, so that the command's choice of units ends with it.
            return contextvars.copy_context().run(_run, repeat_set_option(words))
    except CycloptsError as error:
        sentence = _explain(error, words)
        lead = f"{sentence} See" if sentence.endswith("?") else f"{sentence.rstrip('.')}; see"
        print(f"{lead} {_help_on(words)}.", file=sys.stderr)
    return BAD_INPUT


def _explain(error: CycloptsError, words: Sequence[str]) -> str:
    """Return what is wrong with the words of a command line."""
    if isinstance(error, UnusedCliTokensError):
        return f"This command takes no {', '.join(map(repr, error.unused_tokens or ()))}"
    if words and words[0].endswith(".toml"):
        return f"A command comes first, such as 'nonhertz solve {words[0]}'"
    if isinstance(error, MissingArgumentError) and error.argument and error.argument.index is not None:
        return _explain_missing(error.argument.name, words)
    return " ".join(str(error).split()).partition(" Available commands: ")[0]  # which help lists


def _explain_missing(name: str, words: Sequence[str]) -> str:
    """Return the remedy for a missing argument, which an option before it may have taken."""
    for place, word in enumerate(words):
        option = next((earlier for earlier in reversed(words[1:place]) if earlier.startswith("--")), "")
        if option and word.endswith(".toml"):
            first = " ".join([*words[:1], word, *words[1:place], *words[place + 1 :]])
            return f"{option} takes all words after it, including '{word}'; write 'nonhertz {first}'"
    return f"Give {name}, as in 'nonhertz {EXAMPLES[words[0]].partition(' --')[0]}'"


def _help_on(words: Sequence[str]) -> str:
    """Return how to ask for help on the command of these words, or on all commands."""
    known = bool(words) and words[0] in COMMANDS
    return f"'nonhertz {words[0]} --help'" if known else "'nonhertz --help'"


def _run(words: Sequence[str]) -> int:
    """Run one command, in the units of ``--units``; JSON is in SI units."""
    app = build_application(words[0] if words and words[0] in COMMANDS else None)
    command, bound, _ = app.parse_args(words, exit_on_error=False, print_error=False)
    options = bound.arguments
    choose_units("si" if options.get("as_json") else options.get("units", "si"))
    try:
        answer = command(*bound.args, **bound.kwargs)
    except ConvergenceError as error:
        sys.stdout.flush()
        print(error, file=sys.stderr)
        return NOT_CONVERGED
    if isinstance(answer, Answer):
        return answer.print(as_json=options.get("as_json", False), judge=options.get("judge", False))
    return answer if isinstance(answer, int) else FINE


def repeat_set_option(words: Sequence[str]) -> list[str]:
    """Return the words of a command line, with ``--set`` again before each further change that follows one."""
    completed: list[str] = []
    after = False  # a change, so that another may follow
    for word in words:
        is_change = _CHANGE.match(word) is not None and not Path(word).exists()
        if after and is_change:
            completed.append("--set")
        after = is_change and completed[-1:] == ["--set"]
        completed.append(word)
    return completed


@contextlib.contextmanager
def _plain_warnings() -> Iterator[None]:
    """Show warnings, such as those about a measured profile, as sentences without source lines."""
    with warnings.catch_warnings():
        warnings.showwarning = lambda message, *_, **__: print(f"warning: {message}", file=sys.stderr)
        yield
