"""``"calibrated"``: one image with the weight that comes closest to a free side face."""

from typing import Final

import numpy as np

from nonhertz.bodies.sides.side_face import SideFace

# Weights with which the pressure is within 2 % of the exact quarter-space from a quarter of the half-width inwards,
# fitted to three-dimensional solutions of a roller that ends on a long body and of two coincident ends.
_POISSON: Final = (0.0, 0.2, 0.25, 0.28, 0.3, 0.33, 0.4)
_WEIGHT: Final = (1.10, 1.35, 1.45, 1.50, 1.60, 1.65, 1.95)


class Calibrated(SideFace):
    """A face about which the pressure is mirrored with a weight fitted to exact free faces.

    Examples
    --------
    >>> Calibrated().image_weight(0.3)
    1.6
    """

    word = "calibrated"
    meaning = "by images of the weight that comes nearest to a free face"

    def image_weight(self, poisson: float) -> float:
        """Return the weight: linear between the fitted ones; outside 0 to 0.4, where nothing was fitted, the nearest.

        Parameters
        ----------
        poisson : float
            Poisson's ratio.
        """
        return float(np.interp(poisson, _POISSON, _WEIGHT))
