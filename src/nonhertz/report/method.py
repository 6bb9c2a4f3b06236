"""How a case was solved, in sentences, and the publications behind it.

Only methods that apply to the case are described. Formulas and references come from the docstrings of the functions
used.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator, Mapping
from itertools import chain
from typing import Any

import numpy as np

from nonhertz.bearing.film import Films
from nonhertz.bearing.ratings import rating
from nonhertz.errors import join_words
from nonhertz.files.bearingfile import BearingCase
from nonhertz.files.paths import body_tables
from nonhertz.files.profiles import profile_tables
from nonhertz.hertz import point_contact
from nonhertz.life import MODELS
from nonhertz.model.body import Body
from nonhertz.model.profile import CATALOGUE
from nonhertz.report.results import BearingResults, CaseResults, Results
from nonhertz.strip.element import Element
from nonhertz.subsurface import stress

_REFERENCES = re.compile(r"^References\n-+\n(.*?)(?=\n\n\w+\n---|\Z)", re.DOTALL | re.MULTILINE)
_NO_SOURCE = re.compile(r"^(Geometry|See |ISO[^;]*; see )")
_BOUSSINESQ = "J. Boussinesq, Application des potentiels, Gauthier-Villars, Paris 1885."
_SHARP_ENDS = (
    "M. Comninou, Stress singularity at a sharp edge in contact problems with friction, Zeitschrift für angewandte "
    "Mathematik und Physik 27 (1976), doi:10.1007/BF01594906; here the case without friction."
)
_BEARINGS = (
    "J. M. de Mul, J. M. Vree, D. A. Maas, Equilibrium and associated load distribution in ball and roller bearings "
    "loaded in five degrees of freedom while neglecting friction, Journal of Tribology 111 (1989) 142-155."
)
_STANDARDS = (
    "ISO 281:2007, Rolling bearings: dynamic load ratings and rating life.",
    "ISO 76:2006, Rolling bearings: static load ratings.",
)
_REFERENCE_LIFE = (
    "ISO/TS 16281:2008, Methods for calculating the modified reference rating life for universally loaded bearings."
)
_LINE_FILMS = (
    "J. Pan, B. J. Hamrock, Simple formulas for performance parameters used in elastohydrodynamically lubricated line "
    "contacts, Journal of Tribology 111 (1989) 246-251.",
    "D. Dowson, G. R. Higginson, Elasto-hydrodynamic Lubrication (1966).",
)
_ELLIPSE_FILMS = (
    "B. J. Hamrock, D. Dowson, Isothermal elastohydrodynamic lubrication of point contacts, part III, Journal of "
    "Lubrication Technology 99 (1977) 264-276.",
)
_SCHAEFFLER = "INA/FAG, Rolling Bearings, catalogue HR 1 (2006)."
_SKF = "SKF, Rolling bearings (2018)."
#: Sources by the kind of limit.
_OF_LIMITS = {
    "rib-limit": (_SKF, _SCHAEFFLER),
    "least-load": (_SKF,),
    "hoop-stress": ("NTN, Ball and Roller Bearings, catalogue 2203/E.",),
    "additives": ("SKF, Viscosity ratio (skf.com).", "ZKL, Rolling Bearings, catalogue 4/10."),
}
_SEATS = (
    "ISO 286-1:2010, ISO code system for tolerances on linear sizes.",
    "ISO 492:2014, Rolling bearings: radial bearings, geometrical product specifications and tolerance values.",
)
_GROUPS = ("ISO 5753-1:2009, Rolling bearings: radial internal clearance of radial bearings.",)
_STRIPS = (
    "Each has a load and a half-width, its pressure is {element} across, and all strips interact through both elastic "
    "bodies."
)
_IN_CONTACT = (
    "The contact is cut along y into {strips} strips. {one} One Newton loop finds all loads and half-widths, approach "
    "and tilt together, such that both surfaces touch on the centre line of every loaded strip, to second order "
    "across, and no strip is in tension. Bodies are linear elastic half-spaces (Boussinesq), without friction, and the "
    "separation across the contact is parabolic."
)
_IN_BEARING = (
    "The inner ring has five degrees of freedom, the outer ring is fixed. Each roller is in equilibrium under the "
    "loads of both raceways, of ribs that are loaded, centrifugal force and gyroscopic moment. The displacements of "
    "the rollers, unloaded ones included, are eliminated exactly, which leaves the stiffness of the inner ring. "
    "Newton's method finds the displacement of the inner ring from the prescribed forces, moments and displacements."
)
_BEYOND = (
    "Away from the contact, bodies keep their shape (no bending of rollers, rings or shafts), and no other contact "
    "acts on them, except an equal one on the opposite side of a whole roller."
)


def formula(function: Callable[..., Any] | None) -> str:
    """Return the text of a profile's docstring between its first line and its parameters."""
    words = (inspect.getdoc(function) or "") if function else ""
    body = words.partition("\n\n")[2]
    for section in ("Parameters\n", "Returns\n", "Examples\n"):
        body = body.partition(section)[0]
    return _join_lines(body)


