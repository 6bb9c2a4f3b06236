"""Stress below the surface: Hertz's landmarks, closed forms for the ellipse, direct summation, and equilibrium."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import quad
from scipy.optimize import brentq, minimize_scalar
from scipy.special import elliprd

from nonhertz.hertz import LineContact, PointContact, line_contact, point_contact
from nonhertz.model.body import BODIES, Body, BodyName, Plate, Ring, Roller
from nonhertz.model.contact import Contact
from nonhertz.model.material import Material
from nonhertz.model.profile import crown, iso_logarithmic
from nonhertz.patch import PatchSolution
from nonhertz.patch import solve as solve_patch
from nonhertz.plot.style import FIRST, INK, LINE, PALE, SECOND, SMALL_SIZE, THIN
from nonhertz.result.solution import Solution
from nonhertz.solver.one import solve
from nonhertz.subsurface import Extremes, Field, extremes, passage, stress
from nonhertz.subsurface.field import SIGMA_Z, TAU_XY, TAU_XZ, TAU_YZ, von_mises_of
from nonhertz.verify.claim import Check, Picture, Section

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
Loaded = Solution | PatchSolution

MODULUS = 206000.0
STEEL = Material(MODULUS, 0.3)
NAMES = {"von_mises": "von Mises", "shear": "maximum shear", "orthogonal_shear": "orthogonal shear"}

# Largest value over p0, and its depth over the half-width b (over the radius for the circle).
_LINE = {"von_mises": (0.557516, 0.704292), "shear": (0.300283, 0.786151), "orthogonal_shear": (0.25, 0.5)}
_ORTHOGONAL_X = 0.5 * math.sqrt(3.0)
_VON_MISES = {0.25: (0.57970, 0.65478), 0.28: (0.56569, 0.68621), 0.33: (0.54690, 0.72761)}
_CIRCLE = {"von_mises": (0.620041, 0.480864), "shear": (0.310021, 0.480864), "orthogonal_shear": (0.21389, 0.35086)}
# The depth of a maximum is known only to the square root of the accuracy of its value.
_VALUE, _DEPTH = 2e-4, 1e-3

RADIUS, POINT_LOAD = 10.0, 50.0  # mm, N: a light load, at which a circle is indistinguishable from Hertz's parabola
RATIOS = (0.1, 0.2, 0.4, 0.6, 0.8)
CIRCLE_CELLS = (96, 96)
AXIS_DEPTHS = np.array([0.1, 0.25, 0.5, 0.75, 1.0, 1.5, 2.5])  # minor half-axes

LENGTH, RING_DIAMETER, LOAD, TILT = 20.0, 80.0, 20e3, 0.5e-3
CELLS = (96, 1024)
LEVELS = (0.2, 0.5, 1.0)  # half-widths
ACROSS = (0.0, 0.5, 0.9)  # half-widths
BALANCED = 60  # points
ALLOWED = 5e-3
PIECES = 3  # that strips are cut into
STEP = 0.02  # half-widths: step of finite differences
_INTEGRAL = "integrals of the semi-ellipsoid's potential, after Thomas & Hoersch 1930"
_LUNDBERG = "Lundberg & Palmgren 1947"
_LANDMARK = "closed form below Hertz's pressure"
_LOVE = "Love's rectangles summed one by one"
_FINER, _AT_THE_END = "finer strips", "within a half-width of the ends"
LINE_LENGTH, LINE_STRIPS = 10.0, 5  # mm; uniform along y, so that more strips would resolve nothing
_TEXT = """\
The field below a solved contact is the sum of what its strips, or the cells of its plane grid, do in a half-space. Here
it is set beside what is known of the field below Hertz's pressures, beside a sum that takes no short cut, and beside
the laws that every field obeys. E = {modulus:g} MPa, $\\nu$ = 0.3 unless told otherwise; $`p_0`$ is the greatest
pressure by Hertz and b the half-width, for an ellipse half of its minor axis.

