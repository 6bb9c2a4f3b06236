"""``nonhertz warm``: compile everything now."""

from __future__ import annotations

import os
import time
import warnings
from collections.abc import Callable
from pathlib import Path

import numpy as np

import nonhertz as nh
from nonhertz.cli import FINE, NOT_KEPT
from nonhertz.cli.printing import Progress
from nonhertz.compiled.files import folders, read, write
from nonhertz.errors import AccuracyWarning


def warm() -> int:
    """Compile everything now, for containers and CI.

    What is compiled is kept on disk for this version, processor and compiler; run it again after an upgrade. The exit
    code is 1 if nothing can be written where it is kept.
    """
    seconds = {}
    with Progress(len(PARTS)) as progress:
        for name, run in PARTS.items():
            progress.announce(name)
            start = time.perf_counter()
            with warnings.catch_warnings(), np.errstate(all="ignore"):
                warnings.simplefilter("ignore", AccuracyWarning)
                run()
            seconds[name] = time.perf_counter() - start
    for name, taken in seconds.items():
        print(f"{name}: {taken:.1f} s")
    for folder in filter(Path.is_dir, folders()):
        print(f"machine code: {sum(each.stat().st_size for each in folder.iterdir()) / 1e6:.1f} MB in {folder}")
    # Where nothing can be written a warning says so, and what to do.
    now = os.urandom(8)
    write("warm", b"", now)
    return FINE if read("warm", b"") == now else NOT_KEPT


def _solve() -> None:
    contact = _contact()
    for element in (nh.SEMI_ELLIPTIC, nh.PARABOLIC):
        nh.solve(contact, load=5e3, tilt=1e-4, element=element)
        nh.solve(contact, approach=5e-3, moment=100.0, element=element, strips=11)
        nh.solve_many(contact, load=[4e3, 5e3], element=element, strips=11)


def _stress() -> None:
    solution = nh.solve(_contact(), load=5e3, strips=11)
    nh.subsurface.extremes(solution, 0.0)
    nh.subsurface.stress(solution, 0.0, 0.0, 0.1, body="b", displacement=True)
    hollow = nh.Contact(nh.Roller(diameter=20, length=20, bore=10), nh.Plate())
    nh.subsurface.stress(nh.solve(hollow, load=5e3, strips=5), 0.0, 0.0, 0.1)


def _plane_grid() -> None:
    solution = nh.patch.solve(_contact(), load=5e3, cells=(12, 16))
    nh.subsurface.stress(solution, 0.0, 0.0, 0.1, body="b", displacement=True)
    nh.subsurface.extremes(solution, 0.0)


def _map() -> None:
    found = nh.contact_map(_contact(), load=(0.0, 5e3), accuracy=0.1, checks=20)
    found.strip_loads(found.at(approach=1e-3))
    found.under(load=1e3)


def _bearing() -> None:
    row = nh.bearing.CylindricalRollerBearing(
        roller=_contact().a, inner=nh.Ring(diameter=40.0), outer=nh.Ring(diameter=-60.0), rollers=6
    )
    nh.bearing.solve(row, radial=2e3, method="slices")
    nh.bearing.solve(row, radial=2e3)


PARTS: dict[str, Callable[[], object]] = {
    "strips": _solve,
    "stress": _stress,
    "life": lambda: nh.life.assess(nh.solve(_contact(), load=5e3, strips=11)),
    "plane grid": _plane_grid,
    "map": _map,
    "bearing": _bearing,
}


def _contact() -> nh.Contact:
    roller = nh.Roller(diameter=10.0, length=10.0, profile=nh.profile.crown(radius=2000.0))
    return nh.Contact(roller, nh.Ring(diameter=40.0, length=12.0, side_faces=("mirror", "none"), depth=5.0))
