"""Stress below the surface: Hertz's landmarks, closed forms for the ellipse, direct summation, and equilibrium.

Line contacts are compared with McEwen's closed form and the landmarks that textbooks give; ellipses up to the circle on
the axis with a quadrature of the potential of a semi-ellipsoid, and off it with Lundberg and Palmgren. The field of a
tilted roller is set beside Love's stresses summed over all corners of all cells of a plane grid and of their images,
and obeys the laws that every field obeys.
"""

from __future__ import annotations

import functools
import math
import operator
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import quad
from scipy.optimize import brentq, minimize_scalar
from scipy.special import elliprd

from claims.claim import Array, Claim, Evidence, Value, solved
from nonhertz import Body, Contact, Material, Plate, Ring, Roller, Solution, solve
from nonhertz.hertz import LineContact, PointContact, line_contact, point_contact
from nonhertz.model.body import BODIES, BodyName
from nonhertz.model.profile import crown, iso_logarithmic
from nonhertz.patch import PatchSolution
from nonhertz.patch import solve as solve_patch
from nonhertz.subsurface import Extremes, Field, extremes, passage, stress
from nonhertz.subsurface.field import SIGMA_Z, TAU_XY, TAU_XZ, TAU_YZ

Loaded = Solution | PatchSolution
Landmarks = Mapping[str, tuple[Value, Value]]
Normal = tuple[float, float, float]

MODULUS = 206000.0
STEEL = Material(MODULUS, 0.3)
NAMES = {"von_mises": "von Mises", "shear": "maximum shear", "orthogonal_shear": "orthogonal shear"}

# Largest value over p0, and its depth over the half-width b (over the radius for the circle).
LINE: Landmarks = {"von_mises": (0.557516, 0.704292), "shear": (0.300283, 0.786151), "orthogonal_shear": (0.25, 0.5)}
_ORTHOGONAL_X = 0.5 * math.sqrt(3.0)
_VON_MISES = {0.25: (0.57970, 0.65478), 0.28: (0.56569, 0.68621), 0.33: (0.54690, 0.72761)}
CIRCLE: Landmarks = {
    "von_mises": (0.620041, 0.480864), "shear": (0.310021, 0.480864), "orthogonal_shear": (0.21389, 0.35086)
}  # fmt: skip
_VALUE, _DEPTH = 2e-4, 1e-3
_WHY_DEPTH = "the depth of a maximum is known only to the square root of the accuracy of its value"

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
# Regions of the comparison with Love's rectangles.
_COMPARED = (
    "farther than a half-width from the ends",
    f"everywhere {LEVELS[1]:g} half-widths deep and deeper",
    # Strips as wide as the point is deep show individually.
    f"{LEVELS[0]:g} half-widths deep within a half-width of the ends",
    "everywhere, finer strips",
)
LINE_LENGTH, LINE_STRIPS = 10.0, 5  # mm; uniform along y, so that more strips would resolve nothing


def claims() -> Iterator[Claim]:
    """Yield the claims."""
    # McEwen's closed form is met all over two cross-sections.
    for place, y in (("in the middle", 0.0), ("near the face", 0.49 * LINE_LENGTH)):
        yield Claim(
            f"line: largest difference of any stress {place}, over p0", "McEwen's closed form, plane strain", 0.0,
            functools.partial(_off_mcewen, y), 1e-5,
            why="images sixteen or more away are replaced by line loads: 1e-6 of p0",
        )  # fmt: skip
    yield from _landmarks("line", LINE, _below_line)
    yield Evidence("line", _LANDMARK, lambda: line(0.3)).claim(
        "how far from the middle that is, over b", lambda of: of.extremes.orthogonal_shear.x / of.hertz.half_width,
        _DEPTH, expected=_ORTHOGONAL_X,
    )  # fmt: skip
    for poisson, known in _VON_MISES.items():
        found = functools.partial(_below_line, poisson=poisson)
        yield from _landmarks(f"line, nu {poisson:g}", {"von_mises": known}, found)
    yield from _landmarks("circle", CIRCLE, _below_ellipse)
    why = "a cell is 1/35 of the radius: the edge of the contact is a staircase, which shows in the depth"
    yield from _landmarks("circle, plane grid", CIRCLE, _below_circle_on_cells, why=why)
    for ratio in RATIOS:
        yield from _ellipse(ratio)
    for body, name in zip(BODIES, ("roller", "ring"), strict=True):
        for what, words in enumerate(("any stress", "von Mises")):
            summed = Evidence(
                f"tilted {name}", "Love's rectangles summed one by one", functools.partial(_off_love, body, what)
            )
            yield from summed.each(
                [f"difference of {words} {place}, of the largest at the depth" for place in _COMPARED],
                (ALLOWED, ALLOWED, None, ALLOWED),
            )
    yield from _balance()