- **Line.** Two equal rollers with their faces at the same places and all mirror images: a piece of a line contact
  without ends. McEwen's closed form is met all over a cross-section in the middle and one near the face, and so are the
  landmarks that textbooks give.
- **Circle and ellipses.** Ellipses from {slenderest:g} as wide as long up to the circle. On the axis stresses have
  closed forms: of the potential of a semi-ellipsoid there is one integral left, which is done by quadrature here. The
  largest orthogonal shear stress, off the axis, has the closed form of Lundberg and Palmgren. The circle is done on the
  plane grid too.
- **Tilted roller.** Diameter 20, length {length:g} mm, logarithmic profile of ISO 16281, on a ring of {ring:g} mm,
  {load:g} kN, {tilt:g} mrad: {pressure:.0f} MPa, half-width up to {half_width:.3f} mm. The roller has images about
  both of its faces, the ring has none. The same contact is solved on a plane grid of {across} x {along} cells, and
  Love's stresses below a rectangle are summed over all corners of all cells, and of their images, at {points} points
  in each body from one end to the other, {levels} half-widths deep.
- **Equilibrium.** Derivatives of the field of that roller, by differences, balance each other, and its surface bears
  the pressure and no shear stress.

**Found.** In a line contact the largest stresses are within {line:.4f} % of $`p_0`$ of what is known. On automatic
strips those of ellipses and of the circle are within {ellipses:.4f} % of $`p_0`$, and on the plane grid those of the
circle within {cells:.4f} %. Under the tilted roller no stress differs by more than {inner:.2f} % of the largest at its
depth, {inner_depth:g} half-widths deep and deeper, or farther than a half-width from the ends of the contact. Right at
the ends and {shallowest:g} half-widths deep it is up to {end:.1f} % on automatic strips: the outermost are {first:.3f}
and {last:.3f} mm wide, and the depth is {shallow:.3f} mm. With every strip cut into {pieces} it is
{refined:.2f} % at most everywhere: what was left is the width of the strips, and not the shape across that they assume.
"""


@dataclass(frozen=True, eq=False)
class _Tilted:
    """The tilted roller on automatic strips, on finer strips, and by direct summation.

    Attributes
    ----------
    automatic, refined : Solution
        On strips.
    grid : PatchSolution
        On cells.
    points : ndarray, shape (levels, across, stations, 3)
        x, y, z [mm].
    direct : dict of str to ndarray, shape (levels, across, stations, 6)
        Stress [MPa] in either body, summed directly.
    """

    automatic: Solution
    refined: Solution
    grid: PatchSolution
    points: Array
    direct: dict[str, Array]

    @classmethod
    def of(cls) -> _Tilted:
        roller = Roller(
            diameter=20.0,
            length=LENGTH,
            material=STEEL,
            profile=iso_logarithmic(diameter=20.0, length=LENGTH),
            side_faces="mirror",
        )
        contact = Contact(roller, Ring(diameter=RING_DIAMETER, material=STEEL))
        automatic = solve(contact, load=LOAD, tilt=TILT)
        refined = solve(contact, load=LOAD, tilt=TILT, strips=_finer(automatic))
        grid = solve_patch(contact, load=LOAD, tilt=TILT, cells=CELLS)
        half_width = float(automatic.half_width.max())
        ((low, high),) = automatic.contact_y
        near = np.linspace(-0.15, 0.2, 6)
        y = np.concatenate([low + near, np.linspace(-9.0, 9.0, 7), high - near[::-1]])
        z, x, y = np.meshgrid(half_width * np.array(LEVELS), half_width * np.array(ACROSS), y, indexing="ij")
        points = np.stack([x, y, z], axis=-1)
        return cls(automatic, refined, grid, points, _directly(grid, points))

    @property
    def near_the_ends(self) -> NDArray[np.bool_]:
        """Which stations are within a half-width of an end of the contact."""
        y = self.points[0, 0, :, 1]
        ends = np.ravel(self.automatic.contact_y)
        return np.asarray(np.min(np.abs(y[:, None] - ends), axis=1) < float(self.automatic.half_width.max()))

    def differences(self, solution: Loaded, body: BodyName) -> tuple[Array, Array]:
        """Return differences of components and of von Mises stress, over the largest at that depth."""
        x, y, z = np.moveaxis(self.points, -1, 0)
        found, expected = stress(solution, x, y, z, body=body), Field(body, x, y, z, self.direct[body])
        components = np.abs(found.stress - expected.stress).max(axis=(1, 3))
        of_components = components / np.abs(expected.stress).max(axis=(1, 2, 3))[:, None]
        von_mises = np.abs(found.von_mises - expected.von_mises).max(axis=1)
        return of_components, von_mises / expected.von_mises.max(axis=(1, 2))[:, None]


def section() -> Section:
    """Return all comparisons."""
    line, circle, tilted = _Line.of(STEEL), _Circle.of(), _Tilted.of()
    of_line = [*_plane_strain(line), *_landmarks("line", _LINE, line.hertz, extremes(line.solution, 0.0)), *_poisson()]
    of_circle = _landmarks("circle", _CIRCLE, circle.hertz, extremes(circle.strips))
    of_cells = _on_cells(circle)
    of_ellipses = [check for ratio in RATIOS for check in _ellipse(ratio)]
    of_tilted = _roller(tilted)
    checks = (*of_line, *of_circle, *of_cells, *of_ellipses, *of_tilted, *_balance(tilted.automatic))

    def worst(some: list[Check]) -> float:
        return max(abs(check.difference) for check in some)

    strips, end = tilted.automatic, [check for check in of_tilted if _AT_THE_END in check.claim]
    text = _TEXT.format(
        modulus=MODULUS,
        slenderest=RATIOS[0],
        length=LENGTH,
        ring=RING_DIAMETER,
        load=1e-3 * LOAD,
        tilt=1e3 * TILT,
        pressure=strips.max_pressure,
        half_width=float(strips.half_width.max()),
        across=CELLS[0],
        along=CELLS[1],
        points=tilted.points[..., 0].size,
        levels=", ".join(f"{level:g}" for level in LEVELS),
        line=100.0 * worst([check for check in of_line if check.tolerance == _VALUE]),
        ellipses=100.0 * worst([check for check in (*of_circle, *of_ellipses) if check.tolerance == _VALUE]),
        cells=100.0 * worst([check for check in of_cells if check.tolerance == _VALUE]),
        inner=100.0 * worst([check for check in of_tilted if check.tolerance == ALLOWED and _FINER not in check.claim]),
        end=100.0 * worst(end),
        refined=100.0 * worst([check for check in of_tilted if _FINER in check.claim]),
        first=float(strips.strip_width[strips.line_load > 0.0][0]),
        last=float(strips.strip_width[strips.line_load > 0.0][-1]),
        shallow=float(LEVELS[0] * strips.half_width.max()),
        pieces=PIECES,
        inner_depth=LEVELS[1],
        shallowest=LEVELS[0],
    )
    pictures = (
        Picture(
            "subsurface-depth",
            "Stresses over the pressure against depth over the half-width, below a line and below a circle: von Mises "
            "and maximum shear stress on the axis, and the largest orthogonal shear stress at each depth. Rings: the "
            "landmarks.",
            functools.partial(_draw_depth, line, circle),
        ),
        Picture(
            "subsurface-tilted-roller",
            "Von Mises stress in the tilted roller, below the line x = 0: strips (lines) and direct summation (dots). "
            "Under it, how far strips are off the plane grid, of the largest at the depth; thin: strips a third "
            "as wide. Shaded: half a percent.",
            functools.partial(_draw_tilted, tilted),
            height=4.8,
        ),
    )
    return Section("Stress below the surface", text, checks, pictures)


@dataclass(frozen=True, eq=False)
class _Line:
    """A piece of a line contact, and Hertz's contact of the same load per unit length."""

    hertz: LineContact
    solution: Solution
    poisson: float

    @classmethod
    def of(cls, material: Material) -> _Line:
        roller = Roller(diameter=20.0, length=LINE_LENGTH, material=material, side_faces="mirror", images="series")
        contact = Contact(roller, roller)
        hertz = line_contact(line_load=1e3, radius=5.0, compliance=contact.compliance)
        return cls(hertz, solve(contact, load=1e3 * LINE_LENGTH, strips=LINE_STRIPS), material.poisson)


