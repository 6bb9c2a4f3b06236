"""The whole roller: what models of its ends and of its depth say, beside three-dimensional finite elements."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from nonhertz import life
from nonhertz.bodies.depths import DepthRule
from nonhertz.bodies.influence import HALF_SPACE, Influence, influence_of
from nonhertz.bodies.sides import FaceRule
from nonhertz.errors import without_accuracy_warnings
from nonhertz.hertz import line_contact
from nonhertz.model.body import Plate, Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.plot.style import END_DASHES, FAINT_INK, FIRST, INK, SECOND
from nonhertz.solver.one import solve
from nonhertz.strip.element import SEMI_ELLIPTIC
from nonhertz.strip.influence import displacements
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]

DIAMETER, LENGTH, MODULUS = 20.0, 20.0, 206000.0  # mm, mm, MPa
END = 0.5 * LENGTH


@dataclass(frozen=True)
class _Model:
    """How ends and depth of the roller are modelled, and the errors recorded with the finite elements.

    ``errors`` are in per cent of the displacement under a uniform load in the middle, one half-width from the end and
    at the end, then of the compliance against tilting; None where none are recorded.
    """

    name: str
    side_faces: FaceRule
    depth: DepthRule
    style: tuple[str, str | tuple[object, ...]]
    errors: tuple[float, float, float, float] | None = None

    def roller(self, poisson: float, images: int | str = 1) -> Roller:
        """Return the solid roller so modelled."""
        return Roller(
            diameter=DIAMETER, length=LENGTH, material=Material(MODULUS, poisson), side_faces=self.side_faces,
            depth=self.depth, images=images,  # type: ignore[arg-type]
        )  # fmt: skip


_CHIU_HARTNETT = _Model(
    "Chiu & Hartnett's cylinder, mirrored", "mirror", "cylinder", (SECOND, "--"), (0.8, -10.7, -17.6, -9.1)
)
_WHOLE = _Model("whole roller, free ends", "free", "finite", (FIRST, "-"))
_MODELS = (
    _Model("half-spaces, plane-strain depth", "none", "plane-strain", (FAINT_INK, ":")),
    _Model(
        "Reusner: mirrored, plane-strain depth", "mirror", "plane-strain", (SECOND, "-"), (-1.5, -12.7, -19.4, -10.9)
    ),
    _Model("calibrated images, plane-strain depth", "calibrated", "plane-strain", (INK, "--"), (-0.9, 0.9, 4.7, -3.7)),
    _CHIU_HARTNETT,
    _Model("free ends, plane-strain depth", "free", "plane-strain", (INK, END_DASHES)),
    _WHOLE,
)


@dataclass(frozen=True)
class _Load:
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
_UNIFORM = _Load(
    "uniform load", 0.3, 0.5, False, _Y,
    (7.9174, 7.9295, 7.9728, 8.0132, 8.0743, 8.1690, 8.3251, 8.4465, 8.6257, 8.7544, 8.9321, 9.2032, 9.4532, 9.6815),
)  # fmt: skip
_TILTING = _Load(
    "load proportional to y", 0.3, 0.5, True, _Y,
    (0.0, 1.5764, 3.1594, 3.9568, 4.7622, 5.5824, 6.4347, 6.8874, 7.3804, 7.6570, 7.9739, 8.3724, 8.6912, 8.9622),
)  # fmt: skip
_NARROW = _Load(
    "uniform load, half-width 0.2 mm", 0.3, 0.2, False, _JUDGED,
    (9.7406, 9.8365, 10.1494, 10.4544, 10.7776, 11.0962, 11.4645, 11.9396),
)  # fmt: skip
_PLANE = _Load("uniform load, nu = 0", 0.0, 0.5, False, (0.0, 9.5, 10.0), (7.7947,) * 3)
_TILT_COMPLIANCE = 270.849  # mm^2: integral of y w / (K q) over half the roller
_ELEMENTS = "three-dimensional finite elements"
_RECORDED = "recorded with the finite elements"
_WITHIN, _AT_END = 3e-3, 1e-2
_POINTS = 0.3  # percentage points
# The strips that carry the load, and where the compliance against tilting is summed up: fine towards the ends.
_OUTER = END - np.geomspace(0.005, 0.12, 14)
_EDGES = np.unique(np.concatenate([np.linspace(-END, END, 161), _OUTER, -_OUTER]))
_ALONG = np.unique(np.concatenate([np.linspace(0.0, END, 161), _OUTER]))

# The hollow roller: length, bore and half-width of the load [mm]. Long enough to be nearly plane in the middle.
_HOLLOW_LENGTH, _BORE, _HOLLOW_WIDTH = 30.0, 18.0, 0.3

RING, LOAD, TILT, ROLLERS = 80.0, 20000.0, 0.3e-3, 14
_FRACTIONS = (0.1, 0.25, 0.5)  # of the half-width of Hertz's line contact, from the end

_TEXT = """\
A solid roller of {diameter:g} x {length:g} mm with free ends is pressed on two opposite sides by semi-elliptic line
loads q. How far its surface moves towards its axis, w, is known from three-dimensional finite elements: Fourier modes
around the axis, spectral elements of degree 8 in a half-plane through it, graded towards end and surface, no half-space
and no image; converged to 1e-6. Beside them stand, with the same strips and loads:

