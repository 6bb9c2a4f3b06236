"""A changed document as the text of its file, with the comments and the order of the file."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from typing import Any

from nonhertz.files.bounds import has_long_key
from nonhertz.files.toml import to_toml


def update_toml(document: dict[str, Any], text: str) -> str:
    r"""Return a document as TOML, written into a text that held another version of it.

    Lines with unchanged values stay as they are. If the text is not TOML, or the changes do not fit into it, the
    document is written anew.

    Examples
    --------
    >>> print(update_toml({"load": {"load": "25 kN"}}, '[load]\nload = "20 kN" # of the catalogue\n'), end="")
    [load]
    load = "25 kN" # of the catalogue
    """
    if "#" not in text or has_long_key(text):
        return to_toml(document)
    import tomlkit
    from tomlkit.exceptions import TOMLKitError

    try:
        whole = tomlkit.parse(text)
        _write_into(whole, document)
        rewritten = tomlkit.dumps(whole)
        return rewritten if tomllib.loads(rewritten) == document else to_toml(document)
    except (TOMLKitError, ValueError, KeyError, IndexError, TypeError, AttributeError, RecursionError):
        return to_toml(document)


def _write_into(table: Any, values: Mapping[str, Any], *, within: bool = False) -> None:
    """Write values into a table of a file; ``within`` another table, new ones are written on one line."""
    for name in table.keys() - values.keys():
        del table[name]
    for name, value in values.items():
        old = table.get(name)
        if isinstance(value, dict) and isinstance(old, dict):
            _write_into(old, value, within=True)
        elif all(map(_are_tables, (old, value))):
            for entry, entry_values in zip(old, value, strict=False):
                _write_into(entry, entry_values, within=True)
            del old[len(value) :]
            old.extend(value[len(old) :])
        elif bool in (type(old), type(value)) or old != value:
            table[name] = _on_one_line(value) if within else value


def _on_one_line(value: Any) -> Any:
    import tomlkit

    if isinstance(value, dict):
        table = tomlkit.inline_table()
        table.update({name: _on_one_line(entry) for name, entry in value.items()})
        return table
    if isinstance(value, list):
        row = tomlkit.array()
        row.extend(map(_on_one_line, value))
        return row.multiline(_are_tables(value) and len(value) > 1)
    return value


def _are_tables(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(entry, dict) for entry in value)
