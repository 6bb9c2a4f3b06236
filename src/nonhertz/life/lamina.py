"""The lamina life of ISO/TS 16281 for one contact: every slice fatigues under its own line load.

The contact is cut into n_s laminae of equal length. Lamina k with the load q_k has the capacity q_c = Q_c n_s^(-7/9),
and the life of the contact is

    L_10 = { sum_k (f_k q_k / q_c)^(9/2) }^(-8/9)

million revolutions. f_k expresses how much more severely the edge of a roller is stressed than its line load suggests.
If pressures are known, it is the line load of Hertz's line contact with the same pressure over the line load of the
lamina; the standard's formula for unknown pressures,

    f_k = 1 - 0.01 / ln(1.985 |(2 k - n_s - 1) / (2 n_s - 2)|),

holds for the standard's profile, medium loads and a tilt up to 1.16 mrad.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from nonhertz.errors import InputError
from nonhertz.inputs.checks import text
from nonhertz.inputs.descriptions import Count, Word
from nonhertz.inputs.fields import Input, input_class
from nonhertz.model.contact import Contact
from nonhertz.model.material import STEEL, STEEL_MODULUS
from nonhertz.result.solved import Solved

Array = NDArray[np.float64]
FEWEST, MOST = 30, 2000
SLOPE, EXPONENT = 9.0 / 8.0, 4.5
EDGE_STRESS = ("pressure", "standard", "none")
LINE_LOADS = ("solution", "standard")
LEFT_OUT = 0.1  # of the largest half-width, around an end where the pressure is singular
_OF_STEEL = 2.0 * STEEL.compliance  # of a contact of steel on steel [1/MPa]
STIFFENING = 10.0 / 9.0  # power of the deflection with which the load of a lamina grows


def slice_compliance(contact: Contact) -> float:
    """Return the sum of both compliances [1/MPa], with the standard's constant for every steel."""
    low, high = STEEL_MODULUS
    materials = contact.a.material, contact.b.material
    return sum(STEEL.compliance if low <= material.modulus <= high else material.compliance for material in materials)


def roller_stiffness(length: float, compliance: float = _OF_STEEL) -> float:
    """Return the load [N] on a roller of a length [mm] between two raceways over the deflection [mm] to `STIFFENING`.

    The standard's constant applies to steel of any modulus. It is the inverse of Palmgren's formula, which reads for
    other materials

        deflection = 0.39 {4 (1 - nu_1^2) / E_1 + 4 (1 - nu_2^2) / E_2}^0.9 Q^0.9 / L^0.8

    per contact (3.84e-5 Q^0.9 / L^0.8 for steel; T. A. Harris, Rolling Bearing Analysis), so that the load at a given
    deflection is inversely proportional to the compliance of the contact, K_a + K_b [1/MPa].
    """
    return float(35948.0 * length ** (8.0 / 9.0) * _OF_STEEL / compliance)


def lamina_stiffness(length: float, laminae: int, compliance: float = _OF_STEEL) -> float:
    """Return the load on a lamina of one contact of such a roller, over the penetration to `STIFFENING`.

    In the standard, both contacts of a roller deform in series; one of two equal contacts deforms half as much.
    """
    return float(roller_stiffness(length, compliance) / laminae * 2.0**STIFFENING)


@input_class()
class LaminaModel(Input):
    """The lamina life of ISO/TS 16281, as made by `iso_16281`."""

    name: Annotated[str, Word("the name that files and commands use", "give the name of the model", condition=text)]
    laminae: Annotated[int, Count("number of slices", FEWEST, MOST, "give the number of slices, such as 60")]
    edge_stress: Annotated[str, Word("the edge stress factor", "use 'pressure' for what was solved", EDGE_STRESS)]
    line_loads: Annotated[str, Word("the line loads of the slices", "use 'solution' for what was solved", LINE_LOADS)]
    source: Annotated[str, Word("where it was published", "give its publication", condition=text)]

    @property
    def slope(self) -> float:
        """Weibull's slope e [-]."""
        return SLOPE


