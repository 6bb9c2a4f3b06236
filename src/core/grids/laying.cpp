#include "grids/laying.hpp"

#include <algorithm>
#include <cmath>

namespace nonhertz {
namespace {

constexpr double LOOSEST = 64.0;
constexpr double LEAST_STRIP = 0.4;  // of the target width, for a strip between two corners
constexpr double STEPS_PER_STRIP = 3.0;
constexpr Index MOST_STEPS = 6000;

/// The value at `at` on the line through points with ascending x.
double read(View x, View values, double at) {
  Index low = 0, high = count_of(x) - 1;
  if (at <= x[low]) return values[low];
  if (at >= x[high]) return values[high];
  while (high - low > 1) {
    const Index middle = (low + high) / 2;
    (x[middle] <= at ? low : high) = middle;
  }
  return values[low] + (at - x[low]) / (x[high] - x[low]) * (values[high] - values[low]);
}

/// Step from `start` to `stop` in fractions of a strip; away from features strips are `by` times as wide.
Path walk(const Sizes& sizes, double start, double stop, double by) {
  const double outward = stop > start ? 1.0 : -1.0;
  Path path{{start}, {0.0}};
  for (Index used = 1; used < MOST_STEPS; ++used) {
    const double here = path.place.back();
    double step = sizes(here, by);
    if (used > MOST_STEPS / 2)  // more strips than any grid has: cover the rest in equal steps
      step = std::max(step, STEPS_PER_STRIP * std::fabs(stop - here) / static_cast<double>(MOST_STEPS - used));
    double next = here + outward * step / STEPS_PER_STRIP;
    const bool last = outward * (next - stop) >= 0.0 || used == MOST_STEPS - 1;
    if (last) next = stop;
    path.place.push_back(next);
    path.count.push_back(path.count.back() + std::fabs(next - here) / sizes(0.5 * (here + next), by));
    if (last) break;
  }
  return path;
}

/// Return edges from `start` outwards, with a whole number of strips up to every mark and to the end.
Numbers cut(const Path& path, double start, const Numbers& marks, double share) {
  const Index n = count_of(path.place);
  const double outward = path.place[n - 1] > path.place[0] ? 1.0 : -1.0, whole = path.count[n - 1];
  Numbers along(n), edges{start};
  for (Index i = 0; i < n; ++i) along[i] = outward * path.place[i];
  double begin = read(along, path.count, outward * start);
  for (Index k = 0; k <= count_of(marks); ++k) {
    const bool last = k == count_of(marks);
    const double mark = last ? along[n - 1] : outward * marks[outward > 0.0 ? k : count_of(marks) - 1 - k];
    if (!last && mark <= outward * start) continue;
    const double reached = read(along, path.count, mark);
    // A mark close to another edge would cut off a sliver.
    if (!last && std::min(share * (reached - begin), share * (whole - reached)) < LEAST_STRIP) continue;
    const Index strips = std::max(Index{1}, static_cast<Index>(std::nearbyint(share * (reached - begin))));
    for (Index strip = 1; strip < strips; ++strip)
      edges.push_back(read(path.count, path.place,
                           begin + (reached - begin) / static_cast<double>(strips) * static_cast<double>(strip)));
    edges.push_back(outward * mark);
    begin = reached;
  }
  return edges;
}

/// Return the edges of a grid without a centred strip, cut from the end nearest to the centre.
Numbers from_end(const Path& left, const Path& right, const Numbers& marks, double share) {
  const bool left_is_near = left.count.back() <= right.count.back();
  const Path &near = left_is_near ? left : right, &far = left_is_near ? right : left;
  Path path;
  const Index n = count_of(near.place) - 1;
  for (Index i = 0; i < n; ++i) {
    path.place.push_back(near.place[n - i]);
    path.count.push_back(near.count[n] - near.count[n - i]);
  }
  for (Index i = 0; i < count_of(far.place); ++i) {
    path.place.push_back(far.place[i]);
    path.count.push_back(near.count[n] + far.count[i]);
  }
  Numbers edges = cut(path, path.place[0], marks, share);
  if (!(edges.front() < edges.back())) std::reverse(edges.begin(), edges.end());
  return edges;
}

}  // namespace

Plan::Plan(const Level& from, const Model& model, const Region& region, const std::vector<Extra>& extras,
           double coarseness, double limit) {
  const Sizes sizes(from, model, region, extras, coarseness);
  marks_ = sizes.marks(), centre_ = sizes.centre();
  most_ = limit / std::min(coarseness, 1.0) * static_cast<double>(std::min(sizes.pieces(), Index{2}));
  const auto walk_outward = [&](double by) {
    right_ = walk(sizes, centre_, sizes.high(), by), left_ = walk(sizes, centre_, sizes.low(), by);
    return right_.count.back() + left_.count.back();
  };
  double by = 1.0, wanted = walk_outward(by);
  // If the sizes require too many strips, those away from features are widened.
  while (wanted > most_ && by < LOOSEST) {
    by *= std::max(1.03, std::pow(wanted / most_, 1.5));
    wanted = walk_outward(by);
  }
}

Numbers Plan::lay(double share) const {
  const double of_right = right_.count.back(), of_left = left_.count.back();
  share *= std::min(1.0, most_ / (of_right + of_left));
  const double half = 0.5 / share;
  // Too close to an end for half a strip and another strip beside it.
  if (std::min(of_right, of_left) < half + LEAST_STRIP / share) return from_end(left_, right_, marks_, share);
  const double reach =
      std::min(read(right_.count, right_.place, half) - centre_, centre_ - read(left_.count, left_.place, half));
  const Numbers after = cut(right_, centre_ + reach, marks_, share),
                before = cut(left_, centre_ - reach, marks_, share);
  Numbers edges(before.rbegin(), before.rend());
  edges.insert(edges.end(), after.begin(), after.end());
  return edges;
}

}  // namespace nonhertz
