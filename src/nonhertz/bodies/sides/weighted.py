"""A number: one image with that weight."""

from nonhertz.bodies.sides.side_face import SideFace


class Weighted(SideFace):
    """A face about which the pressure is mirrored with a user-given weight.

    Parameters
    ----------
    weight : float
        Weight of the image, at least zero.
    """

    word = ""
    meaning = "a weight of the images"

    def __init__(self, weight: float) -> None:
        self._weight = weight

    def image_weight(self, poisson: float) -> float:
        """Return the weight, whatever Poisson's ratio."""
        return self._weight