@dataclass(frozen=True, eq=False)
class Line:
    """A piece of a line contact, Hertz's contact of the same load per unit length, and the largest stresses."""

    hertz: LineContact
    solution: Solution
    extremes: Extremes


@solved
def line(poisson: float) -> Line:
    """Return a piece of a line contact of two equal rollers."""
    material = Material(MODULUS, poisson)
    roller = Roller(diameter=20.0, length=LINE_LENGTH, material=material, side_faces="mirror", images="series")
    contact = Contact(roller, roller)
    hertz = line_contact(line_load=1e3, radius=5.0, compliance=contact.compliance)
    solution = solve(contact, load=1e3 * LINE_LENGTH, strips=LINE_STRIPS)
    return Line(hertz, solution, extremes(solution, 0.0))


def point(ratio: float) -> tuple[Contact, PointContact]:
    """Return a contact whose half-axes have the ratio ``ratio``, and Hertz's solution."""
    along = RADIUS * float(elliprd(0.0, 1.0, ratio**2) / elliprd(0.0, ratio**2, 1.0))
    contact = Contact(Body(diameter=2.0 * RADIUS, profile=crown(along), material=STEEL), Plate(material=STEEL))
    hertz = point_contact(radius_x=RADIUS, radius_y=along, load=POINT_LOAD, compliance=contact.compliance)
    return contact, hertz


@solved
def point_on_strips(ratio: float) -> Solution:
    """Return that contact on automatic strips."""
    return solve(point(ratio)[0], load=POINT_LOAD, accuracy=1e-5)


@solved
def on_strips_extremes(ratio: float) -> Extremes:
    """Return the largest stresses on strips: below the middle, where the ellipse is no circle."""
    return extremes(point_on_strips(ratio), None if ratio == 1.0 else 0.0)


@solved
def circle_on_cells() -> PatchSolution:
    """Return the circle on the plane grid."""
    return solve_patch(point(1.0)[0], load=POINT_LOAD, cells=CIRCLE_CELLS)


def _landmarks(
    name: str,
    known: Landmarks,
    found: Callable[[str], tuple[float, float]],
    sources: Mapping[str, str] | None = None,
    why: str = _WHY_DEPTH,
) -> Iterator[Claim]:
    """Yield the largest stresses over p0 and their depths over b."""
    for quantity, (value, depth) in known.items():
        of = Evidence(name, (sources or {}).get(quantity, _LANDMARK), functools.partial(found, quantity))
        largest = f"largest {NAMES[quantity]} over p0"
        yield of.claim(largest, operator.itemgetter(0), _VALUE, expected=value, absolute=True)
        yield of.claim("its depth over b", operator.itemgetter(1), _DEPTH, expected=depth, absolute=True, why=why)


def _below_line(quantity: str, poisson: float = 0.3) -> tuple[float, float]:
    top, hertz = getattr(line(poisson).extremes, quantity), line(poisson).hertz
    return top.max / hertz.max_pressure, top.z / hertz.half_width


def _below_ellipse(quantity: str, ratio: float = 1.0) -> tuple[float, float]:
    top, hertz = getattr(on_strips_extremes(ratio), quantity), point(ratio)[1]
    return top.max / hertz.max_pressure, top.z / hertz.half_width


def _below_circle_on_cells(quantity: str) -> tuple[float, float]:
    a, p0 = point(1.0)[1].half_width, point(1.0)[1].max_pressure
    depth = np.linspace(0.25, 0.6, 71)
    if quantity == "orthogonal_shear":
        depth = depth[10:31]
        return vertex(depth, passage(circle_on_cells(), 0.0, a * depth).orthogonal_shear / p0)
    on_axis = stress(circle_on_cells(), 0.0, 0.0, a * depth)
    return vertex(depth, (on_axis.von_mises if quantity == "von_mises" else on_axis.max_shear) / p0)


