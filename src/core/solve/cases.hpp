// One case, or similar cases one after the other: prescribed values in, solutions with all results out.
#pragma once

#include <variant>

#include "judging/judgement.hpp"
#include "strips/acceptance.hpp"

namespace nonhertz {

/// A graded grid for this accuracy, a number of equal strips, or the edges of strips.
using Strips = std::variant<Accuracy, Index, Numbers>;

/// The outcome of a case, judged even if the loop failed. Its grids omit the matrix of reference points.
struct Result {
  Prescription prescribed;
  Levels levels;
  Pair resultant{};  ///< K Q [mm^2] and K T [mm^3]
  bool is_steady = true;
  Shortfall shortfall{};  ///< of the converged state
  Judgement judgement;

  const Level& finest() const { return levels.levels[0]; }
  /// Whether it is a solution with a contact narrower than the radii and depths of its bodies.
  bool holds() const;
};

/// Judge the solutions of a case on all levels, known to meet the prescribed values.
Result judge_levels(const Model& model, const Prescription& prescribed, Levels levels);
/// The same for solutions that have to be checked, on grids with the matrix of reference points.
Result check_and_judge(const Model& model, const Prescription& prescribed, Levels levels);

/// Solve a case; throws Refused if no strips can meet the prescribed values, and Stopped.
Result solve(const Model& model, const Prescription& prescribed, const Strips& strips, const Stop* stop = nullptr);

/// A result, or the reason why there is none: Refused, or the exception of a profile.
using Ended = std::variant<Result, std::exception_ptr>;

/// Solve cases that may start from the previous one if they share strips. Once stopped, return those solved.
std::vector<Ended> solve_in_turn(const Model& model, std::array<bool, 2> by_force, const std::vector<Pair>& targets,
                                 const Strips& strips, const Stop* stop = nullptr);

}  // namespace nonhertz
