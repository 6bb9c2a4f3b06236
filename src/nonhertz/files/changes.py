"""Values in place of those in a case file or a bearing file, by dotted path, as ``--set load.load=5kN`` gives them."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping, Sequence
from itertools import chain, starmap
from typing import Any

from nonhertz.errors import CaseError, InputError
from nonhertz.files.mistakes import describe_mistake
from nonhertz.files.toml import to_toml
from nonhertz.inputs.fields import Input
from nonhertz.inputs.files import printable_name

_LONGEST = 60  # characters of a value in the comment


def parse_changes(words: Sequence[str]) -> dict[str, Any]:
    """Return the values in words such as ``load.load=5kN``, by path.

    A value is read as in the file, except that text needs no quotes; without a value, the key is removed.

    Raises
    ------
    InputError
        If a word has no path, or two have the same.

    Examples
    --------
    >>> parse_changes(["load.load=5kN", "solver.strips=41", "load.tilt="])
    {'load.load': '5kN', 'solver.strips': 41, 'load.tilt': None}
    """
    changes: dict[str, Any] = {}
    for word in words:
        path, equals, value = (part.strip() for part in word.partition("="))
        if not path or not equals:
            remedy = "write path and value, such as load.load=5kN"
            raise InputError("changes", word, "have an equals sign between path and value", remedy)
        if path in changes:
            raise InputError("changes", word, "set each path once", f"leave one of the values of {path} out")
        changes[path] = _parse_value(value) if value else None
    return changes


def apply_changes(
    document: dict[str, Any],
    text: str | None,
    changes: Mapping[str, Any],
    kind: type[Input],
) -> tuple[dict[str, Any], str | None]:
    """Return a document with other values, and its text, whose first line lists them.

    Parameters
    ----------
    document : dict
        Contents of a case file or a bearing file; it may have mistakes.
    text : str or None
        Text from which it was parsed.
    changes : mapping
        Values by path; None removes a key. Keys that exclude one of them are removed as well.
    kind : type
        The class of the contents of such a file.

    Raises
    ------
    InputError
        If ``changes`` is no such mapping.
    CaseError
        With every path that is not that of a value in such a file.
    """
    if not isinstance(changes, Mapping):
        raise InputError("changes", changes, "be a dictionary", 'map paths to values, such as {"load.load": "5 kN"}')
    if not changes:
        return document, text
    # Imported here, since they also load the fields of bearings, which are needed only for changes.
    from nonhertz.files.paths import drop_before_parameters, find_parameter, list_parameters

    whole, mistakes, known = document, [], list_parameters(document, kind)
    named = (known[path] for path, value in changes.items() if path in known and value is not None)
    changes = dict.fromkeys(chain.from_iterable(target.replaced_in(document) for target in named)) | dict(changes)
    for path, value in drop_before_parameters(changes):
        try:
            whole = find_parameter(path, list_parameters(whole, kind)).put(whole, value)
        except InputError as error:
            mistakes.append((describe_mistake(error.about(error.field, None)), error.field))
    if mistakes:
        raise CaseError(*zip(*mistakes, strict=True))
    what = ", ".join(starmap(_describe_change, changes.items()))
    try:
        return whole, f"# Set in place of what the file held: {what}\n" + to_toml(whole)
    except (TypeError, ValueError):
        remedy = "give numbers, text, or lists and dictionaries of them"
        raise InputError("changes", dict(changes), "hold what a TOML file can", remedy) from None


def _parse_value(text: str) -> Any:
    """Return a value written as in TOML, or else the text itself."""
    try:
        parsed_value = tomllib.loads(f"value = {text}")
    except (tomllib.TOMLDecodeError, RecursionError, ValueError):
        return text
    return parsed_value["value"] if set(parsed_value) == {"value"} else text


def _describe_change(path: str, value: Any) -> str:
    if value is None:
        return f"without {path}"
    text = value if isinstance(value, str) else json.dumps(value, ensure_ascii=False, default=str)
    shown = text if len(text) <= _LONGEST else text[: _LONGEST - 3] + "..."
    return f"{path} = {printable_name(shown)}"
