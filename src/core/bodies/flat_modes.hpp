// What all waves of a flat body with free ends do along the line of contact, less that of some: a smooth function.
//
// nonhertz/bodies/whole_roller.py says what it is for. Of loads, planes and the curved part it reads tables.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

/// A function of a positive distance: cubic polynomials in its logarithm, evenly spaced; straight in it before them.
struct LogarithmicTable {
  double first, step;  ///< of the logarithm
  Matrix pieces;       ///< rows of four coefficients, highest power first, of the logarithm since their piece began

  double at(double logarithm) const;
};

struct FlatModes {
  const LogarithmicTable &loads, &planes, &curved;
  Matrix weights;       ///< of what a free face adds: Chebyshev polynomials (rows), of loads, then of planes (columns)
  Numbers distances;    ///< at which it adds them, over that of the image
  Numbers image, face;  ///< how much both faces' images and they themselves count: at high y, at low y
  double half_length;   ///< [radii]
};

/// Return what unit loads at points do at places, whose rows belong together; radius: the surface's between both.
Matrix effect_of(const FlatModes& flat, View places, const Matrix& points, const Matrix& radius);

}  // namespace nonhertz
