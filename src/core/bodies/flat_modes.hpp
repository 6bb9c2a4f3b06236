// Sum of all waves of a flat body with free ends along the line of contact, minus some of them: a smooth function.
//
// nonhertz/bodies/whole_roller.py explains its use. Loads, planes and the curved part are read from tables.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

/// A function of a positive distance: evenly spaced cubic polynomials in its logarithm; linear in it before them.
struct LogarithmicTable {
  double first, step;  ///< of the logarithm
  Matrix pieces;       ///< rows of four coefficients, highest power first, of the logarithm from the start of the piece

  double at(double logarithm) const;
};

struct FlatModes {
  const LogarithmicTable &loads, &planes, &curved;
  Matrix
      weights;  ///< of the correction for a free face: Chebyshev polynomials (rows), of loads, then of planes (columns)
  Numbers distances;    ///< of the correction's images, over that of the image
  Numbers image, face;  ///< weights of both faces' images and of the faces themselves: at high y, at low y
  double half_length;   ///< [radii]
};

/// Return the effect of unit loads at points on places, row by row; radius: of the surface between both.
Matrix effect_of(const FlatModes& flat, View places, const Matrix& points, const Matrix& radius);

}  // namespace nonhertz
