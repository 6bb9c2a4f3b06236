"""How a case was solved, in sentences, and the publications behind it.

Only what applies to the case is mentioned. Formulas and references come from the docstrings of the functions used.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from nonhertz.files.origin import body_tables
from nonhertz.files.profiles import profile_tables
from nonhertz.life import MODELS
from nonhertz.model.body import Body
from nonhertz.model.profile import CATALOGUE
from nonhertz.report.results import CaseResults
from nonhertz.strip.element import Element
from nonhertz.subsurface import stress

_REFERENCES = re.compile(r"^References\n-+\n(.*?)(?=\n\n\w+\n---|\Z)", re.DOTALL | re.MULTILINE)
_NO_SOURCE = re.compile(r"^(Geometry|See |ISO[^;]*; see )")
_SHARP_ENDS = (
    "M. Comninou, Stress singularity at a sharp edge in contact problems with friction, Zeitschrift für angewandte "
    "Mathematik und Physik 27 (1976), doi:10.1007/BF01594906; here the case without friction."
)


def formula(function: Callable[..., Any] | None) -> str:
    """Return the text of a profile's docstring between its first line and its parameters."""
    words = (inspect.getdoc(function) or "") if function else ""
    body = words.partition("\n\n")[2]
    for section in ("Parameters\n", "Returns\n", "Examples\n"):
        body = body.partition(section)[0]
    return _flowing(body)


def source(documented: Any) -> str:
    """Return the references in a docstring; empty if there are none."""
    found = _REFERENCES.search((inspect.getdoc(documented) or "") if documented else "")
    return _flowing(found[1]) if found else ""


def paragraphs(found: CaseResults) -> list[str]:
    """Return how the case was solved, a paragraph for each part of the method."""
    solution = found.solution
    contact = solution.contact
    parts = [
        f"The contact is cut along y into {solution.strips} strips. Each carries a load and a half-width, its pressure "
        f"is {solution.element.name} across, and all strips act on each other through both elastic bodies. One Newton "
        "loop finds all loads and half-widths, approach and tilt together, so that both surfaces touch on the centre "
        "line of every strip that bears load, to second order across, and no strip pulls. Bodies are linear elastic "
        "half-spaces (Boussinesq), without friction, and the separation across the contact is parabolic.",
    ]
    parts += [" ".join(body_words(name, body)) for name, body in (("body a", contact.a), ("body b", contact.b))]
    if found.stress:
        parts.append(
            "Stress below the surface is integrated from the pressure of the strips, which follows it between their "
            "centres, with the same images behind side faces. The largest values are searched for throughout body "
            f"{found.stress[0].body} below the contact."
        )
    if found.lives:
        parts.append(
            "Life follows from the stresses that every point of both bodies undergoes during a pass of the load. It is "
            "given relative to the life under Hertz's line pressure with the load spread evenly."
        )
    return parts


def references(found: CaseResults) -> list[str]:
    """Return the publications that this case draws on, without repeats."""
    parts = [
        source(Element),
        "J. Boussinesq, Application des potentiels, Gauthier-Villars, Paris 1885.",
        *profile_sources(found.case.document),
    ]
    bodies = found.solution.contact.a, found.solution.contact.b
    parts += [source(type(body.behind)) for body in bodies]
    if found.solution.singular_ends:
        parts.append(_SHARP_ENDS)
    if found.stress or found.lives:
        parts.append(source(stress))
    if found.lives:
        parts += [source(MODELS[life.model.name]) for life in found.lives.lives["a"]]
    return list(dict.fromkeys(each for each in parts if each))


def profile_sources(document: Mapping[str, Any]) -> Iterator[str]:
    """Yield the publications behind the profiles in a document."""
    for _, body in body_tables(document):
        for table in profile_tables(body):
            words = source(CATALOGUE.get(table["kind"]))
            if not _NO_SOURCE.match(words):
                yield words


def body_words(name: str, body: Body) -> Iterator[str]:
    """Yield how side faces and depth of a body are modelled; ``name`` is what the sentences call it."""
    sides = zip(body.face_weights, body.free_faces, strict=True)
    if any(body.free_faces):
        yield (
            f"Side faces of {name} are free of shear and of normal stress, as those of an elastic quarter-space, below "
            "the surface, too."
        )
    weights = [weight for weight, free in sides if weight > 0.0 and not free]
    if weights:
        parts = " and ".join(f"{weight:.3g}" for weight in dict.fromkeys(weights))
        yield (
            f"Side faces of {name} are freed of shear by mirror images of the pressure with the weight {parts}. A "
            "normal stress remains on them, so the true pressure at an end is lower."
        )
    yield f"Displacement of {name} is measured against {body.behind.place}."


def _flowing(text: str) -> str:
    """Return a docstring's lines as one paragraph, without code markup."""
    return " ".join(text.replace("`", "").split())
