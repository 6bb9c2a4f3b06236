"""What is wrong with an answer or a refusal; nothing if all is right.

A fault is a pair: its kind, a few words that group it with others, and the detail. Answers are judged by `own_theory`
from what was prescribed and from the arrays alone.
"""

import math
import re

import numpy as np
from own_theory import EPS, HERTZ_RATIO, Surfaces, amplitudes_from_tables, common_interval, curvature, separation

BALANCE = 1e-8  # of load and of load times reach
GAP, CURVATURE = 1e-7, 1e-6  # of the interference, and of the curvature
SERIES = 1e-3  # the same where the sum of a series of images is truncated
BETWEEN_STRIPS, MARGIN = 0.02, 0.03  # overlap of the interference, away from contact by this share of it or a strip
MOST_ROWS, SCANNED = 160, 401
ESTIMATE_WARNED, MAXIMUM_WARNED = 0.05, 0.20
TABLE_DIGITS = 2e-10  # documented: ten digits of a relief that is read from a table
SPARE = 1e-6  # beside the error estimates of two answers compared
NUMBER = re.compile(r"[-+]?(?:\d[\d.]*(?:e[-+]?\d+)?|\binf\b|\bnan\b)", re.IGNORECASE)


def solution_faults(solution, case):
    """Faults of an answer that calls itself converged."""
    faults = _numbers(solution) or _grid(solution, case)
    if faults:
        return faults
    faults = _loads(solution, case["given"]) + _words(solution) + _maximum(solution)
    return faults + (_surfaces(solution, case) if not faults or not _fatal(faults) else [])


def _fatal(faults):
    return any(kind in {"negative load", "no load"} for kind, _ in faults)


def _numbers(solution):
    numbers = {
        "approach": solution.approach,
        "tilt": solution.tilt,
        "load": solution.load,
        "moment": solution.moment,
        "stiffness": solution.stiffness,
        "edges": solution.edges,
        "line_load": solution.line_load,
        "element_half_width": solution.element_half_width,
        "contact_y": np.array(solution.contact_y, dtype=float),
        "max_pressure": solution.max_pressure,
    }
    faults = [
        ("not finite", f"{name} = {np.asarray(value).ravel()[:4]}")
        for name, value in numbers.items()
        if not np.all(np.isfinite(value))
    ]
    estimate = solution.error_estimate
    faults += [
        ("error estimate not a number", f"{name} {getattr(estimate, name)}")
        for name in ("approach", "load", "max_pressure")
        if not getattr(estimate, name) >= 0.0
    ]
    if np.any(np.isnan(solution.gap)) or np.any(solution.gap == -math.inf):
        faults.append(("not finite", "gap"))
    return faults


def _grid(solution, case):
    edges, strips = solution.edges, case["strips"]
    low, high = common_interval(case)
    faults = []
    least = 8.0 * EPS * float(np.max(np.abs(edges)))
    given = isinstance(strips, list)
    if not given and not np.all(np.diff(edges) > least):
        faults.append(("strip edges do not ascend", f"least width {np.min(np.diff(edges)):.3g}"))
    if edges[0] < low - least or edges[-1] > high + least:
        faults.append(("strips beyond the bodies", f"{edges[0]} {edges[-1]} for {low} {high}"))
    if given and not np.array_equal(edges, strips):
        faults.append(("other strips than given", ""))
    if isinstance(strips, int) and edges.size != strips + 1:
        faults.append(("other number of strips than given", f"{edges.size - 1} for {strips}"))
    shapes = {solution.line_load.shape, solution.element_half_width.shape, solution.gap.shape}
    if shapes != {(edges.size - 1,)}:
        faults.append(("arrays of other lengths", f"{shapes}"))
    places = [place for both in solution.contact_y for place in both]
    if not places or np.any(np.diff(places) < 0.0) or places[0] < edges[0] - least or places[-1] > edges[-1] + least:
        faults.append(("contact_y beyond the strips", f"{solution.contact_y}"))
    return faults


