"""Rooms of the core in C++ include each other downwards only, and know nothing of Python."""

import re
from pathlib import Path

import pytest

CORE = Path(__file__).resolve().parents[2] / "src" / "core"
# What a room may include beside its own files.
LEVELS = ("numbers", "strips", "bodies", "grids", "judging", "solve", "bearing")
BELOW = {room: set(LEVELS[:level]) for level, room in enumerate(LEVELS)}
BELOW |= {room: {"numbers", "strips"} for room in ("maps", "subsurface")}
BELOW["bearing"] |= {"maps", "subsurface"}
FILES = sorted(CORE.glob("**/*.?pp"))


@pytest.mark.skipif(not FILES, reason="the sources of the core are not beside the tests")
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.relative_to(CORE).as_posix())
def test_a_room_includes_only_what_is_below_it(path):
    included = re.findall(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', path.read_text(encoding="utf-8"), re.MULTILINE)
    ours = {name for mark, name in included if mark == '"'}
    assert not [name for name in ours if not (CORE / name).is_file()], "an include is a path below src/core"
    room = path.parent.name
    assert {name.partition("/")[0] for name in ours} <= BELOW[room] | {room}
    assert not [name for _, name in included if re.match(r"(Python\.h|nanobind/|bindings/)", name)]
