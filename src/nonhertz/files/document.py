"""Files of cases, bearings and plans: their text, their documents, and the objects read from them."""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from functools import cache, cached_property
from pathlib import Path
from types import NoneType, UnionType
from typing import Any, ClassVar, Self, get_args, get_type_hints

from nonhertz.errors import AccuracyWarning, InputError, join_words
from nonhertz.files.bounds import FORMAT, LARGEST_CASE, walk
from nonhertz.files.changes import apply_changes
from nonhertz.files.folder import write_file
from nonhertz.files.mistakes import case_error, sort_by_place
from nonhertz.files.title_block import TitleBlock
from nonhertz.files.toml import load_document, to_toml
from nonhertz.findings import Finding
from nonhertz.inputs.assumed import collect_assumptions
from nonhertz.inputs.checks import one_line
from nonhertz.inputs.descriptions import unknown_key_error
from nonhertz.inputs.fields import Input, call_repr
from nonhertz.inputs.files import printable_name, relative_path

MOST_ATTACHED = 10_000_000  # bytes; larger files are not attached


@dataclass(frozen=True, eq=False)
class Origin:
    """The file from which a case was read.

    Attributes
    ----------
    document : dict
        The parsed text.
    text : str or None
        The text; None for a case that came from elsewhere, such as the page.
    notes : tuple of str
        Warnings raised when it was read, such as gaps in a measured profile.
    folder : Path or None
        Directory to which file names are relative; None if no file may be read.
    """

    document: dict[str, Any]
    text: str | None
    notes: tuple[str, ...]
    folder: Path | None

    @property
    def files(self) -> tuple[str, ...]:
        """The names of the files that the text refers to, without repeats."""
        tables = [table for _, table in walk(self.document) if isinstance(table, dict)]
        return tuple(dict.fromkeys(table["file"] for table in tables if isinstance(table.get("file"), str)))

    @cached_property
    def attachments(self) -> Mapping[str, bytes]:
        """Contents of these files by name; missing and too large ones are left out."""
        contents: dict[str, bytes] = {}
        for name in self.files if self.folder is not None else ():
            with contextlib.suppress(OSError):
                file = Path(self.folder or "", name)
                if file.stat().st_size <= MOST_ATTACHED:
                    contents[name] = file.read_bytes()
        return contents


