#include "grids/overlaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "strips/influence.hpp"

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();
constexpr double BESIDE = 0.02;   // of an interval in contact: an overlap this close only locates its end
constexpr double NOTICED = 1e-9;  // of the deepest interference; a smaller overlap is rounding
constexpr double STRIPS_PER_OVERLAP = 5.0;

bool apart_from(const std::vector<Pair>& contact, double y) {
  return std::all_of(contact.begin(), contact.end(), [y](const Pair& interval) {
    const double margin = BESIDE * (interval[1] - interval[0]);
    return y < interval[0] - margin || y > interval[1] + margin;
  });
}

/// Extent of an overlap beyond its last place: up to twice that of a straight line to the next.
double reach_of(const Samples& samples, Index at, Index side) {
  const Index beside = at + side;
  if (!(0 <= beside && beside < count_of(samples.y))) return 0.0;
  const double distance = std::fabs(samples.y[beside] - samples.y[at]), next = samples.h[beside];
  const double share = -INFINITE < next && next < 0.0 ? samples.h[at] / (samples.h[at] - next) : 1.0;
  return distance * std::min(2.0 * share, 0.5);
}

/// Add places to samples, which stay ascending.
Samples with(const Samples& samples, const Numbers& places, const Numbers& h) {
  Samples all = samples;
  all.y.insert(all.y.end(), places.begin(), places.end());
  all.h.insert(all.h.end(), h.begin(), h.end());
  std::vector<Index> order(all.y.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&all](Index i, Index j) { return all.y[i] < all.y[j]; });
  Samples sorted;
  for (Index i : order) {
    if (!sorted.y.empty() && sorted.y.back() == all.y[i]) continue;
    sorted.y.push_back(all.y[i]);
    sorted.h.push_back(all.h[i]);
  }
  return sorted;
}

}  // namespace

Numbers summits_of(View y, View depth) {
  Numbers summits;
  for (Index i = 1; i + 1 < count_of(y); ++i) {
    const double left = depth[i - 1], here = depth[i], right = depth[i + 1];
    if (!(here >= left && here > right && std::isfinite(left) && std::isfinite(right))) continue;
    const double before = (here - left) / (y[i] - y[i - 1]), after = (right - here) / (y[i + 1] - y[i]);
    const double bend = (after - before) / (y[i + 1] - y[i - 1]);
    const double place = 0.5 * (y[i - 1] + y[i]) - 0.5 * before / bend, off = place - y[i];
    if (here - bend * off * off > 0.0 && place > y[i - 1] && place < y[i + 1]) summits.push_back(place);
  }
  return summits;
}

bool suspect(const Level& level, const Samples& along) {
  if (!level.state.converged()) return false;
  const auto contact = intervals(*level.grid, level.state.m);
  const auto depth = [&](Index i) { return level.state.rigid[0] + level.state.rigid[1] * along.y[i] - along.h[i]; };
  const Index last = count_of(along.y) - 1;
  for (Index i = 0; i <= last; ++i) {
    const double here = depth(i), before = i > 0 ? depth(i - 1) : -INFINITE,
                 after = i < last ? depth(i + 1) : -INFINITE;
    if (!(here >= before && here >= after)) continue;
    double highest = here;
    // Bound on the rise of a parabola through the three places above the middle one.
    if (0 < i && i < last && std::isfinite(before) && std::isfinite(after))
      highest += 0.125 * (2.0 * here - before - after);
    if (highest > 0.0 && apart_from(contact, along.y[i])) return true;
  }
  return false;
}

Samples sample_overlap(const Model& model, const Level& level, const Samples& along) {
  const State& state = level.state;
  const auto contact = intervals(*level.grid, state.m);
  if (contact.size() == 1) {
    const double margin = BESIDE * (contact[0][1] - contact[0][0]);
    if (contact[0][0] - margin <= along.y.front() && contact[0][1] + margin >= along.y.back()) return {};
  }
  const auto depth_at = [&state](double y, double h) { return state.rigid[0] + state.rigid[1] * y - h; };
  Numbers depth(along.y.size());
  for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = depth_at(along.y[i], along.h[i]);
  // A bump may touch between two places where the surfaces are apart.
  const Numbers summits = summits_of(along.y, depth);
  const Samples all = summits.empty() ? along : with(along, summits, model.separation(summits));
  Samples overlap{all.y, Numbers(all.y.size())};
  double deepest = -INFINITE;
  Numbers places;
  std::vector<std::size_t> suspects;
  for (std::size_t i = 0; i < all.y.size(); ++i) {
    const double here = depth_at(all.y[i], all.h[i]);
    deepest = std::max(deepest, here);
    if (!apart_from(contact, all.y[i])) continue;
    overlap.h[i] = here;
    if (here > 0.0) suspects.push_back(i), places.push_back(all.y[i]);
  }
  if (!suspects.empty()) {
    const Numbers lift = surface_displacement(places, *level.grid, state, model.kernel());
    const Matrix at_depth = model.at_depth(places, level.grid->edges);
    for (std::size_t k = 0; k < suspects.size(); ++k) {
      double moved = 0.0;
      for (Index j = 0; j < at_depth.columns(); ++j)
        moved += at_depth(static_cast<Index>(k), j) * (state.r[j] * state.m[j]);
      overlap.h[suspects[k]] -= lift[k] - moved;
    }
  }
  for (double& h : overlap.h)
    if (h > 0.0 && h < NOTICED * deepest) h = 0.0;
  return overlap;
}

std::vector<Extra> overlaps(const Model& model, const Region& region, const Level& level) {
  const Samples overlap = sample_overlap(model, level, region.samples_with_crests);
  const double step = (region.high - region.low) / SAMPLES;
  std::vector<Extra> extras;
  const Index n = count_of(overlap.y);
  for (Index i = 0; i < n; ++i) {
    if (!(overlap.h[i] > 0.0)) continue;
    Index j = i;
    while (j + 1 < n && overlap.h[j + 1] > 0.0) ++j;
    // Limited by the neighbouring places without overlap: crests may be much closer together than the samples, and much
    // narrower.
    const double length = overlap.y[j] - overlap.y[i];
    const double reach = reach_of(overlap, i, -1) + length + reach_of(overlap, j, 1);
    extras.push_back(
        {0.5 * (overlap.y[i] + overlap.y[j]), std::max(length, std::min(step, reach)) / STRIPS_PER_OVERLAP});
    i = j;
  }
  return extras;
}

}  // namespace nonhertz
