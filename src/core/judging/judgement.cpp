#include "judging/judgement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace nonhertz {
namespace {

constexpr double AT_CORNER = 1.5;  // strips: a maximum this close to a corner of the profile is attributed to it

/// Whether the largest pressure is at a corner of the profile, where it is also singular.
bool is_at_kink(const Model& model, const Level& level, double y, View singular) {
  const Grid& grid = *level.grid;
  Numbers inside;
  for (double bend : model.contact().bends)
    if (grid.edges.front() < bend && bend < grid.edges.back() && is_nearly_touching(grid, level.state.m, bend))
      inside.push_back(bend);
  if (inside.empty() || inside.size() > MOST_BENDS) return false;
  Index nearest = 0;
  for (Index i = 0; i < grid.count(); ++i)
    if (std::fabs(grid.y[i] - y) < std::fabs(grid.y[nearest] - y)) nearest = i;
  const Kinks kinks = model.kinks_among(inside, grid.edges.back() - grid.edges.front());
  return std::any_of(kinks.place.begin(), kinks.place.end(), [&](double place) {
    const bool is_end = std::find(singular.begin(), singular.end(), place) != singular.end();
    return !is_end && std::fabs(place - y) <= AT_CORNER * grid.width(nearest);
  });
}

}  // namespace

Judgement judge(const Model& model, const Prescription& prescribed, const Levels& levels) {
  const Level& finest = levels.levels[0];
  const Grid& grid = *finest.grid;
  const State& state = finest.state;
  const Index n = grid.count();
  Numbers half_width(n), pressure(n);
  for (Index i = 0; i < n; ++i) {
    half_width[i] = model.hertz_ratio() * std::sqrt(state.m[i]);
    const double line_load = state.r[i] * state.m[i] / model.contact().compliance;
    if (half_width[i] > 0.0) pressure[i] = 2.0 * line_load / (std::numbers::pi * half_width[i]);
  }
  Judgement judgement;
  judgement.contact = intervals(grid, state.m);
  judgement.ends = ends_of(model, finest);
  const Numbers singular = judgement.ends.singular_places();
  judgement.pressure = values_that_count(grid.y, pressure, half_width, singular).largest();
  if (judgement.contact.empty()) judgement.pressure.y = std::numeric_limits<double>::quiet_NaN();
  judgement.half_width = values_that_count(grid.y, half_width, half_width, singular).largest().value;
  judgement.peaks_at_corner = state.converged() && is_at_kink(model, finest, judgement.pressure.y, singular);
  judgement.penetration = penetration_of(model, grid.edges, state.rigid);
  judgement.errors = estimate(model, prescribed, levels, judgement.ends, judgement.peaks_at_corner);
  judgement.checks = check(model, finest, judgement);
  return judgement;
}

}  // namespace nonhertz
