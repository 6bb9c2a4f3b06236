"""Bytes to lines of text, in whatever encoding and with whatever line ends."""

from __future__ import annotations

import codecs

from nonhertz.errors import InputError

_UTF_16 = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
# Of the beginning of a file: what text does not hold.
_LOOKED_AT = 65536
_TEXT_CONTROLS = frozenset(b"\t\n\r\f\x1a")


def decoded(data: bytes, name: str) -> tuple[list[str], tuple[str, ...]]:
    """Return the lines of a text and what has to be noted of it.

    Parameters
    ----------
    data : bytes
        The content of the file: UTF-8 or UTF-16 with or without a mark, else Latin-1.
    name : str
        The file's name, for messages.

    Raises
    ------
    InputError
        If it is no text.
    """
    text, notes = _text(data, name)
    # The end-of-file mark of DOS.
    text = text.rstrip("\x1a").replace("\r\n", "\n").replace("\r", "\n")
    return text.split("\n"), notes


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
    ending = " (Mahr's .pcd is binary and its layout is not public)" if name.lower().endswith(".pcd") else ""
    condition = f"be text in columns, a MarWin text export, .smd, .prf or .x3p{ending}"
    return InputError("file", name, condition, "export the profile as text or X3P")
