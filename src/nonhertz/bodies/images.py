"""Mirror images of the pressure about the side faces of one body.

The image of every strip about a side face at y = f frees that face of shear; it acts only in the body that ends there
and has that body's share of the compliance. With two faces the images have images: a chain begins at each face, and
its links alternate between the two. The first image about a face may have a weight above 1, to compensate for the
normal stress that mirroring leaves on the face; further images only cancel the shear of earlier ones, with weight 1.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from nonhertz.model.body import Body
from nonhertz.model.side_faces import SERIES
from nonhertz.native import core

Array = NDArray[np.float64]

SEPARATE_LINKS, ALL_LINKS = 16, 1000  # of a series: those with their own position, and those summed one by one
NO_WEIGHT = 1e-12
DIRECT = (1.0, 0.0)


@dataclass(frozen=True)
class Images:
    """The images of one body.

    Attributes
    ----------
    places : dict
        (sign, offset) -> weight, which includes the body's share of the compliance: y is mapped to
        ``sign * y + offset``.
    share : float
        The body's share of the total compliance.
    far : FarImages or None
        Images of a series distant enough to act as line loads.
    free : ndarray, shape (faces, 3)
        Rows (place, side, share) of the side faces that are also free of normal stress.
    """

    places: dict[tuple[float, float], float]
    share: float
    far: FarImages | None
    free: Array

    @classmethod
    def of(cls, body: Body, weights: tuple[float, float], share: float) -> Images:
        """Return the images about the faces of a body at low and high y, with the weight of the first about each."""
        both = min(weights) > 0.0  # a single mirror makes a single image
        far = FarImages.of(body.length, weights, share) if body.images == SERIES and both and body.length else None
        sides = zip(body.faces, (-1, 1), body.free_faces, strict=True)
        free = [(place, side, share) for place, side, is_free in sides if is_free]
        return cls(chains(body, weights, share), share, far, np.array(free, dtype=float).reshape(-1, 3))

    def with_direct(self) -> Array:
        """Return rows (sign, offset, weight) of the load itself and its images."""
        return rows({DIRECT: self.share, **self.places})


def rows(terms: dict[tuple[float, float], float]) -> Array:
    """Return rows (sign, offset, weight)."""
    return np.array([(*place, weight) for place, weight in terms.items()])


def chains(body: Body, weights: tuple[float, float], share: float) -> dict[tuple[float, float], float]:
    """Return the weights of all images, by the sign and the offset [mm] of their position, sign * y + offset."""
    count = SEPARATE_LINKS if body.images == SERIES else 2 * int(body.images) - 1
    images: dict[tuple[float, float], float] = {}
    for first in (0, 1):
        sign, offset, weight = 1.0, 0.0, share
        for link in range(count):
            at = (first + link) % 2
            weight *= weights[at] if link == 0 else min(weights[at], 1.0)
            if weight < NO_WEIGHT * share:
                break
            sign, offset = -sign, 2.0 * body.faces[at] - offset
            # The two chains have no position in common, but rounding may give two images the same key.
            images[sign, offset] = images.get((sign, offset), 0.0) + weight
    return images


@dataclass(frozen=True)
class FarImages:
    """Images of a series as line loads at multiples of the body's length; those beyond the last are an integral.

    Attributes
    ----------
    distance, weight : ndarray, shape (links,)
        Distance of each on either side [mm], and its weight.
    beyond : float
        Where the integral begins [mm].
    length : float
        Length of the body [mm].
    """

    distance: Array
    weight: Array
    beyond: float
    length: float

    @classmethod
    def of(cls, length: float, weights: tuple[float, float], share: float) -> FarImages:
        """Return the images beyond the `SEPARATE_LINKS` of a chain."""
        link = np.arange(SEPARATE_LINKS, ALL_LINKS, dtype=np.float64)
        weight: Array = np.zeros(link.size)
        for first, other in (weights, weights[::-1]):
            again = min(first, 1.0) ** (link // 2) * min(other, 1.0) ** ((link + 1) // 2)
            weight += share * first * again
        return cls(length * (link + 1.0), weight, length * (ALL_LINKS + 0.5), length)

    @property
    def core(self) -> core.FarImages:
        """The same in C++."""
        return core.FarImages(self.distance, self.weight, self.beyond, self.length)
