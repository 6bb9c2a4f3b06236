"""Case files: from TOML to a `Contact` and what to solve it for.

All mistakes in a file are found at once and raised together, in the wording of the Python classes.
"""

from __future__ import annotations

import contextlib
import errno
import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any

from nonhertz.errors import CaseError, InputError
from nonhertz.inputs.checks import one_line, one_of
from nonhertz.inputs.files import content, legible
from nonhertz.io.bounds import FORMAT, LARGEST_CASE, TOO_DEEP, excess, has_long_key
from nonhertz.io.changes import changed
from nonhertz.io.mistakes import Mistake, TableError, case_error, in_order
from nonhertz.io.origin import Origin, with_notes
from nonhertz.io.reading import read, schema_of_file
from nonhertz.io.sections import CaseDocument, Life, Solver, of_both, surroundings
from nonhertz.io.title_block import TitleBlock
from nonhertz.io.writing import document_of
from nonhertz.model.body import BODIES
from nonhertz.model.contact import Contact
from nonhertz.strip.element import SEMI_ELLIPTIC

if TYPE_CHECKING:
    from nonhertz.result.solution import Solution

#: Tables of a bearing file in place of those of both bodies.
OF_BEARINGS = ("bearing", "roller", "inner", "outer")
_OF_BOTH_BODIES = ("diameter", "length", "position")
_SECTIONS = {
    "life.dent": ("y", "per_area", "raceway_diameter"),
    "life": ("rollers", "contact_angle", "slope", "fatigue_limit", "laminae", "edge_stress", "line_loads", "share"),
    "load": ("load", "approach", "tilt", "moment"),
    "solver": ("element", "strips", "accuracy"),
}


@dataclass(frozen=True)
class Case:
    """Two bodies, what presses them together, how that is solved, and how long the bodies last.

    Attributes
    ----------
    contact : Contact
        The two bodies.
    prescribed : dict
        Load or approach, tilt or moment: keywords for `nonhertz.solve`.
    solver : dict
        Element, strips and accuracy: keywords for `nonhertz.solve`; semi-elliptic and automatic where left out.
    life : Life
        How long the bodies last: models and a spectrum of loads.
    title : str
        The case's title; the file's name if the file has none.
    path : Path
        The file it was read from; other file names are relative to it.
    title_block : TitleBlock
        What the head of a report says beside the title.
    origin : Origin or None
        What the file held; None for a case made in Python, and for a changed copy made with ``dataclasses.replace``.

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = Path(folder, "case.toml")
    ...     _ = path.write_text(starting_case())
    ...     case = read_case(path)
    >>> case.prescribed["load"], case.contact.interval
    (20000.0, (-10.0, 10.0))
    >>> round(case.solve().load)
    20000
    """

    contact: Contact
    prescribed: dict[str, Any]
    solver: dict[str, Any] = field(default_factory=dict)
    life: Life = field(default_factory=Life)
    title: str = ""
    path: Path = field(default=Path("case.toml"), compare=False)
    title_block: TitleBlock = field(default_factory=TitleBlock)
    # No argument, so that a changed copy does not carry the text of the case it was made from.
    origin: Origin | None = field(default=None, init=False, compare=False, repr=False)

    def __post_init__(self) -> None:
        for name, value, kind in (
            ("contact", self.contact, Contact),
            ("life", self.life, Life),
            ("title", self.title, str),
            ("path", self.path, Path),
            ("title_block", self.title_block, TitleBlock),
        ):
            if not isinstance(value, kind):
                raise InputError(name, value, f"be a {kind.__name__}", "make the case with one")
        one_line("title", self.title, "give a short name")
        for name, given, section in (("prescribed", self.prescribed, "load"), ("solver", self.solver, "solver")):
            known = _SECTIONS[section]
            if not isinstance(given, dict) or not set(given) <= set(known):
                raise InputError(name, given, f"be a dictionary of {', '.join(known)}", "give no other names")
        if len({"load", "approach"} & set(self.prescribed)) != 1:
            condition = "hold either load or approach"
            raise InputError("prescribed", self.prescribed, condition, 'write {"load": 20e3}, say, in N')
        object.__setattr__(self, "solver", {"element": SEMI_ELLIPTIC, "strips": "auto", "accuracy": None} | self.solver)

    @property
    def file_name(self) -> str:
        """The name of its file, without the directory."""
        return legible(self.path.name)

    @property
    def document(self) -> dict[str, Any]:
        """What its file holds, or would hold.

        Raises
        ------
        InputError
            If no case file can hold it; see `write`.
        """
        return document_of_case(self) if self.origin is None else self.origin.document

    @property
    def text(self) -> str:
        """The text of its file, or what `write` would write.

        Raises
        ------
        InputError
            If no case file can hold it; see `write`.
        """
        text = None if self.origin is None else self.origin.text
        return as_toml(self.document) if text is None else text

    @property
    def notes(self) -> tuple[str, ...]:
        """Warnings raised when its file was read, such as gaps in a measured profile."""
        return () if self.origin is None else self.origin.notes

    @property
    def attachments(self) -> Mapping[str, bytes]:
        """Contents of the files that its file names, by name; missing and too large ones are left out."""
        return {} if self.origin is None else self.origin.attachments

    def solve(self) -> Solution:
        """Return the solution of the case, as `nonhertz.solve` does.

        Raises
        ------
        CaseError
            If the solver rejects the case; the sentence names the key in the file.
        ConvergenceError
            If it stops short of a solution.

        Warns
        -----
        AccuracyWarning
            If the result strains the model's validity.
        """
        from nonhertz.solver.one import solve

        try:
            return solve(self.contact, **self.prescribed, **self.solver)
        except InputError as error:
            raise placed(error) from None

    def write(self, path: str | Path) -> None:
        """Write the case to a file that `read_case` reads back as the same case.

        Values are in mm, N, MPa and rad. The points of measured and tabulated profiles are written into the file, so it
        needs no other file. An existing file is overwritten.

        Raises
        ------
        InputError
            If the file cannot be written, or the case has something no case file can hold: a profile or diameter of a
            user-defined class, or strips given by their edges.
        """
        write_document(lambda: document_of_case(self), path)