@dataclass(frozen=True, eq=False)
class _Circle:
    """A circular contact by Hertz, on automatic strips and on a plane grid."""

    hertz: PointContact
    strips: Solution
    cells: PatchSolution

    @classmethod
    def of(cls) -> _Circle:
        contact, hertz = _point(1.0)
        return cls(
            hertz,
            solve(contact, load=POINT_LOAD, accuracy=1e-5),
            solve_patch(contact, load=POINT_LOAD, cells=CIRCLE_CELLS),
        )


def _point(ratio: float) -> tuple[Contact, PointContact]:
    """Return a contact whose half-axes have the ratio ``ratio``, and Hertz's solution."""
    along = RADIUS * float(elliprd(0.0, 1.0, ratio**2) / elliprd(0.0, ratio**2, 1.0))
    contact = Contact(Body(diameter=2.0 * RADIUS, profile=crown(along), material=STEEL), Plate(material=STEEL))
    hertz = point_contact(radius_x=RADIUS, radius_y=along, load=POINT_LOAD, compliance=contact.compliance)
    return contact, hertz


def _landmarks(
    name: str,
    known: dict[str, tuple[float, float]],
    hertz: LineContact | PointContact,
    found: Extremes,
    sources: dict[str, str] | None = None,
) -> list[Check]:
    checks = []
    for quantity, (value, depth) in known.items():
        extreme = getattr(found, quantity)
        claim = f"{name}: largest {NAMES[quantity]} over p0"
        source = _LANDMARK if sources is None else sources[quantity]
        checks += [
            Check(claim, source, value, extreme.max / hertz.max_pressure, _VALUE, absolute=True),
            Check(f"{name}: its depth over b", source, depth, extreme.z / hertz.half_width, _DEPTH, absolute=True),
        ]
    if name == "line":
        x = found.orthogonal_shear.x / hertz.half_width
        checks.append(Check("line: how far from the middle that is, over b", _LANDMARK, _ORTHOGONAL_X, x, _DEPTH))
    return checks


