// The numbers of a solution for each condition of the model.
#include <algorithm>
#include <cmath>
#include <limits>

#include "grids/overlaps.hpp"
#include "judging/judgement.hpp"
#include "judging/resolution.hpp"
#include "numbers/sums.hpp"

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();
constexpr double WIDE_BESIDE =
    2.0;  // times the last strip in contact: a wider neighbour may hide that the contact continues

/// The larger of two numbers; NaN if one of them is.
double larger(double one, double other) { return other > one || std::isnan(other) ? other : one; }

/// The loads of all strips [N].
Numbers loads(const Model& model, const Level& level) {
  Numbers loads(level.state.r.size());
  for (Index i = 0; i < count_of(loads); ++i)
    loads[i] = level.state.r[i] * level.state.m[i] / model.contact().compliance * level.grid->width(i);
  return loads;
}

/// Departure of the bodies from parabolas within a half-width on either side, averaged over strips by their loads.
double unevenness(const Model& model, const Level& level) {
  const Grid& grid = *level.grid;
  const State& state = level.state;
  const Index n = grid.count();
  Numbers places(n * WITHIN);
  for (Index i = 0; i < n; ++i)
    for (int k = 0; k < WITHIN; ++k)
      places[i * WITHIN + k] = grid.y[i] + 2.0 * (model.hertz_ratio() * std::sqrt(state.m[i])) * within(k);
  Numbers h = model.separation(places);
  // Near the ends of bodies and of the interference the relief may fall in any way.
  for (std::size_t i = 0; i < h.size(); ++i)
    if (!(h[i] < state.rigid[0] + state.rigid[1] * places[i])) h[i] = INFINITE;
  Numbers load = loads(model, level), weighted(load.size());
  for (Index i = 0; i < n; ++i) weighted[i] = load[i] * departure(View(h).subspan(i * WITHIN, WITHIN));
  return sum_of(weighted) / sum_of(load);
}

/// Whether a contact continues beyond its strips, or ends beside one too wide to show whether it continues.
bool may_go_on(const Level& level, const Ends& ends) {
  for (const End& end : ends.ends)
    if (end.kind == EndKind::cut_off) return true;
  const Grid& grid = *level.grid;
  const auto bears = [&level](Index i) { return level.state.m[i] > 0.0; };
  for (Index i = 1; i < grid.count(); ++i) {
    if (bears(i) == bears(i - 1)) continue;
    const Index in = bears(i) ? i : i - 1, out = bears(i) ? i - 1 : i;
    if (grid.width(out) > WIDE_BESIDE * grid.width(in)) return true;
  }
  return false;
}

/// Whether a place lies in a strip in contact, or within a strip width beside it, where the contact ends.
bool is_next_to_contact(const Level& level, double y) {
  const Grid& grid = *level.grid;
  const Numbers& m = level.state.m;
  const Index n = grid.count();
  for (Index first = 0; first < n; ++first) {
    if (!(m[first] > 0.0)) continue;
    Index last = first;
    while (last + 1 < n && m[last + 1] > 0.0) ++last;
    if (y >= grid.low(first) - grid.width(first) && y <= grid.high(last) + grid.width(last)) return true;
    first = last;
  }
  return false;
}

/// The largest overlap where no strip is in contact, away from strips in contact and those beside them.
void find_missed(const Model& model, const Level& level, const Ends& ends, Checks& checks) {
  const Grid& grid = *level.grid;
  const double first = grid.edges.front(), last = grid.edges.back();
  const double low = std::max(model.low(), 2.0 * first - last), high = std::min(model.high(), 2.0 * last - first);
  const bool whole = low == model.low() && high == model.high();
  const Samples of_part = whole ? Samples{} : model.sample_with_crests(low, high);
  const Samples& along = whole ? model.region()->samples_with_crests : of_part;
  // The displacement falls away from a contact, so that another contact needs a maximum of the undeformed overlap.
  if (!may_go_on(level, ends) && !suspect(level, along)) return;
  const Samples overlap = sample_overlap(model, level, along);
  for (std::size_t i = 0; i < overlap.y.size(); ++i)
    if (overlap.h[i] > checks.missed && !is_next_to_contact(level, overlap.y[i]))
      checks.missed = overlap.h[i], checks.missed_y = overlap.y[i];
}

}  // namespace

Checks check(const Model& model, const Level& level, const Judgement& known) {
  const Grid& grid = *level.grid;
  const State& state = level.state;
  Checks checks{};
  checks.depth_ratio = INFINITE, checks.deepest = checks.pressed = -INFINITE;
  Numbers areas(grid.y.size());
  double longest = 0.0;
  for (Index i = 0; i < grid.count(); ++i) {
    const double half = model.hertz_ratio() * std::sqrt(state.m[i]), depth = state.interference(grid, i);
    checks.deepest = std::max(checks.deepest, depth);
    if (state.m[i] == 0.0) continue;
    checks.half_width = larger(checks.half_width, half);
    checks.radius_ratio = larger(checks.radius_ratio, half * grid.sharper[i]);
    checks.depth_ratio = -larger(-checks.depth_ratio, -grid.min_depth[i] / half);
    checks.pressed = std::max(checks.pressed, depth);
    areas[i] = half * grid.width(i);
  }
  for (const auto& [low, high] : known.contact) longest = std::max(longest, high - low);
  checks.length_ratio = 2.0 * known.half_width / longest;
  checks.mean_pressure = sum_of(loads(model, level)) / (2.0 * sum_of(areas));
  checks.unevenness = unevenness(model, level);
  if (state.converged()) find_missed(model, level, known.ends, checks);
  return checks;
}

}  // namespace nonhertz
