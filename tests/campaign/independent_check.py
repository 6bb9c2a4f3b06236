"""An answer looked at without the solver's kernels for images and depth: image strips are set down one by one."""

import math

import numpy as np

# The package's rule for faces of both bodies on one side: at this share of the combined radius they have nothing to
# do with each other, and as good as at one place they are one.
APART, TOGETHER = 0.02, 1.0 - 1e-4
ROUNDING = 1e-15  # of approach and separation, whose difference the interference is
SERIES_LINKS, NEAR_LINKS = 400, 24  # of a series: summed, and with strips instead of line loads
TOLERANCE, SERIES_TOLERANCE = 1e-9, 2e-4


def faults(solution, prescribed, automatic):
    """What is wrong with an answer, in words; nothing if it is right."""
    touching = solution.line_load > 0.0
    surfaces = Surfaces(solution)
    displacement, curvature = surfaces.displacement_and_curvature(solution.y)
    curvature = curvature[touching]
    interference = solution.approach + solution.tilt * solution.y - solution.contact.separation(solution.y)
    depth = float(np.max(interference))
    heights = (solution.approach, solution.tilt * solution.y, solution.contact.separation(solution.y)[touching])
    gap = displacement - interference
    noise = ROUNDING * sum(float(np.max(np.abs(height))) for height in heights)
    load = float(np.sum(solution.line_load * solution.strip_width))
    moment = float(np.sum(solution.line_load * solution.strip_width * solution.y))
    reach = 0.5 * float(np.sum(solution.strip_width))
    checks = {
        "load": abs(load / prescribed.get("load", load) - 1.0),
        "moment": abs(moment - prescribed.get("moment", moment)) / (load * reach),
        "negative load": 0.0 if np.all(solution.line_load >= 0.0) else 1.0,
        "approach": abs(solution.approach - prescribed.get("approach", solution.approach)) / depth,
        "tilt": abs(solution.tilt - prescribed.get("tilt", solution.tilt)) * reach / depth,
    }
    of_sums = {
        "gap in contact": max(0.0, float(np.max(np.abs(gap[touching]))) - noise) / depth,
        "penetration": max(0.0, -float(np.min(gap, where=~touching, initial=0.0)) - noise) / depth,
        "curvature": float(np.max(np.abs(curvature / solution.contact.curvature(solution.y[touching]) - 1.0))),
    }
    within = SERIES_TOLERANCE if surfaces.endless else TOLERANCE
    wrong = [f"{name} {value:.1e}" for name, value in checks.items() if not value < TOLERANCE]
    wrong += [f"{name} {value:.1e}" for name, value in of_sums.items() if not value < within]
    # An automatic grid must not miss a place of contact; a speck beside the end of one is within its resolution.
    overlap = overlap_between_strips(solution, surfaces) / depth if automatic else 0.0
    return wrong + ([f"overlap between strips {overlap:.1e}"] if overlap > 0.01 else [])


def overlap_between_strips(solution, surfaces):
    """The deepest overlap at many points on the whole length, away from the intervals in contact."""
    low, high = solution.contact.interval
    y = np.linspace(low, high, 401 if surfaces.bounded else 1001)
    for start, end in solution.contact_y:
        margin = 0.03 * (end - start)
        y = y[(y < start - margin) | (y > end + margin)]
    if y.size == 0:
        return 0.0
    displacement, _ = surfaces.displacement_and_curvature(y)
    gap = displacement - (solution.approach + solution.tilt * y - solution.contact.separation(y))
    return max(0.0, -float(np.min(gap)))


