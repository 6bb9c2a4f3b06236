"""What ``dir`` of a public module lists, and names of a package that are imported on first access.

A module of a package can thus be imported without the other modules and their dependencies, and ``dir`` of a public
module lists only public names.
"""

from __future__ import annotations

import importlib
import sys
import warnings
from collections.abc import Callable, Mapping
from typing import Any

Dir = Callable[[], list[str]]


def dir_of(module: str) -> Dir:
    """Return ``__dir__`` of the module of this name: the names in its ``__all__``."""
    return lambda: sorted(sys.modules[module].__all__)


def attach(
    package: str, homes: Mapping[str, tuple[str, ...]], renamed: Mapping[str, str] | None = None
) -> tuple[Callable[[str], Any], Dir]:
    """Return ``__getattr__`` and ``__dir__`` of a package.

    Parameters
    ----------
    package : str
        Name of the package.
    homes : mapping of str to tuple of str
        Its modules, and the names of each that the package exports.
    renamed : mapping of str to str, optional
        Old names, which work for one release with a DeprecationWarning, and the names in their place.
    """
    home = {name: f"{package}.{module}" for module, names in homes.items() for name in names}

    def attribute(name: str) -> Any:
        if name == "__all__":  # what help() lists
            return sorted(home)
        if renamed and name in renamed:
            message = f"{package}.{name} is now {package}.{renamed[name]}; the old name goes with the next release"
            warnings.warn(message, DeprecationWarning, stacklevel=2)
            return getattr(sys.modules[package], renamed[name])
        if name in homes:
            return importlib.import_module(f"{package}.{name}")
        if name not in home:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        value = getattr(importlib.import_module(home[name]), name)
        setattr(sys.modules[package], name, value)
        return value

    return attribute, lambda: sorted(home)
