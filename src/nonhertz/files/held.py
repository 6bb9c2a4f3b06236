"""Files of cases, bearings and plans: their text, what it holds, and what is read from it."""

from __future__ import annotations

import ast
import contextlib
import errno
import re
import tomllib
import warnings
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, fields
from functools import cache, cached_property
from importlib import resources
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, ClassVar, Self, get_args, get_type_hints

from nonhertz.errors import AccuracyWarning, CaseError, InputError, joined, nearest
from nonhertz.files.bounds import FORMAT, LARGEST_CASE, TOO_DEEP, excess, has_long_key, walk
from nonhertz.files.changes import changed
from nonhertz.files.folder import write_file
from nonhertz.files.mistakes import case_error, in_order, path_of
from nonhertz.files.title_block import TitleBlock
from nonhertz.findings import Finding
from nonhertz.inputs.assumed import assumed
from nonhertz.inputs.checks import one_line, one_of
from nonhertz.inputs.fields import Input, short_repr, unknown_key
from nonhertz.inputs.files import content, legible, seen_from

#: Tables of a bearing file in place of those of both bodies, and what only plans have.
OF_BEARINGS = ("bearing", "roller", "inner", "outer")
OF_PLANS = ("case", "over", "tolerance", "vary")
MOST_ATTACHED = 10_000_000  # bytes; larger files are not attached
_CONTENTS = {"case": "a single contact", "bearing": "a bearing", "plan": "a plan"}
_COMMANDS = {"case": "solve", "bearing": "bearing", "plan": "sweep"}


@dataclass(frozen=True, eq=False)
class Origin:
    """What a case was read from.

    Attributes
    ----------
    document : dict
        The parsed text.
    text : str or None
        The text; None for a case that came from elsewhere, such as the page.
    notes : tuple of str
        Warnings raised when it was read, such as gaps in a measured profile.
    folder : Path or None
        Directory that file names are relative to; None where no file may be read.
    """

    document: dict[str, Any]
    text: str | None
    notes: tuple[str, ...]
    folder: Path | None

    @property
    def files(self) -> tuple[str, ...]:
        """The names of the files that the text refers to, without repeats."""
        tables = [each for _, each in walk(self.document) if isinstance(each, dict)]
        return tuple(dict.fromkeys(each["file"] for each in tables if isinstance(each.get("file"), str)))

    @cached_property
    def attachments(self) -> Mapping[str, bytes]:
        """Contents of these files by name; missing and too large ones are left out."""
        found: dict[str, bytes] = {}
        for name in self.files if self.folder is not None else ():
            with contextlib.suppress(OSError):
                file = Path(self.folder or "", name)
                if file.stat().st_size <= MOST_ATTACHED:
                    found[name] = file.read_bytes()
        return found


