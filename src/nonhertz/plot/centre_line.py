"""Along the centre line of a contact: pressure and half-width, and both surfaces before and after loading."""

from __future__ import annotations

from nonhertz.figures import contact
from nonhertz.plot.axes import OWN, Axes, drawing
from nonhertz.plot.drawer import draw_on
from nonhertz.result.solution import Solution


@drawing
def pressure(solution: Solution, ax: Axes = OWN) -> Axes:
    """Draw the centre-line pressure p0 (left axis) and the half-width b (right axis) against y.

    Both lines run through the centres of the strips to the ends of the contact; the pale steps are the strips
    themselves. The maximum pressure, the length in contact and the ends of the bodies are marked. Where a sharp end
    makes the pressure singular there is no largest value: the left axis is cut, exponent and strength are given at that
    end, and the maximum pressure more than a half-width away from such ends is marked. The right axis belongs to
    a twin of ``ax`` in the same figure.

    Parameters
    ----------
    solution : Solution
        A solved contact.

    References
    ----------
    The pair of curves is that of Fig. 7 in J. M. de Mul, J. J. Kalker, G. M. Vree, An orthogonal
    uniform/parabolic surface pressure half-space element for the analysis of non-Hertzian contact,
    Computational Mechanics, CIMNE, Barcelona 1998.
    """
    return draw_on(contact.pressure(solution), ax)


@drawing
def profile(solution: Solution, ax: Axes = OWN) -> Axes:
    """Draw the surfaces' distance on the centre line, undeformed and deformed, in micrometres against y.

    The undeformed distance is ``h - (delta + gamma y)``, negative where the bodies would overlap if they did
    not deform; the deformed one is the gap, zero in contact (shaded). The area between them is the elastic
    displacement of both surfaces. Where the relief is far larger than the interference the axis is cut, and
    the heading gives the largest distance.

    Parameters
    ----------
    solution : Solution
        A solved contact.
    """
    return draw_on(contact.distance(solution), ax)
