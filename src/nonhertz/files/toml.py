"""Documents: the contents of TOML files, read and written, whatever their meaning."""

from __future__ import annotations

import ast
import contextlib
import errno
import re
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from nonhertz.errors import CaseError, InputError, join_words, nearest
from nonhertz.files.bounds import LARGEST_CASE, TOO_DEEP, exceeded_limit, has_long_key
from nonhertz.files.mistakes import path_of
from nonhertz.inputs.files import read_bytes

#: Tables of a bearing file in place of both bodies, and tables that only plans have.
OF_BEARINGS = ("bearing", "roller", "inner", "outer")
OF_PLANS = ("case", "over", "tolerance", "vary")
_CONTENTS = {"case": "a single contact", "bearing": "a bearing", "plan": "a plan"}


def file_kind(document: Mapping[str, Any]) -> str:
    """Return the kind of file that a document is meant to be; empty if that is not clear.

    Examples
    --------
    >>> [file_kind(each) for each in ({"body": {}, "load": {}}, {"roller": {}}, {"case": "roller.toml", "over": {}})]
    ['case', 'bearing', 'plan']
    """
    if "body" in document:
        return "" if "bearing" in document else "case"
    if any(name in document for name in OF_BEARINGS):
        return "bearing"
    return "plan" if is_plan(document) else ""


def is_plan(document: Mapping[str, Any]) -> bool:
    """Return whether a document has tables that only plans have.

    Examples
    --------
    >>> is_plan({"case": "roller.toml", "over": {}}), is_plan({"body": {}, "load": {}})
    (True, False)
    """
    return any(name in document for name in OF_PLANS)


def load_document(path: str | Path, *kinds: str) -> tuple[dict[str, Any], Path, str]:
    """Return the document in a file, its path and its text. It is read only once, since it may be a pipe.

    Parameters
    ----------
    path : str or Path
        A TOML file.
    *kinds : {"case", "bearing", "plan"}
        The kinds that it may be; the first is suggested for a missing file.

    Raises
    ------
    CaseError
        If it cannot be read, is not TOML, is larger than any case, or is of another kind; readers of plans refuse other
        kinds themselves.
    InputError
        If ``path`` is not the name of a file.
    """
    what = join_words((f"{kind} file" for kind in kinds), "or")
    if not isinstance(path, str | Path):
        raise InputError("path", path, f"be the name of a {what}", "give a string or a Path")
    path = Path(path)
    try:
        text = read_bytes(path, LARGEST_CASE).decode("utf-8-sig")
    except (OSError, ValueError) as error:
        raise CaseError([_explain_unreadable(path, error, what, kinds[0])]) from None
    document = parse(text, str(path))
    kind = file_kind(document)
    if kind and kind not in kinds and "plan" not in kinds:
        contents = join_words((_CONTENTS[kind_] for kind_ in kinds), "or")
        raise CaseError([f"{path} must hold {contents}, not {_CONTENTS[kind]}: use nonhertz.read_{kind}."])
    return document, path, text


def _explain_unreadable(path: Path, error: OSError | ValueError, what: str, kind: str) -> str:
    """Return why a file of a kind, ``what`` in words, could not be read, and what to do about it."""
    match error:
        case FileNotFoundError():
            beside = {file.stem: file for file in path.parent.glob("*.toml")}
            if meant := nearest(path.stem, beside):
                return f"{path} does not exist. Did you mean {beside[meant]}?"
            new = "write one that names its case" if kind == "plan" else f"begin with one from nonhertz.new_{kind}"
            return f"{path} must exist: give the path of a {what}, or {new}."
        case IsADirectoryError():
            return f"{path} must be a file, not a directory: give the path of a {what}."
        case UnicodeDecodeError():
            line = error.object.count(b"\n", 0, error.start) + 1
            return f"{path}, line {line}, must be text in UTF-8: save the file with that encoding."
    reason = getattr(error, "strerror", None) or str(error)
    too_large = getattr(error, "errno", None) == errno.EFBIG
    hint = "put measured points into a file that it names" if too_large else "check path and permissions"
    return f"{path} must be readable ({reason[:1].lower()}{reason[1:]}): {hint}."


def parse(text: str, name: str) -> dict[str, Any]:
    """Return the document in the text of a case file; ``name`` is its name in error messages.

    Raises
    ------
    CaseError
        If the text is not TOML, or exceeds the limits of a case.
    """
    # Before parsing: the parser's time grows with the square of the number of parts in a key.
    if has_long_key(text):
        raise CaseError([f"{name} must be a case file: {TOO_DEEP}."])
    try:
        document = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        reason = _translate_reason(str(error).rstrip(".")) + _suggest_number(text, str(error))
    except RecursionError:
        reason = TOO_DEEP
    except ValueError:  # Python's limit on the digits of an integer
        reason = "a number has thousands of digits"
    else:
        if too_much := exceeded_limit(document):
            raise CaseError([f"{name} must be a case file: {too_much}."])
        return document
    raise CaseError([f"{name} must be valid TOML: {reason[:1].lower()}{reason[1:]}."])


def _translate_reason(reason: str) -> str:
    """Return the parser's reason, without its own terms for duplicates."""
    if match := re.search(r"(?:declare|namespace) \((.*?),?\)(?: twice)? \(", reason):
        keys = path_of(ast.literal_eval(f"({match[1]},)"))
        return f"table [{keys}] is defined twice ({reason[match.end() :]}"
    return re.sub(r"Cannot overwrite a value|Duplicate inline table key '.*?'", "a key is given twice", reason)


def _suggest_number(text: str, reason: str) -> str:
    """Return the remedy for a line of TOML with a number written with a decimal comma, or with its unit."""
    place = re.search(r"at line (\d+)", reason)
    line = text.split("\n")[int(place[1]) - 1] if place else ""
    if re.search(r"=\s*[-+]?\d+,\d", line):
        return "; use a decimal point"
    # Not digits of other bases, nor anything longer than a number with a unit.
    if number := re.search(r"=\s*(?!0[xob])([-+]?\d[\d.]{0,20}\s?(?![eE][-+]?\d)[A-Za-z][\w/^ ]{0,11}?)\s*(#|$)", line):
        return f'; quote a number with its unit, "{number[1]}"'
    return ""


def to_toml(document: dict[str, Any]) -> str:
    """Return a document as the text of a case file.

    Examples
    --------
    >>> print(to_toml({"load": {"load": "20 kN"}}), end="")
    [load]
    load = "20 kN"
    """
    import tomli_w

    return tomli_w.dumps(document)


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
        hint = "choose another name" if path.parent.is_dir() else "make its folder first"
        raise CaseError([f"{path} cannot be written ({reason}): {hint}."]) from None


@contextlib.contextmanager
def name_file_in_errors(path: str | Path) -> Iterator[None]:
    """Prefix every mistake raised in a ``with`` block with the file's name, unless it has it already."""
    try:
        yield
    except CaseError as error:
        sentences = (mistake if mistake.startswith(str(path)) else f"{path}: {mistake}" for mistake in error.mistakes)
        raise CaseError(sentences, error.places) from None
