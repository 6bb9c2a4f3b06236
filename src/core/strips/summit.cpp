#include "strips/summit.hpp"

#include <algorithm>
#include <cmath>

namespace nonhertz {
namespace {

constexpr double SAME = 1e-9;
constexpr double LEAST_SAGITTA = 0.01;  // that of a cusp is larger, that of a resolved summit smaller
// Remaining error over the change of a summit's pressure from half the strips: in a smooth interval, and where strips
// are narrower than this fraction of a half-width, which happens only at a corner of the profile; and over the sagitta
// within the strip. Measured on 800 random rollers, of which 3 exceed the estimate.
constexpr double SMOOTH_LEFT = 0.5, CORNER_LEFT = 1.6, CORNER_STRIP = 0.2, SAGITTA_LEFT = 0.6;

/// The pressure at y on the parabola through the nearest three strips; the largest of fewer strips.
double pressure_at(const Pressures& strips, double y) {
  const Numbers &places = strips.grid.y, &p = strips.pressure;
  const Index n = count_of(p);
  if (n < 3) return std::max(p.front(), p.back());
  Index i = 1;
  while (i + 2 < n && places[i] + places[i + 1] < 2.0 * y) ++i;
  const double low = places[i - 1], middle = places[i], high = places[i + 1];
  const double first = (p[i] - p[i - 1]) / (middle - low), second = (p[i + 1] - p[i]) / (high - middle);
  return p[i] + (y - middle) * (first + (y - low) * (second - first) / (high - low));
}

}  // namespace

Pressures::Pressures(const Level& level, double hertz_ratio)
    : grid(*level.grid), half_width(grid.y.size()), pressure(grid.y.size()), load(grid.y.size()) {
  const State& state = level.state;
  for (Index i = 0; i < grid.count(); ++i) {
    const double root = std::sqrt(state.m[i]);
    half_width[i] = hertz_ratio * root;
    pressure[i] = state.r[i] * root;
    load[i] = state.r[i] * state.m[i] * grid.width(i);
  }
}

double sagitta(View p, Index at) { return p[at] > 0.0 ? (2.0 * p[at] - p[at - 1] - p[at + 1]) / (8.0 * p[at]) : 0.0; }

bool is_summit(View pressure, Index at) {
  const double beside = std::max(pressure[at - 1], pressure[at + 1]);
  // Two strips beside the middle may differ by rounding. A contact may run out beside its largest pressure, as at the
  // corner of a roller.
  return beside > 0.0 && pressure[at] >= (1.0 - SAME) * beside;
}

bool is_cusp(View pressure, Index at) {
  bool rising = false;
  for (Index i = std::max(at - 2, Index{1}); i < std::min(at + 3, count_of(pressure) - 1); ++i)
    rising = rising || sagitta(pressure, i) < 0.0;
  return rising && sagitta(pressure, at) > LEAST_SAGITTA;
}

double cusp(View pressure, Index at) {
  const bool narrow = is_cusp(pressure, at) && is_summit(pressure, at);
  return narrow ? pressure[at] * (1.0 + CUSP * sagitta(pressure, at)) : 0.0;
}

bool is_on_corner(const Pressures& strips, Index at) {
  return strips.grid.width(at) < CORNER_STRIP * strips.half_width[at];
}

std::optional<Index> resolved_summit(const Pressures& strips, double y) {
  const Numbers& p = strips.pressure;
  for (Index i = 1; i + 1 < count_of(p); ++i) {
    if (strips.grid.y[i] != y) continue;
    const double bend = sagitta(p, i);
    const bool is_inside = std::min(p[i - 1], p[i + 1]) > 0.0;
    if (is_inside && is_summit(p, i) && 0.0 < bend && bend < LEAST_SAGITTA) return i;
    return std::nullopt;
  }
  return std::nullopt;
}

double error_at_summit(const Pressures& strips, Index at, const Pressures& before, const Pressures& before_that,
                       bool regular) {
  const Numbers& p = strips.pressure;
  const double y = strips.grid.y[at], bend = sagitta(p, at), slope = (p[at + 1] - p[at - 1]) / p[at];
  const double beside = slope * slope / (64.0 * bend);
  const double coarse = pressure_at(before, y);
  const double last = std::fabs(p[at] - coarse) / p[at];
  double of_grids = (is_on_corner(strips, at) ? CORNER_LEFT : SMOOTH_LEFT) * last;
  if (!regular) of_grids = SAFETY * std::max(last, 0.5 * (std::fabs(coarse - pressure_at(before_that, y)) / p[at]));
  return of_grids + beside + SAGITTA_LEFT * bend;
}

double largest_summit_error(const Level& finest, const Level& half, double hertz_ratio) {
  const Pressures strips(finest, hertz_ratio);
  const auto largest = std::max_element(strips.pressure.begin(), strips.pressure.end());
  const auto at = resolved_summit(strips, strips.grid.y[largest - strips.pressure.begin()]);
  if (!at) return 0.0;
  const Pressures before(half, hertz_ratio);
  return error_at_summit(strips, *at, before, before, true);
}

}  // namespace nonhertz
