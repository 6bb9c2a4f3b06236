"""Reading inputs from the tables of files, by the descriptions of their fields.

All mistakes in a file are found at once: every field is read, then all checks of its class run whose fields are valid.
Only then is the input made.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any, Final, TypeVar

from nonhertz.errors import InputError, InputsError, join_words, nearest
from nonhertz.files.mistakes import Place, missing_key_error, path_of, place_of
from nonhertz.files.writing import document_of
from nonhertz.inputs.descriptions import (
    Description,
    Part,
    Several,
    collect_errors,
    describe_field,
    unknown_key_error,
    unknown_word_error,
)
from nonhertz.inputs.fields import Input, mutually_exclusive_errors
from nonhertz.model.profile import Profile

AnyInput = TypeVar("AnyInput", bound=Input)
Schema = dict[str, Any]
_LAST_WORD = re.compile(r"[A-Z][a-z]*$")
#: Stands for a value that a profile may need and that is itself invalid.
INVALID: Final = object()
#: The class of an input whose table gives no kind, by its values.
Likely = Callable[[Mapping[str, Any]], type[Input]]


@dataclass(frozen=True)
class ReadContext:
    """The context of a table in its file.

    Attributes
    ----------
    folder : Path or None
        Directory to which the names of files are relative; None if no file may be read.
    radius : object
        Combined radius of both bodies across the contact [mm], for profiles; None or `INVALID` if there is none.
    read_profile : callable, optional
        Returns the profile of a body, from its value in the file, the valid fields of the body, and this context.
    """

    folder: Path | None = None
    radius: Any = None
    read_profile: Callable[[Any, Mapping[str, Any], ReadContext], Profile] = lambda written, *_: written


def read_input(
    cls: type[AnyInput],
    table: Any,
    file: ReadContext = ReadContext(),
    place: Place = (),
    likely: Likely | None = None,
) -> AnyInput:
    """Return the input in a table.

    Parameters
    ----------
    cls : type
        Its class; if that has kinds, the class for an unknown kind.
    table : object
        Value in the file.
    file : ReadContext
        Context in the file.
    place : tuple
        Place of the table, for remedies.
    likely : callable, optional
        The class if the table gives no kind; ``cls`` if left out.

    Raises
    ------
    InputsError
        With all mistakes, their fields relative to the table.
    """
    return TableReader(cls, check_table(table, place), file, place, likely=likely).build()  # type: ignore[return-value]


def check_table(table: Any, place: Place) -> dict[str, Any]:
    """Return a table.

    Raises
    ------
    InputError
        If it is not a table.
    """
    if isinstance(table, dict):
        return table
    heading = f"[{path_of(place)}]" if place and isinstance(place[-1], str) else f"[[{path_of(place[:-1])}]]"
    raise InputError("", table, "be a section", f"write it under a heading {heading}")


class TableReader:
    """A table that is being read: its valid values, and its mistaken fields.

    Parameters
    ----------
    cls, table, file, place, likely
        As for `read_input`.
    beside : mapping
        Fields from elsewhere in the file that have been read; None for invalid ones.
    known : sequence of str
        Keys of the table that are not fields.
    """

    def __init__(
        self,
        cls: type[Input],
        table: dict[str, Any],
        file: ReadContext,
        place: Place,
        *,
        likely: Likely | None = None,
        beside: Mapping[str, Any] = MappingProxyType({}),
        known: Sequence[str] = (),
    ) -> None:
        self.cls, self.table, self.file, self.place, self.likely = cls, table, file, place, likely
        self.values = {name: value for name, value in beside.items() if value is not None}
        self.wrong = beside.keys() - self.values.keys()
        self.mistakes: list[InputError] = []
        every = {name: kind for kind in (*cls.kinds.values(), cls) for name in kind.descriptions}
        keys = [*(["kind"] if cls.kinds else []), *(name for name in every if name not in beside), *known]
        strange = {name: nearest(name, keys) for name in table if name not in keys}
        self.mistakes += (unknown_key_error(path_of((name,)), table[name], keys) for name in strange)
        # After "lenght" a missing length is not reported as well.
        self.wrong |= {*strange.values()} - {""}
        self.named = self._choose_class()
        #: Its fields, each with a class that has it.
        self.fields = every if self.named is None else dict.fromkeys(self.named.descriptions, self.named)
        foreign = every.keys() - self.fields.keys()
        self.mistakes += (self._foreign_field_error(name) for name in table if name in foreign)

    def build(self) -> Input:
        """Return the input.

        Raises
        ------
        InputsError
            With all mistakes.
        """
        self.read_fields()
        made = self.named
        if made is not None:
            # Without a known kind, cross checks cannot be chosen.
            is_named, likely = "kind" in self.table and self.cls.kinds, self.likely or self.cls.likely
            made = self._class_of_word if is_named else likely(self.values)
        if made is not None:
            self.run_cross_checks(made)
        if self.mistakes or self.wrong or made is None:
            raise InputsError(self.mistakes)
        return made(**self.values)

    def read_fields(self) -> None:
        """Read every field that is given."""
        # Profiles take missing parameters from their body, which is read before.
        for name in sorted(self.fields, key=lambda name_: getattr(self._description(name_), "of", None) is Profile):
            if name in self.values:
                continue
            if name not in self.table:
                self.note_missing(name)
                continue
            try:
                value = self.read_value(name, self.table[name])
            except InputError as error:
                self.mistakes += error.within(name).each
                self.wrong.add(name)
                continue
            try:
                self.values[name] = self._description(name).validate(name, value)
            except InputError as error:
                for mistake in error.each:
                    self.note(mistake if place_of(mistake.field)[0] == name else mistake.within(name))

    def note_missing(self, name: str) -> None:
        """Note a field that is not given, if it must be."""
        if name in (self.named or self.cls).without_default and name not in self.wrong:
            self.mistakes.append(missing_key_error(name, self.hint(name)))
            self.wrong.add(name)

    def read_value(self, name: str, written: Any) -> Any:
        """Return the value of a field, with inputs in place of tables; errors are relative to it."""
        description, inner = self._description(name), self.fields[name].inputs.get(name)
        match description, written:
            case Several(of=type() as of), _:
                return self._read_several(name, description, of, written)
            case Part(of=of), _ if of is Profile:
                body = {other: self.values.get(other) for other in self.fields if other not in self.wrong}
                return self.file.read_profile(written, body, self.file)
            case Part(named=named), str() if named:
                return written
            case Part(named=named), _ if named and not isinstance(written, dict):
                raise InputError("", written, "be a name or a table", description.remedy)
        if inner and (isinstance(written, dict) or isinstance(description, Part)):
            return read_input(inner, written, self.file, (*self.place, name), getattr(description, "likely", None))
        return written

    def _description(self, name: str) -> Description:
        return self.fields[name].descriptions[name]

    def run_cross_checks(self, made: type[Input]) -> None:
        """Run the checks whose fields are valid."""
        for error in mutually_exclusive_errors(made, self.table):
            if error.field not in self.wrong:
                self.note(error)
        trial = made.unchecked(**self.values)
        for check, names in made.cross_checks:
            if not names & self.wrong:
                try:
                    check(trial)
                except InputError as error:
                    for mistake in error.each:
                        self.note(mistake)

    def note(self, error: InputError) -> None:
        """Note a mistake in a field, and discard its value."""
        first, *rest = place_of(error.field)
        name, written = str(first), self.table.get(str(first))
        # Text and profiles are shown as written, and missing values not at all: TOML has no null.
        shown = written if (isinstance(written, str) or isinstance(error.value, Profile)) and not rest else error.value
        shown = document_of(shown) if isinstance(shown, Input) else shown
        self.mistakes.append(error.about(error.field, shown))
        self.wrong.add(name)

    def hint(self, name: str) -> str:
        """Return the remedy for a missing field."""
        inner = self.fields[name].inputs.get(name)
        if inner is None:
            return f"give {describe_field(self._description(name))}"
        needed = [part for part in sorted(inner.without_default) if part in inner.inputs]
        headings = [f"[{path_of((*self.place, name, part))}]" for part in needed]
        return "write it under a heading " + (" and ".join(headings) or f"[{path_of((*self.place, name))}]")

    def _read_several(self, name: str, description: Several, of: type[Input], value: Any) -> Any:
        if not isinstance(value, list) or not value:
            raise InputError("", value, "be a list of tables", description.item.remedy)
        if len(value) > description.most:
            raise InputError("", value, f"have at most {description.most} tables", description.item.remedy)
        place = (*self.place, name)
        return collect_errors("", value, lambda number, entry: read_input(of, entry, self.file, (*place, number)))

    def _choose_class(self) -> type[Input] | None:
        """Return the class by its word, or that of tables without one; None if it cannot be known."""
        usual = self.cls if not self.cls.kinds or self.cls in self.cls.kinds.values() else None
        if not self.cls.kinds:
            return self.cls
        if "kind" not in self.table:
            if usual is None and "kind" not in self.wrong:
                self.mistakes.append(missing_key_error("kind", f"give {self.cls.meaning_of_kind}"))
            return usual
        if self._class_of_word is None:
            word, noun = self.table["kind"], f"kind of {self._noun}"
            self.mistakes.append(unknown_word_error("kind", word, noun, self.cls.kinds))
        return self._class_of_word or usual

    @property
    def _class_of_word(self) -> type[Input] | None:
        """The class that the word of its kind stands for; None if there is none."""
        word = self.table["kind"]
        return self.cls.kinds.get(word) if isinstance(word, str) else None

    def _foreign_field_error(self, name: str) -> InputError:
        """Return the error for a field that other kinds have."""
        words = join_words(word for word, kind in self.cls.kinds.items() if name in kind.descriptions)
        condition = f"not be given for a {self.table['kind']} {self._noun}"
        return InputError(name, self.table[name], condition, f"leave it out, it belongs to {words} {self._noun}s")

    @property
    def _noun(self) -> str:
        match = _LAST_WORD.search(self.cls.__name__)
        return (match[0] if match else self.cls.__name__).lower()
