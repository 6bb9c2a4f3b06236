// Many cases of one contact, and one: in, what is prescribed; out, all that is known of the solution.
#pragma once

#include <optional>
#include <variant>

#include "judging/judgement.hpp"
#include "strips/acceptance.hpp"

namespace nonhertz {

/// Strips of a case: a graded grid of this accuracy, so many equal ones, or given edges.
struct Automatic {
  double accuracy = ACCURACY;
};
using Strips = std::variant<Automatic, Index, Numbers>;

/// A case as it ended: solved and judged, or with what stands against it.
struct Result {
  Levels levels;
  Shortfall shortfall;
  bool is_steady = false;
  std::optional<Judgement> judgement;  ///< of what has converged
  std::optional<Refused> refused;

  const Level& finest() const { return levels.levels[0]; }
};

/// Solve a case; throws Refused where no strips can meet what is prescribed.
Result solve(const Model& model, const Prescription& given, const Strips& strips);

/// Solve many, in parts of a fixed size: what a case starts from, and so its last digits, do not depend on threads.
std::vector<Result> solve_many(const Model& model, std::array<bool, 2> by_force, const std::vector<Pair>& targets,
                               const Strips& strips, int threads);

}  // namespace nonhertz
