"""What is not imported before it is needed, since that takes longer than the first solve."""

import ast
import importlib
import pydoc
import subprocess
import sys
from pathlib import Path

import pytest

HEAVY = ("numpy", "scipy", "pint", "matplotlib")
#: What has no part in a contact whose pressure runs out.
OTHERS = (
    *("scipy.special", "scipy.interpolate", "scipy.optimize", "scipy.fft", "scipy.linalg", "scipy.sparse"),
    *("nonhertz.bearing.bearings", "nonhertz.maps", "nonhertz.patch.solver", "nonhertz.subsurface", *HEAVY[2:]),
)
CASE = Path(__file__).parents[2] / "examples" / "cylindrical-roller-bearing.toml"
#: What is done one after the other in a new process, and what is not there after it.
STEPS = [
    ("import nonhertz.cli.commands", HEAVY),
    ("nonhertz.cli.main(['--help'])", HEAVY),
    ("nonhertz.cli.main(['design', '--help'])", HEAVY),
    ("import nonhertz.model.profile", HEAVY[1:]),
    # No module hides the verb.
    ("import nonhertz.solver.one; assert callable(nonhertz.solve)", OTHERS),
    ("roller = nonhertz.Roller(diameter='20 mm', length=20, profile=nonhertz.profile.crown(4000))", OTHERS),
    ("nonhertz.solve(nonhertz.Contact(roller, nonhertz.Plate()), load='2 kN')", (*OTHERS, "nonhertz.files")),
    (f"assert nonhertz.cli.main(['solve', {str(CASE)!r}]) == 0", OTHERS),
    ("import nonhertz.plot.finished, nonhertz.bearing.bearings, nonhertz.maps.value", OTHERS[1:6]),
    ("import nonhertz.subsurface.evaluation, nonhertz.patch.solver, nonhertz.life.volume", HEAVY[2:]),
    ("from nonhertz.inputs.units import to_unit; to_unit('field', 3, 'mm')", HEAVY[2:]),
    ("import nonhertz.plot", HEAVY[2:]),
    ("import nonhertz.plot.sheets; nonhertz.plot.sheets.sheet(3.0)", ("matplotlib.pyplot",)),
]


def test_libraries_are_not_imported_before_they_are_needed():
    lines = [f"{step}\nfound = {set(absent)!r} & set(sys.modules)\nassert not found, found" for step, absent in STEPS]
    program = "\n".join(["import sys", *lines])

    def ran(program):
        return subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=False)

    done = ran(program)
    if done.returncode:
        # It may have found no tables of these materials on disk, and made them with functions of scipy.
        ran(program.replace("\nassert not found, found", ""))
        done = ran(program)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("name", ["bearing", "files", "life", "maps", "measured", "patch", "plot", "subsurface"])
def test_a_package_has_the_names_that_its_types_are_checked_by(name):
    package = importlib.import_module(f"nonhertz.{name}")
    nodes = ast.walk(ast.parse(Path(package.__file__).read_text("utf-8")))
    names = [alias.name for node in nodes if isinstance(node, ast.ImportFrom) for alias in node.names]
    assert dir(package) == sorted({*names} - {"TYPE_CHECKING", "attach"})
    assert not hasattr(package, "nothing")
    listed = pydoc.render_doc(package, renderer=pydoc.plaintext)
    assert all(name in listed for name in dir(package))