def document_of_case(case: Case) -> dict[str, Any]:
    """Return a case as the document of a case file: every value in base units, nothing of the bodies left to a default.

    It contains the points of measured and tabulated profiles, so it needs no other file.

    Raises
    ------
    InputError
        If no case file can hold it: a profile or diameter of a user-defined class, or strips given by their edges.
    """
    found: dict[str, Any] = {"format": FORMAT} | ({"title": case.title} if case.title else {})
    found["body"] = {}
    for which in BODIES:
        try:
            found["body"][which] = document_of(getattr(case.contact, which))
        except InputError as error:
            raise error.within(f"body.{which}") from None
    found["load"] = {name: float(value) for name, value in case.prescribed.items()}
    strips = "auto" if case.solver["strips"] is None else case.solver["strips"]
    if not isinstance(strips, str | int):
        raise InputError("strips", "edges", "be 'auto' or a number to go into a case file", "give the number of strips")
    element = case.solver["element"] or SEMI_ELLIPTIC
    found["solver"] = document_of(Solver(element=element.name, strips=strips, accuracy=case.solver["accuracy"]))
    for name, part in (("life", case.life), ("report", case.title_block)):
        given = document_of(part, defaults=False)
        if given:
            found[name] = given
    return found


def read_case(path: str | Path, changes: Mapping[str, Any] | None = None) -> Case:
    """Return the case in a file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see docs/reference/case-file.md.
    changes : mapping of str to object, optional
        Values in place of those in the file, by dotted path, such as ``{"load.load": "5 kN"}``; None takes a key out.
        The title names them.

    Returns
    -------
    Case
        The contact and what to solve it for.

    Raises
    ------
    CaseError
        With every mistake in the file, one sentence each.
    InputError
        If ``path`` is not the name of a file, or ``changes`` not a mapping.
    """
    if not isinstance(path, str | Path):
        raise InputError("path", path, "be the name of a case file", "give a string or a Path")
    path = Path(path)
    text = case_text(path)
    document = parsed(text, str(path))
    if holds_bearing(document):
        raise CaseError([f"{path} must hold a single contact, not a bearing: use 'nonhertz bearing {path}'."])
    return case_in(document, path, text, changes=changes)


