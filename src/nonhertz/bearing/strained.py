"""Strains of the model of a loaded bearing: contacts by strips, rib contacts that reach an edge, bores."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

import numpy as np

from nonhertz.amounts import mm
from nonhertz.bearing.section import RINGS
from nonhertz.findings import Finding, finding
from nonhertz.life.capacity import is_hollow

if TYPE_CHECKING:
    from nonhertz.bearing.solution import BearingSolution


def findings_of(solution: BearingSolution) -> tuple[Finding, ...]:
    """Return the strains of the model; of each kind the first finding, from the most loaded roller down."""
    findings = _of_strips(solution) if solution.method == "strips" else []
    findings += _of_ribs(solution)
    if solution.method == "slices" and any(is_hollow(row.bearing.roller) for row in solution.bearing.rows):
        words = "Slices treat hollow rollers as solid ones, which are stiffer: solve the bearing by strips."
        findings.append(finding("hollow-by-slices", words))
    return tuple(findings)


def _of_ribs(solution: BearingSolution) -> list[Finding]:
    """Return a finding for each ring whose most loaded rib contact reaches an edge."""
    findings = []
    for ring in RINGS:
        most = [
            (float(loads.max()), int(loads.argmax()), rib) for loads, rib in solution.loaded_ribs if rib.ring == ring
        ]
        load, j, rib = max(most, key=lambda loaded: loaded[0], default=(0.0, 0, None))
        if rib is not None and rib.reaches_an_edge(load):
            reach = rib.under(load).half_length
            words = (
                "The contact of roller {roller} with a rib of the {ring} ring reaches {reach:.3g} along the flank, "
                "beyond an edge at {room:.3g}, where the pressure is higher than Hertz's."
            )
            findings.append(finding("rib-edge", words, roller=j + 1, ring=ring, reach=mm(reach), room=mm(rib.room)))
    return findings


def _of_strips(solution: BearingSolution) -> list[Finding]:
    """Return the strains of contacts, with the number of similar ones."""
    first: dict[str, tuple[str, Finding]] = {}
    times: Counter[str] = Counter()
    rank = np.argsort(np.argsort(-solution.load.max(axis=1), kind="stable"))
    foremost = [(min(contact.rollers, key=rank.__getitem__), contact) for contact in solution.distinct_contacts]
    for j, contact in sorted(foremost, key=lambda pair: (rank[pair[0]], pair[1].ring)):
        for strain in contact.solved.findings:
            first.setdefault(strain.kind, (f"{solution.place_of(j)}, {RINGS[contact.ring]} ring", strain))
            times[strain.kind] += len(contact.rollers)
    more = " (And {more} more of the kind.)"
    return [
        finding(
            kind,
            f"{{place}}: {{found}}{more if times[kind] > 1 else ''}",
            place=place,
            found=strain,
            more=times[kind] - 1,
        )
        for kind, (place, strain) in first.items()
    ]