def iso_16281(*, laminae: int = 60, edge_stress: str = "pressure", line_loads: str = "solution") -> LaminaModel:
    """Return the lamina life of ISO/TS 16281.

    Parameters
    ----------
    laminae : int
        n_s, at least 30.
    edge_stress : str
        ``"pressure"``: from the solved pressures. ``"standard"``: the standard's function of k. ``"none"``: f = 1.
    line_loads : str
        ``"solution"``: from the solution. ``"standard"``: from the standard's independent slices under the same load
        and tilt.

    Notes
    -----
    The standard considers a roller between two raceways misaligned by psi. Here its slices belong to one of two equal
    contacts, each with half of the approach and half of psi: a contact with the tilt gamma has the standard's slices
    for psi = 2 gamma.

    References
    ----------
    ISO/TS 16281:2008, Rolling bearings - Methods for calculating the modified reference rating life for universally
    loaded bearings, Eqs. (47), (48), (56) to (65).
    """
    return LaminaModel("iso-16281", laminae, edge_stress, line_loads, "ISO/TS 16281:2008")


@dataclass(frozen=True, eq=False)
class Laminae:
    """A contact cut into laminae of equal length."""

    edges: Array  # [mm], from end to end of the effective length, which is that without corners, shape (laminae + 1,)
    load: Array  # q_k [N], shape (laminae,)
    factor: Array  # f_k [-]
    # Positions near which pressures were left out: sharp ends, or corners of the profile where the contact ends [mm].
    sharp: tuple[float, ...] = ()

    def damage(self, capacity: float) -> Array:
        """Return (f_k q_k / q_c)^(9/2) of every lamina, for the capacity Q_c [N] of the contact."""
        of_lamina = capacity * self.load.size ** (-7.0 / 9.0)
        return np.asarray((self.factor * self.load / of_lamina) ** EXPONENT)

    def life(self, capacity: float) -> float:
        """Return L_10 [10^6 revolutions] for the capacity Q_c [N] of the contact.

        Examples
        --------
        >>> even = Laminae(np.linspace(0.0, 10.0, 31), np.full(30, 100.0), np.ones(30))
        >>> round(even.life(6000.0), 9)  # (Q_c / Q)^4
        16.0
        """
        damage = float(self.damage(capacity).sum())
        return damage ** (-1.0 / SLOPE) if damage > 0.0 else math.inf


def edge_function(laminae: int) -> Array:
    """Return the standard's f_k [-] for k = 1 to ``laminae``.

    Examples
    --------
    >>> float(edge_function(30)[0].round(4)), float(edge_function(31)[15])
    (2.3283, 1.0)
    """
    place = np.abs(2.0 * np.arange(1, laminae + 1) - laminae - 1.0) / (2.0 * laminae - 2.0)
    with np.errstate(divide="ignore"):
        return np.asarray(1.0 - 0.01 / np.log(1.985 * place))


def laminae_of(solution: Solved, model: LaminaModel, span: tuple[float, float] | None = None) -> Laminae:
    """Return the laminae of a solution.

    Beyond the effective length, in the corners, only pressures are counted, with the outermost laminae.

    Parameters
    ----------
    solution : Solution or PatchSolution
        The solved contact.
    model : LaminaModel
        The laminae and their edge stress.
    span : tuple of float, optional
        Interval to cut [mm]: the effective length of a bearing, if another of its contacts is shorter.

    Raises
    ------
    InputError
        If the length over which the bodies can touch is unlimited, or a dent is in the contact.
    """
    refuse_rolling_on(solution)
    contact = solution.contact
    low, high = contact.land if span is None else span
    if not math.isfinite(high - low):
        remedy = "give one of the bodies a length, or choose another model"
        raise InputError("length", None, "be given for laminae", remedy)
    edges = np.linspace(low, high, model.laminae + 1)
    pressed = model.edge_stress == "pressure"
    sharp = tuple(end.y for end in solution.singular_ends) if pressed else ()
    reach, land = (np.concatenate([[end[0]], edges[1:-1], [end[1]]]) for end in (contact.interval, contact.land))
    reach, length = reach if pressed else land, np.diff(land)
    load = (
        _slices(solution, edges)
        if model.line_loads == "standard"
        else _shares(reach, solution.edges, solution.line_load)
    )
    if pressed:
        factor = _factors(solution, reach, length, load, sharp)
    else:
        factor = edge_function(model.laminae) if model.edge_stress == "standard" else np.ones(model.laminae)
    # A longer lamina has a larger capacity, since the capacity of a contact grows with its length.
    return Laminae(edges, load, factor * (np.diff(edges) / length) ** (7.0 / 9.0), sharp)


