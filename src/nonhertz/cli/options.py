"""Options shared by commands, errors that name options in place of arguments, and where results are written."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Group, Parameter

from nonhertz.errors import InputError
from nonhertz.inputs.files import printable_name

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from nonhertz.files.resultfile import Result

#: The group of options that most commands have, listed below their own.
_COMMON = Group("Common", sort_key=9)

# The changes are parsed before a command is called.
if TYPE_CHECKING:
    Changes = Mapping[str, Any]
else:
    Changes = Annotated[
        tuple[str, ...],
        Parameter(
            name="--set",
            negative="",
            show_default=False,
            allow_leading_hyphen=True,
            group=_COMMON,
            help="Values in place of those in the file: load.load=5kN body.a.profile.drop=12um. KEY= removes a key.",
        ),
    ]
NONE: Changes = MappingProxyType({})
UnitsRead = Annotated[
    Literal["si", "us"],
    Parameter(
        name="--units",
        group=_COMMON,
        help="Units of what is shown; us: in, lbf, ksi. Files and options stay in mm, N, MPa.",
    ),
]
AsJson = Annotated[
    bool,
    Parameter(
        name="--json", negative="", show_default=False, group=_COMMON, help="Print one JSON object with all numbers."
    ),
]
Judge = Annotated[
    bool,
    Parameter(
        name="--judge",
        negative="",
        show_default=False,
        group=_COMMON,
        help="End with 4 where a limit is exceeded, 5 where none is known, 6 where the model is strained.",
    ),
]
Excel = Annotated[
    bool,
    Parameter(name="--excel", negative="", help="Also write the rows as rows.xlsx, with the inputs on a second sheet."),
]
Workers = Annotated[int | None, Parameter(help="Number of processes; by default one for each core.")]
Scheduler = Annotated[
    str | None,
    Parameter(help="Address of a Dask scheduler whose workers solve the rows, such as tcp://10.0.0.1:8786."),
]
Words = Annotated[tuple[str, ...], Parameter(consume_multiple=True, negative="", show_default=False)]
#: Names of the arguments of a design in plan files and options.
DESIGN_NAMES = {
    "bounds": "vary", "constraints": "where", "n_starts": "--starts", "points": "--front", "threads": "--workers"
}  # fmt: skip
Figures = Callable[[], "Mapping[str, Figure]"]


@contextlib.contextmanager
def rename_fields(**options: str) -> Iterator[None]:
    """Name refused arguments by their options, such as ``threads="--workers"``; others keep their names."""
    try:
        yield
    except InputError as error:
        if error.field not in options:
            raise
        raise error.about(options[error.field], error.value) from None


def default_output_path(file: Path, ending: str, out: Path | None) -> Path:
    """Return where a command writes: ``--out``, or the file's name with ``ending`` in the current directory."""
    return Path(f"{printable_name(file.stem)}{ending}") if out is None else out


def refuse_unwritable_out(out: Path | None, *, file: bool = False) -> None:
    """Refuse a directory, or a file, that cannot be written to before the work starts, if one is named."""
    from nonhertz.files.folder import refuse_unwritable, refuse_unwritable_file

    if out is not None:
        (refuse_unwritable_file if file else refuse_unwritable)(out)


def write_outputs(
    out: Path | None, texts: Callable[[], Mapping[str, str]], figures: Figures = dict
) -> tuple[Path, ...]:
    """Write texts and figures by their names into a directory, if one is named; return the files."""
    from nonhertz.files.folder import write_files

    return () if out is None else write_files(out, texts(), figure_writer(figures))


def save_result(result: Result, out: Path | None) -> tuple[Path, ...]:
    """Write a result into a directory, if one is named; return the files."""
    return () if out is None else result.save(out)


def figure_writer(figures: Figures) -> Callable[[Path], None]:
    """Return what draws figures and saves them in a folder."""

    def draw(folder: Path) -> None:
        from nonhertz.plot import save_all

        save_all(figures(), folder)

    return draw


def refuse_together(options: Mapping[str, Any], remedy: str) -> None:
    """Refuse the second of several options, by name, where more than one is given."""
    first, second = [*((name, value) for name, value in options.items() if value), ("", ""), ("", "")][:2]
    if second[0]:
        raise InputError(*second, f"not be given with {first[0]}", remedy)


def split_assignments(words: Iterable[str], example: str, option: str) -> dict[str, str]:
    """Return names and values of the assignments of an option; raises as `split_assignment`."""
    return dict(split_assignment(word, example, option) for word in words)


def split_assignment(word: str, example: str = "--over load.load=5kN:40kN:8", option: str = "") -> tuple[str, str]:
    """Return name and value of an assignment of an option.

    Raises
    ------
    InputError
        If there is no equals sign.
    """
    path, equals, values = word.partition("=")
    if not equals or not path.strip():
        raise InputError(option, word, "have an equals sign between name and values", f"write both, such as {example}")
    return path.strip(), values.strip()
