"""Gives one module other text, in every process that is started with this folder on its path.

No file is changed: what is compiled from the others, by Python and by Numba, stays as it is on disk.
"""

import os
import sys
from importlib.machinery import ModuleSpec, SourceFileLoader
from importlib.util import spec_from_file_location
from pathlib import Path
from types import ModuleType

MODULE, FILE, TEXT = "MUTATION_MODULE", "MUTATION_FILE", "MUTATION_TEXT"


class Changed(SourceFileLoader):
    """Loads a module from other text than that of its file."""

    def get_code(self, fullname: str) -> object:
        """Return the code of the other text; nothing is read from, or written to, a cache."""
        return self.source_to_code(Path(os.environ[TEXT]).read_bytes(), self.path)

    def exec_module(self, module: ModuleType) -> None:
        """Make the module, which has its other text for tables that are kept on disk, too."""
        super().exec_module(module)
        module.__file__ = os.environ[TEXT]


class Finder:
    """Finds the changed module."""

    @staticmethod
    def find_spec(name: str, path: object = None, target: object = None) -> ModuleSpec | None:
        """Return where the changed module comes from, None of others."""
        if name != os.environ[MODULE]:
            return None
        return spec_from_file_location(name, os.environ[FILE], loader=Changed(name, os.environ[FILE]))


def change() -> None:
    """Let the changed module be found."""
    if MODULE in os.environ:
        sys.meta_path.insert(0, Finder)  # type: ignore[arg-type]


change()
