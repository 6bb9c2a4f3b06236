"""The interface of a treatment of a side face.

A side face of a half-space is freed of shear by an image of the pressure behind it. The image doubles the normal
stress on the face instead of removing it, so the end is still too stiff; a weight above 1 compensates for part of that.
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
    """

    word: ClassVar[str]
    meaning: ClassVar[str]

    @abstractmethod
    def image_weight(self, poisson: float) -> float:
        """Return the weight of the first mirror image about the face; zero for no image.

        It is this face's part of kappa, the number that governs a sharp end (`nonhertz.bodies.ends`).
        """
