#include "grids/first.hpp"

#include <algorithm>

#include "grids/feasible.hpp"
#include "grids/springs.hpp"

namespace nonhertz {
namespace {

constexpr Index MORE_STRIPS[] = {1, 5, 25};  // multiples, in case fewer strips miss the contact

}  // namespace

Numbers first_strips(const Model& model, const Prescription& prescribed, double low, double high) {
  auto grid = model.springs(uniform(low, high, COARSE_STRIPS));
  refuse_endless_relief(grid->y, grid->separation);
  // Any strips will do if the load is given and the moment is not. A prescribed approach may bring only a tiny spot
  // into contact, a moment only the very end.
  if (prescribed.by_force[0] && (!prescribed.by_force[1] || is_feasible(model, *grid, prescribed))) return grid->edges;
  refuse_arm_outside(prescribed, low, high);
  std::vector<Pair> regions{neighbourhood(model, prescribed, low, high)};
  if (prescribed.both()) {  // at one end of the bodies, centred on the resultant of load and moment
    const double arm = arm_of(prescribed);
    const bool at_high = high - arm < arm - low;
    regions.push_back(at_high ? Pair{std::max(low, 2.0 * arm - high), high}
                              : Pair{low, std::min(high, 2.0 * arm - low)});
  }
  for (const auto& [from, to] : regions)
    for (Index more : MORE_STRIPS) {
      grid = model.springs(uniform(from, to, more * COARSE_STRIPS));
      if (is_feasible(model, *grid, prescribed)) return grid->edges;
    }
  refuse_infeasible(model, *grid, prescribed, false);
  return grid->edges;
}

}  // namespace nonhertz