@dataclass(frozen=True, kw_only=True, repr=False)
class Document:
    """Base of cases, bearing cases and plans, which files contain.

    Attributes
    ----------
    title : str
        Title; the file's name if the file has none.
    path : Path
        The file from which it was read; other file names are relative to it.
    origin : Origin or None
        Contents of the file; None if it was made in Python, or changed with ``dataclasses.replace``.
    """

    title: str = ""
    path: Path = field(default=Path("case.toml"), compare=False)
    # Not an argument, so that a changed copy does not keep the text of the original.
    origin: Origin | None = field(default=None, init=False, compare=False, repr=False)

    #: The kind of such a file.
    kind: ClassVar[str] = "case"

    def __post_init__(self) -> None:
        cls: Any = type(self)
        for name, kinds in _field_classes(cls).items():
            value = getattr(self, name)
            # A dictionary of keywords may replace an input.
            if isinstance(value, Mapping) and issubclass(kinds[0], Input) and not kinds[0].kinds:
                value = _build_input(name, kinds[0], value)
                object.__setattr__(self, name, value)
            if not isinstance(value, kinds):
                words = join_words((kind.__name__ for kind in kinds if kind is not NoneType), "or")
                raise InputError(name, value, f"be a {words}", f"make the {self.kind} with one")
        one_line("title", self.title, "give a short name")

    def __repr__(self) -> str:
        return call_repr(self)

    def _with_origin(self, origin: Origin) -> Self:
        """Store the contents of the file from which it has just been read, and return it."""
        object.__setattr__(self, "origin", origin)
        return self

    @property
    def file_name(self) -> str:
        """The name of its file, without the directory."""
        return printable_name(self.path.name)

    def sections(self) -> dict[str, Any]:
        """Return the sections of its file below the title, every value in base units; raises as `write` does."""
        raise NotImplementedError

    @property
    def own_document(self) -> dict[str, Any]:
        """The document that `write` writes, whatever is in its file; raises as `write`."""
        return {"format": FORMAT} | ({"title": self.title} if self.title else {}) | self.sections()

    @property
    def document(self) -> dict[str, Any]:
        """The document of its file, or that of `write`; raises as `write`."""
        return self.own_document if self.origin is None else self.origin.document

    @property
    def text(self) -> str:
        """The text of its file, or that of `write`; raises as `write`."""
        text = None if self.origin is None else self.origin.text
        return to_toml(self.document) if text is None else text

    def document_in(self, folder: Path) -> dict[str, Any]:
        """Return its document for a file in another folder, to which the names of files are relative."""
        document: dict[str, Any] = _relocate(self.document, self.path.parent, folder)
        return document

    def _written(self, folder: Path) -> dict[str, Any]:
        """Return the document that `write` writes into a folder; raises as `write`."""
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
            If the file cannot be written, or something has no form in a file: a profile, a diameter or a raceway shape
            of a user-defined class, or rows other than one or two equal ones.
        """
        if not isinstance(path, str | Path):
            raise InputError("path", path, "be the name of a file to write", "give a string or a Path")
        path = Path(path)
        text = to_toml(self._written(path.parent))
        if len(text) > LARGEST_CASE:
            condition = f"fit into a case file of at most {LARGEST_CASE / 1e6:g} MB"
            raise InputError("profile", f"{len(text) / 1e6:.1f} MB", condition, "smooth it or take every tenth point")
        write_file(path, text)


@dataclass(frozen=True, kw_only=True, repr=False)
class CaseBase(Document):
    """Base of a case and a bearing case.

    Attributes
    ----------
    title_block : TitleBlock
        The head of a report, except the title.
    """

    title_block: TitleBlock = field(default_factory=TitleBlock)
    # The assumptions listed in a result file, since the case in it gives all defaults.
    stored_assumptions: tuple[Finding, ...] | None = field(default=None, init=False, compare=False, repr=False)

    #: The class of the contents of a file.
    contents: ClassVar[type[Input]]

    #: The sections of fields with other names.
    elsewhere: ClassVar[Mapping[str, str]] = {"prescribed": "load", "title_block": "report"}

    @property
    def parts(self) -> dict[str, Input]:
        """The inputs with defaults that are reported as assumptions, by their places in the file."""
        raise NotImplementedError

    @property
    def assumed(self) -> tuple[Finding, ...]:
        """The assumptions for inputs that are left out and decide the result."""
        if self.stored_assumptions is not None:
            return self.stored_assumptions
        return collect_assumptions(self.parts, None if self.origin is None else self.origin.document)

    @staticmethod
    def contents_of(document: dict[str, Any], folder: Path | None) -> Any:
        """Return the contents of a document, of the class ``contents``; raises ``InputsError`` with every mistake."""
        raise NotImplementedError

    @classmethod
    def read(cls, path: str | Path, changes: Mapping[str, Any] | None = None) -> Self:
        """Return the case in a file, with ``changes`` as for `of`."""
        return cls.of(*load_document(path, cls.kind), changes=changes)

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
        """Return the case in a document that has already been parsed.

        Parameters
        ----------
        document : dict
            Contents of a TOML file.
        path : Path
            Its file; the names of other files are relative to it.
        text : str, optional
            Text from which it was parsed.
        files : bool
            Whether it may name files; False for an untrusted document, for which none must be read.
        changes : mapping of str to object, optional
            Values in place of those in the document, by dotted path; None removes a key. A comment in the text lists
            them.

        Raises
        ------
        CaseError
            With every mistake in the document, one sentence each.
        """
        if changes is not None:
            document, text = apply_changes(document, text, changes, cls.contents)
        folder = path.parent if files else None
        try:
            with warnings.catch_warnings(record=True, action="always", category=AccuracyWarning) as caught:
                inputs = cls.contents_of(document, folder)
        except InputError as error:
            raise case_error(sort_by_place(error.each, document)) from None
        for warning in caught:
            warnings.warn_explicit(warning.message, warning.category, warning.filename, warning.lineno)
        notes = dict.fromkeys(str(w.message) for w in caught if issubclass(w.category, AccuracyWarning))
        names = [field.name for field in fields(cls) if field.init and field.name not in ("title", "path")]
        arguments = {name: getattr(inputs, cls.elsewhere.get(name, name)) for name in names}
        made = cls(title=inputs.title or printable_name(path.stem), path=path, **arguments)
        return made._with_origin(Origin(document, text, tuple(notes), folder))


@cache
def _field_classes(cls: type[Any]) -> dict[str, tuple[type[Any], ...]]:
    """Return the classes of each field of a file that is a single value."""
    hints = get_type_hints(cls)
    kinds = {field.name: hints[field.name] for field in fields(cls) if field.init}
    return {name: get_args(kind) or (kind,) for name, kind in kinds.items() if isinstance(kind, type | UnionType)}


def _build_input(name: str, kind: type[Input], keywords: Mapping[str, Any]) -> Input:
    """Return the input with these keywords."""
    for key, value in keywords.items():
        if key not in kind.descriptions:
            raise unknown_key_error(key, value, kind.descriptions, "name").within(name)
    try:
        return kind(**keywords)
    except InputError as error:
        raise error.within(name) from None


def _relocate(value: Any, old: Path, new: Path) -> Any:
    if isinstance(value, dict):
        moved = {key: _relocate(entry, old, new) for key, entry in value.items()}
        names = {key: value[key] for key in ("file", "case") if key in value and not Path(value[key]).is_absolute()}
        return moved | {key: relative_path(new, old / name).as_posix() for key, name in names.items()}
    return [_relocate(entry, old, new) for entry in value] if isinstance(value, list) else value
