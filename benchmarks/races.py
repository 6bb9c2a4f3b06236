"""What the race is about: contacts whose answer is known, exactly or from fine grids of another method."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path

import cases
import numpy as np

import nonhertz as nh

QUANTITIES = {"approach": "approach", "centre_pressure": "centre pressure", "max_pressure": "maximum pressure"}
FINE = Path(__file__).with_name("logarithmic.json")
Interval = tuple[float, float]


@dataclass(frozen=True)
class Race:
    """A contact to press, the rectangle that plane grids are granted, and the answer with its uncertainty.

    The rectangle holds the contact with little to spare. A program that did not know it would have to look for it.
    Where there are as many cells across as along, they are square, on a square as long as the rectangle.
    """

    title: str
    contact: nh.Contact
    load: float
    tilt: float
    region: tuple[Interval, Interval]
    answer: dict[str, float]
    uncertainty: dict[str, float]
    source: str

    def axes(self, cells: tuple[int, int]) -> tuple[np.ndarray, np.ndarray]:
        """Return the centres of that many cells across and along."""
        return tuple(
            low + (np.arange(count) + 0.5) * (high - low) / count
            for count, (low, high) in zip(cells, self.under(cells), strict=True)
        )

    def under(self, cells: tuple[int, int]) -> tuple[Interval, Interval]:
        """Return the rectangle that so many cells cover."""
        across, (low, high) = self.region
        half = 0.5 * (high - low)
        return (-half, half) if cells[0] == cells[1] else across, (low, high)

    def size(self, cells: tuple[int, int]) -> list[float]:
        """Return the lengths of that rectangle across and along [mm]."""
        return [high - low for low, high in self.under(cells)]

    def gap(self, cells: tuple[int, int]) -> np.ndarray:
        """Return the undeformed gap [mm] at the cells' centres, tilt included."""
        x, y = self.axes(cells)
        return 0.5 * np.outer(x**2, self.contact.curvature(y)) + self.contact.separation(y) - self.tilt * y


def all_races() -> dict[str, Race]:
    """Return the races by name; those whose reference has not been made are left out."""
    races = {"hertz": _ellipse(), "crowned": _crowned()}
    fine = json.loads(FINE.read_text(encoding="utf-8"))["cases"] if FINE.exists() else {}
    return races | {name: logarithmic(name, fine[name]) for name in LOGARITHMIC if name in fine}


# Load, tilt and half the width of the rectangle. The peak at the end of the milder one is 23 % above the middle and
# a plane grid sees it easily; that of the harder one is 71 % above, and narrow.
LOGARITHMIC = {"logarithmic": (40e3, -1e-3, 0.58), "logarithmic, half the load": (20e3, -1e-3, 0.42)}


def logarithmic(name: str, fine: dict | None = None) -> Race:
    """Return a tilted roller with a logarithmic profile, which touches nearly up to an end that bears no load."""
    load, tilt, half = LOGARITHMIC[name]
    contact, _ = cases.contacts()["logarithmic, 40 kN, -1 mrad"]
    fine = fine or {"value": {}, "uncertainty": {}, "method": ""}
    return Race(
        title=f"Logarithmic roller, {load / 1e3:g} kN, {1e3 * tilt:g} mrad",
        contact=contact,
        load=load,
        tilt=tilt,
        region=((-half, half), (-10.0, 10.0)),  # the body's sharp ends are edges of cells
        answer=fine["value"],
        uncertainty=fine["uncertainty"],
        source=fine["method"],
    )


def _ellipse() -> Race:
    radius, load = 360.0, 1e3
    contact = nh.Contact(nh.Body(diameter=20, profile=nh.profile.crown(radius=radius)), nh.Plate())
    exact = nh.hertz.point_contact(radius_x=10, radius_y=radius, compliance=contact.compliance, load=load)
    half_x, half_y = 1.08 * exact.half_width, 1.08 * exact.half_length
    return Race(
        title=f"Hertz ellipse, {exact.ellipticity:.0f} times longer than wide",
        contact=contact,
        load=load,
        tilt=0.0,
        region=((-half_x, half_x), (-half_y, half_y)),
        answer=_answer(exact.approach, exact.max_pressure, exact.max_pressure),
        uncertainty=_answer(1e-5, 1e-6, 1e-6),  # the crown is a circle, Hertz's a parabola
        source="Hertz",
    )


def _crowned() -> Race:
    radius, load, tilt = 4000.0, 3e3, -0.5e-3
    contact = cases.crowned()
    exact = nh.hertz.point_contact(radius_x=10, radius_y=radius, compliance=contact.compliance, load=load)
    # A tilted parabola is the same parabola moved by tilt R, and raised.
    middle, raised = tilt * radius, 0.5 * tilt**2 * radius
    half = 1.08 * exact.half_width
    return Race(
        title=f"Crowned roller, {load / 1e3:g} kN, {1e3 * tilt:g} mrad",
        contact=contact,
        load=load,
        tilt=tilt,
        region=((-half, half), (-10.0, 6.0)),  # from the body's end to as far on the other side of the ellipse
        answer=_answer(exact.approach - raised, float(exact.pressure(-middle)), exact.max_pressure),
        uncertainty=_answer(1e-6, 1e-6, 1e-6),
        source="Hertz, moved along by the tilt",
    )


def _answer(approach: float, centre: float, largest: float) -> dict[str, float]:
    return dict(zip(QUANTITIES, (approach, centre, largest), strict=True))
