"""The page on the race: every number and every verdict on it comes from the results."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from accuracy_reached import NARROW, PEERS, PROGRAMS, Entry
from races import QUANTITIES

# How many times faster than the best peer strips were hoped to be, on their own and many at once.
HOPED = {"approach": {"strips": 20.0, "batch": 100.0}, "max_pressure": {"strips": 10.0, "batch": 50.0}}
AHEAD = 1.0  # hoped for everywhere else
LABELS = dict(zip(PROGRAMS, ("strips", "strips, many at once", "plane grid", *PEERS), strict=True))
NOT_REACHED = "not reached within the ladder"

INTRODUCTION = """\
# A race

Written by `benchmarks/race.py` (`make bench`); do not edit. Everything was measured in one run of {minutes:.1f}
minutes, on {threads}: {processor}, {cores} cores, load average {load} at the start;
{versions}.
"""

ARRIVALS = """\
## Who arrives first

Time of the cheapest grid with which a program comes as near as asked, and from which on no finer grid of its ladder
leaves it again; nothing is interpolated. In brackets the grid: strips, or cells across and along. The plane grid is
`nonhertz.patch`. Strips, many at once: {cases} loads, up to the one asked for from {less:.0f} % less, in one call of
`solve_many`; the time is divided by their number. There "learnt" is the automatic grid of the first load, whose making
counts, used for all; the error is that of the last. Automatic and learnt grids are named by the `accuracy` they were
asked for.
"""

DRAWINGS = """\
## Error against time

![Error of approach and of maximum pressure against time](race.svg)

Open marks: cells four times as many along as across, and equal strips. Filled: sixteen times as many, and automatic
and learnt grids of strips. Shaded: below what is known of the reference. Errors below 1e-7 are drawn there. A point
can be good by chance, where an error changes sign; the table above asks for more than one point.

![Error of the pressure at x = y = 0 against time](race-centre.svg)
"""

RULES = """\
## What makes it fair

- All plane grids solve the same equations: uniform pressure on the same rectangles, no gap at their centres,
  half-spaces, no periodicity, the load prescribed. Their solutions on a grid are one and the same, which is checked.
- Each is stopped with the loosest tolerance of its own, in steps of the square root of ten, that brings it within
  {approach} of the approach and, anywhere, {pressure} of the maximum pressure of that solution: a tenth of what is
  asked above. The tolerances found are in the tables.
- Plane grids are told where the contact is: their rectangle holds it with a few per cent to spare, and sharp ends are
  edges of cells. Strips are told nothing.
- What a peer can keep between solves (half-space operators, the gap) is made before the clock starts. Strips and this
  package's plane grid are timed from contact to answer.
- The smallest gap is taken off the peers' heights. Of the solvers that ContactMechanics has for a prescribed load, the
  fastest runs, chosen in the play-off below.
- tamaas keeps the pressure of the last call and would start from it: it is set to zero. Its displacement comes without
  its mean; one more product with its operator gives the approach.
- Each program, contact and grid has a process of its own: a call on a small grid, one on this grid, during which
  memory is watched (above what the process held before it), then the median of five runs or more, or of as many as fit
  into a second. A solve expected to take longer is left out.
- All on {threads}. The tamaas of PyPI is built without threads.
- The reference for the logarithmic rollers is made of plane grids alone (`benchmarks/reference.py`). What strips leave
  out where a contact ends counts against them.
