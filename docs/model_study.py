"""Write docs/explain/model-table.md: what each choice of side faces and depth changes in typical contacts.

    python docs/model_study.py

Every contact is solved with every choice for its roller; the ring is a half-space and goes on beyond the roller. Listed
are differences from free ends of the whole roller, which the claims on whole rollers set against
three-dimensional finite elements.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterator
from dataclasses import astuple, dataclass
from pathlib import Path

import numpy as np

import nonhertz as nh

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "explain" / "model-table.md"
REFERENCE = ("free", "finite")
CHOICES = (
    ("free", "plane-strain"), ("free", "diameter"), ("free", "none"), ("calibrated", "plane-strain"),
    ("mirror", "plane-strain"), ("mirror", "cylinder"), ("mirror", "diameter"), ("none", "plane-strain"),
    ("none", "none"),
)  # fmt: skip
HEADINGS = (
    "`side_faces`, `depth`", "approach", "moment", "stiffness", "maximum pressure", "near the end", "life, volume",
    "life, laminae",
)  # fmt: skip

_OPENING = """\
# What each choice of side faces and depth changes

Computed by `docs/model_study.py`. The choices: [side faces, depth](model-choices.md).

The choice is that of the roller, all of steel; the ring is a half-space without ends. The first row is the whole roller
with free ends, whose displacements agree with [finite elements](../validation/whole-roller.md) within 0.3 %; the others
differ from it by as many per cent. *Stiffness* is the derivative of load by approach; *near the end* the pressure one
half-width inside the contact, at its more heavily loaded end. Lives are those of the ring relative to a uniform line
contact, by Lundberg and Palmgren's volume and by the laminae of ISO/TS 16281.
"""


@dataclass(frozen=True)
class Case:
    """A roller on a ring, at the tilt that its moment is read at, and whether all else is, too."""

    name: str
    roller: Callable[..., nh.Roller]
    ring: float  # mm
    load: float  # N
    tilt: float  # rad
    stays_tilted: bool

    def contact(self, side_faces: str, depth: str) -> nh.Contact:
        """Return the contact with a choice of models."""
        return nh.Contact(
            self.roller(side_faces=side_faces, depth=depth),
            nh.Ring(diameter=self.ring, side_faces="none", depth="none"),
        )


@dataclass(frozen=True)
class Found:
    """What the table compares, in the order of its columns."""

    approach: float
    moment: float
    stiffness: float
    max_pressure: float
    near_end: float
    volume_life: float
    lamina_life: float


def straight(**models: str) -> nh.Roller:
    """Return a straight roller with rounded corners."""
    return nh.Roller(diameter=20.0, length=20.0, corner_radius=0.5, **models)  # type: ignore[arg-type]


def logarithmic(**models: str) -> nh.Roller:
    """Return a roller with the profile of ISO/TS 16281, scaled to a drop at the end of its land."""
    profile = nh.profile.with_drop("iso-logarithmic", drop=0.02, at=9.5, diameter=15.0, length=20.0)
    return nh.Roller(diameter=15.0, length=20.0, corner_radius=0.5, profile=profile, **models)  # type: ignore[arg-type]


def crowned(**models: str) -> nh.Roller:
    """Return a crowned roller."""
    return nh.Roller(diameter=20.0, length=20.0, profile=nh.profile.crown(3000.0), **models)  # type: ignore[arg-type]


CASES = (
    Case(
        "A straight roller of 20 x 20 mm, corners of 0.5 mm, on a ring of 80 mm, 20 kN, aligned; moment at 0.3 mrad",
        straight, 80.0, 20e3, 0.3e-3, stays_tilted=False,
    ),
    Case(
        "A logarithmic roller of 15 x 20 mm (drop 20 um), corners of 0.5 mm, on a ring of 60 mm, 30 kN, tilted by 2 "
        "arc-minutes",
        logarithmic, 60.0, 30e3, math.radians(2.0 / 60.0), stays_tilted=True,
    ),
    Case(
        "A crowned roller of 20 x 20 mm (radius 3 m) on a ring of 80 mm, 10 kN, aligned; moment at 0.3 mrad",
        crowned, 80.0, 10e3, 0.3e-3, stays_tilted=False,
    ),
)  # fmt: skip


def main() -> None:
    """Solve and write the page."""
    warnings.simplefilter("ignore", nh.AccuracyWarning)
    PAGE.write_text("\n".join(_page()) + "\n", encoding="utf-8")
    print(f"wrote {PAGE.relative_to(ROOT)}")


def _page() -> Iterator[str]:
    yield from _OPENING.splitlines()
    for case in CASES:
        reference = nh.solve(case.contact(*REFERENCE), load=case.load, tilt=case.tilt * case.stays_tilted)
        place = reference.contact_y[-1][1] - float(np.interp(0.0, reference.y, reference.half_width))
        exact = found(case, REFERENCE, place)
        yield from ("", f"## {case.name}", "")
        yield f"| {' | '.join(HEADINGS)} |"
        yield "|---|" + "---:|" * (len(HEADINGS) - 1)
        yield _row(REFERENCE, _absolute(exact))
        for choice in CHOICES:
            other = zip(astuple(found(case, choice, place)), astuple(exact), strict=True)
            yield _row(choice, [f"{round(100.0 * (a / b - 1.0), 1) + 0.0:+.1f}" for a, b in other])  # no -0.0


def found(case: Case, choice: tuple[str, str], place: float) -> Found:
    """Return what one choice says, with the pressure at y = ``place`` [mm]."""
    contact = case.contact(*choice)
    tilted = nh.solve(contact, load=case.load, tilt=case.tilt)
    one = tilted if case.stays_tilted else nh.solve(contact, load=case.load)
    volume, laminae = nh.life.assess(one, ("lundberg-palmgren", "iso-16281"), body="b", rollers=14)
    return Found(
        one.approach,
        tilted.moment,
        float(one.stiffness[0, 0]),
        one.max_pressure,
        float(np.interp(place, one.y, one.centre_pressure)),
        volume.relative_life,
        laminae.relative_life,
    )


def _absolute(exact: Found) -> list[str]:
    return [
        f"{1e3 * exact.approach:.2f} um",
        f"{1e-3 * exact.moment:.2f} Nm",
        f"{1e-3 * exact.stiffness:.0f} N/um",
        f"{exact.max_pressure:.0f} MPa",
        f"{exact.near_end:.0f} MPa",
        f"{exact.volume_life:.3f}",
        f"{exact.lamina_life:.3f}",
    ]


def _row(choice: tuple[str, str], cells: list[str]) -> str:
    return f"| {' | '.join([', '.join(choice), *cells])} |"


if __name__ == "__main__":
    main()
