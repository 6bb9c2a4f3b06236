"""``"free"``: neither shear nor normal stress is left on the face."""

from nonhertz.bodies.sides.side_face import SideFace


class Free(SideFace):
    """A face that is freed exactly: by an image of full weight, and by what an elastic quarter-space adds to it."""

    word = "free"
    meaning = "exactly, of shear and of normal stress"
    exact = True

    def image_weight(self, poisson: float) -> float:
        """Return 1."""
        return 1.0
