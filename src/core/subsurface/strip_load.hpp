// The field below strips: uniform along y, semi-elliptic across; nonhertz/subsurface/strips.py has the method.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "numbers/array.hpp"

namespace nonhertz {

/// The strips in contact, followed by all their pieces.
struct Lamination {
  Numbers low, high;              ///< their ends [mm]
  Numbers line_load, half_width;  ///< q [N/mm], and the half-width b [mm] of the semi-ellipse of that load
  std::vector<Index> first;       ///< index of the first piece of each strip, and the end
};

/// Gaussian rules for a semi-ellipse whose integral is 1 (Chebyshev, second kind).
struct SemiEllipseRules {
  static constexpr std::array<Index, 24> LADDER{2,  3,  4,  5,  6,  8,   10,  12,  16,  20,  24,  32,
                                                40, 48, 64, 80, 96, 128, 192, 256, 384, 512, 768, 1024};
  Numbers nodes, weights;     ///< of all rules, one after the other
  std::vector<Index> starts;  ///< offset of each rule
  Numbers enough;  ///< the smallest sum of distances from both edges over the half-width at which each suffices
};

const SemiEllipseRules& semi_ellipse_rules();

/// Six components of the stress [MPa] at points (x, y, z in a row), or of the shear modulus times the displacement.
void below_strips(const Lamination& strips, double poisson, bool displaced, View points, Row out);

}  // namespace nonhertz
