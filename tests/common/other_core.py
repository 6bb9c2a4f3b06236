"""Puts another build of the core in the place of the one that is installed, if it is imported before nonhertz.

Its path is in the variable NONHERTZ_TEST_CORE. In tests: ``pytest -p other_core``.
"""

import importlib.util
import os
import sys

if path := os.environ.get("NONHERTZ_TEST_CORE"):
    assert "nonhertz.native" not in sys.modules, "another core comes too late"
    # The first that nonhertz asks for, whatever the processor; a module's function is called as its file is.
    name = os.path.basename(path).partition(".")[0]  # noqa: PTH119
    spec = importlib.util.spec_from_file_location(f"nonhertz.{name}", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    sys.modules[spec.name] = sys.modules["nonhertz._core_v3"] = module
