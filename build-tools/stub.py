"""Writes src/nonhertz/_core.pyi, what Python's tools know of the core; with --check says whether it is as it was."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from nanobind.stubgen import StubGen

from nonhertz.native import core

STUB = Path(__file__).resolve().parents[1] / "src" / "nonhertz" / "_core.pyi"


def main() -> int:
    """Write the stub, or check it."""
    parser = argparse.ArgumentParser(description="Write the stub of the core.")
    parser.add_argument("--check", action="store_true", help="write nothing, and fail if it would change")
    checked = parser.parse_args().check
    stub = StubGen(core)
    stub.put(core)
    text = stub.get()
    if checked and text != STUB.read_text(encoding="utf-8"):
        print("src/nonhertz/_core.pyi is not what the core has: make core writes it anew.", file=sys.stderr)
        return 1
    if not checked:
        STUB.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