- **half-spaces**: nothing is done about the ends;
- **Reusner** (dissertation, Karlsruhe 1977; Ball Bearing Journal 230 (1987) 2-10) and de Mul, Kalker and Vree (1998):
  mirrored ends (here with depth of plane strain, not a diameter as in the latter, which is softer still);
- **calibrated images**, of the weight that comes nearest to a free end;
- **Chiu and Hartnett** (Journal of Tribology 109 (1987) 479-485, doi:10.1115/1.3261480): a cylinder of infinite length
  that deforms as a whole, its ends mirrored;
- **free ends**, exactly, but with the depth of plane strain;
- **the whole roller**: `side_faces = "free"`, `depth = "finite"`.

Errors in per cent of w, half-width b = 0.5 mm: in the middle, one half-width from the end, at the end; last, in the
compliance against tilting, the integral of y w under a load proportional to y.

{errors}

**Found.** The whole roller is within {whole:.2f} % of finite elements at every place listed below but the very end,
there within {whole_end:.2f} %, and within {whole_tilt:.2f} % of the compliance against tilting. In the middle no model
is off by more than {middle:.1f} %. Towards the end mirroring leaves a roller too stiff, with Chiu and Hartnett's
cylinder ({chiu:.1f} % at the end) nearly as much as with a plane-strain depth ({reusner:.1f} %): what is missing is the
free end, not the girth. Without lateral contraction it is the other way round. Every slice of the roller is then in
plane strain, and mirrored ends are exact; freed ends above a plane-strain depth make the end too soft by
{free_plane:.1f} %, because the reference point is taken to move as with images alone. Calibrated images come near by
having been fitted to pressures, but are {calibrated:.1f} % off in tilting. A hollow roller, {hollow_length:g} mm long
with a bore of {bore:g} mm, ovals as a thin ring does, within {ring:.1f} %.

