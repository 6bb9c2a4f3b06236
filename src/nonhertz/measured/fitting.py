"""Least-squares fits: which profile of the catalogue is closest to a measured line, and with what uncertainty.

The line is relief = profile(y - shift) + offset + tilt y. Starting values come from a grid over the lengths in a kind
(where its straight middle ends, where its logarithm has its pole): with those given, all kinds are linear in the
reciprocal radius, the amplitude or the taper, which one linear least-squares problem finds. The best point of the grid
is the start for `scipy.optimize.least_squares`.

Errors of neighbouring points on a measured line are correlated: waviness and misfit extend over many points. So the
effective number of points is n / tau, with tau the sum of the autocorrelation of the residual up to its first zero.
Standard errors and the comparison of kinds are based on it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.inputs.checks import check_list, finite, flag, numbers, one_of
from nonhertz.inputs.descriptions import Quantity
from nonhertz.inputs.short_repr import ShortRepr
from nonhertz.measured.trace import Array, Points
from nonhertz.model.profile import CATALOGUE, PARAMETERS, Profile
from nonhertz.result.brief import HasHtml

_MOST_POINTS = 2000
_FAR = 1.0  # mm, in place of the infinite relief beyond a pole
# Search ranges of positive parameters, in their units; at a bound, a parameter has lost its meaning.
_BOUNDS = {"radius": (1.0, 1e7), "end_radius": (1.0, 1e7), "amplitude": (1e-7, 10.0), "angle": (1e-7, 1.0)}
_LENGTH_BOUNDS = (1e-3, 1e4)
_DERIVATIVES = 1e-7  # of the largest: accuracy of finite-difference derivatives


@dataclass(frozen=True, eq=False, repr=False)
class ProfileFit(ShortRepr, HasHtml):
    """The best-fitting profile of a kind.

    Attributes
    ----------
    kind : str
        Its name in the catalogue.
    parameters : dict
        Its parameters by name, in the units of the catalogue.
    standard_errors : dict
        Standard error of every free parameter, and of ``offset``, ``shift`` and ``tilt`` if they were free; infinite
        where a parameter reached the end of its search range, so that the line does not determine it.
    offset, shift, tilt : float
        Added to the profile: a height [mm], a shift along y [mm], a slope [rad].
    rms, largest : float
        Root mean square and largest absolute residual [mm].
    points : float
        Effective number of independent points.
    penalised : float
        Bayesian information criterion (BIC), by which kinds are ranked: lower is better.
    """

    kind: str
    parameters: Mapping[str, float]
    standard_errors: Mapping[str, float]
    offset: float
    shift: float
    tilt: float
    rms: float
    largest: float
    points: float
    penalised: float

    @property
    def profile(self) -> Profile:
        """The profile, about y = 0: without offset, shift and tilt."""
        return CATALOGUE[self.kind](**self.parameters)

    def unit_of(self, name: str) -> str:
        """Return the unit of a parameter, or of the shift.

        Raises
        ------
        InputError
            If the kind has no such parameter.
        """
        one_of("name", name, ("shift", *PARAMETERS[self.kind].descriptions), "give a parameter of the fitted profile")
        field = PARAMETERS[self.kind].descriptions.get(name)
        return field.unit if isinstance(field, Quantity) else "mm"

    def relief(self, y: Array) -> Array:
        """Return the fitted relief [mm] at positions [mm], offset, shift and tilt included.

        Raises
        ------
        InputError
            If the positions are not finite real numbers.
        """
        y = numbers("y", y, "give positions in mm")
        return self.profile.relief(y - self.shift) + self.offset + self.tilt * y


@dataclass(frozen=True)
class _Kind:
    """How a kind is fitted: basis functions, linear once its lengths are given, and the way back to its parameters."""

    lengths: Callable[[float], Iterable[tuple[float, ...]]]  # from the half-length to the lengths to try
    bases: Callable[[Array, tuple[float, ...]], list[Array]]
    parameters: Callable[[tuple[float, ...], Array], dict[str, float]]
    signed: tuple[str, ...] = ()  # parameters that may be negative


def fit(
    points: Points, kind: str, *, shift: bool = True, tilt: bool = False, highest: float | None = None, **fixed: float
) -> ProfileFit:
    """Return the profile of a kind that best fits a measured line.

    Parameters
    ----------
    points : Points
        The line.
    kind : str
        ``"crown"``, ``"partial-crown"``, ``"two-radius"``, ``"logarithmic"``, ``"tapered-ends"``, ``"conical"`` or
        ``"straight"``.
    shift, tilt : bool
        Whether the profile may be shifted along y and tilted. The offset is always free.
    highest : float or None
        Height [mm] of zero relief; that of the highest point if None.
    **fixed : float
        Parameters of the kind whose values are known.

    Returns
    -------
    ProfileFit
        Parameters, standard errors and residuals.

    Raises
    ------
    InputError
        If the kind or a parameter is unknown, or if free parameters cannot be distinguished: the tilt and the shift of
        a crown, the tilt and the angle of a cone.

    Examples
    --------
    >>> y = np.linspace(-5, 5, 101)
    >>> found = fit(Points(y, -(y**2) / 2000), "crown")
    >>> round(found.parameters["radius"]), found.rms < 1e-6
    (1000, True)
    """
    if not isinstance(points, Points):
        raise InputError("points", points, "be Points", "give a Trace, or the points of a Measured")
    _check(kind, shift, tilt, fixed)
    for name, value in fixed.items():
        finite(name, value, f"give the parameter of '{kind}' that is known")
    if highest is not None:
        finite("highest", highest, "give the height from which relief counts in mm")
    y, relief = _average_neighbours(points, highest)
    free = {name: value for name, value in _start(kind, y, relief, fixed).items() if name not in fixed}
    return _solve(kind, y, relief, free, fixed, shift and kind not in _NO_SHIFT, tilt)


def fit_best(
    points: Points,
    kinds: Iterable[str] | None = None,
    *,
    shift: bool = True,
    tilt: bool = False,
    highest: float | None = None,
) -> tuple[ProfileFit, ...]:
    """Return fits of several kinds, best first.

    Kinds are ranked by the Bayesian information criterion (BIC), n ln(mean square) + p ln(n): an extra parameter must
    lower the mean square by more than chance would. n is the effective number of independent points, from the residual
    of the closest kind, and the same for all.

    Parameters
    ----------
    points : Points
        The line.
    kinds : iterable of str or None
        Which kinds to try; None tries all, except ``"crown"`` and ``"conical"`` if the tilt is free.
    shift, tilt : bool
        Whether the profile may be shifted along y and tilted.
    highest : float or None
        As in `fit`.

    Returns
    -------
    tuple of ProfileFit
        One for each kind.

    Raises
    ------
    InputError
        As in `fit`.
    """
    remedy = "give names of kinds, or leave them out"
    kinds = (
        tuple(check_list("kinds", kinds, "be a list of kinds", remedy))
        if kinds is not None
        else tuple(k for k in KINDS if not (tilt and k in _TURNED))
    )
    if not kinds:
        raise InputError("kinds", kinds, "hold at least one kind", remedy)
    fits = [fit(points, kind, shift=shift, tilt=tilt, highest=highest) for kind in kinds]
    nearest = min(fits, key=lambda fit: fit.rms)
    judged = [_penalise(fit, nearest.points) for fit in fits]
    return tuple(sorted(judged, key=lambda fit: fit.penalised))


def _check(kind: str, shift: bool, tilt: bool, fixed: Mapping[str, float]) -> None:
    one_of("kind", kind, KINDS, "name a kind that can be fitted")
    flag("shift", shift, "write True if the profile may be shifted along y")
    flag("tilt", tilt, "write True if the profile may be tilted")
    known = _known(kind)
    for name in fixed:
        one_of("fixed", name, known, f"name a parameter of '{kind}'")
    if tilt and (kind == "conical" or (kind == "crown" and shift)):
        other = "angle" if kind == "conical" else "shift"
        raise InputError(
            "tilt", tilt, f"not be free together with the {other} of a {kind}", "no fit can tell them apart"
        )


def _average_neighbours(points: Points, highest: float | None) -> tuple[Array, Array]:
    """Return means over neighbouring points, about two thousand at most, which is enough for a fit.

    They are counted from both ends, so that a mirror image has the same ones.
    """
    y, relief = points.y, (points.height.max() if highest is None else highest) - points.height
    share = -(-len(y) // _MOST_POINTS)
    beside = share * np.arange(len(y) // share // 2)
    starts = np.unique([*beside, len(beside) * share, *(len(y) - share - beside)])
    starts = starts[starts < len(y)]
    counts = np.diff(starts, append=len(y))
    return np.add.reduceat(y, starts) / counts, np.add.reduceat(relief, starts) / counts


def _start(kind: str, y: Array, relief: Array, fixed: Mapping[str, float]) -> dict[str, float]:
    """Return the parameters of the best grid point."""
    middle = 0.5 * float(y[0] + y[-1])
    how, best, parameters = _HOW[kind], np.inf, {}
    for lengths in how.lengths(0.5 * float(y[-1] - y[0])):
        bases = how.bases(np.abs(y - middle) if kind not in _NO_SHIFT else y, lengths)
        columns = np.column_stack([*bases, np.ones_like(y)])
        solution = np.linalg.lstsq(columns, relief, rcond=None)[0]
        square = float(np.sum((columns @ solution - relief) ** 2))
        factors = np.asarray(solution[:-1], dtype=np.float64)
        if kind in _POSITIVE:
            factors = np.maximum(factors, 1e-9)
        if square < best:
            best, parameters = square, how.parameters(lengths, factors)
    return parameters | dict(fixed)


def _solve(
    kind: str, y: Array, relief: Array, free: dict[str, float], fixed: Mapping[str, float], shift: bool, tilt: bool
) -> ProfileFit:
    from scipy.optimize import least_squares

    names = [*free, "offset", *(["shift"] if shift else []), *(["tilt"] if tilt else [])]
    if len(y) <= len(names):
        condition = f"exceed the {len(names)} free parameters of '{kind}', offset, shift and tilt included"
        raise InputError("points", len(y), condition, "measure more points, or fit a simpler kind")
    logs = np.array([name in free and name not in _HOW[kind].signed for name in names])
    make = CATALOGUE[kind]
    scale = max(float(np.ptp(relief)), 1e-6)

    def values(x: Array) -> dict[str, float]:
        return dict(zip(names, np.where(logs, np.exp(np.where(logs, x, 0.0)), x).tolist(), strict=True))

    def residuals(x: Array) -> Array:
        parameters = values(x)
        nuisance = {name: parameters.pop(name, 0.0) for name in ("offset", "shift", "tilt")}
        try:
            profile = make(**parameters, **fixed)
        except InputError:  # not a valid profile of the kind, such as a middle longer than its circle
            return np.full(len(y), _FAR / scale)
        drop = np.minimum(profile.relief(y - nuisance["shift"]), _FAR)
        return np.asarray((drop + nuisance["offset"] + nuisance["tilt"] * y - relief) / scale)

    first = [np.log(max(free[n], 1e-12)) if log else free.get(n, 0.0) for n, log in zip(names, logs, strict=True)]
    if shift:
        first[names.index("shift")] = 0.5 * (y[0] + y[-1])
    low, high = _limits(names, logs)
    x0 = np.clip(np.array(first), low, high)
    x0[names.index("offset")] = -scale * float(np.mean(residuals(x0)))
    sizes = {"offset": scale, "shift": 0.01 * float(np.ptp(y)), "radius": 0.1 * abs(free.get("radius", 1.0))}
    steps = np.where(logs, 0.1, [sizes.get(n, 1e-4) for n in names])
    # Parameters without effect cause divisions by zero on the way, and show in their standard errors.
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        solution = least_squares(
            residuals, x0, bounds=(low, high), x_scale=steps, xtol=1e-10, ftol=1e-10, gtol=1e-10, max_nfev=200
        )
    return _make_fit(kind, values(solution.x), fixed, solution, logs, scale)


def _limits(names: list[str], logs: NDArray[np.bool_]) -> tuple[Array, Array]:
    pairs = [_BOUNDS.get(name, _LENGTH_BOUNDS) if log else (0.0, np.inf) for name, log in zip(names, logs, strict=True)]
    bounds = np.array(pairs)
    low = np.where(logs, np.log(np.where(logs, bounds[:, 0], 1.0)), -np.inf)
    high = np.where(logs, np.log(np.where(logs, bounds[:, 1], 1.0)), np.inf)
    # A starting value on a bound could not move.
    return low - 1e-9, high + 1e-9


def _make_fit(
    kind: str,
    parameters: dict[str, float],
    fixed: Mapping[str, float],
    solution: Any,
    logs: NDArray[np.bool_],
    scale: float,
) -> ProfileFit:
    residual = scale * solution.fun
    count = len(residual) / _correlation_length(residual)
    square = float(residual @ residual)
    freedom = max(count - len(solution.x), 1.0)
    # Mean square over the effective number of points less the parameters; the normal matrix is scaled accordingly.
    sigma = np.sqrt(square / freedom) * _sensitivity(scale * solution.jac)
    sigma[solution.active_mask != 0] = np.inf
    names = list(parameters)
    errors = {
        name: float(deviation * (parameters[name] if log else 1.0))
        for name, deviation, log in zip(names, sigma, logs, strict=True)
    }
    nuisance = {name: parameters.pop(name, 0.0) for name in ("offset", "shift", "tilt")}
    fitted = ProfileFit(
        kind, parameters | dict(fixed), errors, **nuisance,
        rms=float(np.sqrt(square / len(residual))), largest=float(np.max(np.abs(residual))), points=count,
        penalised=0.0,
    )  # fmt: skip
    return _penalise(fitted, count)


def _sensitivity(jacobian: Array) -> Array:
    """Return the square roots of the diagonal of (J^T J)^-1, infinite for parameters that the line does not determine.

    The columns of J are scaled first: a radius of a hundred metres changes heights so little per millimetre that, next
    to an offset, its column would pass for zero.
    """
    lengths = np.linalg.norm(jacobian, axis=0)
    resolved = lengths > 0.0
    sensitivity = np.full(len(lengths), np.inf)
    _, singular, turned = np.linalg.svd(jacobian[:, resolved] / lengths[resolved], full_matrices=False)
    # The derivatives are differences over 1e-8 of a parameter, and about as accurate.
    known = singular > _DERIVATIVES * singular[0]
    unknown = np.any(np.abs(turned[~known]) > np.sqrt(_DERIVATIVES), axis=0)
    resolved_sensitivity = np.sqrt(np.sum((turned[known] / singular[known, None]) ** 2, axis=0)) / lengths[resolved]
    sensitivity[resolved] = np.where(unknown, np.inf, resolved_sensitivity)
    return sensitivity


def _penalise(fitted: ProfileFit, points: float) -> ProfileFit:
    # No measurement is better than a tenth of a nanometre; this also keeps the value of a perfect fit finite.
    mean_square = fitted.rms**2 + 1e-14
    value = points * np.log(mean_square) + len(fitted.standard_errors) * np.log(points)
    return replace(fitted, penalised=float(value))


def _correlation_length(residual: Array) -> float:
    """Return over how many points a residual is correlated: 1 for noise, many for a long wave."""
    size = 2 * len(residual)
    power = np.abs(np.fft.rfft(residual, size)) ** 2
    covariance = np.fft.irfft(power, size)[: len(residual)]
    if covariance[0] <= 0.0:
        return 1.0
    correlation = covariance / covariance[0]
    ends = np.flatnonzero(correlation <= 0.0)
    until = int(ends[0]) if len(ends) else len(correlation)
    tau = 1.0 + 2.0 * float(np.sum(correlation[1:until]))
    return min(tau, len(residual) / 4.0)


def _known(kind: str) -> tuple[str, ...]:
    return tuple(name for name, field in PARAMETERS[kind].descriptions.items() if isinstance(field, Quantity))


def _junctions(half: float) -> list[tuple[float, ...]]:
    """Return half-lengths of a straight middle or a middle arc."""
    return [(half * float(share),) for share in np.arange(0.05, 0.96, 0.025)]


def _poles(half: float) -> list[tuple[float, ...]]:
    """Return half-lengths of a logarithm's curved part and of its straight middle."""
    middles = [half * share for share in (0.0, 0.2, 0.4, 0.6, 0.8)]
    return [((half - m) * beyond, m) for m in middles for beyond in (1.001, 1.01, 1.05, 1.2, 1.6, 3.0)]