def holds_bearing(document: Mapping[str, Any]) -> bool:
    """Return whether a document is meant as that of a bearing rather than of a single contact.

    Examples
    --------
    >>> holds_bearing({"bearing": {"rollers": 13}}), holds_bearing({"body": {}, "load": {}})
    (True, False)
    """
    return "body" not in document and any(name in document for name in OF_BEARINGS)


def case_text(path: Path, what: str = "case file", new: str = "nonhertz new") -> str:
    """Return the text of a case file, or of another file of that kind. It is read only once, since it may be a pipe.

    Raises
    ------
    CaseError
        If it cannot be read, is not text, or is larger than any case.
    """
    try:
        return content(path, LARGEST_CASE).decode("utf-8-sig")
    except FileNotFoundError:
        way_out = f"give the path of a {what}, or begin with one from '{new}'"
        sentence = f"{path} must exist: {way_out}."
    except IsADirectoryError:
        sentence = f"{path} must be a file, not a directory: give the path of a {what}."
    except UnicodeDecodeError as error:
        line = error.object.count(b"\n", 0, error.start) + 1
        sentence = f"{path}, line {line}, must be text in UTF-8: save the file with that encoding."
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        too_large = getattr(error, "errno", None) == errno.EFBIG
        way_out = "put measured points into a file that it names" if too_large else "check path and permissions"
        sentence = f"{path} must be readable ({reason[:1].lower()}{reason[1:]}): {way_out}."
    raise CaseError([sentence])


def case_in(
    document: dict[str, Any],
    path: Path,
    text: str | None = None,
    *,
    files: bool = True,
    changes: Mapping[str, Any] | None = None,
) -> Case:
    """Return the case in a document that has already been parsed.

    Parameters
    ----------
    document : dict
        What a TOML file holds.
    path : Path
        Where it came from; the names of other files are relative to it.
    text : str, optional
        What it was parsed from.
    files : bool
        Whether it may name files; False for an untrusted document, which must not make us read any.
    changes : mapping of str to object, optional
        Values in place of those in the document, by dotted path, as of `read_case`.

    Raises
    ------
    CaseError
        With every mistake in the document, one sentence each.
    """
    if changes is not None:
        document, text = changed(document, text, changes, schema, legible(path.stem))
    folder = path.parent if files else None
    try:
        found, notes = with_notes(lambda: read(CaseDocument, document, surroundings(document, folder)))
    except TableError as error:
        raise case_error(in_order(error.mistakes, document)) from None
    case = Case(
        title=found.title or legible(path.stem),
        contact=Contact(found.body.a, found.body.b),
        prescribed=found.load.keywords,
        solver=found.solver.keywords,
        path=path,
        life=found.life,
        title_block=found.report,
    )
    object.__setattr__(case, "origin", Origin(document, text, notes, folder))
    return case


def parsed(text: str, name: str) -> dict[str, Any]:
    """Return the document in the text of a case file; ``name`` is what error messages call it.

    Raises
    ------
    CaseError
        If the text is not TOML, or holds more than a case may.
    """
    # Before parsing: the parser's time grows with the square of the number of parts in a key.
    if has_long_key(text):
        raise CaseError([f"{name} must be a case file: {TOO_DEEP}."])
    document = _tables(text, name)
    too_much = excess(document)
    if too_much:
        raise CaseError([f"{name} must be a case file: {too_much}."])
    return document


def as_toml(document: dict[str, Any]) -> str:
    """Return a document as the text of a case file.

    Examples
    --------
    >>> print(as_toml({"load": {"load": "20 kN"}}), end="")
    [load]
    load = "20 kN"
    """
    import tomli_w

    return tomli_w.dumps(document)


#: Machine elements whose cases `starting_case` returns, by name, in words.
TEMPLATES = {
    "cylindrical": "cylindrical roller on a ring",
    "tapered": "tapered roller on a ring",
    "spherical": "barrel of a spherical roller bearing",
    "needle": "needle on a shaft",
    "wheel-on-rail": "crowned wheel on a rail",
    "gear-flank": "flanks of spur gears",
    "cam": "cam and roller follower",
}