def _loads(solution, given):
    y, width, q = _centres(solution), np.diff(solution.edges), solution.line_load
    load, moment = float(np.sum(q * width)), float(np.sum(q * width * y))
    if np.any(q < 0.0) or np.any(solution.element_half_width < 0.0):
        return [("negative load", f"{np.min(q):.3g}")]
    if not load > 0.0:
        return [("no load", f"{load}")]
    faults = []
    if np.any((q > 0.0) != (solution.element_half_width > 0.0)):
        faults.append(("load without width", ""))
    lever = load * float(np.max(np.abs(solution.edges)))
    noise = 8.0 * EPS * lever
    reach = load * 0.5 * float(solution.edges[-1] - solution.edges[0])
    for name, own in (("load", load), ("moment", moment)):
        scale, spare = (load, 0.0) if name == "load" else (reach, noise)
        if not abs(own - getattr(solution, name)) <= BALANCE * scale + spare:
            faults.append(
                (f"reported {name} is not that of the strips", f"{getattr(solution, name):.8g} for {own:.8g}")
            )
        if name in given and not abs(own - given[name]) <= BALANCE * scale + spare:
            faults.append((f"other {name} than prescribed", f"{own:.8g} for {given[name]:.8g}"))
    for name in ("approach", "tilt"):
        wanted = given.get(name, 0.0 if name == "tilt" and "moment" not in given else None)
        if wanted is not None and not abs(getattr(solution, name) - wanted) <= 1e-12 * abs(wanted):
            faults.append((f"other {name} than prescribed", f"{getattr(solution, name)!r} for {wanted!r}"))
    return faults


def _words(solution):
    """An estimate that says the numbers are no good must be said in words."""
    estimate = solution.error_estimate
    said = any(re.search(r"error of|estimate|uncertain|%", sentence) for sentence in solution.warnings)
    bounds = {"approach": ESTIMATE_WARNED, "load": ESTIMATE_WARNED}
    cut_off = any(edge.kind.name == "CUT_OFF" for edge in solution.edge_pressure)
    if not (cut_off or solution.peaks_at_corner):
        bounds["max_pressure"] = MAXIMUM_WARNED
    return [
        (f"large estimate of {name} without a word", f"{getattr(estimate, name):.3g}")
        for name, bound in bounds.items()
        if getattr(estimate, name) > bound and not said
    ]


def _maximum(solution):
    """The maximum is the maximum pressure beyond a half-width from singular ends, or at that very border."""
    ends = [end.y for end in solution.singular_ends]
    half_width = HERTZ_RATIO[solution.element.name] * solution.element_half_width
    pressure = np.zeros(solution.strips)
    touching = half_width > 0.0
    pressure[touching] = 2.0 * solution.line_load[touching] / (math.pi * half_width[touching])
    away = np.ones(solution.strips, dtype=bool)
    for end in ends:
        away &= np.abs(solution.y - end) > half_width
    least, most = float(pressure[away].max(initial=0.0)), float(pressure.max())
    if not (1.0 - SPARE) * least <= solution.max_pressure <= (1.0 + SPARE) * (most if ends else least):
        return [("other maximum than that of the strips", f"{solution.max_pressure:.6g} for {least:.6g} to {most:.6g}")]
    if ends and np.any(away & touching):
        border = min(abs(solution.max_pressure_y - end) for end in ends)
        allowed = float(np.interp(solution.max_pressure_y, solution.y, half_width))
        if border < (1.0 - SPARE) * allowed - 8.0 * EPS * abs(solution.max_pressure_y):
            return [("maximum next to a singular end", f"{border:.6g} from it, half-width {allowed:.6g}")]
    return []