def source(documented: Any) -> str:
    """Return the references in a docstring; empty if there are none."""
    match = _REFERENCES.search((inspect.getdoc(documented) or "") if documented else "")
    return _join_lines(match[1]) if match else ""


def describe_method(result: Results) -> tuple[list[str], list[str]]:
    """Return the description of the method, a paragraph for each part, and the references without repeats."""
    parts = list(_describe_bearing(result) if isinstance(result, BearingResults) else _describe_contact(result))
    references = dict.fromkeys(reference for _, sources in parts for reference in sources if reference)
    return [words for words, _ in parts if words], list(references)


def _describe_contact(result: CaseResults) -> Iterator[tuple[str, list[str]]]:
    solution = result.solution
    contact = solution.contact
    sources = [source(Element), _BOUSSINESQ, *_profile_sources(result.case.document)]
    yield _IN_CONTACT.format(strips=solution.strips, one=_STRIPS.format(element=solution.element.name)), sources
    yield from _describe_bodies({"body a": contact.a, "body b": contact.b})
    yield _BEYOND, [_SHARP_ENDS] if solution.singular_ends else []
    if result.stress:
        words = (
            "Stress below the surface is integrated from the pressure of the strips, interpolated between their "
            "centres, with the same images behind side faces. The largest values are searched for throughout body "
            f"{result.stress[0].body} below the contact."
        )
        yield words, [source(stress)]
    if result.lives:
        words = (
            "Life follows from the stresses at every point of both bodies during a pass of the load. It is relative to "
            "the life under Hertz's line pressure with the load spread evenly."
        )
        yield words, [source(stress), *(source(MODELS[life.model.name]) for life in result.lives.lives["a"])]


def _describe_bearing(result: BearingResults) -> Iterator[tuple[str, list[str]]]:
    yield from chain(_describe_rows(result), _describe_classes(result.case), _describe_operation(result))


def _describe_rows(result: BearingResults) -> Iterator[tuple[str, list[str]]]:
    """Yield how rollers, rings and ribs are solved."""
    strips = result.case.solver.method == "strips"
    row = result.case.bearing.rows[0].bearing
    profiles = [*_profile_sources(result.case.document)]
    yield _IN_BEARING, [_BEARINGS]
    if strips:
        words = (
            "Each contact of a roller with a raceway is solved at its approach and tilt: it is cut along the roller "
            f"into strips on an automatic grid. {_STRIPS.format(element='semi-elliptic')}"
        )
        yield words, [source(Element), _BOUSSINESQ, *profiles]
        yield from _describe_bodies({"a roller": row.roller, "the inner ring": row.inner, "the outer ring": row.outer})
    else:
        words = (
            "Contacts are the slices of ISO/TS 16281: independent of each other, equally stiff at both rings, and "
            "without pressures."
        )
        yield words, [*profiles, _REFERENCE_LIFE]
    if row.rib_contacts:
        words = "Ribs and the spherical ends of the rollers touch over ellipses (Hertz)." if strips else ""
        yield words, [source(point_contact)]


def _describe_classes(case: BearingCase) -> Iterator[tuple[str, list[str]]]:
    """Yield the meaning of classes of fits and groups of clearance."""
    fit = case.fit
    seats = fit is not None and any(seat.fit and seat.interference is None for seat in (fit.shaft, fit.housing))
    group = isinstance(getattr(case.bearing.rows[0].bearing, "clearance", None), str)
    if seats or group:
        used = ["The limits of seats are those of ISO 286, of rings those of ISO 492."] if seats else []
        used += ["The limits of the clearance are those of its group in ISO 5753-1."] if group else []
        yield " ".join([*used, "The mean is used as the likely value."]), [*_SEATS * seats, *_GROUPS * group]