class Surfaces:
    """Both bodies under the loads of a solution, and what these do on the centre line."""

    def __init__(self, solution):
        touching = solution.line_load > 0.0
        self.low, self.high = solution.edges[:-1][touching], solution.edges[1:][touching]
        self.load, self.half_width = solution.line_load[touching], solution.element_half_width[touching]
        self.element = solution.element
        self.bodies = (solution.contact.a, solution.contact.b)
        self.compliances = [(1.0 - b.material.poisson**2) / (math.pi * b.material.modulus) for b in self.bodies]
        self.contact = solution.contact
        self.weights = self._weights()
        self.bounded = any(max(weights) > 0.0 for weights in self.weights)
        self.endless = any(b.images == "series" for b in self.bodies)

    def displacement_and_curvature(self, y):
        """What both bodies together do at ``y``; a displacement against points at depth where a body has one."""
        displacement, curvature = self._strips(y, self.low, self.high, sum(self.compliances))
        for body, weights, compliance in zip(self.bodies, self.weights, self.compliances, strict=True):
            depth = self._depth(body)
            if depth is not None:
                displacement -= compliance * self._at_depth(y, self.low, self.high, depth, body.material.poisson)
            for link, weight, low, high in self._images(body, weights, depth):
                share = weight * compliance
                if link >= NEAR_LINKS:
                    displacement += share * self._line_loads(y, low, high, depth, body.material.poisson)
                    continue
                moved, bent = self._strips(y, low, high, share)
                displacement, curvature = displacement + moved, curvature + bent
                if depth is not None:
                    displacement -= share * self._at_depth(y, low, high, depth, body.material.poisson)
        return displacement, curvature

    def _weights(self):
        """Weights (low, high) of each body's images, lowered where those on one side exceed 1 together."""
        asked = [body.face_weights for body in self.bodies]
        lengths = [body.length for body in self.bodies if body.length is not None]
        shares = np.array(self.compliances) / sum(self.compliances)
        weights = [[0.0, 0.0], [0.0, 0.0]]
        for side in (0, 1):
            apart = abs(self.bodies[0].faces[side] - self.bodies[1].faces[side])
            nearness = max(0.0, 1.0 - apart / (APART * self._radius(side))) if len(lengths) == 2 else 0.0
            nearness = 1.0 if nearness > TOGETHER else nearness
            for one, other in ((0, 1), (1, 0)):
                kappa = shares[one] * asked[one][side] + nearness * shares[other] * asked[other][side]
                weights[one][side] = asked[one][side] / max(kappa, 1.0)
        return weights

    def _radius(self, side):
        """Combined radius between the faces of both bodies on one side, or where the contact must have ended."""
        between = 0.5 * (self.bodies[0].faces[side] + self.bodies[1].faces[side])
        low, high = self.contact.interval
        place = np.array([min(max(between, low), high)])
        return 1.0 / float(self.contact.curvature(place)[0])

    def _images(self, body, weights, depth):
        """Yield (link, weight, low, high): the strips mirrored at either face, at the other one, and so on."""
        if body.length is None:
            return
        links = 2 * body.images - 1 if body.images != "series" else max(SERIES_LINKS, round(20.0 * depth / body.length))
        for first in (0, 1):
            low, high, weight = self.low, self.high, 1.0
            for link in range(links):
                at = (first + link) % 2
                weight *= weights[at] if link == 0 else min(weights[at], 1.0)
                if weight < 1e-13:
                    break
                low, high = 2.0 * body.faces[at] - high, 2.0 * body.faces[at] - low
                yield link, weight, low, high

    def _strips(self, y, low, high, compliance):
        upper = self.element.functions((high - y[:, None]) / self.half_width)
        lower = self.element.functions((low - y[:, None]) / self.half_width)
        displacement = compliance * (upper[0] - lower[0]) @ self.load
        return displacement, compliance * (upper[2] - lower[2]) @ (self.load / self.half_width**2)

    def _at_depth(self, y, low, high, depth, poisson):
        """Displacement at depth under ``y`` per unit of compliance: Boussinesq's, integrated along each strip."""

        def integral(edge):
            u = (edge - y[:, None]) / depth
            return np.arcsinh(u) + u / np.sqrt(1.0 + u * u) / (2.0 * (1.0 - poisson))

        return (integral(high) - integral(low)) @ self.load

    def _line_loads(self, y, low, high, depth, poisson):
        """Displacement of the surface less that at depth, of strips so far away that they are forces."""
        square = (0.5 * (low + high) - y[:, None]) ** 2
        slant = square + depth**2
        at_depth = (1.0 + depth**2 / slant / (2.0 * (1.0 - poisson))) / np.sqrt(slant)
        return (1.0 / np.sqrt(square) - at_depth) @ (self.load * (high - low))

    def _depth(self, body):
        """Depth of the point that displacement is measured against; None for one far away."""
        if body.depth == "none":
            return None
        if body.depth == "diameter":
            return body.diameter
        if body.depth != "plane-strain":
            return body.depth
        # A long strip moves by 2 K q (ln(2 X / a) + C) at half its length X, the point at depth by 2 K q (ln(2 X / d)
        # + 1 / (2 (1 - nu))); their difference has to be Johnson's K q (2 ln(2 D / b) - 1), b = hertz_ratio a.
        far = 1e6
        constant = float(self.element.functions(far)[0]) - math.log(2.0 * far)
        exponent = 1.0 / (2.0 * (1.0 - body.material.poisson)) - constant - 0.5
        return 2.0 * body.diameter / self.element.hertz_ratio * math.exp(exponent)
