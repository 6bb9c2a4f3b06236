"""Ways to treat a side face, one file each; a new one appears in Python, case files and web form at once."""

from __future__ import annotations

from typing import Final

from nonhertz.bodies.sides.calibrated import Calibrated
from nonhertz.bodies.sides.free import Free
from nonhertz.bodies.sides.half_space import HalfSpace
from nonhertz.bodies.sides.mirror import Mirror
from nonhertz.bodies.sides.side_face import SideFace
from nonhertz.bodies.sides.weighted import Weighted

FaceRule = str | float

#: Treatments by their keywords.
SIDE_FACES: Final[dict[str, SideFace]] = {face.word: face for face in (Free(), Mirror(), Calibrated(), HalfSpace())}

WORDS: Final = ", ".join(map(repr, SIDE_FACES))
REMEDY: Final = f"write {WORDS} or {Weighted.meaning}, or a pair for low and high y"


def side_faces(rule: FaceRule | tuple[FaceRule, FaceRule]) -> tuple[SideFace, SideFace]:
    """Return the treatments of the faces at low and high y by a rule, or a pair of them."""
    low, high = rule if isinstance(rule, tuple) else (rule, rule)
    return _side_face(low), _side_face(high)


def _side_face(rule: FaceRule) -> SideFace:
    return SIDE_FACES[rule] if isinstance(rule, str) else Weighted(float(rule))
