#include "grids/levels.hpp"

#include <algorithm>

#include "grids/search.hpp"

namespace nonhertz {
namespace {

constexpr Index COARSEST_LEVEL = 5;

/// Drop coarser levels that have no solution.
void drop_unsolved(std::vector<Level>& levels) {
  const auto is_unsolved = [](const Level& level) { return !level.state.converged(); };
  levels.erase(std::remove_if(levels.begin() + 1, levels.end(), is_unsolved), levels.end());
}

}  // namespace

Levels solve_automatically(const Model& model, const Prescription& prescribed, const Accuracy& accuracy,
                           const Stop* stop) {
  std::vector<Level> levels = Search(model, prescribed, accuracy, stop).run();
  const bool is_regular = levels[1].state.converged();
  drop_unsolved(levels);
  return {std::move(levels), is_regular ? accuracy.of_motion : 0.0};
}

Grids equal_grids(const Model& model, const Prescription& prescribed, Index count) {
  const auto [low, high] = bound_contact(model, prescribed);
  Grids grids;
  for (Index level = count;; level /= 2) {
    grids.push_back(model.grid(uniform(low, high, level)));
    if (!(level / 2 >= COARSEST_LEVEL || (grids.size() == 1 && count > 1))) return grids;
  }
}

Grids given_grids(const Model& model, Numbers edges) {
  Grids grids{model.grid(std::move(edges))};
  const auto count_of_last = [&grids] { return count_of(grids.back()->edges); };
  while (count_of_last() / 2 > COARSEST_LEVEL || (grids.size() == 1 && count_of_last() > 2)) {
    const Numbers& fine = grids.back()->edges;
    Numbers coarse;
    for (std::size_t i = 0; i + 1 < fine.size(); i += 2) coarse.push_back(fine[i]);
    coarse.push_back(fine.back());
    grids.push_back(model.grid(std::move(coarse)));
  }
  return grids;
}

Levels solve_on_grids(std::deque<Track>& tracks, const Prescription& prescribed, const Stop* stop) {
  Levels solved;
  for (auto track = tracks.rbegin(); track != tracks.rend(); ++track) {
    const bool is_last = &*track == &tracks.front();
    Attempt attempt;
    attempt.before = track->solutions.next(prescribed, *track->grid);
    attempt.near = solved.levels.empty() ? nullptr : &solved.levels[0];
    attempt.tolerance = is_last ? TOLERANCE : ROUGH_TOLERANCE, attempt.patient = is_last, attempt.stop = stop;
    State state = solve_on(track->loop, prescribed, attempt);
    track->solutions.add(prescribed, state);
    solved.levels.insert(solved.levels.begin(), {track->grid, std::move(state)});
  }
  drop_unsolved(solved.levels);
  return solved;
}

}  // namespace nonhertz
