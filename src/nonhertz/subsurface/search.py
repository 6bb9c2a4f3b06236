"""The largest stresses below a contact and their positions: in the whole body, and in one cross-section.

Both searches start with samples of passes on a grid of points, as deep and as fine as the half-width requires, refine
the passes with the highest values, and end with nets that shrink around the best point of each.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Unpack

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.findings import Finding, HasFindings, finding
from nonhertz.inputs.checks import check_list, not_negative, positive
from nonhertz.model.body import BodyName
from nonhertz.patch.solution import PatchSolution
from nonhertz.result.brief import HasHtml
from nonhertz.result.edges import EdgeKind
from nonhertz.result.ends import ends_in_words, outermost
from nonhertz.result.read_only import ReadOnly
from nonhertz.result.solved import Solved
from nonhertz.subsurface.evaluation import Within, across_at, field_at, one_station, refuse_options
from nonhertz.subsurface.inside import Inside, check_solution
from nonhertz.subsurface.rolling import QUANTITIES, Passage, StressMeasure, passage, sampled_passage

Array = NDArray[np.float64]

# Depths over the half-width at which the search starts.
DEPTHS = np.array([0.0, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.95, 1.15, 1.4])
MOST_STATIONS, MOST_ROWS = 401, 65  # for strips, and for a plane grid, which takes longer
FEW = 60  # strips: with fewer, their edges are searched as well
CRESTS, WORTH = 3, 0.7  # local maxima to refine, and their least height over the highest
EQUAL, ROUNDING = 1e-6, 1e-9
ALONG_BORE = 33  # points along and around the bore at which its search starts
MESHES, ROUNDS, SHRINKING = np.array([-1.0, -0.5, 0.0, 0.5, 1.0]), 12, 0.5
# After a first such net, nets of three points along each axis; together they still cover the width of the first.
NARROW, NARROW_ROUNDS, NARROW_SPAN, NARROWING = np.array([-1.0, 0.0, 1.0]), 14, 0.3, 0.6


EVERYWHERE = (0.0, np.inf)

Span = tuple[float, float]


@dataclass(frozen=True, repr=False)
class Extreme(ReadOnly):
    """A largest value and its position.

    Attributes
    ----------
    max : float
        The value [MPa].
    x, y, z : float
        Its position [mm]. The field of strips is symmetric about x = 0; x >= 0 is returned.
    at_bore : bool
        Whether it is on the bore of a hollow roller.
    """

    max: float
    x: float
    y: float
    z: float
    at_bore: bool = False

    @property
    def site(self) -> str:
        """Words that precede its coordinates in a sentence."""
        return "at the bore, " if self.at_bore else "at "


@dataclass(frozen=True, repr=False)
class Extremes(HasFindings, ReadOnly, HasHtml):
    """The largest stresses of one body, or of one cross-section of it.

    Attributes
    ----------
    body : {"a", "b"}
        Which body.
    von_mises, shear, orthogonal_shear : Extreme
        Largest von Mises stress, maximum shear stress and |tau_xz|.
    findings : tuple of Finding
        Regions left out and other limitations; empty if none.
    bore : Extreme or None
        Largest von Mises stress on the bore of a hollow roller, which need not be the largest of all.
    """

    body: BodyName
    von_mises: Extreme
    shear: Extreme
    orthogonal_shear: Extreme
    findings: tuple[Finding, ...]
    bore: Extreme | None = None


def extremes(
    solution: Solved,
    station: float | None = None,
    *,
    depths: Span = EVERYWHERE,
    **options: Unpack[Within],
) -> Extremes:
    """Return the largest stresses below a contact, or those in the cross-section at a station.

    Parameters
    ----------
    solution : Solution or PatchSolution
        A solved contact.
    station : float, optional
        Position along y [mm]; the whole body if left out.
    depths : tuple of two float
        The least and the largest depth z [mm] to search, such as those of a hardened case or of the core below it; the
        largest may be infinite.
    **options
        ``body``, ``threads`` and ``callback`` as in `stress`.

    Returns
    -------
    Extremes

    Raises
    ------
    InputError
        As for `stress`, or if ``depths`` are not two ascending numbers.

    Notes
    -----
    For the whole body, points within a half-width of a sharp end, or of a corner of the profile where the contact ends,
    are left out, as for the maximum pressure: the stress there is singular. In a smooth field the error is below 1e-5
    of the largest value; near the surface, steps of the pressure between strips or cells are part of the field. Beyond
    the contact, only a region within a half-width of it, up to a free side face, is searched.

    Examples
    --------
    >>> import nonhertz as nh
    >>> roller = nh.Roller(diameter=20, length=20, profile=nh.profile.crown(radius=2000))
    >>> solution = nh.solve(nh.Contact(roller, nh.Plate()), load=6e3)
    >>> found = extremes(solution)
    >>> round(found.von_mises.max / solution.max_pressure, 3)
    0.562
    """
    refuse_options("extremes", options, Within)
    check_solution(solution)
    depths = _check_depths(depths)
    inside = Inside.of(solution, options.get("body", "a"))
    if station is not None:
        sections = np.array([one_station(station) + 0.0])
        stretches = [(float(sections[0]), float(sections[0]))]
        try:
            inside.refuse_outside(np.zeros(1), sections, np.zeros(1))
        except InputError as error:
            if error.field != "y":
                raise
            raise error.about("station", station) from None
    else:
        stretches = _stretches(solution, _search_range(solution, inside))
        sections = _sections(solution, stretches)
    below = across_at(solution, sections)[1][:, None] * DEPTHS
    if station is not None:  # outside the contact the stress comes from further away and peaks deeper
        below = np.unique(np.concatenate([below, _distances(solution, sections) * DEPTHS], axis=None))[None, :]
    coarse = sampled_passage(solution, sections[:, None], np.minimum(depths[0] + below, depths[1]), **options)
    threads, climbs = options.get("threads"), []
    for name in QUANTITIES:
        values = np.nan_to_num(getattr(coarse, name), nan=0.0)
        places = dict.fromkeys([_first_of_equals(values, coarse.y), *_other_crests(values)])
        climbs += [_Climb(name, *_around(solution, coarse, place, stretches)) for place in places]
    points = np.array([climb.best for climb in climbs])
    closer = passage(solution, points[:, 1], points[:, 2], body=inside.name, threads=threads)
    for k, climb in enumerate(climbs):
        climb.top = float(np.nan_to_num(getattr(closer, climb.name)[k], nan=0.0))
        climb.best[0] = getattr(closer, f"{climb.name}_x")[k]
    _climb(inside, climbs, depths, threads)
    largest = {}
    for name in QUANTITIES:
        of_name = [climb for climb in climbs if climb.name == name]
        best = max(climb.top for climb in of_name)
        # The first of equal values.
        largest[name] = next(climb.extreme(solution) for climb in of_name if climb.top >= (1.0 - EQUAL) * best)
    at_bore = {} if inside.wall is None else _at_bore(inside, station, depths)
    for name, candidate in at_bore.items():
        largest[name] = max(largest[name], candidate, key=lambda extreme: extreme.max)
    left_out = (*(_findings(solution) if station is None else ()), *inside.findings)
    return Extremes(body=inside.name, findings=left_out, bore=at_bore.get("von_mises"), **largest)


def _highest(
    at: Callable[[Array], Array], best: Array, span: Array, limits: list[Span], top: float, mesh: Array = MESHES
) -> tuple[float, Array]:
    """Return the largest of values at places (n, d) on nets that shrink around the highest so far, and its place."""
    for _ in range(ROUNDS):
        axes = [
            np.unique(np.clip(centre + reach * mesh, *ends))
            for centre, reach, ends in zip(best, span, limits, strict=True)
        ]
        net = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, best.size)
        values = at(net)
        if values.max() > top:
            top, best = float(values.max()), net[_highest_of(values, wide=mesh.size > MESHES.size)]
        span = span * (SHRINKING if mesh.size == MESHES.size else 2.0 / (mesh.size - 1))
        mesh = MESHES
    return top, best


def _highest_of(values: Array, *, wide: bool) -> int:
    """Return the index of the largest value of a net: on a wide net the first of those equal to rounding.

    A wide net may contain mirror images; on a narrow net equal values would lie around the same maximum.
    """
    most = values.max()
    return int(np.flatnonzero(values >= most - (ROUNDING * abs(most) if wide else 0.0))[0])


def _at_bore(inside: Inside, station: float | None, depths: Span) -> dict[str, Extreme]:
    """Return the largest stresses on the bore between some depths; tau_xz has no meaning of its own there."""
    low, high = inside.body.faces if station is None else (station, station)
    span, limits = np.array([0.5 * (high - low), 0.25 * np.pi]), [(low, high), (0.0, 0.5 * np.pi)]
    largest = {}

    def places(net: Array) -> tuple[Array, Array, Array]:
        outer, inner = inside.extent.radii(net[:, 0])
        return inner * np.sin(net[:, 1]), net[:, 0], outer - inner * np.cos(net[:, 1])

    for name in ("von_mises", "shear"):

        def at(net: Array, quantity: StressMeasure = QUANTITIES[name]) -> Array:
            x, y, z = places(net)
            values = np.nan_to_num(quantity(field_at(inside, (x, y, z)).stress))
            return np.where((z < depths[0]) | (z > depths[1]), -np.inf, values)

        middle = np.array([0.5 * (low + high), 0.25 * np.pi])
        top, best = _highest(at, middle, span, limits, -np.inf, np.linspace(-1.0, 1.0, ALONG_BORE))
        if np.isfinite(top):
            x, y, z = (float(coordinate[0]) for coordinate in places(best[None]))
            largest[name] = Extreme(top, x, y, z, at_bore=True)
    return largest


def _check_depths(depths: Span) -> Span:
    remedy = "give the least and the largest depth in mm, the latter may be infinite"
    pair = check_list("depths", depths, "be a pair of depths", remedy)
    if len(pair) != 2:
        raise InputError("depths", depths, "be a pair of depths", remedy)
    not_negative("depths", pair[0], remedy)
    if pair[1] != np.inf:
        positive("depths", pair[1], remedy)
    if not pair[0] < pair[1]:
        raise InputError("depths", depths, "ascend", remedy)
    return float(pair[0]), float(pair[1])


def _search_range(solution: Solved, inside: Inside) -> Span:
    """Return the contact, and with it the free side faces of a body within a half-width."""
    low, high = outermost(solution)
    for face in inside.faces:
        if face.side < 0.0 and low - face.half_width < face.place:
            low = min(low, face.place)
        elif face.side > 0.0 and high + face.half_width > face.place:
            high = max(high, face.place)
    return low, high


def _stretches(solution: Solved, whole: Span) -> list[Span]:
    """Return the intervals to search: all except a half-width around singular ends, or the contact if nothing remains.

    A corner of the profile may have contact on both sides.
    """
    stretches = [whole]
    for end in solution.singular_ends:
        inset = float(across_at(solution, np.array([end.y]))[1][0])
        cut = [
            part
            for low, high in stretches
            for part in ((low, min(high, end.y - inset)), (max(low, end.y + inset), high))
        ]
        stretches = [(low, high) for low, high in cut if low < high]
    return stretches or [outermost(solution)]


def clear_of_ends(solution: Solved) -> bool:
    """Return whether part of the contact lies more than a half-width from all singular ends; only that is searched."""
    whole = outermost(solution)
    return not solution.singular_ends or _stretches(solution, whole) != [whole]


def _sections(solution: Solved, stretches: list[Span]) -> Array:
    """Return the stations to search: strips and their edges, or rows, and the ends of the search."""
    searched = _lies_within(solution.y, stretches)
    rows = np.flatnonzero((solution.line_load > 0.0) & searched)
    most = MOST_ROWS if isinstance(solution, PatchSolution) else MOST_STATIONS
    if rows.size > most:
        even = rows[np.linspace(0, rows.size - 1, most).astype(int)]
        # Narrow features such as a dent or an edge appear in the pressure.
        pressure = solution.largest_across
        crests = rows[1:-1][(np.diff(pressure[rows])[:-1] > 0.0) & (np.diff(pressure[rows])[1:] <= 0.0)]
        highest = crests[pressure[crests].argsort()[-most // 4 :]]
        rows = np.unique(np.concatenate([even, highest]))
    between = solution.edges if rows.size < FEW else np.empty(0)
    between = between[_lies_within(between, stretches)]
    return np.unique(np.concatenate([np.ravel(stretches), solution.y[rows], between]))


def _lies_within(y: Array, stretches: list[Span]) -> NDArray[np.bool_]:
    within: NDArray[np.bool_] = np.any([(y > low) & (y < high) for low, high in stretches], axis=0)
    return within


def _other_crests(values: Array) -> list[tuple[int, int]]:
    """Return the highest local maxima of a grid."""
    framed = np.pad(values, 1, constant_values=-np.inf)
    around = [
        framed[1 + i : 1 + i + values.shape[0], 1 + j : 1 + j + values.shape[1]]
        for i in (-1, 0, 1)
        for j in (-1, 0, 1)
        if (i, j) != (0, 0)
    ]
    crests = np.argwhere(values >= np.max(around, axis=0))
    heights = values[crests[:, 0], crests[:, 1]]
    tall = crests[heights >= WORTH * heights.max()]
    order = values[tall[:, 0], tall[:, 1]].argsort()[::-1]
    return [(int(row), int(column)) for row, column in tall[order[:CRESTS]]]


def _distances(solution: Solved, station: Array) -> Array:
    """Return length scales [mm] for the depth of the largest stress: half-width, distance to the contact."""
    touching = solution.y[solution.line_load > 0.0]
    largest = float(across_at(solution, touching)[1].max())
    nearest = float(np.abs(touching - station[0]).min())
    return np.array([[largest], [largest + nearest], [4.0 * (largest + nearest)]])


@dataclass
class _Climb:
    """The climb to one local maximum of a quantity.

    Attributes
    ----------
    name : str
        A key of `QUANTITIES`.
    best : ndarray, shape (3,)
        The best point so far [mm].
    span : ndarray, shape (3,)
        Reach of the next net from it [mm].
    limits : tuple of float
        Range of y [mm].
    half_width : float
        Half-width of the contact there [mm].
    top : float
        The value at the best point [MPa].
    """

    name: str
    best: Array
    span: Array
    limits: Span
    half_width: float
    top: float = 0.0

    def net(self, mesh: Array, depths: Span) -> Array:
        """Return points around the best one, shape (n, 3)."""
        limits = ((-np.inf, np.inf), self.limits, depths)
        axes = [
            np.unique(np.clip(centre + reach * mesh, *ends))
            for centre, reach, ends in zip(self.best, self.span, limits, strict=True)
        ]
        return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)

    def look(self, net: Array, stresses: Array, *, wide: bool) -> None:
        """Move to the best point of a net."""
        values = np.nan_to_num(QUANTITIES[self.name](stresses), nan=0.0)
        if values.max() > self.top:
            self.top, self.best = float(values.max()), net[_highest_of(values, wide=wide)]

    def extreme(self, solution: Solved) -> Extreme:
        """Return the maximum reached."""
        across = float(abs(self.best[0]) if solution.symmetric_across else self.best[0])
        across = 0.0 if abs(across) < ROUNDING * self.half_width else across
        along = 0.0 if abs(self.best[1]) < ROUNDING * self.half_width else float(self.best[1])
        return Extreme(self.top, across, along, float(self.best[2]) + 0.0)


def _around(
    solution: Solved, coarse: Passage, place: tuple[int, int], stretches: list[Span]
) -> tuple[Array, Array, Span, float]:
    """Return a point of a grid, the distance within which its maximum lies, the limits of y, and the half-width."""
    row, column = place
    best = np.array([0.0, coarse.y[place], coarse.z[place]])
    sections = coarse.y[:, 0]
    limits = next(stretch for stretch in stretches if stretch[0] <= best[1] <= stretch[1])
    half_width = float(across_at(solution, sections[row])[1])
    neighbours = sections[max(row - 1, 0) : row + 2]
    step = np.diff(coarse.z[row])[max(column - 1, 0) : column + 1].max()
    reach = max(0.1 * half_width, 0.5 * step)
    along = float(np.ptp(neighbours)) if sections.size > 1 else 0.0
    return best, np.array([reach, along, max(0.2 * half_width, step)]), limits, half_width


def _climb(inside: Inside, climbs: list[_Climb], depths: Span, threads: int | None) -> None:
    """Follow all climbs to their ends, in step: the stress of all their nets is computed in one call."""
    for mesh in (MESHES, *[NARROW] * NARROW_ROUNDS):
        nets = [climb.net(mesh, depths) for climb in climbs]
        points = np.concatenate(nets)
        stresses = field_at(inside, tuple(points.T), threads=threads).stress
        ends = np.cumsum([len(net) for net in nets])[:-1]
        for climb, net, part in zip(climbs, nets, np.split(stresses, ends), strict=True):
            climb.look(net, part, wide=mesh is MESHES)
            climb.span = climb.span * (NARROW_SPAN if mesh is MESHES else NARROWING)


def _first_of_equals(values: Array, y: Array) -> tuple[int, int]:
    """Return the index of the largest value; of equal values the one nearest the middle, then of lowest y.

    All quantities of a symmetric field are thus reported at the same end.
    """
    equal = np.argwhere(values >= (1.0 - EQUAL) * values.max())
    along = y[equal[:, 0], equal[:, 1]]
    nearest = np.abs(along) <= (1.0 + EQUAL) * np.abs(along).min()
    row, column = equal[nearest][0]
    return int(row), int(column)


def _findings(solution: Solved) -> Iterator[Finding]:
    ends = solution.singular_ends
    if ends:
        searched = f"within a half-width of {'them' if len(ends) > 1 else 'it'}"
        rest = f"the whole contact lies {searched}, and the values depend on the strips"
        what = f"the region {searched} was not searched" if clear_of_ends(solution) else rest
        yield finding(
            "stress-at-ends", f"The stress grows without limit towards {{ends}}: {what}.", ends=ends_in_words(ends)
        )
    if solution.peaks_at_corner and not any(end.kind is EdgeKind.CORNER for end in ends):
        yield finding(
            "stress-at-corner",
            "The pressure is largest at a corner of the profile, where it is singular, as is the stress right below: "
            "the largest values depend on the strips.",
        )
