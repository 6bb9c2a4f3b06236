// One case on given strips: if the loop fails from one start, the next is tried.
#pragma once

#include <optional>

#include "strips/newton.hpp"

namespace nonhertz {

// Depth in half-widths below which no loop is started. Half-widths of independent springs may be half of the true ones
// for thin bodies.
inline constexpr double HOPELESS = 0.7;
inline constexpr Index PATIENT_STRIPS = 400;  // up to which all starts are tried

/// Starts other than springs, and the effort.
struct Attempt {
  std::optional<State> before;  ///< close to the solution, from similar cases on the same strips
  const Level* near = nullptr;  ///< a solution on other strips
  double tolerance = TOLERANCE;
  bool patient = true;         ///< whether to try all starts
  const Stop* stop = nullptr;  ///< checked before every step
};

State solve_on(Newton& loop, const Prescription& prescribed, const Attempt& attempt);
State solve_on(const Grid& grid, const Prescription& prescribed, const Kernel& kernel, const Attempt& attempt);

/// Return whether a body is less than `least` half-widths deep: then the equations have no meaningful solution.
bool too_thin(const Grid& grid, const Kernel& kernel, View m, double least);

}  // namespace nonhertz