def _plane_strain(line: _Line) -> list[Check]:
    b, p0 = line.hertz.half_width, line.hertz.max_pressure
    x, z = np.meshgrid(b * np.linspace(-3.0, 3.0, 41), b * np.geomspace(0.01, 5.0, 21), indexing="ij")
    expected = _mcewen(x / b, z / b, line.poisson)
    checks = []
    for place, y in (("in the middle", 0.0), ("near the face", 0.49 * LINE_LENGTH)):
        off = float(np.max(np.abs(stress(line.solution, x, y, z).stress / p0 - expected)))
        claim = f"line: largest difference of any stress {place}, over p0"
        # Images sixteen or more away are replaced by line loads: 1e-6 of p0.
        checks.append(Check(claim, "McEwen's closed form, plane strain", 0.0, off, 1e-5, absolute=True))
    return checks


def _mcewen(x: Array, z: Array, poisson: float) -> Array:
    """Return the stresses of Hertz's line contact over p0 at positions over b, Johnson 1985, Eq. (4.49)."""
    apart = 1.0 - x**2 + z**2
    root = np.sqrt(apart**2 + 4.0 * x**2 * z**2)
    m = np.sqrt(0.5 * (root + apart))
    n = np.copysign(np.sqrt(np.maximum(0.5 * (root - apart), 0.0)), x)
    fraction = (z**2 + n**2) / (m**2 + n**2)
    across, below = -m * (1.0 + fraction) + 2.0 * z, -m * (1.0 - fraction)
    shear = -n * (m**2 - z**2) / (m**2 + n**2)
    none = np.zeros_like(x)
    return np.stack([across, poisson * (across + below), below, none, shear, none], axis=-1)