@dataclass(frozen=True, kw_only=True, repr=False)
class Held:
    """Base of what a file holds.

    Attributes
    ----------
    title : str
        What it is called; the file's name if the file has no title.
    path : Path
        The file it was read from; other file names are relative to it.
    origin : Origin or None
        What the file held; None for what was made in Python, and for a changed copy made with ``dataclasses.replace``.
    """

    title: str = ""
    path: Path = field(default=Path("case.toml"), compare=False)
    # No argument, so that a changed copy does not carry the text of the case it was made from.
    origin: Origin | None = field(default=None, init=False, compare=False, repr=False)

    #: What such a file is called.
    kind: ClassVar[str] = "case"

    def __post_init__(self) -> None:
        cls: Any = type(self)
        for name, kinds in _classes_of(cls).items():
            value = getattr(self, name)
            # An input may be given by its keywords.
            if isinstance(value, Mapping) and issubclass(kinds[0], Input) and not kinds[0].kinds:
                value = _made(name, kinds[0], value)
                object.__setattr__(self, name, value)
            if not isinstance(value, kinds):
                words = joined((each.__name__ for each in kinds if each is not NoneType), "or")
                raise InputError(name, value, f"be a {words}", f"make the {self.kind} with one")
        one_line("title", self.title, "give a short name")

    def __repr__(self) -> str:
        return short_repr(self)

    def _held_in(self, origin: Origin) -> Self:
        """Note what the file held from which it has just been read, and return it."""
        object.__setattr__(self, "origin", origin)
        return self

    @property
    def file_name(self) -> str:
        """The name of its file, without the directory."""
        return legible(self.path.name)

    def sections(self) -> dict[str, Any]:
        """Return the sections of its file below the title, every value in base units; raises as `write` does."""
        raise NotImplementedError

    @property
    def own_document(self) -> dict[str, Any]:
        """What `write` writes, whatever its file held; raises as that does."""
        return {"format": FORMAT} | ({"title": self.title} if self.title else {}) | self.sections()

    @property
    def document(self) -> dict[str, Any]:
        """What its file holds, or what `write` would write; raises as that does."""
        return self.own_document if self.origin is None else self.origin.document

    @property
    def text(self) -> str:
        """The text of its file, or what `write` would write; raises as that does."""
        text = None if self.origin is None else self.origin.text
        return as_toml(self.document) if text is None else text

    def document_in(self, folder: Path) -> dict[str, Any]:
        """Return its document as a file in another folder holds it: the names of files are relative to that."""
        document: dict[str, Any] = _moved(self.document, self.path.parent, folder)
        return document

    def _written(self, folder: Path) -> dict[str, Any]:
        """Return the document that `write` writes into a folder; raises as that does."""
        return self.own_document

    @property
    def notes(self) -> tuple[str, ...]:
        """Warnings raised when its file was read, such as gaps in a measured profile."""
        return () if self.origin is None else self.origin.notes

    @property
    def attachments(self) -> Mapping[str, bytes]:
        """Contents of the files that its file names, by name; missing and too large ones are left out."""
        return {} if self.origin is None else self.origin.attachments

    def write(self, path: str | Path) -> None:
        """Write it to a file that is read back as the same.

        Values are in mm, N, MPa, rad and 1/min. The points of measured and tabulated profiles are written into the
        file, so it needs no other file. An existing file is overwritten.

        Raises
        ------
        InputError
            If the file cannot be written, or it has something no file can hold: a profile, a diameter or the shape of
            a raceway of a user-defined class, or rows that are not two equal ones.
        """
        if not isinstance(path, str | Path):
            raise InputError("path", path, "be the name of a file to write", "give a string or a Path")
        path = Path(path)
        text = as_toml(self._written(path.parent))
        if len(text) > LARGEST_CASE:
            condition = f"fit into a case file of at most {LARGEST_CASE / 1e6:g} MB"
            raise InputError("profile", f"{len(text) / 1e6:.1f} MB", condition, "smooth it or take every tenth point")
        write_file(path, text)