The same in contact: the roller, straight, on an unbounded ring of {ring_diameter:g} mm, {load:g} kN. Pressures are at
{fractions} of b = {half_width:.3f} mm (Hertz's line contact) from a sharp end; the life is that of ISO/TS 16281
relative to a uniform line contact. The last three columns are with the axes tilted by {tilt:g} mrad.

{contacts}

Relative to the whole roller, Reusner's model makes the approach {approach:+.1f} %, the pressure at a quarter of the
half-width from the end {pressure:+.0f} %, the tilting moment {moment:+.1f} % and the life {life:+.0f} %; half-spaces
make that pressure {none_pressure:+.0f} % and the moment {none_moment:+.0f} %.
"""


@without_accuracy_warnings()
def section() -> Section:
    """Return the table of models."""
    found = {model: tuple(_errors(model, poisson) for poisson in (0.3, 0.0)) for model in _MODELS}
    tilts = {model: 100.0 * (_tilt_compliance(model) / _TILT_COMPLIANCE - 1.0) for model in _MODELS}
    judged = [*_of_whole_roller(), *_plane()]
    ring = _hollow()
    checks = [*judged, ring, *_of_models(found, tilts)]
    contacts = {model: _contacts(model) for model in _MODELS}
    whole = contacts[_WHOLE]
    off = {model: _off(contacts[model], whole) for model in (_MODELS[0], _MODELS[1])}
    inner = [abs(check.difference) for check in judged if check.tolerance == _WITHIN]
    ends = [abs(check.difference) for check in judged if check.tolerance == _AT_END]
    text = _TEXT.format(
        diameter=DIAMETER, length=LENGTH, errors=_error_table(found, tilts), whole=100.0 * max(inner),
        whole_end=100.0 * max(ends), whole_tilt=abs(tilts[_WHOLE]),
        middle=max(abs(middle) for (middle, _, _), _ in found.values()), chiu=found[_CHIU_HARTNETT][0][2],
        reusner=found[_MODELS[1]][0][2], free_plane=found[_MODELS[4]][1][2], calibrated=abs(tilts[_MODELS[2]]),
        hollow_length=_HOLLOW_LENGTH, bore=_BORE, ring=100.0 * abs(ring.difference), ring_diameter=RING,
        load=1e-3 * LOAD, fractions=", ".join(f"{fraction:g}" for fraction in _FRACTIONS), half_width=_hertz(),
        tilt=1e3 * TILT, contacts=_contact_table(contacts), approach=off[_MODELS[1]].approach,
        pressure=off[_MODELS[1]].near_end[1], moment=off[_MODELS[1]].moment, life=off[_MODELS[1]].life,
        none_pressure=off[_MODELS[0]].near_end[1], none_moment=off[_MODELS[0]].moment,
    )  # fmt: skip
    picture = Picture(
        "whole-roller",
        "Error of the displacement towards the end, nu = 0.3: a uniform load (left) and one proportional to y (right), "
        "by model of ends and depth.",
        _draw,
    )
    return Section("The whole roller: models of ends and depth side by side", text, tuple(checks), (picture,))


def _displaced(roller: Roller, places: Array, edges: Array, load: Array, half_width: float) -> Array:
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


def _moved(roller: Roller, load: _Load, places: Array) -> Array:
    """Return w / (K q) at places y."""
    middle = 0.5 * (_EDGES[1:] + _EDGES[:-1])
    along = middle / END if load.tilting else np.ones_like(middle)
    return _displaced(roller, places, _EDGES, along, load.half_width)


def _errors(model: _Model, poisson: float) -> tuple[float, float, float]:
    """Return errors in per cent under a uniform load: in the middle, one half-width from the end, at the end."""
    load = _UNIFORM if poisson else _PLANE
    places = (0.0, END - load.half_width, END)
    expected = np.interp(places, load.y, load.moved)
    middle, near, end = 100.0 * (_moved(model.roller(poisson), load, np.array(places)) / expected - 1.0)
    return float(middle), float(near), float(end)


def _tilt_compliance(model: _Model) -> float:
    return float(np.trapezoid(_ALONG * _moved(model.roller(0.3), _TILTING, _ALONG), _ALONG))


def _of_whole_roller() -> list[Check]:
    checks = []
    for load in (_UNIFORM, _TILTING, _NARROW, _PLANE):
        moved = _moved(_WHOLE.roller(load.poisson), load, np.array(load.y))
        for y, expected, computed in zip(load.y, load.moved, moved, strict=True):
            if y not in _JUDGED or not expected:
                continue
            tolerance = _WITHIN if y < END - 0.1 * load.half_width else _AT_END
            checks.append(
                Check(
                    f"{_WHOLE.name}, {load.name}: w / (K q) at y = {y:g} mm", _ELEMENTS, expected, computed, tolerance
                )
            )
    claim = f"{_WHOLE.name}: compliance against tilting"
    return [*checks, Check(claim, _ELEMENTS, _TILT_COMPLIANCE, _tilt_compliance(_WHOLE), _WITHIN, "mm^2")]


def _plane() -> list[Check]:
    """Return that without lateral contraction mirrored ends of a cylinder change nothing."""
    roller = _CHIU_HARTNETT.roller(0.0, images="series")
    middle, end = _moved(roller, _PLANE, np.array([0.0, END]))
    name = f"{_CHIU_HARTNETT.name}, all images, nu = 0"
    return [
        Check(f"{name}: w at the end over that in the middle", "plane strain", 1.0, end / middle, 1e-4),
        Check(f"{name}: w / (K q)", "plane strain: 2 ln(4 R / b) - 1", _compression(), middle, 1e-4),
    ]


def _compression() -> float:
    """Return w / (K q) of a long cylinder in plane strain."""
    return 2.0 * math.log(2.0 * DIAMETER / _PLANE.half_width) - 1.0


def _hollow() -> Check:
    """Return the ovalling of a thin hollow roller."""
    roller = Roller(
        diameter=DIAMETER, length=_HOLLOW_LENGTH, bore=_BORE, material=Material(MODULUS, 0.3), side_faces="free",
        depth="finite",
    )  # fmt: skip
    edges = np.linspace(-0.5 * _HOLLOW_LENGTH, 0.5 * _HOLLOW_LENGTH, 121)
    moved = float(_displaced(roller, np.zeros(1), edges, np.ones(120), _HOLLOW_WIDTH)[0])
    # Each side of a ring of bending stiffness E I under two opposite loads P moves by P r^3 (pi/4 - 2/pi) / (2 E I).
    wall, mean = 0.5 * (DIAMETER - _BORE), 0.25 * (DIAMETER + _BORE)
    ring = 6.0 * math.pi * (math.pi / 4.0 - 2.0 / math.pi) * (mean / wall) ** 3
    return Check("hollow roller, uniform load: w / (K q) in the middle", "thin ring, plane strain", ring, moved, 0.03)


def _of_models(found: dict[_Model, tuple[tuple[float, float, float], ...]], tilts: dict[_Model, float]) -> list[Check]:
    """Return the errors of the other models, judged where they are recorded with the finite elements."""
    places = ("in the middle", "one half-width from the end", "at the end", "in tilting")
    checks = []
    for model in _MODELS[:-1]:
        computed = (*found[model][0], tilts[model])
        for place, error, number in zip(places, computed, model.errors or (0.0,) * 4, strict=True):
            source, tolerance = (_RECORDED, _POINTS) if model.errors else (_ELEMENTS, None)
            claim = f"{model.name}: error {place}, nu = 0.3"
            checks.append(Check(claim, source, number, error, tolerance, "%", absolute=True))
    return checks


@dataclass(frozen=True)
class _InContact:
    """The roller on a ring: pressures near the end, all else as the names say. Also for differences in per cent."""

    approach: float
    middle: float
    near_end: tuple[float, ...]
    life: float
    moment: float
    near_end_tilted: float
    life_tilted: float


def _hertz() -> float:
    """Return the half-width of Hertz's line contact [mm]."""
    compliance = 2.0 * Material(MODULUS, 0.3).compliance
    radius = 0.5 / (1.0 / DIAMETER + 1.0 / RING)
    return line_contact(line_load=LOAD / LENGTH, radius=radius, compliance=compliance).half_width


def _contacts(model: _Model) -> _InContact:
    roller = model.roller(0.3)
    ring = Ring(diameter=RING, material=roller.material, side_faces="none", depth="none")
    aligned, tilted = (solve(Contact(roller, ring), load=LOAD, tilt=tilt) for tilt in (0.0, TILT))
    near = END - np.array(_FRACTIONS) * _hertz()
    even, uneven = (
        life.assess(each, life.iso_16281(), body="b", rollers=ROLLERS)[0].relative for each in (aligned, tilted)
    )
    return _InContact(
        1e3 * aligned.approach,
        float(np.interp(0.0, aligned.y, aligned.centre_pressure)),
        tuple(np.interp(near, aligned.y, aligned.centre_pressure).tolist()),
        even,
        1e-3 * tilted.moment,
        float(np.interp(near[1], tilted.y, tilted.centre_pressure)),
        uneven,
    )


def _off(one: _InContact, other: _InContact) -> _InContact:
    """Return the differences of one from the other in per cent."""

    def off(a: float, b: float) -> float:
        return 100.0 * (a / b - 1.0)

    return _InContact(
        off(one.approach, other.approach),
        off(one.middle, other.middle),
        tuple(map(off, one.near_end, other.near_end)),
        off(one.life, other.life),
        off(one.moment, other.moment),
        off(one.near_end_tilted, other.near_end_tilted),
        off(one.life_tilted, other.life_tilted),
    )


def _error_table(found: dict[_Model, tuple[tuple[float, float, float], ...]], tilts: dict[_Model, float]) -> str:
    lines = ["| model | $\\nu$ = 0.3 | $\\nu$ = 0 | tilting, $\\nu$ = 0.3 |", "|---|---|---|---:|"]
    for model, by_poisson in found.items():
        uniform = (" / ".join(_signed(error) for error in errors) for errors in by_poisson)
        lines.append(f"| {model.name} | {' | '.join(uniform)} | {_signed(tilts[model])} |")
    return "\n".join(lines)


def _signed(error: float) -> str:
    return f"{round(error, 1) + 0.0:+.1f}"  # no -0.0


def _contact_table(contacts: dict[_Model, _InContact]) -> str:
    near = [f"p at {fraction:g} b (MPa)" for fraction in _FRACTIONS]
    head = [
        "model", "approach (um)", "p(0) (MPa)", *near, "life", "moment (Nm)",
        f"p at {_FRACTIONS[1]:g} b (MPa)", "life, tilted",
    ]  # fmt: skip
    lines = [f"| {' | '.join(head)} |", "|---|" + "---:|" * (len(head) - 1)]
    for model, one in contacts.items():
        pressures = (f"{pressure:.0f}" for pressure in (one.middle, *one.near_end))
        cells = (
            model.name, f"{one.approach:.2f}", *pressures, f"{one.life:.2f}", f"{one.moment:.2f}",
            f"{one.near_end_tilted:.0f}", f"{one.life_tilted:.2f}",
        )  # fmt: skip
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def _draw(figure: Figure) -> None:
    both = figure.subplots(1, 2, sharey=True)
    for axes, load in zip(both, (_UNIFORM, _TILTING), strict=True):
        outer = slice(load.y.index(4.0), None)
        y, expected = np.array(load.y)[outer], np.array(load.moved)[outer]
        for model in _MODELS:
            error = 100.0 * (_moved(model.roller(load.poisson), load, y) / expected - 1.0)
            colour, dashes = model.style
            axes.plot(y, error, color=colour, linestyle=dashes, label=model.name)
        axes.set(xlabel="y (mm)", xlim=(4.0, END))
    both[0].set(ylabel="error of w (%)", ylim=(-40.0, 10.0))
    figure.legend(*both[0].get_legend_handles_labels(), loc="outside lower center", ncols=2)
