"""Reliefs that are hard on a solver and in no catalogue: cusps, steps, dimples and waves."""

from dataclasses import dataclass

import numpy as np

from nonhertz.model.profile import Profile


@dataclass(frozen=True)
class Cusp(Profile):
    """Relief height (|y - at| / reach)^power: a point for powers below 1, flat-bottomed for large ones."""

    at: float
    height: float
    reach: float
    power: float

    def relief(self, y):
        with np.errstate(over="ignore"):
            return self.height * (np.abs(np.asarray(y, dtype=float) - self.at) / self.reach) ** self.power


@dataclass(frozen=True)
class Step(Profile):
    """Relief that jumps by ``height`` at a place; the side that is lower is the one of ``side``."""

    at: float
    height: float
    side: float

    def relief(self, y):
        return np.where(self.side * (np.asarray(y, dtype=float) - self.at) > 0.0, self.height, 0.0)

    @property
    def bends(self):
        return (self.at,)


@dataclass(frozen=True)
class Dimple(Profile):
    """A round pit, positive height, or a bump, negative height."""

    at: float
    height: float
    reach: float

    def relief(self, y):
        distance = (np.asarray(y, dtype=float) - self.at) / self.reach
        return self.height * np.maximum(1.0 - distance**2, 0.0) ** 2


@dataclass(frozen=True)
class Wave(Profile):
    """Waviness along the axis, so that a contact falls apart."""

    height: float
    length: float
    phase: float

    def relief(self, y):
        return self.height * (0.5 - 0.5 * np.cos(2.0 * np.pi * np.asarray(y, dtype=float) / self.length + self.phase))
