"""The numbers of every example and template, by the command that prints them as JSON, kept in the files beside this.

    PYTHONPATH=src python tests/golden/golden.py            # writes all of them anew, where numbers change on purpose
    PYTHONPATH=src python tests/golden/golden.py life map   # or those of some commands

They hold numbers alone, a run in a line, so that words may change and numbers may not. Of a longer list of numbers
they hold how many there are, the sum of their sizes, and a sum in which each has a weight of its own.
"""

import contextlib
import csv
import io
import json
import math
import platform
import sys
import tempfile
import tomllib
from pathlib import Path

import numpy as np
import scipy
import tomli_w

from nonhertz.cli import main

HERE = Path(__file__).resolve().parent
EXAMPLES = HERE.parents[1] / "examples"
LONGEST = 8  # numbers of a list that are kept one by one

# A source is an example, or what `nonhertz new` writes.
CASES = ("crowned-roller", "cylindrical-roller-bearing", "elliptical-point-contact", "measured-roller", "roller-15x20")
CONTACTS = [f"{name}.toml" for name in (*CASES, "tabulated-profile")]
TEMPLATES = ("cylindrical", "tapered", "spherical", "needle", "wheel-on-rail", "gear-flank", "cam")
BEARING_TEMPLATES = ("cylindrical", "needle", "tapered-pair", "spherical", "thrust")
CONTACTS += ["new", *(f"new --template {name}" for name in TEMPLATES)]
BEARINGS = ["nu206.toml", "nu206-mounted.toml", "nu206-classes.toml", "tapered-pair.toml", "new --bearing"]
BEARINGS += [f"new --bearing --template {name}" for name in BEARING_TEMPLATES]
SOME = ("elliptical-point-contact.toml", "roller-15x20.toml", "new")
LOADS = [{"load": "5 kN"}, {"load": "20 kN", "tilt": "1 arcmin"}]
DESIGN = {"loads": LOADS, "starts": 1}
#: By command and source: words that follow, or tables of a plan that are made smaller.
RUNS = {
    "solve": dict.fromkeys(CONTACTS, ""),
    # Of these few strips will do, and of the slowest commands the sources that differ most: seconds each.
    "stress": dict.fromkeys([*CONTACTS[:5], "new", "new --template tapered"], "--set solver.strips=11"),
    "life": dict.fromkeys([*SOME, "crowned-roller.toml", "new --template tapered"], "--set solver.strips=11"),
    "bearing": dict.fromkeys(BEARINGS, ""),
    "profile": {"measured-roller.txt": "--fit best", "tabulated-profile.csv": "--sense drop --fit crown"},
    "map": dict.fromkeys(SOME[1:], "--load 0:2kN:3 --tilt 0 --accuracy 0.01"),
    "sweep": {
        "roller-15x20-sweep.toml": {"over": {"load.tilt": ["0", "0.3 mrad"], "body.a.profile.drop": ["20 um"]}},
        "new --plan": {"over": {"load.load": "5 kN : 20 kN : 3"}},
        "nu206.toml": "--over load.radial=2kN,8kN",
    },
    "tolerance": {
        "roller-15x20-tolerance.toml": {"samples": {"count": 14}, "quantities": ["relative_life"]},
    },
    "design": {
        "roller-15x20-design.toml": {"design": DESIGN | {"goal": "life", "loads": LOADS[:1]}},
        "new --plan": {"design": DESIGN},
    },
}
STUDIES = ("sweep", "tolerance", "design")


def ran(command, source):
    """Return the exit code of a command, and all numbers that it prints as JSON or writes into tables, by name.

    Last come the warnings that it prints.
    """
    printed, words = io.StringIO(), RUNS[command][source]
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(io.StringIO()):
            file = EXAMPLES / source
            if source.startswith("new"):
                main(["new", "case.toml"])
                file = Path(f"{command}.toml")
                main([*source.split(), str(file)])
            if isinstance(words, dict):
                plan = tomllib.loads(file.read_text(encoding="utf-8"))
                plan |= words | {"case": str(file.parent.absolute() / plan["case"])}
                file, words = Path("plan.toml"), ""
                file.write_text(tomli_w.dumps(plan), encoding="utf-8")
            printed.truncate(printed.seek(0))
            words += {"map": " --out map.csv"}.get(command, " --workers 1 --out rows" if command in STUDIES else "")
            code = main([command, str(file), *words.split(), "--json"])
        tables = {path.name: csv.reader(path.read_text("utf-8").splitlines()) for path in Path().rglob("*.csv")}
    columns = {name: {head: cells for head, *cells in zip(*rows, strict=True)} for name, rows in tables.items()}
    found = json.loads(printed.getvalue() or "{}")
    return code, dict(numbers(found | columns)), found.get("warnings", [])


def number(value):
    """Return a value as a number or flag, None where it is neither."""
    try:
        return value if isinstance(value, bool) or value is None else float(value)
    except (TypeError, ValueError):
        return None


def numbers(value, name=""):
    """Yield the name and value of all numbers and flags within nested lists and dictionaries."""
    if isinstance(value, dict | list):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from numbers(inner, f"{name}.{key}" if name else str(key))
    elif number(value) is not None:
        yield name, number(value)


def compact(found):
    """Return the numbers of a run as they are kept: of a longer list count, sum of sizes and weighted sum."""
    lists, kept = {}, {}
    for name, value in found.items():
        lists.setdefault(".".join(part for part in name.split(".") if not part.isdigit()), {})[name] = value
    for name, values in lists.items():
        if len(values) <= LONGEST:
            kept |= values
        else:
            row = np.array(list(values.values()), dtype=float)
            row = row[np.isfinite(row)]
            weights = np.cos(np.arange(row.size))
            kept[name] = [row.size, math.fsum(abs(row)), math.fsum(weights * row)]
    return json.loads(json.dumps(kept), parse_float=lambda text: float(f"{float(text):.13g}"))


def machine():
    """Return what rounding depends on: system, libraries, and the instructions by which they sum."""
    extensions = np.show_config(mode="dicts")["SIMD Extensions"].get("found", [])
    system = [platform.machine(), *extensions, *platform.libc_ver(), platform.python_version()]
    return " ".join([*system, *(library.__version__ for library in (np, scipy))])


def kept(command):
    """Return what the file of a command holds: the machine that wrote it, and the numbers by source."""
    return json.loads((HERE / f"{command}.json").read_text(encoding="utf-8"))


def write(command):
    """Write the file of a command."""
    lines = [f'"machine": {json.dumps(machine())}']
    for source in RUNS[command]:
        code, found, _ = ran(command, source)
        lines.append(f"{json.dumps(source)}: {json.dumps({'exit code': code} | compact(found))}")
    (HERE / f"{command}.json").write_text("{" + ",\n".join(lines) + "}\n", encoding="utf-8")


if __name__ == "__main__":
    for each in sys.argv[1:] or RUNS:
        write(each)
