"""How a bearing was solved, in sentences, and the publications behind it."""

from __future__ import annotations

from nonhertz.bearing.ratings import rating
from nonhertz.hertz import point_contact
from nonhertz.report.bearing.results import BearingResults
from nonhertz.report.method import body_words, profile_sources, source
from nonhertz.strip.element import Element

_BEARINGS = (
    "J. M. de Mul, J. M. Vree, D. A. Maas, Equilibrium and associated load distribution in ball and roller bearings "
    "loaded in five degrees of freedom while neglecting friction, Journal of Tribology 111 (1989) 142-155."
)
_STANDARDS = (
    "ISO 281, Rolling bearings: dynamic load ratings and rating life.",
    "ISO 76, Rolling bearings: static load ratings.",
)
_REFERENCE_LIFE = (
    "ISO/TS 16281, Methods for calculating the modified reference rating life for universally loaded bearings."
)
_PARTS = {"roller": "a roller", "inner": "the inner ring", "outer": "the outer ring"}


def bearing_paragraphs(found: BearingResults) -> list[str]:
    """Return how the bearing was solved, a paragraph for each part of the method."""
    strips = found.case.solver.get("method", "strips") == "strips"
    row = found.case.bearing.rows[0].bearing
    parts = [
        "The inner ring has five degrees of freedom, the outer one is at rest. Each roller is in balance by itself: "
        "between both raceways and, where they bear loads, ribs, and under centrifugal force and gyroscopic moment. "
        "Its motion is eliminated exactly, which leaves the stiffness of the ring, and Newton's method finds the "
        "motion that goes with the given forces, moments and displacements. Rollers without load are part of it.",
    ]
    if strips:
        parts.append(
            "Each contact of a roller with a raceway is solved at its approach and tilt: it is cut along the roller "
            "into strips on an automatic grid, each of which carries a load and a half-width, with a semi-elliptic "
            "pressure across. All strips of a contact act on each other through both elastic bodies."
        )
        parts += [" ".join(body_words(words, getattr(row, name))) for name, words in _PARTS.items()]
    else:
        parts.append(
            "Contacts are the slices of ISO/TS 16281: independent of each other, of equal stiffness at both rings, "
            "without pressures."
        )
    if row.rib_contacts and strips:
        parts.append("Ribs press on the spherical ends of the rollers over ellipses after Hertz.")
    if found.slices is not None:
        parts.append(
            "For comparison the bearing was solved once more by the independent slices of ISO/TS 16281, two equal "
            "contacts in series for each roller."
        )
    if found.life is not None:
        edges = " The edges of the laminae take the pressures of the strips." if strips else ""
        parts.append(
            "Ratings are those of ISO 281 and ISO 76 unless given. L10 follows from the equivalent load, L10r from the "
            f"loads of all laminae of all rollers, and the modified life from lubrication and reliability.{edges}"
        )
    return parts


def bearing_references(found: BearingResults) -> list[str]:
    """Return the publications that this bearing draws on, without repeats."""
    strips = found.case.solver.get("method", "strips") == "strips"
    row = found.case.bearing.rows[0].bearing
    parts = [_BEARINGS]
    if strips:
        parts += [source(Element), "J. Boussinesq, Application des potentiels, Gauthier-Villars, Paris 1885."]
        parts += [source(type(body.behind)) for body in (row.roller, row.inner, row.outer)]
    parts += profile_sources(found.case.document)
    if row.rib_contacts:
        parts.append(source(point_contact))
    if found.life is not None:
        parts += [*_STANDARDS, source(rating)]
    if found.life is not None or found.slices is not None or not strips:
        parts.append(_REFERENCE_LIFE)
    return list(dict.fromkeys(each for each in parts if each))
