// Legendre polynomials.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

/// Fill in the Legendre polynomials at x, as many as there is room for.
inline void legendre(double x, Row out) {
  out[0] = 1.0, out[1] = x;
  for (Index n = 1; n + 1 < count_of(out); ++n) {
    const double order = static_cast<double>(n);
    out[n + 1] = ((2.0 * order + 1.0) * x * out[n] - order * out[n - 1]) / (order + 1.0);
  }
}

}  // namespace nonhertz
