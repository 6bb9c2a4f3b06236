// The final check of a solution: whether it meets the prescribed values, computed only from its own arrays.
//
// It shares only the element's table and the images with the loop: from edges, loads, half-widths and motion it
// recomputes displacement and curvature at every strip. A state that fails is not a solution, whatever the loop
// reported.
#pragma once

#include "strips/kernel.hpp"
#include "strips/strips.hpp"

namespace nonhertz {

enum class Unmet { none, not_finite, first, second, tension, unclosed, overlap, bent, hidden };

/// The first condition that is not met, the value found, and the strip where it was found.
struct Shortfall {
  Unmet condition = Unmet::none;
  double value = 0.0;
  Index at = 0;
};

/// The claimed solution: K q, half-width and gap of every strip, approach and tilt.
struct Answer {
  Numbers q, half_width, gap;
  Pair motion;
  double interference(const Grid& grid, Index i) const {
    return motion[0] + motion[1] * grid.y[i] - grid.separation[i];
  }
};

Shortfall first_unmet(const Grid& grid, const Prescription& prescribed, const Kernel& kernel, const Answer& answer);
Shortfall first_unmet(const Grid& grid, const Prescription& prescribed, const Kernel& kernel, const State& state);

/// Whether the stiffness against approach and tilt is positive; spurious solutions fail this.
bool steady(const std::array<Pair, 2>& stiffness, double reach);
bool steady(const Grid& grid, const State& state);

}  // namespace nonhertz
