#include "solve/cases.hpp"

#include <algorithm>
#include <cmath>

#include "numbers/sums.hpp"

namespace nonhertz {
namespace {

/// Strips without the matrix of all by all: of thousands of results they would fill the memory.
std::shared_ptr<const Grid> without_depth(const Grid& grid) {
  return std::make_shared<const Grid>(
      Grid{grid.edges, grid.y, grid.separation, grid.curvature, grid.min_depth, grid.sharper, {}, {}});
}

Grids grids_of(const Model& model, const Prescription& given, const Strips& strips) {
  if (const auto* edges = std::get_if<Numbers>(&strips)) return given_grids(model, *edges);
  return equal_grids(model, given, std::get<Index>(strips));
}

/// Whether all cases have the same strips: where to look for a contact of endless bodies depends on the case.
bool are_shared(const Model& model, const Strips& strips) {
  return std::holds_alternative<Numbers>(strips) ||
         (std::holds_alternative<Index>(strips) && model.region() != nullptr);
}

/// A case that may start from the one before on shared grids.
Levels solve_levels(const Model& model, const Prescription& given, const Strips& strips, const Grids& shared,
                    const Result* before, const Stop* stop) {
  if (const auto* accuracy = std::get_if<Accuracy>(&strips)) return solve_automatically(model, given, *accuracy, stop);
  const Grids& grids = shared.empty() ? grids_of(model, given, strips) : shared;
  refuse_infeasible(model, *grids[0], given);
  if (before == nullptr || shared.empty()) return solve_on_grids(model, grids, given, nullptr, {}, stop);
  return solve_on_grids(model, grids, given, &before->finest().state, before->given, stop);
}

/// Grids that cases share, and the same without their matrices for the results.
struct Shared {
  Grids whole, light;
};

Result solve_one(const Model& model, const Prescription& given, const Strips& strips, const Shared& shared,
                 const Result* before, const Stop* stop) {
  Result result = checked(model, given, solve_levels(model, given, strips, shared.whole, before, stop));
  for (Level& level : result.levels.levels) {
    const auto at = std::find(shared.whole.begin(), shared.whole.end(), level.grid) - shared.whole.begin();
    if (at < std::ssize(shared.light))
      level.grid = shared.light[at];
    else if (!level.grid->at_depth.empty())
      level.grid = without_depth(*level.grid);
  }
  return result;
}

}  // namespace

bool Result::holds() const {
  const Judgement& j = judgement;
  const auto& rigid = finest().state.rigid;
  for (double number : {rigid[0], rigid[1], resultant[0], resultant[1], j.pressure.value, j.half_width})
    if (!std::isfinite(number)) return false;
  return finest().state.converged() && is_steady && shortfall.condition == Unmet::none &&
         j.checks.radius_ratio <= 1.0 && j.checks.depth_ratio >= 1.0;
}

Result judged(const Model& model, const Prescription& given, Levels levels) {
  Result result{given, std::move(levels), {}, true, {}, {}};
  const auto& [grid, state] = result.finest();
  Numbers carried(state.r.size()), turned(state.r.size());
  for (Index i = 0; i < grid->count(); ++i) {
    carried[i] = state.r[i] * state.m[i] * grid->width(i);
    turned[i] = carried[i] * grid->y[i];
  }
  result.resultant = {sum_of(carried), sum_of(turned)};
  result.judgement = judge(model, given, result.levels);
  return result;
}

Result checked(const Model& model, const Prescription& given, Levels levels) {
  Result result = judged(model, given, std::move(levels));
  const auto& [grid, state] = result.finest();
  if (!state.converged()) return result;
  result.is_steady = steady(*grid, state);
  result.shortfall = first_unmet(*grid, given, model.kernel(), state);
  return result;
}

Result solve(const Model& model, const Prescription& given, const Strips& strips, const Stop* stop) {
  return solve_one(model, given, strips, {}, nullptr, stop);
}

std::vector<Ended> solve_in_turn(const Model& model, std::array<bool, 2> by_force, const std::vector<Pair>& targets,
                                 const Strips& strips, const Stop* stop) {
  std::vector<Ended> cases;
  cases.reserve(targets.size());
  Shared shared;
  const auto solve_next = [&](const Pair& target) {
    const Prescription given{by_force, target};
    if (shared.whole.empty() && are_shared(model, strips)) {
      shared.whole = grids_of(model, given, strips);
      for (const auto& grid : shared.whole) shared.light.push_back(without_depth(*grid));
    }
    const Result* before = cases.empty() ? nullptr : std::get_if<Result>(&cases.back());
    Result result = solve_one(model, given, strips, shared, before, stop);
    // A neighbour that misleads is no reason to fail.
    if (before == nullptr || shared.whole.empty() || result.holds()) return result;
    return solve_one(model, given, strips, shared, nullptr, stop);
  };
  for (const Pair& target : targets) {
    try {
      cases.emplace_back(solve_next(target));
    } catch (const Stopped&) {
      break;
    } catch (...) {
      cases.emplace_back(std::current_exception());
    }
  }
  return cases;
}

}  // namespace nonhertz
