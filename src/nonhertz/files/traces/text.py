"""From bytes, in any encoding and with any line endings, to lines of text, and from cells of text to numbers."""

from __future__ import annotations

import codecs
import re

from nonhertz.errors import InputError
from nonhertz.files.traces.line import MOST_POINTS

#: Most lines above the points of a text.
LONGEST_HEAD = 1000
#: Lines, at most, by which the layout of a text is recognised.
SAMPLED = 400
#: Characters of the longest line that is read: three hundred columns of numbers.
LONGEST_LINE = 5000

_UTF_16 = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
_NUMBER = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eEdD][-+]?[0-9]+)?")
# "Not measured" as written by hand, by C runtimes (Microsoft's 1.#QNAN, -1.#IND and 1.#J, glibc's -nan(0x8)), by
# Fortran (a field of asterisks), by Java, and by spreadsheets, also German ones.
_OF_SHEETS = r"#{3,}(?=\s*(?:$|[;,|\t]))|#(?:n/?a|nv|div/0|num|ref|null|value|name|wert|zahl|bezug)\b[!?]?"
_IN_WORDS = "no[ _-]?(?:data|value|signal|contact)|not[ _-]?(?:measured|valid)|out of range"
_MISSING = re.compile(
    r"[-+]?(?:nan[qs]?(?:\(\w*\))?|inf(?:inity)?|\d[.,]#\w*(?:e[-+]?\d+)?)"
    rf"|{_OF_SHEETS}|{_IN_WORDS}|<?n/?a>?|null|nil|none|bad|invalid|missing|void|-*|\*+|\?+|\.+|\u221e",
    re.IGNORECASE,
)
#: What a line of comment begins with.
COMMENT = re.compile(rf"\s*(?!{_OF_SHEETS})(?:#|%|//|'|!)+\s*", re.IGNORECASE)
_COMMENT_BEHIND = re.compile(rf"(?:^|(?<=[\s;|])|(?<=\D,))(?!{_OF_SHEETS})#.*", re.IGNORECASE)
#: The same in words that blanks may separate.
NOT_MEASURED = re.compile(rf"(?<!\w)(?:{_IN_WORDS})(?!\w)", re.IGNORECASE)
#: A mark before or behind the numbers of a line.
MARK = re.compile(r"^[*!>~&+]\s+|\s*[;,|\t]?\s*[*!<~&#\u2020]+$")
# Bytes at the beginning of a file in which non-text bytes are searched.
_LOOKED_AT = 65536
_TEXT_CONTROLS = frozenset(b"\t\n\r\f\x1a")


def decode(data: bytes, name: str) -> tuple[list[str], tuple[str, ...]]:
    """Return the lines of a text, and notes about it.

    Parameters
    ----------
    data : bytes
        The content of the file: UTF-8 or UTF-16 with or without a byte order mark, else Latin-1.
    name : str
        The file's name, for messages.

    Raises
    ------
    InputError
        If it is not text, or has more or longer lines than a profile.
    """
    text, notes = _text(data, name)
    # The end-of-file mark of DOS.
    return lines_of(text.rstrip("\x1a").replace("\r\n", "\n").replace("\r", "\n"), name), notes


def lines_of(text: str, name: str) -> list[str]:
    """Return the lines of a text whose line endings are newlines.

    Raises
    ------
    InputError
        If there are more lines than the longest profile has, or one is too long to be a line of numbers. Both are
        checked before the lines are parsed, which takes a hundred times as much memory and time.
    """
    if text.count("\n") > MOST_POINTS + LONGEST_HEAD:
        condition = f"hold no more than {MOST_POINTS:,} points"
        raise InputError("file", name, condition, "export fewer; a few thousand are enough")
    lines = text.split("\n")
    number, longest = max(enumerate(map(len, lines), start=1), key=lambda line: line[1])
    if longest > LONGEST_LINE:
        condition = f"have lines of no more than {LONGEST_LINE:,} characters (line {number} has {longest:,})"
        raise InputError("file", name, condition, "export the profile as text in two columns, one point per line")
    return lines


def value_in(cell: str) -> float | None:
    """Return the number in a cell, NaN for a word that means "not measured", None for any other text.

    ``float`` would read ``1_5`` as fifteen.
    """
    if _NUMBER.fullmatch(cell):
        return float(cell.replace("d", "e").replace("D", "e"))
    return float("nan") if _MISSING.fullmatch(cell) else None


def without_comment(line: str) -> str:
    """Return a line without the comment behind a ``#`` that begins no missing value of a spreadsheet or a runtime."""
    return _COMMENT_BEHIND.sub("", line) if "#" in line else line


def _text(data: bytes, name: str) -> tuple[str, tuple[str, ...]]:
    if data.startswith(_UTF_16):
        return _as_utf_16(data, name, "utf-16"), ()
    half = data[:_LOOKED_AT]
    if half[1::2].count(0) > 0.4 * len(half) / 2 and half[0::2].count(0) < 0.1 * len(half) / 2:
        return _as_utf_16(data, name, "utf-16-le"), ()
    if any(byte < 32 and byte not in _TEXT_CONTROLS for byte in half):
        raise _no_text(name)
    try:
        return data.decode("utf-8-sig"), ()
    except UnicodeDecodeError:
        return data.decode("latin-1"), ("The file is not in UTF-8 and was read as Latin-1.",)


def _as_utf_16(data: bytes, name: str, encoding: str) -> str:
    try:
        return data.decode(encoding)
    except UnicodeDecodeError:
        raise _no_text(name) from None


def _no_text(name: str) -> InputError:
    ending = " (Mahr's .pcd is binary and its format is not public)" if name.lower().endswith(".pcd") else ""
    condition = f"be text in columns, a MarWin text export, .smd, .prf, .x3p or .xlsx{ending}"
    return InputError("file", name, condition, "export the profile as text or X3P")
