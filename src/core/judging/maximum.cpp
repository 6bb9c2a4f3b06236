#include "judging/maximum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nonhertz {
namespace {

constexpr double SAME = 1e-6;      // relative difference up to which a place counts as that of a border
constexpr double ROUNDING = 1e-9;  // up to which two values count as equal; mirrored maxima differ by at most 1e-12

double nearest(double y, View ends) {
  double least = std::numeric_limits<double>::infinity();
  for (double end : ends) least = std::min(least, std::fabs(y - end));
  return least;
}

/// The place between a strip and the next that is a half-width from an end, if there is one, and the value there.
///
/// Interpolated by a power of the distance from the end through both strips, or linearly if the end lies between them.
Largest at_border(View y, View values, View half_width, View ends, Index i) {
  const Index j = i + 1;
  if (!(values[i] > 0.0 && values[j] > 0.0)) return {};
  const double first = nearest(y[i], ends), second = nearest(y[j], ends);
  if ((first > half_width[i]) == (second > half_width[j])) return {};
  // The end within a half-width of one strip, and the distances of both strips from it. Both may be on its far side, if
  // the contact is much narrower at the other strip.
  const bool first_is_near = first <= half_width[i];
  const Index near = first_is_near ? i : j, far = first_is_near ? j : i;
  double end = ends[0];
  for (double end_place : ends)
    if (std::fabs(y[near] - end_place) == (first_is_near ? first : second)) end = end_place;
  const double away = y[far] > end ? 1.0 : -1.0, one = away * (y[i] - end), other = away * (y[j] - end);
  const double share = (one - half_width[i]) / ((one - half_width[i]) - (other - half_width[j]));
  double power = share;
  if (one > 0.0 && other > 0.0 && one != other)
    power = std::log((one + share * (other - one)) / one) / std::log(other / one);
  const double place = y[i] + share * (y[j] - y[i]);
  // A border of one end may lie close to another end.
  const double width_there = half_width[i] + share * (half_width[j] - half_width[i]);
  if (!(nearest(place, ends) >= (1.0 - SAME) * width_there)) return {0.0, place};
  return {std::pow(values[i], 1.0 - power) * std::pow(values[j], power), place};
}

}  // namespace

Counted values_that_count(View y, View values, View half_width, View ends) {
  const std::size_t n = y.size();
  Counted result{Numbers(2 * n - 1), Numbers(2 * n - 1)};
  bool any_counts = false;
  Index farthest = -1;
  double most = -1.0;
  for (std::size_t i = 0; i < n; ++i) {
    result.places[i] = y[i];
    if (!(values[i] > 0.0)) continue;
    const double distance = nearest(y[i], ends);
    if (distance > half_width[i]) result.values[i] = values[i], any_counts = true;
    const double of_width = half_width[i] > 0.0 ? distance / half_width[i] : distance;
    if (of_width > most) farthest = static_cast<Index>(i), most = of_width;
  }
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Largest border = at_border(y, values, half_width, ends, static_cast<Index>(i));
    result.places[n + i] = border.y, result.values[n + i] = border.value;
    any_counts = any_counts || border.value > 0.0;
  }
  if (!any_counts && farthest >= 0) result.values[farthest] = values[farthest];
  return result;
}

Index Counted::at() const {
  Index first = std::max_element(values.begin(), values.end()) - values.begin();
  const double least = (1.0 - ROUNDING) * values[first];
  for (Index k = 0; k < count_of(values); ++k)
    if (values[k] > 0.0 && values[k] >= least && places[k] < places[first]) first = k;
  return first;
}

Largest Counted::largest() const { return {*std::max_element(values.begin(), values.end()), places[at()]}; }

}  // namespace nonhertz