def _poisson() -> list[Check]:
    checks = []
    for poisson, known in _VON_MISES.items():
        line = _Line.of(Material(MODULUS, poisson))
        found = extremes(line.solution, 0.0)
        checks += _landmarks(f"line, nu {poisson:g}", {"von_mises": known}, line.hertz, found)
    return checks


def _on_cells(circle: _Circle) -> list[Check]:
    a, p0 = circle.hertz.half_width, circle.hertz.max_pressure
    depth = np.linspace(0.25, 0.6, 71)
    on_axis, over = stress(circle.cells, 0.0, 0.0, a * depth), passage(circle.cells, 0.0, a * depth[10:31])
    checks = []
    for name, at, values in (
        ("von_mises", depth, on_axis.von_mises),
        ("shear", depth, on_axis.max_shear),
        ("orthogonal_shear", depth[10:31], over.orthogonal_shear),
    ):
        value, where = _CIRCLE[name]
        top, found = _vertex(at, values / p0)
        claim = f"circle, plane grid: largest {NAMES[name]} over p0"
        # A cell is 1/35 of the radius: the edge of the contact is a staircase, which shows in the depth of a stress.
        checks += [
            Check(claim, _LANDMARK, value, top, _VALUE, absolute=True),
            Check("circle, plane grid: its depth over b", _LANDMARK, where, found, _DEPTH, absolute=True),
        ]
    return checks


def _vertex(places: Array, values: Array) -> tuple[float, float]:
    """Return the maximum, and its position, of the parabola through the largest of equidistant values."""
    best = int(np.clip(values.argmax(), 1, values.size - 2))
    low, top, high = values[best - 1 : best + 2]
    moved = 0.5 * (low - high) / (low - 2.0 * top + high)
    return float(top - 0.25 * (low - high) * moved), float(places[best] + moved * (places[1] - places[0]))


def _ellipse(ratio: float) -> list[Check]:
    contact, hertz = _point(ratio)
    solution = solve(contact, load=POINT_LOAD, accuracy=1e-5)
    b, p0 = hertz.half_width, hertz.max_pressure
    on_axis = stress(solution, 0.0, 0.0, b * AXIS_DEPTHS).stress[:, :3] / p0
    off = float(np.max(np.abs(on_axis - [_axis(ratio, depth) for depth in AXIS_DEPTHS])))
    deepest = [
        minimize_scalar(lambda depth, of=of: -of(_axis(ratio, depth)), bounds=(0.2, 1.2), method="bounded")
        for of in (_von_mises_on_axis, _shear_on_axis)
    ]
    known = {
        name: (-float(best.fun), float(best.x)) for name, best in zip(("von_mises", "shear"), deepest, strict=True)
    }
    name = f"b/a {ratio:g}"
    claim = f"{name}: largest difference of normal stresses on the axis, over p0"
    return [
        Check(claim, _INTEGRAL, 0.0, off, _VALUE, absolute=True),
        *_landmarks(
            name,
            known | {"orthogonal_shear": _lundberg(ratio)},
            hertz,
            extremes(solution, 0.0),
            {"von_mises": _INTEGRAL, "shear": _INTEGRAL, "orthogonal_shear": _LUNDBERG},
        ),
    ]


