"""Reference points of displacement, one row for each; a new row appears in Python, case files and web form.

Their effect on the influence of loads is in `nonhertz.bodies.depths`.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from nonhertz.amounts import mm
from nonhertz.errors import InputError
from nonhertz.model.outline import refuse_unless_whole

if TYPE_CHECKING:
    from nonhertz.model.body import Body

DepthRule = str | float


def _refuse_free_faces(body: Body) -> None:
    if any(body.free_faces):
        remedy = "write depth = 'finite', or side_faces = 'mirror'"
        raise InputError("depth", body.behind.word, "not be used for a body with free side faces", remedy)


@dataclass(frozen=True)
class Depth:
    """Reference point of a body's displacement.

    Attributes
    ----------
    word : str
        Its keyword in files and Python; empty if given as a number.
    meaning : str
        Its place, as it follows the word in descriptions of case files.
    reference : str
        The same, as it follows "is measured against".
    of_diameter : bool
        Whether it requires a body that is convex everywhere.
    whole : bool
        Whether the body deforms as a whole, with its bore if it has one.
    refuse : callable
        Raises `InputError` for a body that cannot have it.
    source : str
        The publication behind it.
    thickness : float
        The number [mm], infinite where it is a word.
    """

    word: str
    meaning: str
    reference: str
    of_diameter: bool = False
    whole: bool = False
    refuse: Callable[[Body], None] = lambda body: None
    source: str = ""
    thickness: float = math.inf

    @property
    def shown(self) -> str:
        """Its value in a file."""
        return self.word or f"{mm(self.thickness):.6g}"

    @property
    def place(self) -> str:
        """The reference, with its number if it has one."""
        return self.reference if self.word else self.reference.format(f"{mm(self.thickness):.6g}")


#: Choices by their keywords.
DEPTHS: Final = {
    depth.word: depth
    for depth in (
        Depth("none", "far away", "a point far away: it is a half-space of infinite depth"),
        Depth(
            "plane-strain",
            "at the depth at which a long cylinder has the compression of plane strain",
            "the depth that makes the compression of a long cylinder that of plane strain",
            of_diameter=True,
            source="K. L. Johnson, Contact Mechanics, Cambridge University Press, 1985, Section 5.6, Eq. (5.57), "
            "doi:10.1017/CBO9781139171731.",
        ),
        Depth("diameter", "a diameter below the surface", "a point its diameter below the surface", of_diameter=True),
        Depth(
            "cylinder",
            "on the axis of a cylinder of infinite length that deforms as a whole",
            "its axis, and it deforms as a solid cylinder of infinite length, equally loaded on the opposite side",
            of_diameter=True,
            refuse=_refuse_free_faces,
            source="Y. P. Chiu and M. J. Hartnett, A numerical solution for the contact problem involving bodies with "
            "cylindrical surface considering cylinder effect, Journal of Tribology 109 (1987) 479-485, "
            "doi:10.1115/1.3261480.",
        ),
        Depth(
            "finite",
            "on the axis of a roller that deforms as a whole, which needs side_faces = 'free' and a length",
            "its axis, and it deforms as a whole, equally loaded on the opposite side",
            of_diameter=True,
            whole=True,
            refuse=refuse_unless_whole,
        ),
    )
}
THICKNESS: Final = "a depth below the surface [mm], such as the thickness of a ring"
DEPTH_REMEDY: Final = f"write {', '.join(map(repr, DEPTHS))} or a depth in mm such as the thickness of a ring"


def depth_of(rule: DepthRule, convex: bool) -> Depth:
    """Return the reference point that a rule stands for.

    Raises
    ------
    InputError
        If it requires a diameter and the body is not ``convex``.
    """
    if not isinstance(rule, str):
        return Depth("", THICKNESS, "a point {} below the surface", thickness=float(rule))
    if DEPTHS[rule].of_diameter and not convex:
        remedy = "give the thickness of a ring or plate in mm, or write 'none'"
        raise InputError("depth", rule, "only be used for a convex body, which has a diameter", remedy)
    return DEPTHS[rule]