@dataclass(frozen=True, kw_only=True, repr=False)
class HeldCase(Held):
    """Base of a case and a bearing case.

    Attributes
    ----------
    title_block : TitleBlock
        What the head of a report says beside the title.
    """

    title_block: TitleBlock = field(default_factory=TitleBlock)
    # What a result file says was assumed: the case in it gives all defaults.
    stored_assumptions: tuple[Finding, ...] | None = field(default=None, init=False, compare=False, repr=False)

    #: The class of what a file holds.
    contents: ClassVar[type[Input]]

    #: The sections that fields are read from where these have other names.
    elsewhere: ClassVar[Mapping[str, str]] = {"prescribed": "load", "title_block": "report"}

    @property
    def parts(self) -> dict[str, Input]:
        """The inputs of which something may be assumed, by their places in its file."""
        raise NotImplementedError

    @property
    def assumed(self) -> tuple[Finding, ...]:
        """What is assumed where its file, or the inputs it was made of, leave something out that decides the result."""
        if self.stored_assumptions is not None:
            return self.stored_assumptions
        return assumed(self.parts, None if self.origin is None else self.origin.document)

    @staticmethod
    def contents_of(document: dict[str, Any], folder: Path | None) -> Any:
        """Return what a document holds, of the class ``contents``; raises ``InputsError`` with every mistake in it."""
        raise NotImplementedError

    @classmethod
    def read(cls, path: str | Path, changes: Mapping[str, Any] | None = None) -> Self:
        """Return what a file holds, with changes as of ``of``."""
        return cls.of(*opened(path, cls.kind), changes=changes)

    @classmethod
    def of(
        cls,
        document: dict[str, Any],
        path: Path,
        text: str | None = None,
        *,
        files: bool = True,
        changes: Mapping[str, Any] | None = None,
    ) -> Self:
        """Return what a document holds that has already been parsed.

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
            Values in place of those in the document, by dotted path; None takes a key out. The text names them.

        Raises
        ------
        CaseError
            With every mistake in the document, one sentence each.
        """
        if changes is not None:
            document, text = changed(document, text, changes, cls.contents)
        folder = path.parent if files else None
        try:
            with warnings.catch_warnings(record=True, action="always", category=AccuracyWarning) as caught:
                found = cls.contents_of(document, folder)
        except InputError as error:
            raise case_error(in_order(error.each, document)) from None
        for each in caught:
            warnings.warn_explicit(each.message, each.category, each.filename, each.lineno)
        notes = dict.fromkeys(str(each.message) for each in caught if issubclass(each.category, AccuracyWarning))
        names = [each.name for each in fields(cls) if each.init and each.name not in ("title", "path")]
        given = {name: getattr(found, cls.elsewhere.get(name, name)) for name in names}
        made = cls(title=found.title or legible(path.stem), path=path, **given)
        return made._held_in(Origin(document, text, tuple(notes), folder))


@cache
def _classes_of(cls: type[Any]) -> dict[str, tuple[type[Any], ...]]:
    """Return the classes that each field of a file must be of, where it is one value."""
    hints = get_type_hints(cls)
    kinds = {each.name: hints[each.name] for each in fields(cls) if each.init}
    return {name: get_args(kind) or (kind,) for name, kind in kinds.items() if isinstance(kind, type | UnionType)}


def _made(name: str, kind: type[Input], given: Mapping[str, Any]) -> Input:
    """Return the input that keywords make."""
    for key, value in given.items():
        if key not in kind.descriptions:
            raise unknown_key(key, value, kind.descriptions, "name").within(name)
    try:
        return kind(**given)
    except InputError as error:
        raise error.within(name) from None


def _moved(value: Any, old: Path, new: Path) -> Any:
    if isinstance(value, dict):
        moved = {key: _moved(each, old, new) for key, each in value.items()}
        names = {key: value[key] for key in ("file", "case") if key in value and not Path(value[key]).is_absolute()}
        return moved | {key: seen_from(new, old / name).as_posix() for key, name in names.items()}
    return [_moved(each, old, new) for each in value] if isinstance(value, list) else value


def meant_as(document: Mapping[str, Any]) -> str:
    """Return the kind of file that a document is meant as, empty if that cannot be told.

    Examples
    --------
    >>> [meant_as(each) for each in ({"body": {}, "load": {}}, {"roller": {}}, {"case": "roller.toml", "over": {}})]
    ['case', 'bearing', 'plan']
    """
    if "body" in document:
        return "" if "bearing" in document else "case"
    if any(name in document for name in OF_BEARINGS):
        return "bearing"
    return "plan" if holds_plan(document) else ""


def holds_plan(document: Mapping[str, Any]) -> bool:
    """Return whether a document has what only plans have.

    Examples
    --------
    >>> holds_plan({"case": "roller.toml", "over": {}}), holds_plan({"body": {}, "load": {}})
    (True, False)
    """
    return any(name in document for name in OF_PLANS)