def _axis(ratio: float, depth: float) -> tuple[float, float, float]:
    """Return sigma_x, sigma_y, sigma_z over p0 on the axis, the depth over the minor half-axis b across.

    With the potential V of the pressure, int p / r dA, and the integral of -V over the depth, chi, stresses in a
    half-space are sigma_z = (V_z - z V_zz) / (2 pi) and sigma_x = (2 nu V_z - z V_xx - (1 - 2 nu) chi_xx) / (2 pi).
    V of a semi-ellipsoid is a single integral over t, on the axis from z to infinity; here it is taken over s = z / t.
    """
    a, z, poisson = 1.0 / ratio, depth, STEEL.poisson

    def integral(of: Callable[[float, float, float], float]) -> float:
        return a * float(quad(lambda s: of(z / s, a**2 + (z / s) ** 2, 1.0 + (z / s) ** 2) * z / s**2, 0.0, 1.0,
                              epsabs=1e-10, epsrel=1e-10)[0])  # fmt: skip

    V_z = -z * integral(lambda t, A, B: 1.0 / (t**2 * math.sqrt(A * B)))
    V_xx = -integral(lambda t, A, B: 1.0 / (B * math.sqrt(A * B)))
    V_yy = -integral(lambda t, A, B: 1.0 / (A * math.sqrt(A * B)))
    chi_xx = integral(lambda t, A, B: (t - z) / (B * math.sqrt(A * B)))
    chi_yy = integral(lambda t, A, B: (t - z) / (A * math.sqrt(A * B)))
    sideways = 1.0 - 2.0 * poisson
    return (
        2.0 * poisson * V_z - z * V_xx - sideways * chi_xx,
        2.0 * poisson * V_z - z * V_yy - sideways * chi_yy,
        V_z + z * (V_xx + V_yy),
    )


def _von_mises_on_axis(normal: tuple[float, float, float]) -> float:
    x, y, z = normal
    return math.sqrt(0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2))


def _shear_on_axis(normal: tuple[float, float, float]) -> float:
    return 0.5 * (max(normal) - min(normal))


def _lundberg(ratio: float) -> tuple[float, float]:
    """Return the largest |tau_xz| over p0 and its depth over b, when the load rolls across the minor axis."""
    t = float(brentq(lambda t: (t**2 - 1.0) * (2.0 * t - 1.0) - ratio**2, 1.0, 2.0, xtol=1e-14))
    root = math.sqrt(2.0 * t - 1.0)
    return root / (2.0 * t * (t + 1.0)), 1.0 / ((t + 1.0) * root)


def _sources(pressure: Array, x: Array, y: Array, sides: tuple[float, float]) -> tuple[Array, Array, Array]:
    """Return x, y and weight of every corner of cells at which the pressure steps."""
    weight = np.diff(np.diff(np.pad(pressure, 1), axis=0), axis=1)
    x_edges, y_edges = (np.append(at - 0.5 * side, at[-1] + 0.5 * side) for at, side in zip((x, y), sides, strict=True))
    row, column = np.nonzero(weight)
    return x_edges[row], y_edges[column], weight[row, column]


def _love(sources: tuple[Array, Array, Array], point: Array, poisson: float) -> Array:
    """Return Love's stresses at a point, the sum over all corners."""
    x, y, weight = sources
    X, Y, z = x - point[0], y - point[1], point[2]
    r = np.sqrt(X**2 + Y**2 + z**2)
    XX, YY = X**2 + z**2, Y**2 + z**2
    product, sideways = X * Y, 1.0 - 2.0 * poisson
    V_z, V_xx, V_yy = -np.arctan2(product, z * r), -product / (r * XX), -product / (r * YY)
    corner = (
        2.0 * poisson * V_z - z * V_xx - sideways * np.arctan2(product, XX + z * r),
        2.0 * poisson * V_z - z * V_yy - sideways * np.arctan2(product, YY + z * r),
        V_z + z * (V_xx + V_yy),
        -(z**2) * X / (r * YY),
        -(z**2) * Y / (r * XX),
        -z / r - sideways * np.log(z + r),
    )
    return np.array([weight @ each for each in corner]) / (2.0 * math.pi)


