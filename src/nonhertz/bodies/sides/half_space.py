"""``"none"``: the body continues behind the face, as a half-space does."""

from nonhertz.bodies.sides.side_face import SideFace


class HalfSpace(SideFace):
    """A face that is not freed."""

    word = "none"
    meaning = "not at all"
    of_body = False

    def image_weight(self, poisson: float) -> float:
        """Return 0."""
        return 0.0
