// Correction for a free side face to the displacement of a load of unit length, with the strip's pressure across, and
// to its curvature: the tables of `free_end` are made from it, once for a Poisson's ratio.
#pragma once

#include "strips/element.hpp"

namespace nonhertz {

/// Images at several distances whose weights depend on the direction (nonhertz.bodies.quarter_space).
struct FaceWeights {
  Numbers distances;
  Matrix weights;  ///< of images, then of smoothed pressures; a row for each Chebyshev polynomial
};

/// Fill in h and c for places and loads at the distances u and v from the face, in half-widths.
void face_densities(const Element& element, const FaceWeights& face, View u, View v, Row h, Row c);

}  // namespace nonhertz
