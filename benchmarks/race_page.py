"""The page on the race: every number and every verdict on it comes from the results."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from accuracy_reached import PEERS, PROGRAMS, Entry
from entrants import DEAREST, LEARNT
from races import QUANTITIES

# How many times faster than the best peer strips are meant to be, on their own and many at once.
TARGETS = {"approach": {"strips": 20.0, "batch": 100.0}, "max_pressure": {"strips": 10.0, "batch": 50.0}}
AHEAD = 1.0  # the target everywhere else
LABELS = dict(zip(PROGRAMS, ("strips", "strips, many at once", "plane grid", *PEERS), strict=True))
RATIOS = ("strips : peer", "many : peer")
NOT_REACHED = "not reached"

INTRODUCTION = """\
# Race against other programs

Measured by `benchmarks/race.py` (`make bench`). One run of {minutes:.1f} minutes on {threads}: {processor},
{cores} cores, load average {load}; {versions}.
"""

ARRIVALS = """\
## Time to reach a given accuracy

Time [ms] of the cheapest grid that meets the target, as all finer grids of the same program must. In brackets the
grid: strips (automatic grids by their `accuracy`), or cells across and along. The plane grid is `nonhertz.patch`. Many
at once: {cases} loads, up to {less:.0f} % apart, in one `solve_many`, the time for each; "reused" is the automatic grid
of the middle load. The last columns: how many times as fast as the best peer strips are (target in brackets).
"""

DRAWINGS = """\
## Error against time

![Error of approach and of maximum pressure against time](race.svg)

Filled: automatic and reused grids, and sixteen times as many cells along as across. Open: equal strips, four times as
many, and as many (ASPHER). Shaded: below the uncertainty of the reference. All entries: [race.json](race.json);
errors at the centre: [race-centre.svg](race-centre.svg).
"""

RULES = """\
## Rules

- All plane grids solve the same equations on the same cells, rectangles of uniform pressure on half-spaces, and their
  solutions are checked to agree.
- Each has its loosest tolerance that ends within {approach} of the converged approach and {pressure} of the maximum
  pressure on its grid, a tenth of the target.
- Plane grids get a rectangle that just encloses the contact, with sharp ends on edges of cells; strips find it. ASPHER
  has only square cells on a square as long as the rectangle, and no part in the common grid.
- Set-up that a peer can reuse is not timed; ours is.
- ContactMechanics and ASPHER run their fastest solver for a prescribed load: {winners}.
  tamaas starts from zero pressure. All are as pip installs them; pip builds ASPHER on this machine.
- Each program, contact and grid has its own process: the median of at least five runs after a first, or of as many as
  fit into a second. Solves over {dearest} s are left out.
- The reference of the logarithmic rollers comes from plane grids alone (`benchmarks/reference.py`).
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
    yield _table(("contact", "accuracy", *LABELS.values(), *RATIOS), _arrivals(results))
    yield _verdict(results)
    yield DRAWINGS
    yield from _full_size(results["full size"], results["races"])
    limits = {name: _relative(value) for name, value in results["algebraic"].items()}
    winners = " and ".join(f'"{each.partition(": ")[2]}"' for each in results["play-off"]["winners"].values())
    yield RULES.format(winners=winners, dearest=DEAREST, **limits)
    yield _table(("contact", *QUANTITIES.values(), "each known to", "from"), _references(results))


def _arrivals(results: dict[str, Any]) -> Iterator[list[str]]:
    before = None
    for row in results["headlines"]:
        # The contact stands in the first of its rows.
        title = "" if row["race"] == before else results["races"][row["race"]]["title"]
        before = row["race"]
        cells = (_arrival(row["cheapest"][program], program in results["missing"]) for program in LABELS)
        judged = [f"{_times(row[f'{way} against peer'])} ({target:g})" for way, target in _targets(row).items()]
        yield [title, _asked(row), *cells, *judged]


def _verdict(results: dict[str, Any]) -> str:
    """Return a sentence on the ratios, whichever way they came out."""
    rows = results["headlines"]
    ratios = [row["strips against peer"] for row in rows if row["strips against peer"] is not None]
    if not ratios:
        return "No peer can be compared with.\n"
    judged = [(row[f"{way} against peer"] or 0.0) >= target for row in rows for way, target in _targets(row).items()]
    least, most = (_times(ratio) for ratio in (min(ratios), max(ratios)))
    met = f"{sum(judged)} of {len(judged)}"
    return f"The ratio to the best peer is {least} to {most}; {met} comparisons meet the target.\n"


def _targets(row: dict[str, Any]) -> dict[str, float]:
    """Return the targets: for the approach those of tilted rollers, for the maximum those of logarithmic ones."""
    hard = row["race"] != "hertz" if row["quantity"] == "approach" else row["race"].startswith("logarithmic")
    return TARGETS[row["quantity"]] if hard else dict.fromkeys(("strips", "batch"), AHEAD)


def _full_size(full: dict[str, Any], races: dict[str, Any]) -> Iterator[str]:
    entries = full["entries"]
    if not entries:
        return
    yield f"## Plane grids on {_grid(entries[0]['grid'])} cells\n"
    yield f"{races[full['race']]['title']}; the same cells and algebraic error for all.\n"
    rows = (
        [_named(entry), _time(entry["time"]), str(entry["runs"]), _memory(entry["memory"]), *_errors(entry)]
        for entry in entries
    )
    yield _table(("program", "time", "runs", "memory", *QUANTITIES.values()), rows)
    own = next((entry for entry in entries if entry["entrant"] == "patch"), None)
    peer = min((e for e in entries if e is not own), key=lambda entry: entry["time"], default=None)
    if own and peer:
        verdict = "faster than either peer" if own["time"] <= peer["time"] else "slower"
        yield f"The plane grid takes {own['time'] / peer['time']:.2f} of the time of {_named(peer)}: {verdict}.\n"


def _references(results: dict[str, Any]) -> Iterator[list[str]]:
    for race in results["races"].values():
        answer = race["answer"]
        pressures = (f"{answer[name]:.2f} MPa" for name in ("centre_pressure", "max_pressure"))
        known = ", ".join(_relative(race["uncertainty"][name]) for name in QUANTITIES)
        yield [race["title"], f"{answer['approach']:.8f} mm", *pressures, known, race["source"]]


def _table(columns: tuple[str, ...], rows: Any) -> str:
    lines = [columns, ["---"] * len(columns), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


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
    return f"{_milliseconds(entry['time'])} ({_grid(entry['grid'])})" if entry else NOT_REACHED


def _times(value: float | None) -> str:
    return "-" if value is None else f"{value:.0f}" if value >= 100 else f"{value:.2g}"


def _relative(value: float | None) -> str:
    if value is None:
        return "-"
    return f"{100 * value:.2g} %" if value >= 0.95e-3 else f"{value:.1e}".replace("e-0", "e-").replace(".0e", "e")


def _grid(grid: Any) -> str:
    if isinstance(grid, str):
        return grid.replace(LEARNT, "reused")
    return str(grid) if isinstance(grid, int) else " x ".join(map(str, grid))


def _time(seconds: float) -> str:
    return f"{seconds:.3g} s" if seconds >= 1.0 else f"{_milliseconds(seconds)} ms"


def _milliseconds(seconds: float) -> str:
    return f"{1e3 * seconds:.0f}" if seconds >= 0.1 else f"{1e3 * seconds:.3g}"


def _memory(size: int) -> str:
    return f"{size / 2**20:.3g} MB" if size >= 2**20 else "under 1 MB"


def _threads(count: int) -> str:
    return "one thread" if count == 1 else f"{count} threads"
