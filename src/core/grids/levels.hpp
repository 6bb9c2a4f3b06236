// Grids solved from coarse to fine: each solution is the start of the next and says where its strips lie.
#pragma once

#include <exception>

#include "grids/laying.hpp"
#include "strips/solving.hpp"

namespace nonhertz {

/// A prescription that no strips can meet; Python puts it into words.
struct Refused : std::exception {
  enum class Why { endless_relief, nan_relief, no_contact, arm_outside, no_strip_between, tilted_apart };
  Why why;
  double value = 0.0, low = 0.0, high = 0.0;

  explicit Refused(Why reason, double of = 0.0, double from = 0.0, double to = 0.0)
      : why(reason), value(of), low(from), high(to) {}
  const char* what() const noexcept override { return "no strips can meet what is prescribed"; }
};

/// Solutions of one case, finest first; and what the grid aims for, 0 where strips are given.
struct Levels {
  std::vector<Level> levels;
  double accuracy = 0.0;
};

/// Solve one case on a graded grid that is adapted to the contact.
Levels solve_automatically(const Model& model, const Prescription& given, double accuracy, const Stop* stop = nullptr);

/// Edges given or equal, and coarser ones that leave out every other one or are fewer; finest first.
std::vector<std::shared_ptr<const Grid>> equal_grids(const Model& model, Index count);

/// Solve one case on given grids; `before`: a similar case, solved on the finest.
Levels solve_on_grids(const Model& model, const std::vector<std::shared_ptr<const Grid>>& grids,
                      const Prescription& given, const State* before, const Prescription& of_before,
                      const Stop* stop = nullptr);

/// Refuse what no loads on these strips can meet.
void refuse_infeasible(const Model& model, const Grid& grid, const Prescription& given);

inline constexpr double ACCURACY = 1e-4;       // that of the automatic grid if none is given
inline constexpr double LEFT_OF_CHANGE = 0.4;  // the error is mostly less than this share of the last change

}  // namespace nonhertz
