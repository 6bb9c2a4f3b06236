"""Reports in other languages: a file for each, with every sentence of a report in English and in that language.

Sentences are worded in English where they are made, many of them far below the report: by the solver, by checks, by
figures. They are translated where a report is laid out, so that nothing below knows of languages. An entry of a
language's file may have places, ``"at y = {y} mm"``; what stands there is translated in turn, and numbers get the
language's decimal separator. Text without an entry stays English, and is remembered for the tests.
"""

from __future__ import annotations

import functools
import re
import tomllib
from collections.abc import Callable, Iterator, Sequence
from importlib import resources
from typing import TYPE_CHECKING, Final

from nonhertz.errors import InputError
from nonhertz.result.reading import SI, chosen

if TYPE_CHECKING:
    from matplotlib.axis import Axis
    from matplotlib.figure import Figure

_PLACE: Final = re.compile(r"(?<!_)\{(\w+)\}")  # braces after an underscore are those of a formula
_NUMBER: Final = re.compile(r"(?<![\w.])(\d+)\.(\d+(?:e[-+]?\d+)?)(?!\.?\w)")
_LIST: Final = re.compile(r"(?<=\d), (?=[-+]?\d)(?![^()]*\))")  # names of cases, in brackets, may be numbers
_SENTENCES: Final = re.compile(r"(?<=[.]) (?=[A-Z'])")
_WORD: Final = re.compile(r"\b(?!(?:mrad|rad|MPa)\b)[A-Za-z]{3,}")
_WITHIN_SENTENCE: Final = r"(?:(?![.] [A-Z']).)"
_APART: Final = ("numbers", "joined")
Patterns = Sequence[tuple[re.Pattern[str], str]]


class Language:
    """The words of one language.

    Attributes
    ----------
    code : str
        As HTML has it, ``"en"`` or ``"de"``.
    missing : set of str
        Text with words that had no entry.

    Raises
    ------
    InputError
        If results are read in other units than those in which the sentences are worded.
    """

    def __init__(self, code: str) -> None:
        if code != "en" and chosen() is not SI:
            raise InputError("units", chosen().code, "be 'si' in other languages than English", "leave one of both out")
        self.code = code
        self.missing: set[str] = set()
        table = {} if code == "en" else _entries(code)
        self._decimal = table.get("numbers", {}).get("decimal", ".")
        self._between = table.get("numbers", {}).get("between", ", ")
        self._thousands = table.get("numbers", {}).get("thousands", ",")
        sentences = {
            english: own for name, part in table.items() if name not in _APART for english, own in part.items()
        }
        # What joins words, tried in order where nothing else fits.
        self._joined = [(_pattern(english), own) for english, own in table.get("joined", {}).items()]
        self._whole = {english: own for english, own in sentences.items() if not _PLACE.search(english)}
        patterned = [english for english in sentences if english not in self._whole]
        # Of several that match, the one with the most letters of its own says most exactly what is meant.
        patterned.sort(key=lambda english: -len(_PLACE.sub("", english)))
        self._patterns = [(_pattern(english), sentences[english]) for english in patterned]

    def __call__(self, text: str) -> str:
        """Return text of the program in this language."""
        if self.code == "en" or not text:
            return text
        found = self._found(text)
        if found is not None:
            return found
        parts = _SENTENCES.split(text)
        if len(parts) > 1:
            return " ".join(self(part) for part in parts)
        found = self._fitted(self._listed(text), self._joined, self)
        if found is not None:
            return found
        if _WORD.search(text):
            self.missing.add(text)
        return self.numbers(self._listed(text))

    def numbers(self, text: str) -> str:
        """Return text with the decimal separator of this language in its numbers."""
        return _NUMBER.sub(rf"\1{self._decimal}\2", text) if self._decimal != "." else text

    def whole(self, number: int) -> str:
        """Return a whole number with its thousands separated."""
        return f"{number:,}".replace(",", self._thousands)

    def _found(self, text: str) -> str | None:
        """Return the text of an entry that fits, None if none does."""
        bare = text.strip()
        if bare in self._whole:
            return text.replace(bare, self._whole[bare])
        return self._fitted(bare, self._patterns, self.words)

    @staticmethod
    def _fitted(text: str, patterns: Patterns, translated: Callable[[str], str]) -> str | None:
        """Return the text of the first pattern that fits, with what stands in its places translated."""
        for pattern, own in patterns:
            match = pattern.fullmatch(text)
            if match:
                places = {name: translated(value) for name, value in match.groupdict().items()}
                return _PLACE.sub(lambda place, places=places: places[place[1]], own)  # type: ignore[misc]
        return None

    def words(self, value: str) -> str:
        """Return what may be words of the program, or a number, or a name that stays as it is."""
        found = self._found(value)
        if found is None:
            found = self._fitted(self._listed(value), self._joined, self.words)
        return self.numbers(self._listed(value)) if found is None else found

    def _listed(self, text: str) -> str:
        """Return text with the numbers of a list apart, which decimal commas would run together."""
        return _LIST.sub(self._between, text)


@functools.cache
def _entries(code: str) -> dict[str, dict[str, str]]:
    text = resources.files("nonhertz.report").joinpath("languages", f"{code}.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)


def _pattern(english: str) -> re.Pattern[str]:
    parts = enumerate(_PLACE.split(english))
    own = (f"(?P<{part}>{_WITHIN_SENTENCE}+?)" if number % 2 else re.escape(part) for number, part in parts)
    return re.compile("".join(own), re.DOTALL)


def translate_figure(figure: Figure, language: Language) -> None:
    """Put the words of a figure, and the numbers at its axes, into a language."""
    from matplotlib.text import Text

    if language.code == "en":
        return
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            _with_separator(axis, language)
    ticks = {id(text) for axes in figure.axes for text in _tick_texts(axes.xaxis, axes.yaxis)}
    for text in figure.findobj(Text):
        assert isinstance(text, Text)
        # What is not parsed is the name of a file.
        if id(text) not in ticks and text.get_text() and text.get_parse_math():
            text.set_text("\n".join(language(line) for line in text.get_text().split("\n")))


def _tick_texts(*axes: Axis) -> Iterator[object]:
    for axis in axes:
        for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks()):
            yield from (tick.label1, tick.label2)


def _with_separator(axis: Axis, language: Language) -> None:
    formatter = axis.get_major_formatter()
    written = formatter.format_ticks

    def separated(values: list[float]) -> list[str]:
        return [language.numbers(text) for text in written(values)]

    formatter.format_ticks = separated  # type: ignore[method-assign]
