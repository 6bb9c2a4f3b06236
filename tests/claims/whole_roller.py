"""The whole roller: models of ends and depth side by side, against three-dimensional finite elements.

A solid roller with free ends is pressed on two opposite sides by semi-elliptic line loads q. How far its surface moves
towards its axis, w, is known from Fourier modes around the axis and spectral elements of degree 8 in a half-plane
through it, graded towards end and surface: no half-space and no image, converged to 1e-6.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from claims.claim import Array, Claim, Evidence, solved
from nonhertz import SEMI_ELLIPTIC, Contact, Material, Plate, Roller
from nonhertz.bodies.influence import HALF_SPACE, Influence, influence_of
from nonhertz.model.depths import DepthRule
from nonhertz.model.side_faces import FaceRule
from nonhertz.strip.influence import displacements

DIAMETER, LENGTH, MODULUS = 20.0, 20.0, 206000.0  # mm, mm, MPa
END = 0.5 * LENGTH


@dataclass(frozen=True)
class Model:
    """How ends and depth of the roller are modelled, and the errors recorded with the finite elements.

    ``errors`` are in per cent of the displacement under a uniform load in the middle, one half-width from the end and
    at the end, then of the compliance against tilting; None where none are recorded.
    """

    name: str
    side_faces: FaceRule
    depth: DepthRule
    errors: tuple[float, float, float, float] | None = None

    def roller(self, poisson: float, images: int | str = 1) -> Roller:
        """Return the solid roller so modelled."""
        return Roller(
            diameter=DIAMETER, length=LENGTH, material=Material(MODULUS, poisson), side_faces=self.side_faces,
            depth=self.depth, images=images,  # type: ignore[arg-type]
        )  # fmt: skip


CHIU_HARTNETT = Model("Chiu & Hartnett's cylinder, mirrored", "mirror", "cylinder", (0.8, -10.7, -17.6, -9.1))
WHOLE = Model("whole roller, free ends", "free", "finite")
MODELS = (
    Model("half-spaces, plane-strain depth", "none", "plane-strain"),
    Model("Reusner: mirrored, plane-strain depth", "mirror", "plane-strain", (-1.5, -12.7, -19.4, -10.9)),
    Model("calibrated images, plane-strain depth", "calibrated", "plane-strain", (-0.9, 0.9, 4.7, -3.7)),
    CHIU_HARTNETT,
    Model("free ends, plane-strain depth", "free", "plane-strain"),
    WHOLE,
)


@dataclass(frozen=True)
class Load:
    """A semi-elliptic line load on two opposite sides, and the displacement w / (K q) at places y by finite elements.

    ``tilting``: proportional to y, with q at the end; else uniform.
    """

    name: str
    poisson: float
    half_width: float  # mm
    tilting: bool
    y: tuple[float, ...]
    moved: tuple[float, ...]


_Y = (0.0, 2.0, 4.0, 5.0, 6.0, 7.0, 8.0, 8.5, 9.0, 9.25, 9.5, 9.75, 9.9, 10.0)
_JUDGED = (0.0, 5.0, 8.0, 9.0, 9.5, 9.75, 9.9, 10.0)
UNIFORM = Load(
    "uniform load", 0.3, 0.5, False, _Y,
    (7.9174, 7.9295, 7.9728, 8.0132, 8.0743, 8.1690, 8.3251, 8.4465, 8.6257, 8.7544, 8.9321, 9.2032, 9.4532, 9.6815),
)  # fmt: skip
TILTING = Load(
    "load proportional to y", 0.3, 0.5, True, _Y,
    (0.0, 1.5764, 3.1594, 3.9568, 4.7622, 5.5824, 6.4347, 6.8874, 7.3804, 7.6570, 7.9739, 8.3724, 8.6912, 8.9622),
)  # fmt: skip
NARROW = Load(
    "uniform load, half-width 0.2 mm", 0.3, 0.2, False, _JUDGED,
    (9.7406, 9.8365, 10.1494, 10.4544, 10.7776, 11.0962, 11.4645, 11.9396),
)  # fmt: skip
PLANE = Load("uniform load, nu = 0", 0.0, 0.5, False, (0.0, 9.5, 10.0), (7.7947,) * 3)
TILT_COMPLIANCE = 270.849  # mm^2: integral of y w / (K q) over half the roller
_ELEMENTS = "three-dimensional finite elements"
_WITHIN, _AT_END = 5e-4, 1e-3
# The strips that carry the load, and where the compliance against tilting is summed up: fine towards the ends.
_OUTER = END - np.geomspace(0.005, 0.12, 14)
_EDGES = np.unique(np.concatenate([np.linspace(-END, END, 161), _OUTER, -_OUTER]))
_ALONG = np.unique(np.concatenate([np.linspace(0.0, END, 161), _OUTER]))

# The hollow roller: length, bore and half-width of the load [mm]. Long enough to be nearly plane in the middle.
_HOLLOW_LENGTH, _BORE, _HOLLOW_WIDTH = 30.0, 18.0, 0.3


def moved(roller: Roller, load: Load, places: Array) -> Array:
    """Return w / (K q) at places y [mm]."""
    middle = 0.5 * (_EDGES[1:] + _EDGES[:-1])
    along = middle / END if load.tilting else np.ones_like(middle)
    return displaced(roller, places, _EDGES, along, load.half_width)


@solved
def whole_moved(load: Load) -> Array:
    """Return w / (K q) of the whole roller at the places of a load."""
    return moved(WHOLE.roller(load.poisson), load, np.array(load.y))


@solved
def errors(model: Model) -> tuple[float, ...]:
    """Return errors in per cent: in the middle, one half-width from the end, at the end, and in tilting."""
    places = np.array((0.0, END - UNIFORM.half_width, END))
    expected = np.interp(places, UNIFORM.y, UNIFORM.moved)
    found = 100.0 * (moved(model.roller(UNIFORM.poisson), UNIFORM, places) / expected - 1.0)
    return (*found.tolist(), 100.0 * (tilt_compliance(model) / TILT_COMPLIANCE - 1.0))


def tilt_compliance(model: Model) -> float:
    """Return the integral of y w / (K q) over half the roller under a load proportional to y [mm^2]."""
    return float(np.trapezoid(_ALONG * moved(model.roller(0.3), TILTING, _ALONG), _ALONG))


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    for load in (UNIFORM, TILTING, NARROW, PLANE):
        yield from _of_whole_roller(load)
    yield Claim(
        f"{WHOLE.name}: compliance against tilting", _ELEMENTS, TILT_COMPLIANCE, lambda: tilt_compliance(WHOLE),
        _WITHIN, "mm^2",
    )  # fmt: skip
    # Without lateral contraction mirrored ends of a cylinder change nothing.
    plane = Evidence(
        f"{CHIU_HARTNETT.name}, all images, nu = 0", "plane strain",
        lambda: moved(CHIU_HARTNETT.roller(0.0, images="series"), PLANE, np.array([0.0, END])),
    )  # fmt: skip
    long = 2.0 * math.log(2.0 * DIAMETER / PLANE.half_width) - 1.0
    yield plane.claim("w at the end over that in the middle", lambda w: w[1] / w[0], 1e-4, expected=1.0)
    yield plane.claim("w / (K q)", lambda w: w[0], 1e-4, expected=long, source="plane strain: 2 ln(4 R / b) - 1")
    # Each side of a ring of bending stiffness E I under two opposite loads P moves by P r^3 (pi/4 - 2/pi) / (2 E I).
    wall, mean = 0.5 * (DIAMETER - _BORE), 0.25 * (DIAMETER + _BORE)
    ring = 6.0 * math.pi * (math.pi / 4.0 - 2.0 / math.pi) * (mean / wall) ** 3
    yield Claim("hollow roller, uniform load: w / (K q) in the middle", "thin ring, plane strain", ring, _hollow, 0.03)
    places = ("in the middle", "one half-width from the end", "at the end", "in tilting")
    for model in MODELS[:-1]:
        # Judged where they are recorded with the finite elements.
        source = "recorded with the finite elements" if model.errors else _ELEMENTS
        yield from Evidence(model.name, source, functools.partial(errors, model)).each(
            [f"error {place}, nu = 0.3" for place in places], 0.3 if model.errors else None, "%",
            expected=model.errors or (0.0,) * 4, absolute=True,
        )  # fmt: skip


def _of_whole_roller(load: Load) -> Iterator[Claim]:
    judged = [place for place, y in enumerate(load.y) if y in _JUDGED and load.moved[place]]
    yield from Evidence(f"{WHOLE.name}, {load.name}", _ELEMENTS, lambda: whole_moved(load)[judged]).each(
        [f"w / (K q) at y = {load.y[place]:g} mm" for place in judged],
        [_WITHIN if load.y[place] < END - 0.1 * load.half_width else _AT_END for place in judged],
        expected=[load.moved[place] for place in judged],
    )  # fmt: skip


def _hollow() -> float:
    """Return w / (K q) of a thin hollow roller in the middle, which ovals."""
    roller = Roller(
        diameter=DIAMETER, length=_HOLLOW_LENGTH, bore=_BORE, material=Material(MODULUS, 0.3), side_faces="free",
        depth="finite",
    )  # fmt: skip
    edges = np.linspace(-0.5 * _HOLLOW_LENGTH, 0.5 * _HOLLOW_LENGTH, 121)
    return float(displaced(roller, np.zeros(1), edges, np.ones(120), _HOLLOW_WIDTH)[0])


def displaced(roller: Roller, places: Array, edges: Array, load: Array, half_width: float) -> Array:
    """Return w / K under a line load: that of roller and plate together, less the plate's.

    Shares in the compliance of the contact are halves, as both are of one material.
    """
    plate = Plate(material=roller.material, side_faces="none", depth="none")
    square = np.full(load.size, half_width**2)
    both, half_spaces = (
        displacements(influence, places, edges, load / square, square, SEMI_ELLIPTIC)
        for influence in (influence_of(Contact(roller, plate), SEMI_ELLIPTIC), Influence(HALF_SPACE))
    )
    return 2.0 * both - half_spaces
