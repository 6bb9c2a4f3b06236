"""Whether two states of the package give the same numbers: cases of campaigns, golden runs, claims of the validation.

    python tests/campaign/same_numbers.py commits main HEAD               # or a commit alone: this folder beside it
    python tests/campaign/same_numbers.py commits main --cases 200        # a fiftieth of all draws

records two commits, each from a worktree of its own, with this folder's cases and the present interpreter, and prints
what differs. A source tree can be recorded by itself, too, and records compared:

    PYTHONPATH=/before/src python tests/campaign/same_numbers.py record /tmp/before.jsonl
    PYTHONPATH=src         python tests/campaign/same_numbers.py record /tmp/after.jsonl
    python tests/campaign/same_numbers.py compare /tmp/before.jsonl /tmp/after.jsonl

A record is a line: what it is of, how it ended, and its numbers by name.
"""

import argparse
import json
import math
import multiprocessing
import os
import subprocess
import sys
import tempfile
import warnings
from collections import defaultdict
from itertools import chain
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "golden"))
# Of 10,000 cases; every fifth bearing is by strips, the others by slices.
DRAWS = {"roller": 2_000, "extreme": 10_000, "bearing": 2_000, "patch": 300, "stress": 300}
SAME = 1e-12
# Of a case that took its time, and of the release that made the file.
NOT_COMPARED = ("seconds", "version", "format", ".case")


def case_record(work):
    """Return the record of a case of a campaign."""
    kind, number = work
    of = {"roller": roller, "extreme": extreme, "bearing": bearing, "patch": patch, "stress": stress}
    ended, found = of[kind](number)
    return {"of": f"{kind} {number}", "ended": ended, "numbers": found}


NAMES = ("approach", "tilt", "load", "moment", "max_pressure", "max_half_width", "stiffness")
ROWS = ("edges", "line_load", "half_width", "gap")


def roller(number):
    """Return how a random roller ended, and its numbers."""
    from test_real_rollers import real_case

    import nonhertz as nh

    def solve():
        contact, given = real_case(number)
        return nh.solve(contact, **given)

    ended, found = tried(solve)
    return ended, {} if found is None else quantities(found, NAMES, ROWS)


def extreme(number):
    """Return how an extreme contact ended, and its numbers."""
    from campaign_run import solved
    from extreme_cases import random_case

    ending = solved(random_case(number))
    return f"{ending.kind} {ending.words}", {} if ending.solution is None else quantities(ending.solution, NAMES, ROWS)


def bearing(number):
    """Return how a random bearing ended, and its numbers."""
    from test_bearings import random_bearing

    import nonhertz as nh

    of, given = random_bearing(number)
    ended, found = tried(lambda: nh.bearing.solve(of, method="slices" if number % 5 else "strips", **given))
    rows = ("load", "moment", "approach", "tilt", "each_rib_load")
    return ended, {} if found is None else quantities(found, ("displacement", "force", "stiffness"), rows)