def _off_mcewen(y: float) -> float:
    b, p0 = line(0.3).hertz.half_width, line(0.3).hertz.max_pressure
    x, z = np.meshgrid(b * np.linspace(-3.0, 3.0, 41), b * np.geomspace(0.01, 5.0, 21), indexing="ij")
    expected = mcewen(x / b, z / b, 0.3)
    return float(np.max(np.abs(stress(line(0.3).solution, x, y, z).stress / p0 - expected)))


def mcewen(x: Array, z: Array, poisson: float) -> Array:
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


def vertex(places: Array, values: Array) -> tuple[float, float]:
    """Return the maximum, and its position, of the parabola through the largest of equidistant values."""
    best = int(np.clip(values.argmax(), 1, values.size - 2))
    low, top, high = values[best - 1 : best + 2]
    moved = 0.5 * (low - high) / (low - 2.0 * top + high)
    return float(top - 0.25 * (low - high) * moved), float(places[best] + moved * (places[1] - places[0]))


def _ellipse(ratio: float) -> Iterator[Claim]:
    def off() -> float:
        b, p0 = point(ratio)[1].half_width, point(ratio)[1].max_pressure
        found = stress(point_on_strips(ratio), 0.0, 0.0, b * AXIS_DEPTHS).stress[:, :3] / p0
        return float(np.max(np.abs(found - [on_axis(ratio, depth) for depth in AXIS_DEPTHS])))

    def deepest(of: Callable[[Normal], float]) -> tuple[Value, Value]:
        return lambda: largest_on_axis(ratio, of)[0], lambda: largest_on_axis(ratio, of)[1]

    name = f"b/a {ratio:g}"
    yield Claim(f"{name}: largest difference of normal stresses on the axis, over p0", _INTEGRAL, 0.0, off, _VALUE)
    landmarks = {
        "von_mises": deepest(von_mises_on_axis), "shear": deepest(shear_on_axis), "orthogonal_shear": lundberg(ratio)
    }  # fmt: skip
    sources = {"von_mises": _INTEGRAL, "shear": _INTEGRAL, "orthogonal_shear": _LUNDBERG}
    yield from _landmarks(name, landmarks, functools.partial(_below_ellipse, ratio=ratio), sources)


@solved
def largest_on_axis(ratio: float, of: Callable[[Normal], float]) -> tuple[float, float]:
    """Return the largest value of a stress on the axis over p0, and its depth over b."""
    best = minimize_scalar(lambda depth: -of(on_axis(ratio, depth)), bounds=(0.2, 1.2), method="bounded")
    return -float(best.fun), float(best.x)


def on_axis(ratio: float, depth: float) -> Normal:
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