def _logarithm(y: Array, lengths: tuple[float, ...]) -> list[Array]:
    reach, middle = lengths
    share = np.minimum(np.maximum(y - middle, 0.0) / reach, 1.0 - 1e-9)
    return [-np.log1p(-(share**2))]


def _arcs(y: Array, lengths: tuple[float, ...]) -> list[Array]:
    (junction,) = lengths
    past = np.maximum(y - junction, 0.0)
    return [0.5 * np.minimum(y, junction) ** 2 + past * junction, 0.5 * past**2]


_HOW: dict[str, _Kind] = {
    "straight": _Kind(lambda _: [()], lambda _y, _l: [], lambda _l, _f: {}),
    "conical": _Kind(
        lambda _: [()], lambda y, _: [y], lambda _, f: {"angle": float(np.arctan(f[0]))}, signed=("angle",)
    ),
    "crown": _Kind(
        lambda _: [()], lambda y, _: [0.5 * y**2], lambda _, f: {"radius": _radius(f[0])}, signed=("radius",)
    ),
    "tapered-ends": _Kind(
        _junctions,
        lambda y, s: [np.maximum(y - s[0], 0.0)],
        lambda s, f: {"straight": 2.0 * s[0], "angle": float(np.arctan(f[0]))},
    ),
    "partial-crown": _Kind(
        _junctions,
        lambda y, s: [0.5 * np.maximum(y - s[0], 0.0) ** 2],
        lambda s, f: {"radius": _radius(f[0]), "straight": 2.0 * s[0]},
    ),
    "two-radius": _Kind(
        _junctions,
        _arcs,
        lambda s, f: {"radius": _radius(f[0]), "end_radius": _radius(f[1]), "middle": 2.0 * s[0]},
    ),
    "logarithmic": _Kind(
        _poles,
        _logarithm,
        lambda s, f: {"amplitude": float(f[0]), "length": 2.0 * s[0], "straight": 2.0 * s[1]},
    ),
}
#: Kinds that can be fitted.
KINDS = tuple(_HOW)
_NO_SHIFT = frozenset({"straight", "conical"})
_TURNED = frozenset({"crown", "conical"})
_POSITIVE = frozenset({"tapered-ends", "partial-crown", "two-radius", "logarithmic"})


def _radius(curvature: float) -> float:
    # To any machine a radius of 1000 km is infinite.
    size = max(abs(curvature), 1e-9)
    return float(np.copysign(1.0 / size, curvature))
