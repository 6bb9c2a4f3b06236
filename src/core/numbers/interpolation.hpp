// Curves through points: straight lines as numpy.interp draws them, and cubic polynomials as scipy's PPoly.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

/// Straight lines between points; level beyond the outermost.
struct Polyline {
  Numbers places, values;  ///< places ascending

  double at(double x) const;
};

/// Cubic polynomials between places.
struct Cubics {
  Numbers places;       ///< ascending
  Matrix coefficients;  ///< of each piece, of the distance from its beginning, highest power first

  /// The value at a place within.
  double at(double x) const;
};

}  // namespace nonhertz