def patch(number):
    """Return how a random contact on a plane grid ended, and its numbers."""
    import numpy as np
    from test_patch_estimate import KINDS, case

    import nonhertz as nh

    generator = np.random.default_rng((number % len(KINDS), number // len(KINDS)))
    of, given = case(KINDS[number % len(KINDS)], generator)
    cells = int(generator.integers(16, 49)), int(generator.integers(24, 97))
    ended, found = tried(lambda: nh.patch.solve(of, cells=cells, **given))
    names = ("approach", "tilt", "load", "moment", "max_pressure")
    return ended, {} if found is None else quantities(found, names, ("x", "y", "pressure", "gap"))


def stress(number):
    """Return the stress at some places below a random contact."""
    import numpy as np
    from test_stress_campaign import random_solution

    import nonhertz as nh
    from golden import numbers

    case = random_solution(number)
    if case is None:
        return "refused", {}
    solution, _, rng = case
    low, high = solution.edges[np.flatnonzero(solution.line_load)[[0, -1]] + [0, 1]]
    wide = solution.half_width.max()
    places = wide * rng.uniform(-2.0, 2.0, 20), rng.uniform(low, high, 20), wide * rng.uniform(0.05, 3.0, 20)
    ended, found = "solved", {}
    for body in "ab":
        ended, field = tried(lambda body=body: nh.subsurface.stress(solution, *places, body=body, threads=1))
        found |= {} if field is None else dict(numbers(field.stress.tolist(), body))
    return ended, found


def tried(solve):
    """Return how a solve ended, and its result, None if it has none."""
    import nonhertz as nh

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return "solved", solve()
        except nh.NonhertzError as error:
            return type(error).__name__, None


def quantities(result, names, rows):
    """Return numbers of a result, and of arrays that depend on its grid how many, their sum and that of squares."""
    import numpy as np

    from golden import numbers

    found = dict(numbers({name: np.asarray(getattr(result, name)).tolist() for name in names}))
    for name in rows:
        row = np.asarray(getattr(result, name)).ravel()
        row = row[np.isfinite(row)]
        found |= {f"{name}.count": row.size, f"{name}.sum": math.fsum(row), f"{name}.squares": row @ row}
    return found


def command_records():
    """Yield the records of the golden runs, with all their numbers."""
    from golden import RUNS, ran

    for command, sources in RUNS.items():
        for source in sources:
            code, found, *_ = ran(command, source)
            yield {"of": f"{command} {source}", "ended": str(code), "numbers": found}


def check_records():
    """Yield the records of the claims, but for those that measure time."""
    import claims

    for section in claims.sections(name for name in claims.CATALOGUE if name != "cost"):
        for number, check in enumerate(section.checks):
            numbers = {"expected": check.expected, "computed": check.computed}
            yield {"of": f"claims {section.name} {number}", "ended": check.verdict, "numbers": numbers}


def _number(value):
    return None if value is None else value if isinstance(value, str | bool | int) else float(value)


def record(out, cases, workers):
    """Write the records of one state of the package."""
    import nonhertz

    print(f"recording {Path(nonhertz.__file__).parent}", flush=True)
    drawn = [(kind, number) for kind, count in DRAWS.items() for number in range(count * cases // 10_000)]
    with multiprocessing.get_context("spawn").Pool(workers) as pool, out.open("w") as lines:
        solved = pool.imap_unordered(case_record, drawn, chunksize=20)
        for found in chain(command_records(), check_records(), solved):
            found["numbers"] = {name: _number(value) for name, value in found["numbers"].items()}
            lines.write(json.dumps(found) + "\n")


def of_commits(commits, options):
    """Record one commit and the sources here, or two commits, and return whether they give the same."""
    with tempfile.TemporaryDirectory() as folder:
        records, git = [], ["git", "-C", str(HERE)]
        for commit in commits:
            tree, written = Path(folder, f"tree{len(records)}"), Path(folder, f"{len(records)}.jsonl")
            root = tree if commit else HERE.parents[1]
            if commit:
                subprocess.run([*git, "worktree", "add", "--quiet", "--detach", str(tree), commit], check=True)
            try:
                if (tree / "CMakeLists.txt").exists():
                    _build_core(tree)
                words = [sys.executable, __file__, "record", str(written), *options]
                # Golden runs as that state makes them: commands may have changed their names and what they write.
                paths = os.pathsep.join([str(root / "src"), str(root / "tests" / "golden")])
                subprocess.run(words, env=os.environ | {"PYTHONPATH": paths}, check=True)
            finally:
                if commit:
                    subprocess.run([*git, "worktree", "remove", "--force", str(tree)], check=True)
            records.append(written)
        return compared(*records)


def _build_core(tree):
    """Build the core of a worktree beside its sources."""
    words = ["cmake", "-S", str(tree), "-B", str(tree / "build"), "-G", "Ninja", "-DNONHERTZ_IN_PLACE=ON"]
    tools = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])  # where make has installed them
    for command in ([*words, f"-DPython_EXECUTABLE={sys.executable}"], ["cmake", "--build", str(tree / "build")]):
        subprocess.run(command, env=os.environ | {"PATH": tools}, stdout=subprocess.DEVNULL, check=True)


def difference(one, other):
    """Return the relative difference of two numbers, infinite where only one is a number or words differ."""
    if isinstance(one, int | float) and isinstance(other, int | float):
        if one == other or (math.isnan(one) and math.isnan(other)):
            return 0.0
        found = abs(one - other) / max(abs(one), abs(other))
        return found if math.isfinite(found) else math.inf
    return 0.0 if one == other else math.inf


def compared(before, after):
    """Print where two records differ, by the name of the number, and return whether nowhere."""
    records = [{line["of"]: line for line in map(json.loads, path.open())} for path in (before, after)]
    worst, count, total = defaultdict(lambda: (0.0, "")), defaultdict(int), 0
    for name in sorted(set(records[0]) | set(records[1])):
        one, other = (found.get(name, {"ended": "not there", "numbers": {}}) for found in records)
        differences = {"how it ended": difference(one["ended"], other["ended"])}
        for key in set(one["numbers"]) | set(other["numbers"]):
            if not any(word in key for word in NOT_COMPARED):
                total += 1
                differences[key] = difference(one["numbers"].get(key, "none"), other["numbers"].get(key, "none"))
        for key, found in differences.items():
            if found > SAME:
                kind = f"{name.split()[0]}: {'.'.join(part for part in key.split('.') if not part.isdigit())}"
                count[kind] += 1
                worst[kind] = max(worst[kind], (found, f"{name}{key if '.' in key else ''}"))
    print(f"{len(records[0])} and {len(records[1])} records, {total} numbers compared to {SAME:g}")
    for kind in sorted(count, key=count.get, reverse=True):
        print(f"{count[kind]:6} differ in {kind}, by {worst[kind][0]:.2g} at most, {worst[kind][1]}")
    print("all the same" if not count else f"{sum(count.values())} differ")
    return not count


def main():
    """Record one state, or compare two."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    actions = parser.add_subparsers(dest="action", required=True)
    recording = actions.add_parser("record", help="write the numbers of one state")
    recording.add_argument("out", type=Path)
    comparing = actions.add_parser("compare", help="compare the numbers of two states")
    comparing.add_argument("before", type=Path)
    comparing.add_argument("after", type=Path)
    both = actions.add_parser("commits", help="record two commits and compare them")
    both.add_argument("before")
    both.add_argument("after", nargs="?", help="by default the sources as they are here")
    for each in (recording, both):
        each.add_argument("--cases", type=int, default=10_000, help="of each campaign; other draws in proportion")
        each.add_argument("--workers", type=int, default=os.cpu_count())
    chosen = parser.parse_args()
    if chosen.action == "record":
        record(chosen.out, chosen.cases, chosen.workers)
        return 0
    if chosen.action == "compare":
        return 0 if compared(chosen.before, chosen.after) else 1
    options = ["--cases", str(chosen.cases), "--workers", str(chosen.workers)]
    return 0 if of_commits((chosen.before, chosen.after), options) else 1


if __name__ == "__main__":
    sys.exit(main())
