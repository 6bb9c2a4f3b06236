// One case on given strips: where the loop fails from one start, the next is tried.
#pragma once

#include <optional>

#include "strips/newton.hpp"

namespace nonhertz {

// Depth in half-widths below which no loop is started. Those of independent springs may be half of the true ones where
// bodies are thin.
inline constexpr double HOPELESS = 0.7;
inline constexpr Index PATIENT_STRIPS = 400;  // up to which all starts are tried

/// Which starts there are beside springs, and how hard to try.
struct Attempt {
  std::optional<State> before;  ///< close to the solution, from similar cases on the same strips
  const Level* near = nullptr;  ///< a solution on other strips
  double tolerance = TOLERANCE;
  bool patient = true;         ///< whether to try hard
  const Stop* stop = nullptr;  ///< looked at before every step
};

State solve_on(Newton& loop, const Prescription& given, const Attempt& attempt);
State solve_on(const Grid& grid, const Prescription& given, const Kernel& kernel, const Attempt& attempt);

/// Return whether a body is less than `least` half-widths deep: then the equations have no meaningful solution.
bool too_thin(const Grid& grid, const Kernel& kernel, View m, double least);

}  // namespace nonhertz