def refuse_rolling_on(solution: Solved) -> None:
    """Refuse a solution that holds only for one position of a dent.

    Raises
    ------
    InputError
    """
    # Imported here: case files need this module, but few of them the plane grid.
    from nonhertz.patch.solution import PatchSolution

    if isinstance(solution, PatchSolution) and solution.rolls_on:
        condition = "stay as it is while the surfaces roll, and a dent rolls on with its surface"
        remedy = "solve the contact without it, and roll it through with nonhertz.life.overrolled"
        raise InputError("solution", "one position of a dent", condition, remedy)


def _shares(edges: Array, fine: Array, density: Array) -> Array:
    """Return the integrals between ``edges`` of a density that is constant between ``fine`` edges."""
    total = np.concatenate([[0.0], np.cumsum(density * np.diff(fine))])
    return np.diff(np.interp(edges, fine, total))


def _factors(solution: Solved, edges: Array, length: Array, load: Array, sharp: tuple[float, ...]) -> Array:
    """Return f_k from the pressures: the load of Hertz's line contact with these pressures over the lamina's load.

    The mean over a lamina uses the power of its load in the damage, and leaves out the vicinity of an end where the
    pressure is singular.
    """
    fine, density = solution.edges, solution.line_load
    pressure = solution.largest_across
    contact = solution.contact
    as_in_hertz = np.pi**2 * contact.compliance / contact.curvature(solution.y) * pressure**2
    counted = np.ones(pressure.size)
    left_out = LEFT_OUT * solution.max_half_width
    for end in sharp:
        counted[np.abs(solution.y - end) < left_out] = 0.0
    suffered, borne, lost = (
        _shares(edges, fine, values) for values in (counted * as_in_hertz**EXPONENT, counted * density, 1.0 - counted)
    )
    length = length - lost
    mean = np.divide(suffered, length, out=np.zeros_like(load), where=length > 0.0) ** (1.0 / EXPONENT)
    even = np.divide(borne, length, out=np.zeros_like(load), where=length > 0.0)
    factor: Array = np.divide(mean, even, out=np.ones_like(load), where=even > 0.0)
    return factor


def _slices(solution: Solved, edges: Array) -> Array:
    """Return the loads of the standard's independent slices under the load and tilt of the solution."""
    contact: Contact = solution.contact
    y = 0.5 * (edges[1:] + edges[:-1])
    gap = contact.separation(y) - solution.tilt * y
    gap -= gap.min()  # a large gap in all slices would leave no digits for the approach
    stiffness = lamina_stiffness(float(edges[-1] - edges[0]), y.size, slice_compliance(contact))

    def loads(approach: float) -> Array:
        return np.asarray(stiffness * np.maximum(approach - gap, 0.0) ** STIFFENING)

    # If one slice carries the whole load, rounding must not leave the load just above that of this approach.
    high = (1.0 + 1e-9) * (solution.load / stiffness) ** (1.0 / STIFFENING)
    from scipy.optimize import brentq

    root = brentq(lambda approach: loads(approach).sum() - solution.load, 0.0, high, xtol=1e-15, rtol=1e-13)
    return loads(float(root))