def _surfaces(solution, case):
    """Gap, curvature and pressures, at all strips or at many of them; and between them on an automatic grid."""
    touching = np.flatnonzero(solution.line_load > 0.0)
    edges, q, a = solution.edges, solution.line_load[touching], solution.element_half_width[touching]
    surfaces = Surfaces(case, edges[touching], edges[touching + 1], q, a)
    rows = _rows(touching, solution.strips)
    y = _centres(solution)[rows]
    with np.errstate(over="ignore", invalid="ignore"):
        w, bent = surfaces.displacement_and_curvature(y)
    h, roughness = _separation(case, y, float(np.max(np.abs(edges))))
    d = solution.approach + solution.tilt * y - h
    bearing = solution.line_load[rows] > 0.0
    reach = 0.5 * float(edges[-1] - edges[0])
    depth = float(np.max(d[bearing]))
    scale = depth if depth > 0.0 else abs(solution.approach) + abs(solution.tilt) * reach
    slope = sum(surfaces.compliances) * float(np.max(q / a)) * 30.0
    noise = surfaces.noise + roughness + 4.0 * EPS * float(np.max(np.abs(edges))) * slope
    noise += 8.0 * EPS * (abs(solution.approach) + np.abs(solution.tilt * y) + np.where(np.isfinite(h), np.abs(h), 0.0))
    known = np.isfinite(noise) & np.isfinite(h)
    gap, reported = np.where(known, w - d, 0.0), np.where(known, solution.gap[rows], 0.0)
    within = SERIES if surfaces.endless else GAP
    allowed = within * scale + 4.0 * noise
    faults = []
    for kind, wrong in (
        ("gap in contact", bearing & (np.abs(gap) > allowed)),
        ("overlap out of contact", ~bearing & (gap < -allowed)),
        ("reported gap is another", np.abs(gap - reported) > 10.0 * allowed),
        ("bearing where there is no body", bearing & ~np.isfinite(h)),
    ):
        if np.any(wrong):
            worst = np.flatnonzero(wrong)[np.argmax(np.abs(gap)[wrong])]
            faults.append((kind, f"{gap[worst] / scale:.2e} of the interference at y = {y[worst]:.6g}"))
    off = np.abs(bent[bearing] / curvature(case, y[bearing]) - 1.0)
    if np.any(off > (SERIES if surfaces.endless else CURVATURE)):
        faults.append(("curvature in contact", f"{np.max(off):.2e}"))
    pressure = 2.0 * q / (np.pi * a * HERTZ_RATIO[case["element"]])
    if not np.max(np.abs(solution.centre_pressure[touching] / pressure - 1.0)) < 1e-9:
        faults.append(("pressure is not that of load and width", ""))
    if case["strips"] is None and not faults:
        faults += _between_strips(solution, case, surfaces, scale)
    return faults


