"""What pip and others build the package with: scikit-build-core, and a compiler where the machine has none."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import compiler
from scikit_build_core import build
from scikit_build_core.build import *  # noqa: F403  # all that is not replaced here

Settings = dict[str, Any] | None


def get_requires_for_build_wheel(config_settings: Settings = None) -> list[str]:
    """Return what a wheel needs while it is built."""
    return build.get_requires_for_build_wheel(config_settings) + compiler.needed()


def get_requires_for_build_editable(config_settings: Settings = None) -> list[str]:
    """Return what an editable install needs while it is built."""
    return build.get_requires_for_build_editable(config_settings) + compiler.needed()


def build_wheel(wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None) -> str:
    """Build a wheel and return its name."""
    with tempfile.TemporaryDirectory() as folder:
        compiler.choose(Path(folder))
        return build.build_wheel(wheel_directory, config_settings, metadata_directory)


def build_editable(
    wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None
) -> str:
    """Build an editable wheel and return its name; its build folder is kept, and so is the compiler's."""
    compiler.choose(Path("build", "zig"))
    return build.build_editable(wheel_directory, config_settings, metadata_directory)
