// How a solution stands against each condition of the model.
#include <algorithm>
#include <cmath>
#include <limits>

#include "grids/overlaps.hpp"
#include "judging/judgement.hpp"

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();

/// How far the bodies depart from parabolas within a half-width to either side, in the mean of all strips by their
/// loads.
double unevenness(const Model& model, const Level& level) {
  const Grid& grid = *level.grid;
  const State& state = level.state;
  const Index n = grid.count();
  Numbers places(n * WITHIN);
  for (Index i = 0; i < n; ++i)
    for (int k = 0; k < WITHIN; ++k)
      places[i * WITHIN + k] = grid.y[i] + 2.0 * (model.hertz_ratio() * std::sqrt(state.m[i])) * within(k);
  Numbers h = model.separation(places);
  // Towards the ends of bodies and of the interference the relief may fall as it likes.
  for (std::size_t i = 0; i < h.size(); ++i)
    if (!(h[i] < state.rigid[0] + state.rigid[1] * places[i])) h[i] = INFINITE;
  double total = 0.0, load = 0.0;
  for (Index i = 0; i < n; ++i) {
    const double carried = state.r[i] * state.m[i] * grid.width(i);
    total += carried * departure(View(h).subspan(i * WITHIN, WITHIN));
    load += carried;
  }
  return total / load;
}

/// The largest overlap where no strip is in contact, away from strips in contact and those beside them.
void find_missed(const Model& model, const Level& level, Checks& found) {
  const Grid& grid = *level.grid;
  const double first = grid.edges.front(), last = grid.edges.back();
  const double low = std::max(model.low(), 2.0 * first - last), high = std::min(model.high(), 2.0 * last - first);
  const bool whole = low == model.low() && high == model.high();
  const Samples of_part = whole ? Samples{} : model.surveyed(low, high);
  const Samples along = overlapping(model, level, whole ? model.region()->surveyed : of_part);
  const Numbers& m = level.state.m;
  const auto beside_contact = [&](double y) {
    for (Index i = 0; i < grid.count(); ++i)
      if (m[i] > 0.0 && y >= grid.low(i) - grid.width(i) && y <= grid.high(i) + grid.width(i)) return true;
    return false;
  };
  for (std::size_t i = 0; i < along.y.size(); ++i)
    if (along.h[i] > found.missed && !beside_contact(along.y[i]))
      found.missed = along.h[i], found.missed_y = along.y[i];
}

}  // namespace

Checks check(const Model& model, const Level& level, const std::vector<Pair>& contact) {
  const Grid& grid = *level.grid;
  const State& state = level.state;
  Checks found{};
  found.depth_ratio = INFINITE, found.deepest = found.pressed = -INFINITE;
  double widest = 0.0, area = 0.0, load = 0.0, longest = 0.0;
  for (Index i = 0; i < grid.count(); ++i) {
    const double half = model.hertz_ratio() * std::sqrt(state.m[i]), depth = state.interference(grid, i);
    found.deepest = std::max(found.deepest, depth);
    if (!(state.m[i] > 0.0)) continue;
    found.pressed = std::max(found.pressed, depth);
    found.radius_ratio = std::max(found.radius_ratio, half * grid.sharper[i]);
    found.depth_ratio = std::min(found.depth_ratio, grid.min_depth[i] / half);
    widest = std::max(widest, half);
    area += 2.0 * half * grid.width(i);
    load += state.r[i] * state.m[i] * grid.width(i);
  }
  for (const auto& [low, high] : contact) longest = std::max(longest, high - low);
  found.length_ratio = 2.0 * widest / longest;
  found.mean_pressure = load / model.contact().compliance / area;
  found.unevenness = unevenness(model, level);
  find_missed(model, level, found);
  return found;
}

}  // namespace nonhertz
