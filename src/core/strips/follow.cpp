#include "strips/follow.hpp"

#include <algorithm>

#include "strips/solving.hpp"

namespace nonhertz {
namespace {

/// Change m as for springs, so that strips leave at once where the bodies no longer overlap.
void foresee(const Grid& grid, const Pair& motion, State& state) {
  const auto overlaps = [&](Index i) {
    const double now = motion[0] + motion[1] * grid.y[i] - grid.separation[i];
    return std::pair(state.interference(grid, i), now);
  };
  bool touches = false;
  for (Index i = 0; i < grid.count(); ++i) {
    const auto [before, now] = overlaps(i);
    if (state.m[i] > 0.0 && before > 0.0) touches = touches || now > 0.0;
  }
  if (!touches) return;
  for (Index i = 0; i < grid.count(); ++i) {
    const auto [before, now] = overlaps(i);
    if (state.m[i] > 0.0 && before > 0.0) state.m[i] *= std::min(std::max(now / before, 0.0), 4.0);
  }
}

}  // namespace

Following::Following(std::shared_ptr<const Grid> grid, std::shared_ptr<const Kernel> kernel)
    : grid_(std::move(grid)), kernel_(std::move(kernel)), loop_(*grid_, *kernel_), trial_(grid_->count()) {}

std::optional<Pair> Following::follow(const Pair& motion, State& state) {
  trial_ = state;
  foresee(*grid_, motion, trial_);
  if (too_thin(*grid_, *kernel_, trial_.m, HOPELESS)) return {};
  trial_.rigid = motion;
  Options options;
  options.follows = true;
  loop_.run({{false, false}, motion}, options, trial_);
  if (!trial_.converged()) return {};
  state = trial_;
  return loop_.resultant();
}

}  // namespace nonhertz