@cache
def schema() -> Mapping[str, Any]:
    """Return the JSON schema of a case file, with the meaning and the unit of every key.

    It is made once, since that takes longer than twenty cases to solve, and only read.
    """
    return schema_of_file(CaseDocument)


def starting_case(template: str | None = None) -> str:
    """Return a commented case file to start from.

    Parameters
    ----------
    template : str, optional
        One of `TEMPLATES`, each an example of a machine element; one with all that a case may hold if left out.

    Raises
    ------
    InputError
        If there is no such template.
    """
    return starting_text("starting_case.toml", template, TEMPLATES, "templates")


def starting_text(name: str, template: str | None = None, known: Iterable[str] = (), folder: str = "") -> str:
    """Return the text of one of our own files to start from: of a template in a folder, or of the one of a name.

    Raises
    ------
    InputError
        If a template is asked for that is not known.
    """
    if template is not None:
        one_of("template", template, tuple(known), "choose one of them")
        name = f"{folder}/{template}.toml"
    return resources.files("nonhertz.io").joinpath(name).read_text(encoding="utf-8")


def write_new(text: str, path: str | Path) -> None:
    """Write text to a new file, all of it or nothing.

    Raises
    ------
    InputError
        If the file already exists or cannot be written.
    """
    path = Path(path)
    try:
        with path.open("x", encoding="utf-8") as file, _taken_away_unless_whole(path):
            file.write(text)
            file.flush()
    except FileExistsError:
        remedy = "choose another name, since nothing is overwritten"
        raise InputError("PATH", str(path), "not exist yet", remedy) from None
    except (OSError, ValueError) as error:
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        raise InputError("PATH", str(path), f"be a file to write to ({reason})", "choose another name") from None


def write_document(make: Callable[[], dict[str, Any]], path: str | Path) -> None:
    """Write the document that a function makes to a file, in place of an older one; all of it or nothing.

    Raises
    ------
    InputError
        If the file cannot be written, or the document is larger than any that would be read.
    """
    from nonhertz.io.folder import write_files

    if not isinstance(path, str | Path):
        raise InputError("path", path, "be the name of a file to write", "give a string or a Path")
    text, path = as_toml(make()), Path(path)
    if len(text) > LARGEST_CASE:
        condition = f"fit into a case file of at most {LARGEST_CASE / 1e6:g} MB"
        raise InputError("profile", f"{len(text) / 1e6:.1f} MB", condition, "smooth it or take every tenth point")
    try:
        write_files(path.parent, {path.name: text})
    except InputError as error:
        raise InputError("path", str(path), error.condition, error.remedy) from None


@contextlib.contextmanager
def _taken_away_unless_whole(path: Path) -> Iterator[None]:
    try:
        yield
    except BaseException:
        path.unlink(missing_ok=True)
        raise


def placed(error: InputError) -> CaseError:
    """Return an error from `nonhertz.solve` as one about the case file, with the field named as in the file."""
    if error.field in _OF_BOTH_BODIES:
        field = of_both(error)
        return case_error([Mistake(("body", *field.field.split(".")), field, absent=field.value is None)])
    section = [section for section, fields in _SECTIONS.items() if error.field in fields]
    place = (*(part for each in section for part in each.split(".")), *error.field.split("."))
    return case_error([Mistake(place, error)])


@contextlib.contextmanager
def named(path: str | Path) -> Iterator[None]:
    """Put the file's name in front of every mistake raised in a ``with`` block, unless it is there already."""
    try:
        yield
    except CaseError as error:
        sentences = (each if each.startswith(str(path)) else f"{path}: {each}" for each in error.mistakes)
        raise CaseError(sentences, error.places) from None


def _tables(text: str, name: str) -> dict[str, Any]:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        reason = str(error).rstrip(".")
    except RecursionError:
        reason = TOO_DEEP
    except ValueError:  # Python's limit on the digits of an integer
        reason = "a number has thousands of digits"
    raise CaseError([f"{name} must be valid TOML: {reason[:1].lower()}{reason[1:]}."])
