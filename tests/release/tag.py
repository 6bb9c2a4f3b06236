"""Ends with an error if a tag is not that of the release in the sources: ``python tests/release/tag.py v0.1.0``.

A release has its version in the package, in CITATION.cff, in the recipe, and a dated heading in the changelog.
"""

from __future__ import annotations

import re
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def mistakes(tag: str) -> list[str]:
    """Return what does not agree with a tag."""
    version = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
    changelog = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    found = [] if tag == f"v{version}" else [f"The tag is {tag}, but pyproject.toml has version {version}."]
    if not re.search(rf"^## {re.escape(version)}, \d{{4}}-\d\d-\d\d$", changelog, re.MULTILINE):
        found.append(f"CHANGELOG.md needs a heading '## {version}, YYYY-MM-DD'.")
    return found


if __name__ == "__main__":
    found = mistakes(sys.argv[1])
    print(*found, sep="\n")
    sys.exit(1 if found else 0)
