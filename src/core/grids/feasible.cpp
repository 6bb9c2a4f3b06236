#include "grids/feasible.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "grids/springs.hpp"

namespace nonhertz {
namespace {

constexpr Index LOOKS = 20000;  // places along the strips
constexpr int CLOSER_LOOKS = 4;
constexpr Index CLOSER = 100;  // intervals around the best place

/// Why a prescription cannot be met on strips whose separation is finite somewhere, without the numbers.
std::optional<Refusal> stands_against(const Model& model, const Grid& grid, const Prescription& prescribed,
                                      Pair& usable) {
  const auto is_finite = [](double h) { return std::isfinite(h); };
  const Numbers& h = grid.separation;
  if (prescribed.both()) {
    usable = {grid.y[std::find_if(h.begin(), h.end(), is_finite) - h.begin()],
              grid.y[h.rend() - std::find_if(h.rbegin(), h.rend(), is_finite) - 1]};
    const bool inside = usable[0] <= arm_of(prescribed) && arm_of(prescribed) <= usable[1];
    return inside ? std::nullopt : std::optional(Refusal::arm_off_strips);
  }
  if (prescribed.by_force[1])
    return is_touching(springs(model, prescribed, grid.edges)) ? std::nullopt : std::optional(Refusal::tilted_apart);
  if (prescribed.by_force[0]) return std::nullopt;
  for (Index i = 0; i < grid.count(); ++i)
    if (prescribed.target[0] + prescribed.target[1] * grid.y[i] - h[i] > 0.0) return std::nullopt;
  return Refusal::apart;
}

/// The smallest approach at which the bodies touch, by repeated refinement around the best place.
double first_touch(const Model& model, double tilt, Numbers y) {
  double least = std::numeric_limits<double>::infinity();
  for (int look = 0; look < CLOSER_LOOKS; ++look) {
    const Numbers h = model.separation(y);
    refuse_endless_relief(y, h);
    std::size_t best = 0;
    for (std::size_t i = 0; i < y.size(); ++i)
      if (h[i] - tilt * y[i] < h[best] - tilt * y[best]) best = i;
    least = std::min(least, h[best] - tilt * y[best]);
    y = uniform(y[best > 0 ? best - 1 : 0], y[std::min(best + 1, y.size() - 1)], CLOSER);
  }
  return least;
}

/// A number of places between the first and the last edge, dense where edges are.
Numbers along(View edges) {
  const double last = static_cast<double>(edges.size() - 1);
  Numbers y;
  for (double at : uniform(0.0, last, LOOKS - 1)) {
    const auto below = static_cast<std::size_t>(std::min(at, last - 1.0));
    y.push_back(edges[below] + (at - static_cast<double>(below)) * (edges[below + 1] - edges[below]));
  }
  return y;
}

}  // namespace

bool is_feasible(const Model& model, const Grid& grid, const Prescription& prescribed) {
  const Numbers& h = grid.separation;
  Pair usable{};
  return std::none_of(h.begin(), h.end(), [](double separation) { return std::isnan(separation); }) &&
         std::any_of(h.begin(), h.end(), [](double separation) { return std::isfinite(separation); }) &&
         !stands_against(model, grid, prescribed, usable);
}

void refuse_infeasible(const Model& model, const Grid& grid, const Prescription& prescribed, bool chosen) {
  refuse_endless_relief(grid.y, grid.separation);
  Pair usable{};
  const auto refusal = stands_against(model, grid, prescribed, usable);
  if (!refusal) return;
  if (*refusal == Refusal::apart) refuse_no_contact(model, grid.edges, prescribed, chosen);
  if (*refusal == Refusal::tilted_apart) throw Refused(*refusal, prescribed.target[0]);
  if (!chosen) refuse_arm_outside(prescribed, usable[0], usable[1]);
  throw Refused(*refusal, arm_of(prescribed), usable[0], usable[1], grid.count());
}

void refuse_arm_outside(const Prescription& prescribed, double low, double high) {
  if (prescribed.both() && !(low <= arm_of(prescribed) && arm_of(prescribed) <= high))
    throw Refused(Refusal::arm_outside, arm_of(prescribed), low, high);
}

void refuse_endless_relief(View y, View separation) {
  const auto is_nan = [](double h) { return std::isnan(h); };
  const auto undefined = std::find_if(separation.begin(), separation.end(), is_nan);
  if (undefined != separation.end()) throw Refused(Refusal::nan_relief, y[undefined - separation.begin()]);
  if (std::none_of(separation.begin(), separation.end(), [](double h) { return std::isfinite(h); }))
    throw Refused(Refusal::endless_relief);
}

void refuse_no_contact(const Model& model, View edges, const Prescription& prescribed, bool chosen) {
  const double low = edges.front(), high = edges.back();
  const Level fine = springs(model, prescribed, uniform(low, high, FINE_STRIPS));
  if (chosen && is_touching(fine)) throw Refused(Refusal::between_strips, 0.0, low, high, count_of(edges) - 1);
  const double tilt = prescribed.by_force[1] ? 0.0 : prescribed.target[1];
  // Graded strips may be finer than the equal spring strips, so their edges are searched as well.
  Numbers y = along(edges);
  y.insert(y.end(), fine.grid->y.begin(), fine.grid->y.end());
  y.insert(y.end(), edges.begin(), edges.end());
  std::sort(y.begin(), y.end());
  y.erase(std::unique(y.begin(), y.end()), y.end());
  const double needed = first_touch(model, tilt, std::move(y)), approach = prescribed.target[0];
  if (approach > needed) throw Refused(Refusal::unresolved, approach);
  throw chosen ? Refused(Refusal::apart, needed, low, high, count_of(edges) - 1) : Refused(Refusal::apart, needed);
}

}  // namespace nonhertz
