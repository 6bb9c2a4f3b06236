// Curves through points: straight lines as in numpy.interp, and cubic polynomials as in scipy's PPoly.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

/// Straight lines between points; constant beyond the outermost.
struct Polyline {
  Numbers places, values;  ///< places ascending

  double at(double x) const;
};

/// Cubic polynomials between places.
struct Cubics {
  Numbers places;       ///< ascending
  Matrix coefficients;  ///< of each piece, in powers of the distance from its beginning, highest first

  /// The value at a place within.
  double at(double x) const;
};

}  // namespace nonhertz