def _directly(grid: PatchSolution, points: Array) -> dict[str, Array]:
    """Return the stress in the roller, with its images about both faces, and in the ring, without any."""
    sources = _sources(grid.pressure, grid.x, grid.y, (grid.dx, grid.dy))

    def summed(points: Array) -> Array:
        return np.array([_love(sources, point, STEEL.poisson) for point in points])

    at = points.reshape(-1, 3)
    alone = summed(at)
    images = np.zeros_like(alone)
    for face in (-0.5 * LENGTH, 0.5 * LENGTH):
        # The field of an image here is that of the pressure at the mirrored point, with components odd in y reversed.
        mirrored = summed(np.column_stack([at[:, 0], 2.0 * face - at[:, 1], at[:, 2]]))
        mirrored[:, [TAU_YZ, TAU_XY]] *= -1.0
        images += mirrored
    shape = (*points.shape[:-1], 6)
    return {"a": (alone + images).reshape(shape), "b": alone.reshape(shape)}


def _finer(solution: Solution) -> Array:
    """Return the edges of the strips with each strip cut into pieces."""
    edges = solution.edges
    return np.interp(np.arange(PIECES * (edges.size - 1) + 1) / PIECES, np.arange(edges.size), edges)


def _roller(tilted: _Tilted) -> list[Check]:
    near = tilted.near_the_ends
    shallow = f"{LEVELS[0]:g} half-widths deep"
    checks = []
    for body, name in zip(BODIES, ("roller", "ring"), strict=True):
        of_automatic, of_refined = (tilted.differences(each, body) for each in (tilted.automatic, tilted.refined))
        for what, automatic, refined in zip(("any stress", "von Mises"), of_automatic, of_refined, strict=True):
            for where, differences, tolerance in (
                ("farther than a half-width from the ends", automatic[:, ~near], ALLOWED),
                (f"everywhere {LEVELS[1]:g} half-widths deep and deeper", automatic[1:], ALLOWED),
                # Strips as wide as the point is deep show individually.
                (f"{shallow} {_AT_THE_END}", automatic[0, near], None),
                (f"everywhere, {_FINER}", refined, ALLOWED),
            ):
                claim = f"tilted {name}: difference of {what} {where}, of the largest at the depth"
                checks.append(Check(claim, _LOVE, 0.0, float(np.max(differences)), tolerance, absolute=True))
    return checks


def _balance(solution: Solution) -> list[Check]:
    """Return checks that the field is in equilibrium, and that the surface is loaded by the pressure alone."""
    half_width = float(solution.half_width.max())
    step = STEP * half_width
    draw = np.random.default_rng(1)
    at = np.column_stack(
        [draw.uniform(low, high, BALANCED) for low, high in ((-0.4, 0.4), (-9.5, 9.7), (0.3 * half_width, half_width))]
    )
    rates = []
    for axis in range(3):
        moved = [at + distance * step * np.eye(3)[axis] for distance in (-2.0, -1.0, 1.0, 2.0)]
        further_down, down, up, further_up = (stress(solution, *each.T).tensor for each in moved)
        rates.append((8.0 * (up - down) - (further_up - further_down)) / (12.0 * step))
    rate = np.stack(rates)
    unbalanced = float(np.max(np.abs(np.einsum("inij->nj", rate)))) / float(np.max(np.abs(rate)))
    away = np.min(np.abs(solution.y[:, None] - np.ravel(solution.contact_y)), axis=1) > half_width
    away &= solution.line_load > 0.0
    y, p0, a = (each[away] for each in (solution.y, solution.centre_pressure, solution.element_half_width))
    across = np.array([-0.5, 0.0, 0.5])[:, None]
    surface = stress(solution, across * a, y, 0.0).stress / solution.max_pressure
    pressure = p0 * np.sqrt(1.0 - across**2) / solution.max_pressure
    sheared = float(np.max(np.abs(surface[..., [TAU_XZ, TAU_YZ]])))
    off = float(np.max(np.abs(surface[..., SIGMA_Z] + pressure)))
    name = "tilted roller, surface farther than a half-width from the ends"
    return [
        # Fourth-order differences leave (step / depth)^4; where a distant strip starts to count as a whole, a jump of
        # 1e-5 of the pressure adds as much to the derivative.
        Check("tilted roller: largest sum of derivatives that should balance, of the largest derivative", "equilibrium",
              0.0, unbalanced, 2e-3, absolute=True),
        # Between the centres of strips the pressure is interpolated, and the load of all of them kept.
        Check(f"{name}: largest difference of sigma_z and the pressure, over the largest pressure", "the solution",
              0.0, off, 5e-3, absolute=True),
        Check(f"{name}: largest shear stress over the largest pressure", "no friction", 0.0, sheared, 1e-9,
              absolute=True),
    ]  # fmt: skip


