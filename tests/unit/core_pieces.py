"""Pieces of the compiled core for tests: strips and a law without bodies, and its outer loops interpreted."""

import numpy as np

import nonhertz as nh
from nonhertz.bodies.influence import HALF_SPACE, Influence
from nonhertz.strip import influence, problem, solving
from nonhertz.strip.records import Strips

NO_DEPTH = np.zeros((0, 0))


def strips_between(low, high, *, curvature=0.1, separation=0.0, at_depth=NO_DEPTH):
    """Strips between two rows of edges, of one curvature [1/mm]."""
    y = 0.5 * (low + high)
    return Strips(
        y, low, high, np.full(y.size, curvature), separation + np.zeros(y.size), at_depth, np.zeros((4, y.size))
    )


def kernel_of(element=nh.SEMI_ELLIPTIC, terms=HALF_SPACE):
    return influence.kernel_of(Influence(np.atleast_2d(terms)), element)


def interpret(monkeypatch, **replaced):
    """Settle cases in the interpreter, down to the Newton loop, with some functions of `solving` replaced.

    Machine code calls machine code: what is replaced is met only by those that the interpreter runs.
    """
    for name in ("loop", "solve_on_strips"):
        function = getattr(solving, name)
        monkeypatch.setattr(solving, name, getattr(function, "py_func", function))  # plain where nothing is compiled
    monkeypatch.setattr(problem, "solve_on_strips", solving.solve_on_strips)
    for name, function in replaced.items():
        monkeypatch.setattr(solving, name, function)