def opened(path: str | Path, *kinds: str) -> tuple[dict[str, Any], Path, str]:
    """Return the document in a file, its path and its text. It is read only once, since it may be a pipe.

    Parameters
    ----------
    path : str or Path
        A TOML file.
    *kinds : {"case", "bearing", "plan"}
        What it may be; the first is what one may begin with.

    Raises
    ------
    CaseError
        If it cannot be read, is not TOML, is larger than any case, or holds something else than it may; what holds no
        plan is left to be refused by who reads plans.
    InputError
        If ``path`` is not the name of a file.
    """
    what = joined((f"{kind} file" for kind in kinds), "or")
    if not isinstance(path, str | Path):
        raise InputError("path", path, f"be the name of a {what}", "give a string or a Path")
    path = Path(path)
    try:
        text = content(path, LARGEST_CASE).decode("utf-8-sig")
    except FileNotFoundError:
        new = "nonhertz new" if kinds[0] == "case" else f"nonhertz new --{kinds[0]}"
        way_out = f"give the path of a {what}, or begin with one from '{new} {path}'"
        beside = {each.stem: each for each in path.parent.glob("*.toml")}
        meant = nearest(path.stem, beside)
        sentence = f"{path} must exist: {way_out}."
        if meant:
            sentence = f"{path} does not exist. Did you mean {beside[meant]}?"
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
    else:
        document = parsed(text, str(path))
        kind = meant_as(document)
        if not kind or kind in kinds or "plan" in kinds:
            return document, path, text
        contents = joined((_CONTENTS[each] for each in kinds), "or")
        sentence = f"{path} must hold {contents}, not {_CONTENTS[kind]}: use 'nonhertz {_COMMANDS[kind]} {path}'."
    raise CaseError([sentence])


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
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        reason = _in_words(str(error).rstrip(".")) + _meant(text, str(error))
    except RecursionError:
        reason = TOO_DEEP
    except ValueError:  # Python's limit on the digits of an integer
        reason = "a number has thousands of digits"
    else:
        if too_much := excess(document):
            raise CaseError([f"{name} must be a case file: {too_much}."])
        return document
    raise CaseError([f"{name} must be valid TOML: {reason[:1].lower()}{reason[1:]}."])


def _in_words(reason: str) -> str:
    """Return the parser's reason without its own terms for what is given twice."""
    if found := re.search(r"(?:declare|namespace) \((.*?),?\)(?: twice)? \(", reason):
        keys = path_of(ast.literal_eval(f"({found[1]},)"))
        return f"table [{keys}] is defined twice ({reason[found.end() :]}"
    return re.sub(r"Cannot overwrite a value|Duplicate inline table key '.*?'", "a key is given twice", reason)


def _meant(text: str, reason: str) -> str:
    """Return what to do about a line of TOML that is a number as people write it: with a comma, or with its unit."""
    place = re.search(r"at line (\d+)", reason)
    line = text.split("\n")[int(place[1]) - 1] if place else ""
    if re.search(r"=\s*[-+]?\d+,\d", line):
        return "; use a decimal point"
    # Neither digits of other bases nor what is longer than any number and unit.
    if number := re.search(r"=\s*(?!0[xob])([-+]?\d[\d.]{0,20}\s?(?![eE][-+]?\d)[A-Za-z][\w/^ ]{0,11}?)\s*(#|$)", line):
        return f'; quote a number with its unit, "{number[1]}"'
    return ""


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
    return resources.files("nonhertz.files").joinpath(name).read_text(encoding="utf-8")


def write_new(text: str, path: str | Path) -> None:
    """Write text to a new file, all of it or nothing.

    Raises
    ------
    CaseError
        If the file already exists or cannot be written.
    """
    path = Path(path)
    try:
        with path.open("x", encoding="utf-8") as file:
            try:
                file.write(text)
                file.flush()
            except BaseException:
                path.unlink(missing_ok=True)
                raise
    except FileExistsError:
        raise CaseError([f"{path} already exists: choose another name, since nothing is overwritten."]) from None
    except (OSError, ValueError) as error:
        reason = (getattr(error, "strerror", None) or str(error)).lower()
        way_out = "choose another name" if path.parent.is_dir() else "make its folder first"
        raise CaseError([f"{path} cannot be written ({reason}): {way_out}."]) from None


@contextlib.contextmanager
def named(path: str | Path) -> Iterator[None]:
    """Put the file's name in front of every mistake raised in a ``with`` block, unless it is there already."""
    try:
        yield
    except CaseError as error:
        sentences = (each if each.startswith(str(path)) else f"{path}: {each}" for each in error.mistakes)
        raise CaseError(sentences, error.places) from None
