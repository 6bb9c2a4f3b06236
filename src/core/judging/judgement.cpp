#include "judging/judgement.hpp"

#include <algorithm>
#include <cmath>

namespace nonhertz {
namespace {

constexpr double AT_CORNER = 1.5;  // strips: a maximum this close to a corner of the profile is attributed to it

/// Whether the largest pressure is at a corner of the profile: it has no limit there either.
bool is_at_kink(const Model& model, const Level& level, double y, View singular) {
  const Grid& grid = *level.grid;
  Numbers inside;
  for (double bend : model.contact().bends)
    if (grid.edges.front() < bend && bend < grid.edges.back() && nearly_touching(grid, level.state.m, bend))
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

Judgement judge(const Model& model, const Prescription& given, const Levels& levels) {
  const Level& finest = levels.levels[0];
  Judgement found;
  found.contact = intervals(*finest.grid, finest.state.m);
  found.ends = ends_of(model, finest);
  found.largest = largest_pressure(finest, model.hertz_ratio(), found.ends.singular);
  found.peaks_at_corner = is_at_kink(model, finest, found.largest.y, found.ends.singular);
  const Estimate estimated = estimate(model, given, levels, found.ends, found.largest, found.peaks_at_corner);
  found.errors = estimated.errors, found.penetration = estimated.penetration;
  found.checks = check(model, finest, found.contact);
  return found;
}

/// The parabolas within a strip, as three orthonormal rows over the places.
static std::array<std::array<double, WITHIN>, 3> parabolas() {
  std::array<std::array<double, WITHIN>, 3> rows{};
  for (int power = 0; power < 3; ++power) {
    for (int k = 0; k < WITHIN; ++k) rows[power][k] = std::pow(within(k), power);
    for (int other = 0; other < power; ++other) {
      double along = 0.0;
      for (int k = 0; k < WITHIN; ++k) along += rows[power][k] * rows[other][k];
      for (int k = 0; k < WITHIN; ++k) rows[power][k] -= along * rows[other][k];
    }
    double square = 0.0;
    for (double each : rows[power]) square += each * each;
    for (double& each : rows[power]) each /= std::sqrt(square);
  }
  return rows;
}

double departure(View separation) {
  static const auto rows = parabolas();
  std::array<double, 3> share{};
  for (int k = 0; k < WITHIN; ++k) {
    if (!std::isfinite(separation[k])) return 0.0;
    for (int row = 0; row < 3; ++row) share[row] += separation[k] * rows[row][k];
  }
  double total = 0.0;
  for (int k = 0; k < WITHIN; ++k) {
    const double off = separation[k] - (share[0] * rows[0][k] + share[1] * rows[1][k] + share[2] * rows[2][k]);
    total += off * off;
  }
  return std::sqrt(total / WITHIN);
}

}  // namespace nonhertz
