"""What is not imported before it is needed, since that takes longer than the first solve."""

import subprocess
import sys

HEAVY = ("numpy", "scipy", "pint", "matplotlib")
#: What is done one after the other in a new process, and what is not there after it.
STEPS = [
    ("import nonhertz.cli.commands", HEAVY),
    ("nonhertz.cli.main(['--help'])", HEAVY),
    ("nonhertz.cli.main(['design', '--help'])", HEAVY),
    ("import nonhertz.model.profile", HEAVY[1:]),
    ("import nonhertz.subsurface, nonhertz.patch, nonhertz.life", HEAVY[2:]),
    # No module hides the verb.
    ("import nonhertz.solver.one; assert callable(nonhertz.solve)", HEAVY[2:]),
    ("from nonhertz.inputs.units import in_unit; in_unit('field', 3, 'mm')", HEAVY[2:]),
    ("import nonhertz.plot", HEAVY[2:]),
    ("import nonhertz.plot.sheets; nonhertz.plot.sheets.sheet(3.0)", ("matplotlib.pyplot",)),
]


def test_libraries_are_not_imported_before_they_are_needed():
    lines = [f"{step}\nfound = {set(absent)!r} & set(sys.modules)\nassert not found, found" for step, absent in STEPS]
    program = "\n".join(["import sys", *lines])
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
