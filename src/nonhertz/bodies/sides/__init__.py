"""Ways to treat a side face, one file each; a new one appears in Python, case files and web form at once."""

from __future__ import annotations

from numbers import Real
from typing import Final

from nonhertz.bodies.sides.calibrated import Calibrated
from nonhertz.bodies.sides.free import Free
from nonhertz.bodies.sides.half_space import HalfSpace
from nonhertz.bodies.sides.mirror import Mirror
from nonhertz.bodies.sides.side_face import SideFace
from nonhertz.bodies.sides.weighted import Weighted
from nonhertz.errors import InputError
from nonhertz.inputs.checks import not_negative

FaceRule = str | float

#: Treatments by their keywords.
SIDE_FACES: Final[dict[str, SideFace]] = {face.word: face for face in (Free(), Mirror(), Calibrated(), HalfSpace())}

WORDS: Final = ", ".join(map(repr, SIDE_FACES))
_REMEDY: Final = f"write {WORDS} or {Weighted.meaning}, or a pair for low and high y"


def side_faces(rule: FaceRule | tuple[FaceRule, FaceRule]) -> tuple[SideFace, SideFace]:
    """Return the treatments of the faces at low and high y.

    Raises
    ------
    InputError
        If ``rule`` is neither one of the words nor a number of at least zero, nor a pair of these.
    """
    pair = rule if isinstance(rule, (tuple, list)) else (rule, rule)
    if len(pair) != 2:
        raise InputError("side_faces", rule, "be one rule, or a pair of rules", _REMEDY)
    return _side_face(pair[0]), _side_face(pair[1])


def _side_face(rule: FaceRule) -> SideFace:
    if isinstance(rule, str) and rule in SIDE_FACES:
        return SIDE_FACES[rule]
    if isinstance(rule, bool) or not isinstance(rule, Real):
        raise InputError("side_faces", rule, f"be one of {WORDS} or a weight", _REMEDY)
    not_negative("side_faces", rule, _REMEDY)
    return Weighted(float(rule))
