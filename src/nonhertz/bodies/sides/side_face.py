"""The interface of a treatment of a side face.

A side face of a half-space is freed of shear by an image of the pressure behind it. The image doubles the normal
stress on the face instead of removing it, so the end is still too stiff; a weight above 1 compensates for part of that,
and what an elastic quarter-space adds (`nonhertz.bodies.quarter_space`) for all of it.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import ClassVar


class SideFace(ABC):
    """How far, and by what means, one side face is freed of stress.

    Attributes
    ----------
    word : str
        Its keyword in files and Python; empty if given as a number.
    meaning : str
        What it does, as it follows the word in descriptions of case files.
    exact : bool
        Whether the normal stress that an image leaves is taken away, too.
    of_body : bool
        Whether the body ends there, so that its field below the surface is free of stress on the face, however the
        pressure was found.
    """

    word: ClassVar[str]
    meaning: ClassVar[str]
    exact: ClassVar[bool] = False
    of_body: ClassVar[bool] = True

    @abstractmethod
    def image_weight(self, poisson: float) -> float:
        """Return the weight of the first mirror image about the face; zero for no image.

        It is this face's part of kappa, the number that governs a sharp end (`nonhertz.bodies.ends`).
        """