def _describe_operation(result: BearingResults) -> Iterator[tuple[str, list[str]]]:
    """Yield the methods for lives, films, friction and limits."""
    if result.solution is None:
        return
    strips = result.case.solver.method == "strips"
    if result.life is not None:
        edges = " Edge stresses of the laminae are the pressures of the strips." if strips else ""
        words = (
            "Ratings are those of ISO 281 and ISO 76 unless given. L10 follows from the equivalent load, L10r from the "
            f"loads of all laminae of all rollers, and the modified life from lubrication and reliability.{edges}"
        )
        yield words, [*_STANDARDS, source(rating), _REFERENCE_LIFE]
    films = result.case.films(result.solution)
    if films is not None:
        words = (
            "Oil films are isothermal and fully flooded, of line contacts with the local load, radius and speed along "
            "the rollers, or of an elliptical contact; side leakage is neglected. Rollers roll without sliding in the "
            "middle of their length."
        )
        yield words, _film_sources(films)
    if result.case.friction(result.solution) is not None:
        words = (
            "Friction torque and power are empirical, after Palmgren, with manufacturers' factors for each series. At "
            "the thermal speed the heat of this torque equals the heat dissipated through the seats by ISO 15312."
        )
        yield words, [_SCHAEFFLER, "ISO 15312:2018, Rolling bearings - Thermal speed rating - Calculation."]
    if limits := result.case.limits(result.solution):
        sources = [*chain.from_iterable(_OF_LIMITS.get(limit.kind, ()) for _, limit in limits)]
        yield "Manufacturers' limits are rules of thumb from their catalogues.", sources
    if result.slices is not None:
        words = (
            "For comparison the bearing was also solved by the independent slices of ISO/TS 16281, with two equal "
            "contacts in series for each roller."
        )
        yield words, [_REFERENCE_LIFE]


def _film_sources(films: Films) -> list[str]:
    """Return the publications on films of line contacts and elliptical contacts, if there are any."""
    ellipses = films.elliptic[films.solution.load > 0.0]
    return [*(() if np.all(ellipses) else _LINE_FILMS), *(_ELLIPSE_FILMS if np.any(ellipses) else ())]


def _profile_sources(document: Mapping[str, Any]) -> Iterator[str]:
    """Yield the publications behind the profiles in a document."""
    for _, body in body_tables(document):
        for table in profile_tables(body):
            words = source(CATALOGUE.get(table["kind"]))
            if not _NO_SOURCE.match(words):
                yield words


def _describe_bodies(bodies: Mapping[str, Body]) -> Iterator[tuple[str, list[str]]]:
    """Yield how side faces and depths are modelled, once for bodies that are alike."""
    for describe in (_describe_sides, _describe_depth):
        alike: dict[str, list[str]] = {}
        for name, body in bodies.items():
            alike.setdefault(describe("{name}", body), []).append(name)
        for words, names in alike.items():
            yield words.format(name=join_words(names)), [bodies[name].behind.source for name in names]


def _describe_depth(name: str, body: Body) -> str:
    """Return the sentence on the reference point of displacement; ``name`` is that of the body."""
    return f"Displacement of {name} is measured against {body.behind.place}."


def _describe_sides(name: str, body: Body) -> str:
    """Return the sentences on the side faces of a body, named ``name``; empty if it has none."""
    sentences = []
    sides = zip(body.face_weights, body.free_faces, strict=True)
    if any(body.free_faces):
        sentences.append(
            f"The side faces of {name} are free of shear and normal stress, also below the surface, as those of an "
            "elastic quarter-space."
        )
    weights = [weight for weight, free in sides if weight > 0.0 and not free]
    if weights:
        parts = " and ".join(f"{weight:.3g}" for weight in dict.fromkeys(weights))
        sentences.append(
            f"Mirror images of the pressure with weight {parts} free the side faces of {name} from shear. A normal "
            "stress remains on them, so the true pressure at an end is lower."
        )
    return " ".join(sentences)


def _join_lines(text: str) -> str:
    """Return a docstring's lines as one paragraph, without code markup."""
    return " ".join(text.replace("`", "").split())