def _draw_depth(line: _Line, circle: _Circle, figure: Figure) -> None:
    depth = np.linspace(0.0, 2.0, 101)
    panels = figure.subplots(1, 2, sharey=True)
    cases: tuple[tuple[str, Solution, LineContact | PointContact, dict[str, tuple[float, float]]], ...] = (
        ("line", line.solution, line.hertz, _LINE),
        ("circle", circle.strips, circle.hertz, _CIRCLE),
    )
    for axes, (case, solution, hertz, known) in zip(panels, cases, strict=True):
        z = hertz.half_width * depth
        on_axis, over = stress(solution, 0.0, 0.0, z), passage(solution, 0.0, z[1:])
        curves = {"von_mises": on_axis.von_mises, "shear": on_axis.max_shear}
        curves["orthogonal_shear"] = np.append(0.0, over.orthogonal_shear)
        for (name, values), colour, dashes in zip(curves.items(), (FIRST, SECOND, INK), ("-", "--", ":"), strict=True):
            axes.plot(depth, values / hertz.max_pressure, color=colour, linestyle=dashes, label=NAMES[name])
            value, where = known[name]
            axes.plot(where, value, "o", color=colour, mfc="none")
        axes.set_title(case, loc="left", fontsize=SMALL_SIZE)
        axes.set(
            xlabel="z / b" if case == "line" else "z / a",
            xlim=(0.0, 2.0),
            ylim=(0.0, 0.68),
            xticks=(0.0, 0.5, 1.0, 1.5, 2.0),
        )
    panels[0].set_ylabel("stress / $p_0$")
    panels[0].legend(loc="upper right")


def _draw_tilted(tilted: _Tilted, figure: Figure) -> None:
    upper, lower = figure.subplots(2, 1, sharex=True, height_ratios=(1.3, 1.0))
    of_stations = tilted.points[0, 0, :, 1]
    y = np.sort(np.concatenate([np.linspace(-9.95, 9.95, 100), np.linspace(-9.9, -9.0, 60), np.linspace(9.3, 9.9, 60)]))
    lower.axhspan(-100.0 * ALLOWED, 100.0 * ALLOWED, color=PALE)
    styles = zip((FIRST, SECOND, INK), ("-", "--", ":"), strict=True)
    for i, (level, (colour, dashes)) in enumerate(zip(LEVELS, styles, strict=True)):
        z = float(tilted.points[i, 0, 0, 2])
        automatic, refined, cells = (
            stress(each, 0.0, y, z).von_mises for each in (tilted.automatic, tilted.refined, tilted.grid)
        )
        upper.plot(y, automatic, color=colour, linestyle=dashes, label=f"z = {level:g} b")
        direct = von_mises_of(tilted.direct["a"][i, 0])
        upper.plot(of_stations, direct, ".", color=colour, markersize=4.0)
        for each, width in ((automatic, LINE), (refined, THIN)):
            off = 100.0 * (each - cells) / cells.max()
            lower.plot(y, off, color=colour, linestyle=dashes, linewidth=width)
    upper.set(ylabel="von Mises (MPa)", ylim=(0.0, None))
    upper.legend(loc="lower center", ncols=3)
    lower.set(xlabel="y (mm)", ylabel="difference (%)", xlim=(-10.0, 10.0))