def _rows(touching, strips):
    """All strips, or of many the ends of contact and some in between."""
    if strips <= MOST_ROWS:
        return np.arange(strips)
    ends = np.flatnonzero(np.diff(touching) > 1)
    ends = np.concatenate([touching[:1], touching[ends], touching[ends + 1], touching[-1:]])[:40]
    near = np.concatenate([ends + by for by in (-2, -1, 0, 1, 2)])
    spread = np.linspace(0, strips - 1, MOST_ROWS // 2).astype(int)
    inside = touching[np.linspace(0, touching.size - 1, MOST_ROWS // 4).astype(int)]
    return np.unique(np.clip(np.concatenate([near, spread, inside]), 0, strips - 1))


def _separation(case, y, farthest):
    """Separation, and by how much it changes within the rounding of y."""
    by = 4.0 * EPS * farthest
    h, before, after = np.split(separation(case, np.concatenate([y, y - by, y + by])), 3)
    with np.errstate(invalid="ignore"):
        change = np.maximum(np.abs(after - h), np.abs(before - h))
    change = np.where(np.isnan(change), 0.0 if np.all(np.isfinite(h)) else np.inf, change)
    return h, change + sum(TABLE_DIGITS * amplitude for amplitude in amplitudes_from_tables(case))


def _between_strips(solution, case, surfaces, scale):
    """An automatic grid must not miss a place of contact."""
    low, high = common_interval(case)
    low, high = max(low, -1e300), min(high, 1e300)
    if not high - low < 1e299:
        half = float(solution.edges[-1] - solution.edges[0])
        low, high = max(low, solution.edges[0] - half), min(high, solution.edges[-1] + half)
    y = np.linspace(low, high, SCANNED)[1:-1]
    for start, end in solution.contact_y:
        before, after = (max(MARGIN * (end - start), _width(solution, place)) for place in (start, end))
        y = y[(y < start - before) | (y > end + after)]
    # A rough profile that is too much for the grid is said to be.
    if any("a contact region is missed" in said or "is uncertain" in said for said in solution.warnings):
        return []
    d = solution.approach + solution.tilt * y - separation(case, y)
    y, d = y[d > BETWEEN_STRIPS * scale], d[d > BETWEEN_STRIPS * scale]
    if y.size == 0:
        return []
    if y.size > 60:
        deepest = np.sort(np.argsort(d)[-60:])
        y, d = y[deepest], d[deepest]
    w, _ = surfaces.displacement_and_curvature(y)
    worst = int(np.argmin(w - d))
    overlap = float((d - w)[worst] / scale)
    if overlap <= BETWEEN_STRIPS:
        return []
    return [("a place of contact missed", f"overlap {overlap:.3g} of the interference at y = {y[worst]:.6g}")]


def _width(solution, place):
    """Width of the bearing strip nearest to an end of contact, within which it is not known."""
    nearest = np.argmin(np.where(solution.line_load > 0.0, np.abs(_centres(solution) - place), np.inf))
    return float(np.diff(solution.edges)[nearest])


def _centres(solution):
    return 0.5 * (solution.edges[1:] + solution.edges[:-1])


def sentence_faults(error, case):
    """Faults of the sentence that a case ends in: more than one line, or about what nobody gave."""
    said, faults = str(error), []
    if "\n" in said or not said.strip().endswith((".", "?")) or len(said) > 600:
        faults.append(("not one sentence", said[:200]))
    if type(error).__name__ == "ConvergenceError":
        solution = error.solution
        if solution is None or solution.status.label == "converged":
            faults.append(("ConvergenceError without the state reached", said))
        return faults
    field = error.field.split(".")[-1].split("[")[0]
    about = {"approach", "load", "tilt", "moment", "strips"}
    given = set(case["given"]) | ({"strips"} if case["strips"] is not None else set())
    if field in about and field not in given and not (field == "load" and "approach" not in given):
        faults.append((f"names {field}, which nobody gave", said))
    elif field in case["given"] and not math.isclose(error.value, case["given"][field], rel_tol=1e-12):
        faults.append((f"names another {field} than given", said))
    elif field == "strips" and isinstance(error.value, int) and error.value != _strips(case):
        faults.append(("names another number of strips than given", said))
    if re.search(r"\bnan\b", said):
        faults.append(("names nan", said))
    return faults + _false_refusal(error, field, case)


def _strips(case):
    return len(case["strips"]) - 1 if isinstance(case["strips"], list) else case["strips"]


def _false_refusal(error, field, case):
    """A refusal that is not true, as far as that can be told without solving."""
    given, said = case["given"], str(error)
    low, high = common_interval(case)
    if field == "moment" and "load" in given:
        arm = given["moment"] / given["load"]
        inside = low + 1e-12 * abs(low) < arm < high - 1e-12 * abs(high)
        if inside and np.isfinite(separation(case, np.array([arm])))[0] and "keep moment / load" in said:
            return [("refused though the moment lies within the bodies", said)]
    if field == "approach" and "begin to touch" in said and "tilt" in {*given, "tilt"} and "moment" not in given:
        strips, whole = case["strips"], (max(low, -1e6), min(high, 1e6))
        if isinstance(strips, list) and _touching(case, given, strips[0], strips[-1]):
            return [("refused though the bodies touch on the strips", said)]
        # Of given strips it says between which y.
        if not isinstance(strips, list) and _touching(case, given, *whole):
            return [("says that the bodies do not touch, which they do", said)]
    return []


def _touching(case, given, low, high):
    y = np.linspace(low, high, 4001)
    depth = given["approach"] + given.get("tilt", 0.0) * y - separation(case, y)
    noise = 1e-9 * (abs(given["approach"]) + abs(given.get("tilt", 0.0)) * float(np.max(np.abs(y))))
    return bool(np.max(depth[np.isfinite(depth)], initial=-math.inf) > noise)


def without_numbers(sentence):
    """A sentence with its numbers and what follows a colon of suggestions left out."""
    return NUMBER.sub("#", sentence)
