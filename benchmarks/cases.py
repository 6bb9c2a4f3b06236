"""The contacts whose speed is measured, and how the linear algebra is kept on one core."""

from __future__ import annotations

import subprocess
import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import numpy as np
import scipy.linalg  # noqa: F401  (a limit of threads holds for the linear algebra that is loaded by then)
from threadpoolctl import threadpool_limits

import nonhertz as nh

Solve = Callable[[], nh.Solution]

HALF_SPACE: dict[str, Any] = {"side_faces": "none", "depth": "none"}
STRIPS, FIXED_TARGET, AUTOMATIC_TARGET, HELP_TARGET = 41, 1.5e-3, 3e-3, 0.5  # s
MANY, MANY_TARGET, GAIN_TARGET = 2000, 0.5e-3, 1.8  # cases; s each on one thread; times that on two
FINITE_TARGET = 3.5  # times the half-spaces
POINTS, STRIPS_ABOVE, BELOW_TARGET = 100_000, 81, 5.0  # points below so many strips; s on two threads


def crowned(extent: dict[str, Any] = HALF_SPACE) -> nh.Contact:
    """Return the crowned roller of the tutorial on its plate, half-spaces unless told otherwise."""
    return _on_plate(nh.profile.crown(radius=4000), extent)


def fixed(strips: int | str, extent: dict[str, Any] = HALF_SPACE) -> Solve:
    """Return a solve of the crowned roller on that many equal strips, or on the automatic grid."""
    contact = crowned(extent)
    return lambda: nh.solve(contact, load=20e3, strips=strips)


def many() -> dict[str, Callable[[int], nh.Solutions]]:
    """Return solves of many cases on equal strips by name, as functions of the number of threads."""
    contact, rng = crowned(), np.random.default_rng(1)
    sweep = {"load": np.linspace(5e3, 30e3, MANY), "tilt": 3e-4}
    scattered = {"load": rng.uniform(5e3, 30e3, MANY), "tilt": rng.uniform(-1e-3, 1e-3, MANY)}
    return {
        "loads and tilts at random": lambda threads: nh.solve_many(
            contact, **scattered, strips=STRIPS, threads=threads
        ),
        "a sweep of loads": lambda threads: nh.solve_many(contact, **sweep, strips=STRIPS, threads=threads),
    }


def below() -> dict[str, Callable[[int], object]]:
    """Return by name what is evaluated below a tilted logarithmic roller, as functions of the number of threads.

    Points are at random in a block that is as long as the roller and three half-widths deep.
    """
    profile = nh.profile.iso_logarithmic(diameter=20, length=20)
    rng = np.random.default_rng(1)

    def solution(extent: dict[str, Any], strips: int | str) -> nh.Solution:
        return nh.solve(_on_plate(profile, extent), load=20e3, tilt=0.5e-3, strips=strips)

    half_spaces, finite = (solution(extent, STRIPS_ABOVE) for extent in (HALF_SPACE, {}))
    half_width = float(finite.half_width.max())
    scale = np.array([2.0 * half_width, 20.0, 3.0 * half_width])
    points = (rng.random((3, POINTS)).T * scale - [half_width, 10.0, 0.0]).T
    automatic = solution({}, "auto")
    cells = nh.patch.solve(automatic.contact, load=20e3, tilt=0.5e-3)
    stress, extremes = nh.subsurface.stress, nh.subsurface.extremes
    return {
        f"{POINTS} points, {STRIPS_ABOVE} strips, half-space": lambda threads: stress(
            half_spaces, *points, threads=threads
        ),
        f"{POINTS} points, {STRIPS_ABOVE} strips, both faces mirrored": lambda threads: stress(
            finite, *points, threads=threads
        ),
        f"{POINTS} points, 128 x 512 cells, both faces mirrored": lambda threads: stress(
            cells, *points, threads=threads
        ),
        "largest stresses, automatic strips": lambda threads: extremes(automatic, threads=threads),
        "lives by all models, automatic strips": lambda threads: nh.life.assess(automatic, threads=threads, body="b"),
    }


def automatic() -> dict[str, Solve]:
    """Return solves between half-spaces on the automatic grid by name."""
    return {name: solving(contact, **prescribed) for name, (contact, prescribed) in contacts().items()}


def against_finite() -> dict[str, tuple[Solve, Solve]]:
    """Return pairs of solves by name: between half-spaces, and with faces and depth on both bodies."""
    pairs = {f"{STRIPS} equal strips: crown 4000, 20 kN": (crowned(), {"load": 20e3, "strips": STRIPS})} | contacts()
    return {
        name: (solving(contact, **prescribed), solving(made_finite(contact), **prescribed))
        for name, (contact, prescribed) in pairs.items()
    }


def solving(contact: nh.Contact, **prescribed: Any) -> Solve:
    """Return a solve of a contact."""
    return lambda: nh.solve(contact, **prescribed)


def made_finite(contact: nh.Contact) -> nh.Contact:
    """Return the contact with four faces at places of their own and a depth in either body."""
    low, high = contact.interval
    length = high - low if np.isfinite(high - low) else 20.0
    longer = {"side_faces": "mirror", "length": 1.2 * length}
    a = replace(contact.a, **(longer if contact.a.length is None else {"side_faces": "mirror"}), depth="plane-strain")
    return nh.Contact(a, replace(contact.b, **longer, depth=10.0))


def contacts() -> dict[str, tuple[nh.Contact, dict[str, float]]]:
    """Return contacts of half-spaces with what is prescribed, by name."""
    logarithmic = _on_plate(nh.profile.logarithmic(amplitude=0.005, length=20, fraction=0.9999), HALF_SPACE)
    straight, crown = _on_plate(nh.profile.straight(), HALF_SPACE), crowned()
    bearing = nh.Contact(
        nh.Roller(
            diameter=9,
            length=10,
            effective_length=8.8,
            profile=nh.profile.iso_logarithmic(diameter=9, length=8.8),
            **HALF_SPACE,
        ),
        nh.Ring(diameter=37.5),
    )
    ellipse = nh.Contact(nh.Body(diameter=20, profile=nh.profile.crown(radius=100)), nh.Plate())
    return {
        "crown 4000, 20 kN": (crown, {"load": 20e3}),
        "crown 4000, 20 kN, 0.5 mrad": (crown, {"load": 20e3, "tilt": 0.5e-3}),
        "logarithmic, 40 kN, -1 mrad": (logarithmic, {"load": 40e3, "tilt": -1e-3}),
        "logarithmic, 20 kN, 5 N m": (logarithmic, {"load": 20e3, "moment": 5e3}),
        "straight, 20 kN": (straight, {"load": 20e3}),
        "bearing roller, ISO profile, 4.2 kN, 0.5 mrad": (bearing, {"load": 4.2e3, "tilt": 0.5e-3}),
        "Hertz ellipse, unbounded bodies, 1 kN": (ellipse, {"load": 1e3}),
    }


def command(*words: str) -> Callable[[], None]:
    """Return a function that runs a fresh Python with these arguments."""

    def run() -> None:
        subprocess.run([sys.executable, *words], check=True, stdout=subprocess.DEVNULL)

    return run


@contextmanager
def one_thread() -> Iterator[None]:
    """Keep linear algebra on one thread, and the accuracy warnings of the cases to themselves."""
    with threadpool_limits(limits=1), warnings.catch_warnings():
        warnings.simplefilter("ignore", nh.AccuracyWarning)
        yield


def _on_plate(profile: nh.profile.Profile, extent: dict[str, Any]) -> nh.Contact:
    return nh.Contact(nh.Roller(diameter=20, length=20, profile=profile, **extent), nh.Plate())
