#include "grids/extent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();
constexpr int NEAREST = 3;  // strips whose largest half-width is taken as the local one

/// Where the contact around strip `at` ends on the given side, at most one strip away.
double end_of(const Grid& grid, View m, Index at, Index other, int side) {
  const double edge = side > 0 ? grid.high(at) : grid.low(at);
  const Index next_in = at - side, next_out = at + side;
  if (at == other || m[next_in] <= m[at]) return edge;
  const double y = grid.y[at], limit = 0 <= next_out && next_out < count_of(m) ? grid.y[next_out] : edge;
  const double run = m[at] * std::fabs(y - grid.y[next_in]) / (m[next_in] - m[at]);
  return side * std::min(side * (y + side * run), side * limit);
}

}  // namespace

std::vector<Pair> intervals(const Grid& grid, View m) {
  std::vector<Pair> result;
  const Index n = count_of(m);
  Index first = -1;
  for (Index i = 0; i < n; ++i) {
    if (m[i] > 0.0 && first < 0) first = i;
    if (m[i] > 0.0 && (i + 1 == n || !(m[i + 1] > 0.0))) {
      result.push_back({end_of(grid, m, first, i, -1), end_of(grid, m, i, first, 1)});
      first = -1;
    }
  }
  return result;
}

bool reaches(const Grid& grid, View m, int side) {
  const Index n = count_of(m), at = side > 0 ? n - 1 : 0, next_in = side > 0 ? n - 2 : 1;
  if (!(m[at] > 0.0)) return false;
  if (n < 2) return true;
  const double distance =
      0.5 * std::fabs(grid.edges[at] + grid.edges[at + 1] - grid.edges[next_in] - grid.edges[next_in + 1]);
  return m[at] - 0.5 * (m[next_in] - m[at]) / distance * grid.width(at) > 0.0;
}

bool is_nearly_touching(const Grid& grid, View m, double place) {
  const Index n = count_of(m);
  for (Index i = 0; i < n; ++i)
    if (m[i] > 0.0 && grid.edges[std::max(i - 1, Index{0})] <= place && place <= grid.edges[std::min(i + 2, n)])
      return true;
  return false;
}

double width_near(const Grid& grid, View m, double place) {
  double widest = 0.0, beyond = -1.0;
  for (int k = 0; k < NEAREST; ++k) {
    Index at = -1;
    double closest = INFINITE;
    for (Index i = 0; i < count_of(m); ++i) {
      const double distance = std::fabs(grid.y[i] - place);
      if (m[i] > 0.0 && beyond < distance && distance < closest) at = i, closest = distance;
    }
    if (at < 0) break;
    widest = std::max(widest, m[at]), beyond = closest;
  }
  return std::sqrt(widest);
}

double fall(const Grid& grid, View m, double low, double high, int side) {
  const Index n = count_of(m);
  const double end = side > 0 ? high : low;
  double summit = 0.0;
  Index at_summit = -1, first = -1;
  for (Index k = 0; k < n; ++k) {
    const Index i = side > 0 ? n - 1 - k : k;
    if (!(m[i] > 0.0 && low <= grid.y[i] && grid.y[i] <= high)) continue;
    first = first < 0 ? i : first;
    if (m[i] < summit) break;
    summit = m[i], at_summit = i;
  }
  if (at_summit < 0) return high - low;
  Index i = first;
  while (m[i] < 0.5 * summit) i -= side;
  const double distance = std::fabs(grid.y[i] - end);
  if (i == first) return distance;
  const Index out = i + side;
  const double before = std::fabs(grid.y[out] - end), share = (0.5 * summit - m[out]) / (m[i] - m[out]);
  return before + share * (distance - before);
}

}  // namespace nonhertz
