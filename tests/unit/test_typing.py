"""Types that users are given: a strict checker infers what the main functions return, and nothing as Any."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

pytest.importorskip("mypy")

ROOT = Path(__file__).parents[2]
#: Expressions of a user and their types, as mypy reveals them.
EXPECTED = {
    "roller": "Roller",
    "roller.profile": "Profile",
    "contact": "Contact",
    'nh.MATERIALS["steel"]': "Material",
    "solution": "Solution",
    "solution.max_pressure": "float",
    "solution.centre_pressure": "Array",
    "solution.edge_pressure": "tuple[EdgePressure, EdgePressure]",
    "solution.warnings": "tuple[str, ...]",
    'solution.gradient("approach")': "Gradient",
    "solution.plot()": "Axes",
    "many": "Solutions",
    "many.load": "Array",
    "many[0]": "Solution",
    "many.failures": "dict[int | tuple[int, ...], Exception]",
    "case": "Case",
    "case.solve()": "Solution",
    'nh.read_case("case.toml")': "Case",
    'nh.read_result("result.json")': "Result",
    "nh.sweep(case)": "Sweep",
    "nh.tolerance(case).sweep": "Sweep",
    "nh.optimize(case).value": "float",
    "nh.pareto(case, first=[], second=[])": "Front",
    "nh.compare(contact, load=5e3)": "Comparison",
    "nh.contact_map(contact, load=(0.0, 5e3))": "ContactMap",
    "nh.patch.solve(contact, load=5e3)": "PatchSolution",
    'nh.life.assess(solution, "lundberg-palmgren")': "tuple[Life, ...]",
    "nh.strength.assess(solution).static_safety": "float",
    "nh.subsurface.extremes(solution).von_mises.max": "float",
    "nh.hertz.line_contact(line_load=1e3, radius=10.0, e_star=1e5)": "LineContact",
    "bearing": "BearingCase",
    "loaded": "BearingSolution",
    "loaded.load": "Array",
    "loaded.contact(0)": "Solution | None",
    "loaded.plot()": "Axes",
    "bearing.assess(loaded).rated_life": "float",
    "nh.bearing.solve_many(bearing.bearing, radial=[1e3, 2e3])[0]": "BearingSolution",
}
SCRIPT = """
import nonhertz as nh

roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=4000))
contact = nh.Contact(roller, nh.Plate())
solution = nh.solve(contact, load=20e3, tilt=2e-4)
many = nh.solve_many(contact, load=[1e3, 2e3])
case = nh.new_case()
bearing = nh.read_bearing("bearing.toml")
loaded = nh.bearing.solve(bearing.bearing, radial=5e3)
"""


@pytest.mark.slow
def test_a_strict_checker_infers_what_main_functions_return(tmp_path):
    lines = [f"reveal_type({expression})" for expression in EXPECTED]
    (tmp_path / "user.py").write_text("\n".join([SCRIPT, *lines]), encoding="utf-8")
    options = ["--config-file", str(ROOT / "pyproject.toml"), "--cache-dir", str(ROOT / ".mypy_cache")]
    checked = subprocess.run(
        [sys.executable, "-m", "mypy", *options, "user.py"],
        capture_output=True, text=True, check=False, cwd=tmp_path, env=os.environ | {"MYPYPATH": str(ROOT / "src")},
    )  # fmt: skip
    assert checked.returncode == 0, checked.stdout
    revealed = [plain(text) for text in re.findall('Revealed type is "(.*)"', checked.stdout)]
    assert dict(zip(EXPECTED, revealed, strict=True)) == EXPECTED


def plain(revealed):
    """Return a revealed type without modules; arrays of floats of any shape as they are called in the sources."""
    array = "numpy.ndarray[tuple[Any, ...], numpy.dtype[numpy.float64]]"
    return re.sub(r"\b(\w+\.)+(?=\w)", "", revealed.replace(array, "Array"))
