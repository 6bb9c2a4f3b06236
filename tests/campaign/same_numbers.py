"""Whether two states of the package give the same numbers: campaign cases, examples, and the checks of `verify`.

The states are two source trees. Each is recorded by itself, with this folder's cases, and the records are compared:

    PYTHONPATH=/before/src python tests/campaign/same_numbers.py record /tmp/before.jsonl
    PYTHONPATH=src         python tests/campaign/same_numbers.py record /tmp/after.jsonl
    python tests/campaign/same_numbers.py compare /tmp/before.jsonl /tmp/after.jsonl

A record is a line: what it is of, how it ended, and its numbers by name.
"""

import argparse
import contextlib
import io
import json
import math
import multiprocessing
import os
import sys
from collections import defaultdict
from itertools import chain
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
CAMPAIGNS = ("practice_cases", "extreme_cases")
COMMANDS = ("solve", "stress", "life")
SAME = 1e-12
# Of a case that took its time, and of the release that made the file.
NOT_COMPARED = ("seconds", "version", "format", ".case")


def flattened(value, name=""):
    """Yield name and value of every number, word and flag within nested lists and dictionaries."""
    if isinstance(value, dict | list):
        parts = value.items() if isinstance(value, dict) else enumerate(value)
        for key, inner in parts:
            yield from flattened(inner, f"{name}.{key}")
    else:
        yield name, value


def case_record(work):
    """Return the record of a case of a campaign."""
    import campaign_run
    import numpy as np

    campaign, number = work
    ending = campaign_run.solved(campaign_run.generator(campaign)(number))
    found = {"of": f"{campaign} {number}", "ended": f"{ending.kind} {ending.words}", "numbers": {}}
    if ending.solution is not None:
        solution, names = ending.solution, ("approach", "tilt", "load", "moment", "max_pressure", "max_half_width")
        found["numbers"] = {name: float(getattr(solution, name)) for name in names}
        found["numbers"] |= dict(flattened(np.asarray(solution.stiffness).tolist(), "stiffness"))
        for name in ("edges", "line_load", "half_width", "gap"):
            row = np.asarray(getattr(solution, name))
            row = row[np.isfinite(row)]
            found["numbers"] |= {f"{name}.count": row.size, f"{name}.sum": math.fsum(row), f"{name}.squares": row @ row}
    return found


def command_record(work):
    """Return the record of what a command tells of an example."""
    from nonhertz.cli import main

    command, case = work
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(io.StringIO()):
        try:
            code = main([command, str(case), "--json"])
        except SystemExit as ended:
            code = ended.code
    text = printed.getvalue()
    return {
        "of": f"{command} {case.name}",
        "ended": str(code or 0),
        "numbers": dict(flattened(json.loads(text))) if text else {},
    }


def check_records():
    """Yield the records of the checks of `verify`, but for those that measure time."""
    from nonhertz.cli import main
    from nonhertz.verify import CATALOGUE

    printed, numbers_of = io.StringIO(), defaultdict(int)
    with contextlib.redirect_stdout(printed), contextlib.redirect_stderr(io.StringIO()):
        main(["verify", "--json", "--only", *(name for name in CATALOGUE if name != "cost")])
    for check in json.loads(printed.getvalue()):
        section, numbers = check["section"], {name: check[name] for name in ("expected", "computed")}
        yield {"of": f"verify {section} {numbers_of[section]}", "ended": check["verdict"], "numbers": numbers}
        numbers_of[section] += 1


def _number(value):
    return None if value is None else value if isinstance(value, str | bool | int) else float(value)


def record(out, cases, workers):
    """Write the records of one state of the package."""
    import nonhertz

    print(f"recording {Path(nonhertz.__file__).parent}", flush=True)
    numbered = [(campaign, number) for campaign in CAMPAIGNS for number in range(cases)]
    contacts = [case for case in sorted(EXAMPLES.glob("*.toml")) if "[body.a]" in case.read_text(encoding="utf-8")]
    examples = [(command, case) for command in COMMANDS for case in contacts]
    with multiprocessing.get_context("spawn").Pool(workers) as pool, out.open("w") as lines:
        solved = pool.imap_unordered(case_record, numbered, chunksize=20)
        for found in chain(map(command_record, examples), check_records(), solved):
            found["numbers"] = {name: _number(value) for name, value in found["numbers"].items()}
            lines.write(json.dumps(found) + "\n")


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
    recording.add_argument("--cases", type=int, default=10_000, help="of each campaign")
    recording.add_argument("--workers", type=int, default=os.cpu_count())
    comparing = actions.add_parser("compare", help="compare the numbers of two states")
    comparing.add_argument("before", type=Path)
    comparing.add_argument("after", type=Path)
    chosen = parser.parse_args()
    if chosen.action == "record":
        record(chosen.out, chosen.cases, chosen.workers)
        return 0
    return 0 if compared(chosen.before, chosen.after) else 1


if __name__ == "__main__":
    sys.exit(main())
