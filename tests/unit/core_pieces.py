"""Pieces of the core for tests: strips and a law without bodies, and a loop that fails."""

import numpy as np

import nonhertz as nh
from nonhertz.bodies.influence import HALF_SPACE, Influence
from nonhertz.native import core
from nonhertz.strip import influence

NO_DEPTH = np.zeros((0, 0))


def strips_between(edges, *, curvature=0.1, separation=0.0, at_depth=NO_DEPTH):
    """Strips between edges, of one curvature [1/mm]."""
    same = np.ones(edges.size - 1)
    return core.Grid(edges, curvature * same, separation * same, same * np.inf, curvature * same, at_depth, NO_DEPTH)


def state_of(r, m, rigid, gap=None):
    """A state that nothing is known of."""
    gap = np.zeros(m.size) if gap is None else gap
    return core.State(r, m, gap, rigid, np.zeros((2, 2)), core.Status.STAGNATED, 0, np.inf)


def kernel_of(element=nh.SEMI_ELLIPTIC, terms=HALF_SPACE):
    return influence.kernel_of(Influence(np.atleast_2d(terms)), element)
