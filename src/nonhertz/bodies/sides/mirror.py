"""``"mirror"``: one image of full weight, which leaves no shear on the face and doubles the normal stress."""

from nonhertz.bodies.sides.side_face import SideFace


class Mirror(SideFace):
    """A face about which the pressure is mirrored."""

    word = "mirror"
    meaning = "by images of the pressure"
    of_body = False

    def image_weight(self, poisson: float) -> float:
        """Return 1."""
        return 1.0
