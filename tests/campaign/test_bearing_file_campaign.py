"""Bearing files changed at random: each is read and can be written, or is refused in a sentence for each mistake."""

from __future__ import annotations

import time
import warnings
from collections import Counter
from pathlib import Path

import pytest
from case_texts import EXAMPLES, FILES, Mutator, is_sentence
from extent import extent

from nonhertz.errors import CaseError
from nonhertz.files.bearingfile import read_bearing, starting_bearing
from nonhertz.files.bounds import MISTAKES

CASES = extent(30_000, 600)
SLOWEST = 2.0
"""s of computing, for any file."""
BARRELS = """
[bearing]
kind = "spherical"
rollers = 17
contact_angle = "10 deg"
profile_radius = 60
inner_groove = 61.5
outer_groove = 61.5
[roller]
diameter = 12
length = 14
[inner]
diameter = 60
[outer]
diameter = -84.35
[load]
radial = ["20 kN", "5 kN"]
axial = 6e3
"""
THRUST = """
[bearing]
kind = "thrust"
rollers = 20
pitch_diameter = 60
density = "7.85 g/cm^3"
[roller]
diameter = 8
length = 8
profile = { kind = "tabulated", file = "points.csv" }
[inner]
depth = 4
[outer]
[load]
axial_displacement = "5 um"
moment = "10 N m"
"""

pytestmark = pytest.mark.campaign


def complaints(path: Path) -> tuple[str, ...]:
    """Return what is said of a bearing file; an error of another kind by its name."""
    try:
        read_bearing(path)
    except CaseError as error:
        return error.mistakes or ("no mistake is named",)
    except Exception as error:  # noqa: BLE001  (whatever it is, it is what is looked for)
        return (f"{type(error).__name__}: {error}",)
    return ()


def of_written(path: Path) -> tuple[str, ...]:
    """Return what is wrong with the file that a sound one is written to."""
    case, again = read_bearing(path), path.with_name("again.toml")
    try:
        case.write(again)
        same = read_bearing(again)
    except Exception as error:  # noqa: BLE001
        return (f"Error: written, {error}",)
    return () if (same.bearing, same.prescribed) == (case.bearing, case.prescribed) else ("Error: not the same again",)


def test_changed_bearing_files(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    for name, content in FILES.items():
        Path(name).write_text(content, encoding="utf-8")
    examples = [(EXAMPLES / f"{name}.toml").read_text(encoding="utf-8") for name in ("nu206", "tapered-pair")]
    texts, path = [starting_bearing(), *examples, BARRELS, THRUST], Path("bearing.toml")
    counts, amiss, slowest = Counter[str](), [], 0.0
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        # What goes on to a person as a warning must have been meant for one.
        warnings.simplefilter("error", RuntimeWarning)
        for text in texts:
            path.write_text(text, encoding="utf-8")
            assert complaints(path) == of_written(path) == ()
        for number in range(CASES):
            path.write_bytes(Mutator(number, texts).text().encode("utf-8", "surrogatepass"))
            begun = time.process_time()
            found = complaints(path)
            slowest = max(slowest, time.process_time() - begun)
            found = found or of_written(path)
            counts["refused" if found else "sound"] += 1
            amiss += [f"{number}: {each[:300]!r}" for each in found if not is_sentence(each)]
            if len(found) > MISTAKES + 1:
                amiss.append(f"{number}: {len(found)} mistakes")
    with capsys.disabled():
        print(f"\n{CASES} bearing files: {dict(counts)}, dearest {slowest:.2f} s")
    assert amiss == []
    assert counts["sound"] > CASES // 50
    assert counts["refused"] > CASES // 2
    assert slowest < SLOWEST
