#include "grids/peaks.hpp"

#include <algorithm>
#include <cmath>

#include "strips/summit.hpp"

namespace nonhertz {
namespace {

// Largest factor by which strips may become narrower at once, fraction by which another pressure may be smaller and
// still count as the largest, and number of strips about a kink that are left unchanged.
constexpr double LEAST_AT_PEAK = 0.2, ALIKE = 0.01, AT_KINK = 3.0;
// Fraction of a strip's width: an edge this close to y = 0 lies there except for rounding, and its strip on one side.
constexpr double AT_ZERO = 1e-9;

/// The strip with the largest pressure among those on one side of y = 0, zero if there is none.
Index highest_on(const Grid& grid, View pressure, bool high_side, double least) {
  Index at = 0;
  double reached = least;
  for (Index i = 1; i + 1 < grid.count(); ++i) {
    const double least_part = AT_ZERO * grid.width(i);
    if (high_side ? !(grid.high(i) > least_part) : !(grid.low(i) < -least_part)) continue;
    // A lower summit may be the largest pressure, if it is too pointed for its strips.
    const double sagittas = is_cusp(pressure, i) ? CUSP : 1.0;
    const double reach = pressure[i] * (1.0 + sagittas * std::max(0.0, sagitta(pressure, i)));
    if (reach > reached && is_summit(pressure, i)) at = i, reached = reach;
  }
  return at;
}

}  // namespace

std::vector<Peak> peaks_of(const Level& level, View kinks, double allowed) {
  const Grid& grid = *level.grid;
  Numbers pressure(grid.y.size());
  double highest = 0.0;
  for (Index i = 0; i < grid.count(); ++i) {
    pressure[i] = level.state.r[i] * std::sqrt(level.state.m[i]);
    highest = std::max(highest, pressure[i]);
  }
  std::vector<Peak> peaks;
  for (const bool high_side : {false, true}) {
    const Index at = highest_on(grid, pressure, high_side, (1.0 - ALIKE) * highest);
    if (at == 0) continue;
    const double bend = sagitta(pressure, at), width = grid.width(at), place = grid.y[at];
    const auto is_near = [&](double kink) { return std::fabs(place - kink) < AT_KINK * width; };
    if (bend > allowed && std::none_of(kinks.begin(), kinks.end(), is_near))
      peaks.push_back({place, width * std::max(std::sqrt(allowed / bend), LEAST_AT_PEAK), width});
  }
  return peaks;
}

}  // namespace nonhertz
