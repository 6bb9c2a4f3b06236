"""Who comes as near as asked, with what, and how much faster than whom."""

from __future__ import annotations

from typing import Any

import numpy as np
from entrants import TO

ASKED = {"approach": 1e-4, "max_pressure": 0.02}
PEERS = ("tamaas", "ContactMechanics", "ASPHER")
NARROW = 1.25  # times what is asked
PROGRAMS = ("strips", "batch", "patch", *PEERS)

Entry = dict[str, Any]


def headlines(results: dict[str, Any]) -> list[dict[str, Any]]:
    """Return, for each contact and each accuracy asked, the cheapest entry of each program, and the ratios."""
    rows = []
    for name, race in results["races"].items():
        for quantity, target in ASKED.items():
            best = {program: cheapest(entries_of(race, program), quantity, target) for program in PROGRAMS}
            peers = [best[program] for program in PEERS if best[program]]
            peer = min(peers, key=lambda entry: entry["time"], default=None)
            rows.append({
                "race": name,
                "quantity": quantity,
                "target": target,
                "cheapest": {program: _short(entry) for program, entry in best.items()},
                "narrow misses": [
                    _short(entry)
                    for program, first in best.items()
                    if (entry := cheapest(entries_of(race, program), quantity, NARROW * target)) is not first
                ],
                "strips against peer": ratio(peer, best["strips"]),
                "batch against peer": ratio(peer, best["batch"]),
            })  # fmt: skip
    return rows


def entries_of(race: dict[str, Any], program: str) -> list[Entry]:
    """Return a program's ladder; of strips the semi-elliptic ones, which have no error of their own."""
    wanted = f"{program}: semi-elliptic" if program in {"strips", "batch"} else program
    return [entry for entry in race["entries"] if entry["entrant"].startswith(wanted)]


def cheapest(entries: list[Entry], quantity: str, target: float) -> Entry | None:
    """Return the fastest entry within the target that no finer grid of the same program leaves again."""
    reached = [entry for entry in entries if all(within(other, quantity, target) for other in _from(entry, entries))]
    return min(reached, key=lambda entry: entry["time"], default=None)


def within(entry: Entry, quantity: str, target: float) -> bool:
    """Return whether an entry is as near as asked."""
    error = entry["error"][quantity]
    return error is not None and error <= target


def ratio(slow: Entry | None, fast: Entry | None) -> float | None:
    """Return how many times longer the first takes, if both arrive."""
    return slow["time"] / fast["time"] if slow and fast else None


def _from(entry: Entry, entries: list[Entry]) -> list[Entry]:
    return [other for other in entries if other is entry or _finer(other["grid"], entry["grid"])]


def _finer(one: Any, other: Any) -> bool:
    if isinstance(one, str) and isinstance(other, str):
        (kind, _, accuracy), (other_kind, _, wider) = one.partition(TO), other.partition(TO)
        return kind == other_kind and float(accuracy) < float(wider)
    if isinstance(one, str) or isinstance(other, str):
        return False
    return one != other and bool(np.all(np.asarray(one) >= np.asarray(other)))


def _short(entry: Entry | None) -> Entry | None:
    return {key: entry[key] for key in ("entrant", "grid", "time", "error")} if entry else None
