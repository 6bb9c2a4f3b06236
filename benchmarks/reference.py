"""Make logarithmic.json, the converged answers for the rollers that have no closed form.

    python benchmarks/reference.py

Uniform rectangles on plane grids by ContactMechanics (in its padded FFT form), with tamaas as a witness on one grid;
nothing comes from strips. From a base grid the cells are halved across, and along. Each direction's last change,
d, adds d / 3 to the finest value (errors fall with the square of the cell) and 2/3 |d| to the uncertainty, so that
the uncertainty does not rest on the order. Takes about five minutes.
"""

from __future__ import annotations

import json
import time
from typing import Any

import entrants
import races

ACROSS = [(count, 2048) for count in (32, 64, 128, 256)]
ALONG = [(64, count) for count in (1024, 2048, 4096, 8192)]
BASE = (64, 2048)
WITNESSED = (64, 1024)
PROGRAM, WITNESS = "ContactMechanics: with restart", "tamaas"
TOLERANCE = 1e-7
ROUNDING = 1e-6


def main() -> None:
    """Solve, extrapolate, write."""
    made = {name: made_reference(name) for name in races.LOGARITHMIC}
    document = {"made by": "benchmarks/reference.py", "versions": entrants.versions(), "cases": made}
    races.FINE.write_text(json.dumps(document, indent=1) + "\n", encoding="utf-8")


def made_reference(name: str) -> dict[str, Any]:
    """Return values, uncertainties and every grid behind them."""
    race = races.logarithmic(name)
    grids = {cells: solved(race, cells) for cells in dict.fromkeys((*ACROSS, *ALONG))}
    witness = solved(race, WITNESSED, WITNESS)
    differs = {key: abs(value / grids[WITNESSED][key] - 1.0) for key, value in witness.items()}
    found = {key: extrapolated(grids, key) for key in races.QUANTITIES}
    finest = " and ".join(f"{across} x {along}" for across, along in (ACROSS[-1], ALONG[-1]))
    return {
        "method": f"rectangles up to {finest}, extrapolated",
        "value": {key: value for key, (value, _) in found.items()},
        "uncertainty": {key: uncertainty for key, (_, uncertainty) in found.items()},
        f"{WITNESS} differs by": differs,
        "grids": {f"{across} x {along}": entry for (across, along), entry in grids.items()},
    }


def solved(race: races.Race, cells: entrants.Cells, program: str = PROGRAM) -> dict[str, float]:
    """Return approach, centre pressure and the maximum pressure on the centre line."""
    start = time.perf_counter()
    answer = entrants.prepared(program, race, cells, threads=1)(TOLERANCE)
    found = {
        "approach": answer.approach,
        "centre_pressure": answer.centre_pressure,
        # On the centre line, which lies between rows of cells.
        "max_pressure": float(entrants.at_zero(race.axes(cells)[0], answer.pressure).max()),
    }
    print(program, cells, f"{time.perf_counter() - start:.1f} s", found, flush=True)
    return found


def extrapolated(grids: dict[entrants.Cells, dict[str, float]], key: str) -> tuple[float, float]:
    """Return the value without cells, and its relative uncertainty."""
    across = grids[ACROSS[-1]][key] - grids[ACROSS[-2]][key]
    along = grids[ALONG[-1]][key] - grids[ALONG[-2]][key]
    # The finest along is coarse across: only what it changed is taken over.
    finest = grids[ACROSS[-1]][key] + grids[ALONG[-1]][key] - grids[BASE][key]
    doubt = 2.0 / 3.0 * (abs(across) + abs(along))
    return finest + (across + along) / 3.0, doubt / finest + ROUNDING


if __name__ == "__main__":
    main()
