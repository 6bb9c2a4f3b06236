// One case, and similar cases one after the other: in, what is prescribed; out, all that is known of the solution.
#pragma once

#include <variant>

#include "judging/judgement.hpp"
#include "strips/acceptance.hpp"

namespace nonhertz {

/// A graded grid that aims at this accuracy, so many equal strips, or the edges of strips.
using Strips = std::variant<Accuracy, Index, Numbers>;

/// A case as it ended, judged also where the loop failed. What strips are measured against is left out of its grids.
struct Result {
  Prescription given;
  Levels levels;
  Pair resultant{};  ///< K Q [mm^2] and K T [mm^3]
  bool is_steady = true;
  Shortfall shortfall{};  ///< of what has converged
  Judgement judgement;

  const Level& finest() const { return levels.levels[0]; }
  /// Whether it is a solution, and leaves its bodies rounder and thicker than the contact is wide.
  bool holds() const;
};

/// Judge the solutions of a case on all levels, known to meet what is prescribed.
Result judged(const Model& model, const Prescription& given, Levels levels);
/// The same of solutions that have to be checked, on grids with all that strips are measured against.
Result checked(const Model& model, const Prescription& given, Levels levels);

/// Solve a case; throws Refused where no strips can meet what is prescribed, and Stopped.
Result solve(const Model& model, const Prescription& given, const Strips& strips, const Stop* stop = nullptr);

/// A result, or why there is none: Refused, or what a profile raised.
using Ended = std::variant<Result, std::exception_ptr>;

/// Solve cases that may start from the one before, where they share their strips. Once stopped, return those solved.
std::vector<Ended> solve_in_turn(const Model& model, std::array<bool, 2> by_force, const std::vector<Pair>& targets,
                                 const Strips& strips, const Stop* stop = nullptr);

}  // namespace nonhertz
