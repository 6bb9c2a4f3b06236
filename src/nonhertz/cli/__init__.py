"""The command line: read the input, call one function, print.

A command is a function in a module of its own; `nonhertz.cli.commands` is the table of commands. Only the module of the
command that is run is imported, and none for ``--help``, so that help appears at once.
"""

from __future__ import annotations

import _thread
import contextlib
import errno
import io
import os
import sys
import threading
import traceback
from collections.abc import Iterator, Sequence
from pathlib import Path

from nonhertz.cli.exit_codes import BAD_INPUT, BROKEN_PIPE, INTERNAL, INTERRUPTED
from nonhertz.cli.remedies import name_commands
from nonhertz.errors import CaseError, InputError, Interrupted

_OUT_OF_CALLBACK = 0.02  # s; if this is too early, the interrupt is repeated once more

_EXTRAS = {
    **dict.fromkeys(("cyclopts", "jinja2", "matplotlib", "pint", "rich", "tomli_w", "x3pio"), "cli"),
    **dict.fromkeys(("anyio", "starlette", "uvicorn"), "web"),
    "distributed": "cluster",
    "openpyxl": "data",
}
# Arguments of functions whose options have the same other name in every command.
_OPTIONS = {"changes": "--set", "folder": "--out", "out": "--out", "port": "--port", "scheduler": "--scheduler"}
_NEEDS = {
    "cli": "the command line",
    "web": "the page",
    "cluster": "a Dask scheduler",
    "data": "a workbook",
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line.

    Parameters
    ----------
    arguments : sequence of str or None
        Command-line arguments without the program's name; None for those of the process.

    Returns
    -------
    int
        Exit code: 0 success, 1 not converged or not verified, 2 bad input, 3 internal error or output that cannot be
        written, 130 interrupted, 141 broken pipe; with ``--judge`` 4 a limit is exceeded, 5 none is known, 6 the model
        is strained.
    """
    _fill_closed_streams()
    # Figures are drawn to files only: a backend set for other programs, even a misspelled one, must not matter.
    os.environ["MPLBACKEND"] = "agg"
    words = list(sys.argv[1:] if arguments is None else arguments)
    debug = "--debug" in words or os.environ.get("NONHERTZ_DEBUG", "0") not in {"", "0"}
    if isinstance(sys.stdout, io.TextIOWrapper):
        # A Greek title must not crash a solve on an ASCII-only terminal.
        sys.stdout.reconfigure(errors="replace")
    try:
        if sys.stdout is None:
            raise OSError(errno.EBADF, "standard output is closed")
        from nonhertz.cli.commands import run  # here, since its dependencies may be missing

        with _repeat_dropped_interrupts():
            code = run([word for word in words if word != "--debug"])
        sys.stdout.flush()
        return code
    except SystemExit as error:
        # rich turns a broken pipe into SystemExit.
        if isinstance(error.__context__, BrokenPipeError):
            return _report_end(error.__context__)
        raise
    except (Exception, KeyboardInterrupt) as error:  # noqa: BLE001  (top level: everything ends as an exit code)
        if debug:
            with contextlib.suppress(OSError):
                traceback.print_exception(error)
        return _report_end(error)


@contextlib.contextmanager
def _repeat_dropped_interrupts() -> Iterator[None]:
    """Repeat a Ctrl-C that Python drops: one during a finaliser, or a callback from C."""
    before, timers = sys.unraisablehook, []

    def repeat(dropped: sys.UnraisableHookArgs) -> None:
        if issubclass(dropped.exc_type, KeyboardInterrupt):
            timers.append(threading.Timer(_OUT_OF_CALLBACK, _thread.interrupt_main))
            timers[-1].start()
        else:
            before(dropped)

    sys.unraisablehook = repeat
    try:
        yield
    finally:
        sys.unraisablehook = before
        for timer in timers:
            timer.cancel()


def _report_end(error: BaseException) -> int:
    """Say in one sentence how a command ended, and return its exit code."""
    if isinstance(error, OSError):  # discard all further output, including what the interpreter flushes on exit
        with contextlib.suppress(AttributeError, OSError, ValueError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    code, lines = _describe_end(error)
    # Standard error may be the stream that cannot be written.
    with contextlib.suppress(OSError):
        print(*lines, sep="\n", end="\n" if lines else "", file=sys.stderr)
    return code


def _describe_end(error: BaseException) -> tuple[int, list[str]]:
    what = f"{type(error).__name__}: {error}".replace("\n", " ").rstrip(".")
    report, place = "please report it together with your case file", "NONHERTZ_DEBUG=1 shows where it happened"
    verdict = INTERNAL, [f"This is an error in nonhertz ({what}); {report}; {place}."]
    match error:
        case CaseError(mistakes=[_, _, *_]):
            verdict = BAD_INPUT, [f"{i}. {name_commands(mistake)}" for i, mistake in enumerate(error.mistakes, start=1)]
        case CaseError():
            verdict = BAD_INPUT, [name_commands(str(error))]
        case InputError(field=field) if field in _OPTIONS:
            verdict = BAD_INPUT, [name_commands(str(error.about(_OPTIONS[field], error.value)))]
        case InputError():
            verdict = BAD_INPUT, [name_commands(str(error))]
        case Interrupted():
            verdict = INTERRUPTED, [str(error)]
        case KeyboardInterrupt():
            verdict = INTERRUPTED, ["Interrupted."]
        case BrokenPipeError():
            verdict = BROKEN_PIPE, []
        case OSError():
            verdict = INTERNAL, [f"The output could not be written: {error.strerror or error}."]
        case ModuleNotFoundError(name=str(name)) if name.partition(".")[0] in _EXTRAS:
            package = name.partition(".")[0]
            extra = _EXTRAS[package]
            hint = f"pip install {package.replace('_', '-')}, or pip install '.[{extra}]' in the folder of nonhertz"
            verdict = BAD_INPUT, [f"The package {package}, needed for {_NEEDS[extra]}, is not installed: {hint}"]
    return verdict


def _fill_closed_streams() -> None:
    """Open closed standard streams on the null device; otherwise the next file opened would take their place."""
    for descriptor in range(3):
        try:
            os.fstat(descriptor)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # takes the lowest free descriptor
    if sys.stderr is None:
        sys.stderr = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115  (until the process ends)