def von_mises_on_axis(normal: Normal) -> float:
    """Return the von Mises stress of normal stresses."""
    x, y, z = normal
    return math.sqrt(0.5 * ((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2))


def shear_on_axis(normal: Normal) -> float:
    """Return the maximum shear stress of normal stresses."""
    return 0.5 * (max(normal) - min(normal))


def lundberg(ratio: float) -> tuple[float, float]:
    """Return the largest |tau_xz| over p0 and its depth over b, when the load rolls across the minor axis."""
    t = float(brentq(lambda t: (t**2 - 1.0) * (2.0 * t - 1.0) - ratio**2, 1.0, 2.0, xtol=1e-14))
    root = math.sqrt(2.0 * t - 1.0)
    return root / (2.0 * t * (t + 1.0)), 1.0 / ((t + 1.0) * root)


@dataclass(frozen=True, eq=False)
class Tilted:
    """The tilted roller on strips and cells, and its stress summed directly in either body.

    ``points`` have the shape (levels, across, stations, 3) [mm], the stresses (levels, across, stations, 6) [MPa].
    """

    automatic: Solution
    refined: Solution
    grid: PatchSolution
    points: Array
    direct: dict[str, Array]

    @property
    def near_the_ends(self) -> NDArray[np.bool_]:
        """Which stations are within a half-width of an end of the contact."""
        y = self.points[0, 0, :, 1]
        ends = np.ravel(self.automatic.contact_y)
        return np.asarray(np.min(np.abs(y[:, None] - ends), axis=1) < float(self.automatic.half_width.max()))


@solved
def tilted_on_strips() -> Solution:
    """Return the tilted roller on automatic strips."""
    profile = iso_logarithmic(diameter=20.0, length=LENGTH)
    roller = Roller(diameter=20.0, length=LENGTH, material=STEEL, profile=profile, side_faces="mirror")
    return solve(Contact(roller, Ring(diameter=RING_DIAMETER, material=STEEL)), load=LOAD, tilt=TILT)


@solved
def tilted() -> Tilted:
    """Return the tilted roller."""
    automatic = tilted_on_strips()
    contact, edges = automatic.contact, automatic.edges
    finer = np.interp(np.arange(PIECES * (edges.size - 1) + 1) / PIECES, np.arange(edges.size), edges)
    refined = solve(contact, load=LOAD, tilt=TILT, strips=finer)
    grid = solve_patch(contact, load=LOAD, tilt=TILT, cells=CELLS)
    half_width = float(automatic.half_width.max())
    ((low, high),) = automatic.contact_y
    near = np.linspace(-0.15, 0.2, 6)
    y = np.concatenate([low + near, np.linspace(-9.0, 9.0, 7), high - near[::-1]])
    z, x, y = np.meshgrid(half_width * np.array(LEVELS), half_width * np.array(ACROSS), y, indexing="ij")
    points = np.stack([x, y, z], axis=-1)
    return Tilted(automatic, refined, grid, points, _directly(grid, points))


@solved
def differences(body: BodyName, finer: bool) -> tuple[Array, Array]:
    """Return differences of components and of von Mises stress on strips, over the largest at that depth."""
    solution = tilted().refined if finer else tilted().automatic
    x, y, z = np.moveaxis(tilted().points, -1, 0)
    found, expected = stress(solution, x, y, z, body=body), Field(body, x, y, z, tilted().direct[body])
    components = np.abs(found.stress - expected.stress).max(axis=(1, 3))
    of_components = components / np.abs(expected.stress).max(axis=(1, 2, 3))[:, None]
    von_mises = np.abs(found.von_mises - expected.von_mises).max(axis=1)
    return of_components, von_mises / expected.von_mises.max(axis=(1, 2))[:, None]


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


def _off_love(body: BodyName, what: int) -> list[float]:
    """Return the largest differences in the regions of _COMPARED: of any stress (0), or of von Mises (1)."""
    automatic, refined = (differences(body, finer)[what] for finer in (False, True))
    near = tilted().near_the_ends
    return [float(np.max(each)) for each in (automatic[:, ~near], automatic[1:], automatic[0, near], refined)]


def _balance() -> Iterator[Claim]:
    """Yield that the field is in equilibrium, and that the surface is loaded by the pressure alone."""
    yield Evidence("tilted roller", "equilibrium", tilted_on_strips).claim(
        "largest sum of derivatives that should balance, of the largest derivative", _unbalanced, 2e-3,
        why="fourth-order differences leave (step / depth)^4; where a distant strip starts to count as a whole, a jump "
        "of 1e-5 of the pressure adds as much to the derivative",
    )  # fmt: skip
    surface = Evidence(
        "tilted roller, surface farther than a half-width from the ends", "the solution",
        lambda: _on_surface(tilted_on_strips()),
    )  # fmt: skip
    yield surface.claim(
        "largest difference of sigma_z and the pressure, over the maximum pressure", operator.itemgetter(0), 5e-3,
        why="between the centres of strips the pressure is interpolated, and the load of all of them kept",
    )  # fmt: skip
    largest = "largest shear stress over the maximum pressure"
    yield surface.claim(largest, operator.itemgetter(1), 1e-9, source="no friction")


def _unbalanced(solution: Solution) -> float:
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
    return float(np.max(np.abs(np.einsum("inij->nj", rate)))) / float(np.max(np.abs(rate)))


def _on_surface(solution: Solution) -> tuple[float, float]:
    """Return the largest difference of sigma_z and the pressure, and the largest shear stress, over the pressure."""
    half_width = float(solution.half_width.max())
    away = np.min(np.abs(solution.y[:, None] - np.ravel(solution.contact_y)), axis=1) > half_width
    away &= solution.line_load > 0.0
    y, p0, a = (each[away] for each in (solution.y, solution.centre_pressure, solution.element_half_width))
    across = np.array([-0.5, 0.0, 0.5])[:, None]
    surface = stress(solution, across * a, y, 0.0).stress / solution.max_pressure
    pressure = p0 * np.sqrt(1.0 - across**2) / solution.max_pressure
    sheared = float(np.max(np.abs(surface[..., [TAU_XZ, TAU_YZ]])))
    return float(np.max(np.abs(surface[..., SIGMA_Z] + pressure))), sheared
