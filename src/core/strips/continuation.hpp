// Start of a case that follows similar ones on the same strips, as when a load rises from case to case.
#pragma once

#include <optional>
#include <vector>

#include "strips/strips.hpp"

namespace nonhertz {

/// The last solutions on one grid, extrapolated to the next prescription.
class Continuation {
 public:
  void add(const Prescription& prescribed, const State& solution);
  /// Return the start of the next case; nothing if the last one is not similar enough.
  ///
  /// Prescriptions on a straight line are extrapolated by the parabola through the last three, or the line through two.
  std::optional<State> next(const Prescription& prescribed, const Grid& grid) const;

 private:
  struct Solved {
    Pair target;
    State state;
  };
  std::vector<double> weights(const Pair& target) const;

  std::vector<Solved> solved_;  // the latest first
};

}  // namespace nonhertz
