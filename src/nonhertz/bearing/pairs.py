"""Rows of rollers side by side, on one inner ring or on rings clamped together."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import accumulate
from typing import Annotated, Any

import numpy as np
from numpy.typing import NDArray

from nonhertz.bearing.bearings import RollerBearing, TaperedRollerBearing
from nonhertz.bearing.parts import MOST_ROLLERS, NO_CLEARANCE, refuse_large_clearance
from nonhertz.bearing.row import Row
from nonhertz.errors import InputError
from nonhertz.inputs.checks import check_list, finite, flag, positive
from nonhertz.inputs.descriptions import Custom, Part, Quantities, Quantity, Several, Word
from nonhertz.inputs.fields import Input, cross_check, input_class

Array = NDArray[np.float64]

ARRANGEMENTS = ("X", "O", "tandem")
_PRELOAD = Quantity(
    "N",
    "axial force between two equal tapered rows in X or O, mounted, cold and without load, in place of the clearance "
    "between them",
    positive,
    "give the axial force in N, or the clearance in its place",
)


def _ways(name: str, value: Any, remedy: str) -> tuple[bool, ...]:
    ways = check_list(name, value, "be True or False for each row", remedy)
    for way in ways:
        flag(name, way, remedy)
    return tuple(ways)


@input_class(kw_only=True)
class Paired(Input):
    """Rows of rollers on one inner ring, or on rings clamped together.

    See Also
    --------
    paired : two equal rows in X, O or tandem
    """

    bearings: Annotated[
        tuple[RollerBearing, ...], Several(Part("the rows", RollerBearing, "give two rows, or more"), MOST_ROLLERS)
    ]
    x: Annotated[
        tuple[float, ...],
        Quantities("mm", "axial coordinates of their rollers' centres; the inner ring tilts about x = 0"),
    ]
    turned: Annotated[
        tuple[bool, ...],
        Custom("whether each is turned round, for axial loads along -x", _ways, {}, "write True or False for each row"),
    ]
    clearance: Annotated[
        float,
        Quantity(
            "mm",
            "axial clearance between rows that support axial loads in opposite directions, in addition to the rows' "
            "own; negative: preload",
            finite,
            "give the axial clearance in mm",
        ),
        replace(
            NO_CLEARANCE,
            where=lambda pair: pair.preload is None and not any(row.radial_clearance for row in pair.bearings),
        ),
    ] = 0.0
    preload: Annotated[float | None, _PRELOAD] = None

    @cross_check("bearings", "x", "turned")
    def _check_rows(self) -> None:
        count = len(self.bearings)
        if not count:
            raise InputError("bearings", self.bearings, "be rows of rollers", "give two rows, or more")
        if len(self.x) != count or len(self.turned) != count:
            raise InputError("x", self.x, f"hold {count} positions, as many as turned", "give one for each row")

    @cross_check("bearings", "clearance")
    def _check_clearance(self) -> None:
        if self.clearance and not any(any(row.bears_axially) for row in self.bearings):
            condition = "be zero for rows that do not locate the inner ring axially"
            raise InputError("pair.clearance", self.clearance, condition, "leave it out, or use rows with ribs")
        for row in self.bearings:
            if row.radial_clearance is not None:  # that of thrust bearings does not displace the rings radially
                radial = 2.0 * math.tan(row.nominal_angle) * self.clearance
                refuse_large_clearance("pair.clearance", self.clearance, radial, row.pitch)

    @cross_check("bearings", "x", "turned", "clearance", "preload")
    def _check_preload(self) -> None:
        if self.preload is None:
            return
        if self.clearance:
            raise InputError("pair.preload", self.preload, "not be given together with clearance", "leave one out")
        equal = all(isinstance(row, TaperedRollerBearing) and row == self.bearings[0] for row in self.bearings)
        if not equal or sorted(self.turned) != [False, True]:
            condition = "be left out except for two equal tapered rows in X or O"
            raise InputError("pair.preload", self.preload, condition, "give the clearance of the rows")

    def at(self, clearance: str = "likely") -> Paired:
        """Return the rows with the least, likely or greatest clearance of their groups."""
        return replace(self, bearings=tuple(row.at(clearance) for row in self.bearings))

    @property
    def rows(self) -> tuple[Row, ...]:
        """The rows at their positions."""
        firsts = accumulate((row.rollers for row in self.bearings[:-1]), initial=0)
        rows = zip(self.bearings, self.x, self.turned, firsts, strict=True)
        return tuple(Row(row, x, way, 0.5 * self.clearance, first) for row, x, way, first in rows)


@input_class()
class Pair(Input):
    """Arrangement of a second row equal to the first, on the same inner ring or on rings clamped together."""

    arrangement: Annotated[
        str,
        Word(
            "'X', face to face: the lines of pressure meet between the rows; 'O', back to back: they meet outside; or "
            "'tandem', both rows supporting axial loads along +x",
            "'X' is face to face, 'O' back to back",
            ARRANGEMENTS,
        ),
    ]
    distance: Annotated[
        float,
        Quantity(
            "mm",
            "the axial distance between the centres of both rows' rollers",
            positive,
            "give the distance of the rows in mm",
        ),
    ]
    clearance: Annotated[
        float,
        Quantity(
            "mm",
            "axial clearance of the pair, in addition to the rows' own; negative: preload",
            finite,
            "give the axial clearance in mm",
        ),
    ] = 0.0
    preload: Annotated[float | None, _PRELOAD] = None

    @classmethod
    def of(cls, rows: Paired) -> Pair:
        """Return the arrangement of two equal rows.

        Raises
        ------
        InputError
            If the rows are not two equal ones.
        """
        first, distance = rows.bearings[0], rows.x[-1] - rows.x[0]
        for arrangement in ARRANGEMENTS if distance > 0.0 else ():
            if rows == _make_pair(first, pair := cls(arrangement, distance, rows.clearance, rows.preload)):
                return pair
        condition = "be two equal rows in X, O or tandem to go into a file"
        raise InputError("bearings", len(rows.bearings), condition, "solve such a bearing in Python")


def paired(
    bearing: RollerBearing,
    arrangement: str,
    distance: float,
    *,
    clearance: float = 0.0,
    preload: float | None = None,
) -> Paired:
    """Return two equal rows.

    Parameters
    ----------
    bearing : RollerBearing
        A row.
    arrangement : {"X", "O", "tandem"}
        ``"X"``, face to face: the lines of pressure meet between the rows. ``"O"``, back to back: they meet outside.
        ``"tandem"``: both rows support axial loads along +x.
    distance : float
        Axial distance between the centres of their rollers [mm].
    clearance, preload : float
        As in `Paired`.

    Examples
    --------
    >>> import nonhertz as nh
    >>> cone = nh.Roller(diameter=nh.TabulatedDiameter((-6, 6), (11, 10)), length=12)
    >>> rings = {"inner": nh.Ring(diameter=41), "outer": nh.Ring(diameter=-62.5)}
    >>> row = nh.bearing.TaperedRollerBearing(roller=cone, **rings, rollers=14, contact_angle=0.2)
    >>> paired(row, "O", 20.0).turned
    (False, True)
    """
    return _make_pair(bearing, Pair(arrangement, distance, clearance, preload))


def _make_pair(bearing: RollerBearing, pair: Pair) -> Paired:
    turned = {"X": (True, False), "O": (False, True), "tandem": (False, False)}[pair.arrangement]
    half = 0.5 * pair.distance
    return Paired(
        bearings=(bearing, bearing), x=(-half, half), turned=turned, clearance=pair.clearance, preload=pair.preload
    )


def parts_of(bearing: RollerBearing | Paired) -> dict[str, Input]:
    """Return the inputs of a bearing, by their places in a file.

    The clearance of rows that locate each other axially is that of the pair.
    """
    row = bearing.rows[0].bearing
    paired_by_angle = isinstance(bearing, Paired) and row.nominal_angle > 0.0
    parts = {"roller": row.roller, "inner": row.inner, "outer": row.outer}
    return {**parts, **({"bearing.pair": bearing} if paired_by_angle else {"bearing": row})}


def loaded_shares(bearing: RollerBearing | Paired, load: Array) -> Array:
    """Return the fraction of each row's rollers that the inner ring loads.

    Parameters
    ----------
    bearing : RollerBearing or Paired
        The bearing.
    load : ndarray, shape (..., rollers, 2)
        Loads at the inner and the outer ring [N].

    Returns
    -------
    ndarray, shape (..., rows)
    """
    # At speed every roller presses on the outer ring; only these carry load between the rings.
    loaded = load[..., 0] > 0.0
    return np.stack([loaded[..., row.rollers].mean(axis=-1) for row in bearing.rows], axis=-1)
