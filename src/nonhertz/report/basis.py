"""What several cases rest on, where that differs so much that their numbers do not compare.

Each sentence names the numbers concerned, and what they rest on in which case. Dimensions of the bodies are what is
compared; they stand in the table of inputs that differ.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

from nonhertz.amounts import given, mm, mpa, mrad, newton, newton_mm
from nonhertz.model.body import BODIES, Body
from nonhertz.model.materials import MATERIALS
from nonhertz.report.results import CaseResults
from nonhertz.result.solution import Status


def basis(found: Sequence[CaseResults]) -> list[str]:
    """Return a sentence for each difference between cases that keeps numbers from being compared."""
    return list(_of_cases(found))


def _of_cases(found: Sequence[CaseResults]) -> Iterator[str]:
    labels = [each.label for each in found]
    for sentence, words in (
        ("Pressures, approaches and lives are those of different loads", _load),
        ("Results are those of different alignment", _alignment),
        ("Loads per length differ with the length over which the bodies can touch", _touching),
    ):
        yield from differing(labels, sentence, map(words, found))
    for name in BODIES:
        yield from of_body(labels, f"body {name}", [getattr(each.solution.contact, name) for each in found])
    for sentence, words in (
        ("Maximum pressures not comparable", _maximum),
        ("Differences of a few per cent may come from the strips, which are of different elements", _element),
        ("Small differences may come from the grids, which are of different accuracy", _accuracy),
    ):
        yield from differing(labels, sentence, map(words, found))


def of_body(labels: Sequence[str], name: str, bodies: Sequence[Body]) -> Iterator[str]:
    """Yield how cases differ in what a body is measured against, in its side faces and in its material."""
    for sentence, words in (
        (f"Approaches not comparable, since displacement of {name} is measured against different points", _reference),
        (f"Pressures near the ends not comparable, since side faces of {name} are treated differently", _faces),
        (f"Pressures and approaches are those of different materials of {name}", _material),
    ):
        yield from differing(labels, sentence, map(words, bodies))


def differing(labels: Sequence[str], sentence: str, words: Iterable[str]) -> Iterator[str]:
    """Yield the sentence with the words on each case, unless all are the same; a case without words does not count."""
    of: dict[str, list[str]] = {}
    for label, said in zip(labels, words, strict=True):
        if said:
            of.setdefault(said, []).append(label)
    if len(of) > 1:
        parts = "; ".join(f"{said} ({', '.join(names)})" for said, names in of.items())
        yield f"{sentence}: {parts}."


def _load(found: CaseResults) -> str:
    load = found.case.prescribed.get("load")
    return "an approach is given" if load is None else f"{newton(load):g}"


def _alignment(found: CaseResults) -> str:
    prescribed = found.case.prescribed
    if "moment" in prescribed:
        return f"a moment of {newton_mm(prescribed['moment']):g}"
    return f"a tilt of {mrad(prescribed.get('tilt', 0.0)):.4g}"


def _touching(found: CaseResults) -> str:
    low, high = found.solution.contact.interval
    if not math.isfinite(high - low):
        return "any length"
    bodies = found.solution.contact.a, found.solution.contact.b
    effective = any(body.effective_length is not None for body in bodies)
    return f"{mm(high - low):g}{', an effective length' if effective else ''}"


def _faces(body: Body) -> str:
    """Return how side faces are treated; nothing of a body without any, which has no ends to compare."""
    if body.length is None:
        return ""
    faces = body.side_faces if isinstance(body.side_faces, tuple) else (body.side_faces,)
    return " and ".join(face if isinstance(face, str) else given(face) for face in faces)


def _material(body: Body) -> str:
    name = next((name for name, known in MATERIALS.items() if known == body.material), "")
    return name or f"E = {mpa(body.material.modulus):g}, ν = {given(body.material.poisson)}"


def _reference(body: Body) -> str:
    return body.behind.place.replace(": ", ", ")


def _element(found: CaseResults) -> str:
    return found.solution.element.name


def _maximum(found: CaseResults) -> str:
    solution = found.solution
    if solution.status is not Status.CONVERGED:
        return ""
    if solution.peaks_at_corner:
        return "at a corner of the profile, where the pressure has no limit"
    if solution.singular_ends:
        return "away from singular ends, where the pressure has no limit"
    return "of the whole contact"


def _accuracy(found: CaseResults) -> str:
    solver = found.case.solver
    if solver["strips"] != "auto":
        return f"{solver['strips']} strips" if isinstance(solver["strips"], int) else "strips by their edges"
    return f"{1e-4 if solver['accuracy'] is None else solver['accuracy']:g}"
