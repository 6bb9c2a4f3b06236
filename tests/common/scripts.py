"""Scripts that are no modules of the package, imported from their files."""

import importlib.util
from pathlib import Path
from types import ModuleType


def script(path: Path) -> ModuleType:
    """Return a script after it has run."""
    specification = importlib.util.spec_from_file_location(path.stem.replace("-", "_"), path)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module
