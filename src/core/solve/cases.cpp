#include "solve/cases.hpp"

#include <algorithm>
#include <cmath>

#include "numbers/sums.hpp"

namespace nonhertz {
namespace {

/// Strips without the full matrix: those of thousands of results would fill the memory.
std::shared_ptr<const Grid> without_depth(const Grid& grid) {
  return std::make_shared<const Grid>(
      Grid{grid.edges, grid.y, grid.separation, grid.curvature, grid.min_depth, grid.sharper, {}, {}});
}

Grids grids_of(const Model& model, const Prescription& prescribed, const Strips& strips) {
  if (const auto* edges = std::get_if<Numbers>(&strips)) return given_grids(model, *edges);
  return equal_grids(model, prescribed, std::get<Index>(strips));
}

/// Whether all cases have the same strips: the region of a contact of infinite bodies depends on the case, and so does
/// an automatic grid.
bool are_shared(const Model& model, const Strips& strips) {
  return std::holds_alternative<Numbers>(strips) ||
         (std::holds_alternative<Index>(strips) && model.region() != nullptr);
}

/// Cases one after the other, on the same grids if these are shared.
class Course {
 public:
  Course(const Model& model, const Strips& strips)
      : model_(model), strips_(strips), shares_(are_shared(model, strips)) {}

  Result solve(const Prescription& prescribed, const Stop* stop) {
    Result result = check_and_judge(model_, prescribed, solve_levels(prescribed, stop));
    for (Level& level : result.levels.levels) level.grid = light(level.grid);
    return result;
  }

  /// Solve a case that may start from previous ones. A misleading start is not a reason to fail.
  Result solve_next(const Prescription& prescribed, const Stop* stop) {
    if (!shares_) return solve(prescribed, stop);
    const bool is_first = tracks_.empty();
    Result result = solve(prescribed, stop);
    if (is_first || result.holds()) return result;
    tracks_.clear();
    return solve(prescribed, stop);
  }

 private:
  Levels solve_levels(const Prescription& prescribed, const Stop* stop) {
    if (const auto* accuracy = std::get_if<Accuracy>(&strips_))
      return solve_automatically(model_, prescribed, *accuracy, stop);
    if (!shares_) tracks_.clear();
    if (tracks_.empty())
      for (const auto& grid : grids_of(model_, prescribed, strips_)) tracks_.emplace_back(grid, model_.kernel());
    refuse_infeasible(model_, *tracks_[0].grid, prescribed);
    return solve_on_grids(tracks_, prescribed, stop);
  }

  std::shared_ptr<const Grid> light(const std::shared_ptr<const Grid>& grid) {
    if (grid->at_depth.empty()) return grid;
    for (Track& track : tracks_)
      if (track.grid == grid) {
        if (!track.light) track.light = without_depth(*grid);
        return track.light;
      }
    return without_depth(*grid);
  }

  const Model& model_;
  const Strips& strips_;
  const bool shares_;
  std::deque<Track> tracks_;
};

}  // namespace

bool Result::holds() const {
  const Judgement& j = judgement;
  const auto& rigid = finest().state.rigid;
  for (double number : {rigid[0], rigid[1], resultant[0], resultant[1], j.pressure.value, j.half_width})
    if (!std::isfinite(number)) return false;
  return finest().state.converged() && is_steady && shortfall.condition == Unmet::none &&
         j.checks.radius_ratio <= 1.0 && j.checks.depth_ratio >= 1.0;
}

Result judge_levels(const Model& model, const Prescription& prescribed, Levels levels) {
  Result result{prescribed, std::move(levels), {}, true, {}, {}};
  const auto& [grid, state] = result.finest();
  Numbers carried(state.r.size()), turned(state.r.size());
  for (Index i = 0; i < grid->count(); ++i) {
    carried[i] = state.r[i] * state.m[i] * grid->width(i);
    turned[i] = carried[i] * grid->y[i];
  }
  result.resultant = {sum_of(carried), sum_of(turned)};
  result.judgement = judge(model, prescribed, result.levels);
  return result;
}

Result check_and_judge(const Model& model, const Prescription& prescribed, Levels levels) {
  Result result = judge_levels(model, prescribed, std::move(levels));
  const auto& [grid, state] = result.finest();
  if (!state.converged()) return result;
  result.is_steady = steady(*grid, state);
  result.shortfall = first_unmet(*grid, prescribed, model.kernel(), state);
  return result;
}

Result solve(const Model& model, const Prescription& prescribed, const Strips& strips, const Stop* stop) {
  return Course(model, strips).solve(prescribed, stop);
}

std::vector<Ended> solve_in_turn(const Model& model, std::array<bool, 2> by_force, const std::vector<Pair>& targets,
                                 const Strips& strips, const Stop* stop) {
  std::vector<Ended> cases;
  cases.reserve(targets.size());
  Course course(model, strips);
  for (const Pair& target : targets) {
    try {
      cases.emplace_back(course.solve_next({by_force, target}, stop));
    } catch (const Stopped&) {
      break;
    } catch (...) {
      cases.emplace_back(std::current_exception());
    }
  }
  return cases;
}

}  // namespace nonhertz