"""

SOLVERS = """\
Fastest runs. The least for all contacts together takes "{winner}", which then runs the race. `minimize_proxy` is the
program's own, after Polonsky and Keer. The other two are those of NuMPI, on pressures, that `dual_minimize_proxy`
calls, here with the mean pressure prescribed: after Polonsky and Keer, with restarts, and after Bugnicourt, without.
"""


def page(results: dict[str, Any]) -> Iterator[str]:
    """Yield the page in pieces."""
    computer = results["machine"]
    versions = computer["versions"] | computer["peers"]
    yield INTRODUCTION.format(
        **{key: computer[key] for key in ("processor", "cores", "load")},
        minutes=results["seconds"] / 60,
        threads=_threads(computer["threads"]),
        versions=", ".join(f"{name} {version}" for name, version in versions.items()),
    )
    yield from (f"Without {LABELS[program]}: {reason}.\n" for program, reason in results["missing"].items())
    yield from (f"Failed: {failure}.\n" for failure in results["failures"])
    yield ARRIVALS.format(cases=results["batch"]["cases"], less=100 * results["batch"]["range"])
    yield _table(("contact", "asked", *LABELS.values()), _arrivals(results))
    yield from _narrow_misses(results)
    yield "How many times faster strips arrive, beside what was hoped for:\n"
    yield _table(("contact", "asked", *_ratio_columns()), _ratios(results))
    yield _verdict(results)
    yield DRAWINGS
    yield from _full_size(results["full size"], results["races"])
    limits = {name: _relative(value) for name, value in results["algebraic"].items()}
    yield RULES.format(threads=_threads(computer["threads"]), **limits)
    yield _table(("contact", *QUANTITIES.values(), "each known to", "from"), _references(results))
    yield from _playoff(results["play-off"], results["races"])
    yield from _ladders(results["races"])


def _arrivals(results: dict[str, Any]) -> Iterator[list[str]]:
    for row in results["headlines"]:
        cells = (_arrival(row["cheapest"][program], program in results["missing"]) for program in LABELS)
        yield [results["races"][row["race"]]["title"], _asked(row), *cells]


def _narrow_misses(results: dict[str, Any]) -> Iterator[str]:
    missed = [(row, entry) for row in results["headlines"] for entry in row["narrow misses"]]
    if missed:
        yield f"Cheaper entries that miss by less than {100 * (NARROW - 1.0):.0f} %, and so do not count by little:\n"
        yield "".join(f"- {_near(row, entry, results['races'])}\n" for row, entry in missed)


def _near(row: dict[str, Any], entry: Entry, races: dict[str, Any]) -> str:
    off = f"{entry['error'][row['quantity']] / row['target']:.2f} of what is asked"
    return f"{races[row['race']]['title']}, {_asked(row)}: {_named(entry)}, {_arrival(entry, False)}, errs by {off}"


def _ratio_columns() -> tuple[str, ...]:
    return ("than the best peer", "hoped", "many at once, than the best peer", "hoped", "than the plane grid")


def _ratios(results: dict[str, Any]) -> Iterator[list[str]]:
    for row in results["headlines"]:
        judged = [
            text
            for way, hoped in _hopes(row).items()
            for text in (_times(row[f"{way} against peer"]), _hope(row[f"{way} against peer"], hoped))
        ]
        yield [results["races"][row["race"]]["title"], _asked(row), *judged, _times(row["strips against patch"])]


def _verdict(results: dict[str, Any]) -> str:
    """Return a sentence on the ratios, whichever way they came out."""
    rows = results["headlines"]
    found = [row["strips against peer"] for row in rows if row["strips against peer"] is not None]
    if not found:
        return "No peer can be compared with.\n"
    judged = [(row[f"{way} against peer"] or 0.0) >= hoped for row in rows for way, hoped in _hopes(row).items()]
    return (
        f"Against the best peer the ratio lies between {min(found):.2g} and {max(found):.2g}. What was hoped for is\n"
        f"met in {sum(judged)} of {len(judged)} comparisons with it.\n"
    )


def _hopes(row: dict[str, Any]) -> dict[str, float]:
    """Return what was hoped for: so much of approach on tilted rollers, of the maximum on logarithmic ones."""
    wanted = row["race"] != "hertz" if row["quantity"] == "approach" else row["race"].startswith("logarithmic")
    return HOPED[row["quantity"]] if wanted else dict.fromkeys(("strips", "batch"), AHEAD)


def _full_size(full: dict[str, Any], races: dict[str, Any]) -> Iterator[str]:
    entries = full["entries"]
    if not entries:
        return
    yield f"## Plane grids among themselves: {_grid(entries[0]['grid'])}\n"
    yield f"{races[full['race']]['title']}; the same cells and the same algebraic error for all.\n"
    rows = (
        [_named(entry), _time(entry["time"]), str(entry["runs"]), _memory(entry["memory"]), *_errors(entry)]
        for entry in entries
    )
    yield _table(("program", "time", "runs", "memory", *QUANTITIES.values()), rows)
    own = next((entry for entry in entries if entry["entrant"] == "patch"), None)
    peer = min((e for e in entries if e is not own), key=lambda entry: entry["time"], default=None)
    if own and peer:
        verdict = "no slower than either peer, as hoped" if own["time"] <= peer["time"] else "slower, against the hope"
        yield f"The plane grid takes {own['time'] / peer['time']:.2f} of the time of {_named(peer)}: {verdict}.\n"


def _references(results: dict[str, Any]) -> Iterator[list[str]]:
    for race in results["races"].values():
        answer = race["answer"]
        pressures = (f"{answer[name]:.2f} MPa" for name in ("centre_pressure", "max_pressure"))
        known = ", ".join(_relative(race["uncertainty"][name]) for name in QUANTITIES)
        yield [race["title"], f"{answer['approach']:.8f} mm", *pressures, known, race["source"]]


def _playoff(playoff: dict[str, Any], races: dict[str, Any]) -> Iterator[str]:
    if not playoff["entries"]:
        return
    yield "## The solvers of ContactMechanics\n"
    names = list(dict.fromkeys(entry["entrant"] for entries in playoff["entries"].values() for entry in entries))
    rows = []
    for race, entries in playoff["entries"].items():
        times = {entry["entrant"]: _time(entry["fastest"]) for entry in entries}
        rows.append([races[race]["title"], _grid(entries[0]["grid"]), *(times.get(name, "failed") for name in names)])
    yield _table(("contact", "cells", *(name.partition(": ")[2] for name in names)), rows)
    yield SOLVERS.format(winner=playoff["winner"].partition(": ")[2])


def _ladders(races: dict[str, Any]) -> Iterator[str]:
    yield "## Every entry\n"
    yield "Errors are relative; the tolerance is the program's own. More is in [race.json](race.json).\n"
    for race in races.values():
        yield f"### {race['title']}\n"
        rows = ([*_start(entry), *_errors(entry), _tolerance(entry["tolerance"])] for entry in race["entries"])
        yield _table(("program", "grid", "time", "memory", *QUANTITIES.values(), "tolerance"), rows)


def _table(columns: tuple[str, ...], rows: Any) -> str:
    lines = [columns, ["---"] * len(columns), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def _start(entry: Entry) -> list[str]:
    return [_named(entry), _grid(entry["grid"]), _time(entry["time"]), _memory(entry["memory"])]


def _named(entry: Entry) -> str:
    program, _, variant = entry["entrant"].partition(": ")
    return f"{LABELS[program]}: {variant}" if variant else LABELS[program]


def _errors(entry: Entry) -> list[str]:
    return [_relative(entry["error"][name]) for name in QUANTITIES]


def _asked(row: dict[str, Any]) -> str:
    return f"{QUANTITIES[row['quantity']]} to {_relative(row['target'])}"


def _arrival(entry: Entry | None, absent: bool) -> str:
    if absent:
        return "not there"
    return f"{_time(entry['time'])} ({_grid(entry['grid'])})" if entry else NOT_REACHED


def _times(value: float | None) -> str:
    return "-" if value is None else f"{value:.0f} times" if value >= 100 else f"{value:.2g} times"


def _hope(value: float | None, hoped: float) -> str:
    return f"{hoped:g}: {'open' if value is None else 'met' if value >= hoped else 'missed'}"


def _relative(value: float | None) -> str:
    if value is None:
        return "-"
    return f"{100 * value:.2g} %" if value >= 0.95e-3 else f"{value:.1e}".replace("e-0", "e-").replace(".0e", "e")


def _tolerance(value: float | None) -> str:
    return "-" if value is None else f"{value:.1e}".replace("e-0", "e-")


def _grid(grid: Any) -> str:
    if isinstance(grid, str):
        return grid
    return f"{grid} strips" if isinstance(grid, int) else " x ".join(map(str, grid))


def _time(seconds: float) -> str:
    if seconds >= 1.0:
        return f"{seconds:.3g} s"
    return f"{1e3 * seconds:.0f} ms" if seconds >= 0.1 else f"{1e3 * seconds:.3g} ms"


def _memory(size: int) -> str:
    return f"{size / 2**20:.3g} MB" if size >= 2**20 else "under 1 MB"


def _threads(count: int) -> str:
    return "one thread" if count == 1 else f"{count} threads"
