"""The command line: read, call one function, print.

Only what parses the arguments is imported before a command runs, so that ``--help`` answers at once.
"""

from __future__ import annotations

import contextlib
import errno
import io
import os
import sys
import traceback
from collections.abc import Sequence
from pathlib import Path

from nonhertz.errors import CaseError, InputError

FINE, NOT_CONVERGED, BAD_INPUT, INTERNAL = range(4)
NOT_VERIFIED = NOT_CONVERGED
# As a shell reports a program that a signal has ended.
INTERRUPTED, BROKEN_PIPE = 130, 141

_EXTRAS = {
    **dict.fromkeys(("cyclopts", "jinja2", "matplotlib", "pint", "pydantic", "rich", "tomli_w", "x3pio"), "cli"),
    **dict.fromkeys(("starlette", "uvicorn"), "web"),
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line.

    Parameters
    ----------
    arguments : sequence of str or None
        What follows the program's name; None takes it from the shell.

    Returns
    -------
    int
        Exit code: 0 fine, 1 not converged or not verified, 2 bad input, 3 internal error or output that cannot be
        written, 130 interrupted, 141 nobody reads the output to its end.
    """
    _fill_closed_streams()
    # Figures are drawn into files, whatever screen is preferred, or misspelled, for other programs.
    os.environ["MPLBACKEND"] = "agg"
    words = list(sys.argv[1:] if arguments is None else arguments)
    debug = "--debug" in words or os.environ.get("NONHERTZ_DEBUG", "0") not in {"", "0"}
    if isinstance(sys.stdout, io.TextIOWrapper):
        # A title in Greek must not end a solve on a terminal that knows ASCII only.
        sys.stdout.reconfigure(errors="replace")
    try:
        if sys.stdout is None:
            raise OSError(errno.EBADF, "standard output is closed")
        from nonhertz.cli.commands import run  # here, since what it imports may be missing

        code = run([word for word in words if word != "--debug"])
        sys.stdout.flush()
        return code
    except SystemExit as error:
        # What rich makes of a pipe that nobody reads on.
        if isinstance(error.__context__, BrokenPipeError):
            return _ended(error.__context__)
        raise
    except (Exception, KeyboardInterrupt) as error:  # noqa: BLE001  (the border: everything ends as a code)
        if debug:
            with contextlib.suppress(OSError):
                traceback.print_exception(error)
        return _ended(error)


def _ended(error: BaseException) -> int:
    """Say in one sentence how a command ended, and return its exit code."""
    if isinstance(error, OSError):
        _close_output()
    code, lines = _verdict(error)
    # Standard error may be the stream that cannot be written.
    with contextlib.suppress(OSError):
        print(*lines, sep="\n", end="\n" if lines else "", file=sys.stderr)
    return code


def _verdict(error: BaseException) -> tuple[int, list[str]]:
    match error:
        case CaseError(mistakes=[_, _, *_]):
            verdict = BAD_INPUT, [f"{i}. {mistake}" for i, mistake in enumerate(error.mistakes, start=1)]
        case CaseError() | InputError():
            verdict = BAD_INPUT, [str(error)]
        case KeyboardInterrupt():
            verdict = INTERRUPTED, ["Interrupted."]
        case BrokenPipeError():
            verdict = BROKEN_PIPE, []
        case OSError():
            verdict = INTERNAL, [f"The output could not be written: {error.strerror or error}."]
        case ModuleNotFoundError(name=str(name)) if name.partition(".")[0] in _EXTRAS:
            package = name.partition(".")[0]
            extra = _EXTRAS[package]
            what = "the page" if extra == "web" else "the command line"
            way_out = f"install what {what} needs with: pip install 'nonhertz[{extra}]'"
            verdict = BAD_INPUT, [f"The package {package} is not installed; {way_out}"]
        case _:
            what = f"{type(error).__name__}: {error}".replace("\n", " ").rstrip(".")
            report = "please report it together with your case file"
            place = "NONHERTZ_DEBUG=1 shows where it happened"
            verdict = INTERNAL, [f"This is an error in nonhertz ({what}); {report}; {place}."]
    return verdict


def _fill_closed_streams() -> None:
    """Put nothing in the place of standard streams that are closed, where the next file to be opened would end up."""
    for descriptor in range(3):
        try:
            os.fstat(descriptor)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # takes the lowest number that is free
    if sys.stderr is None:
        sys.stderr = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115  (until the process ends)


def _close_output() -> None:
    """Let nothing more be written, not even by the interpreter when it ends."""
    with contextlib.suppress(AttributeError, OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
