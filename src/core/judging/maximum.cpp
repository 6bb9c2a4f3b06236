// The largest pressure that is independent of refinement: more than a half-width from ends at which it has no limit.
//
// Usually the largest of these pressures is at the border itself, which need not be in the middle of a strip: it is
// interpolated there, by the power law of the distance through the two neighbours.
#include <cmath>
#include <limits>

#include "judging/judgement.hpp"

namespace nonhertz {
namespace {

constexpr double SAME = 1e-6;  // relative difference up to which two pressures count as equally large

class Maximum {
 public:
  Maximum(const Level& level, double hertz_ratio, View singular)
      : y_(level.grid->y), ends_(singular), pressure_(y_.size()), half_width_(y_.size()) {
    for (std::size_t i = 0; i < y_.size(); ++i) {
      const double root = std::sqrt(level.state.m[i]);
      pressure_[i] = level.state.r[i] * root, half_width_[i] = hertz_ratio * root;
    }
  }

  Largest find() const {
    const Index n = count_of(y_);
    Largest largest{0.0, y_[0]};
    bool any_counts = false;
    Index farthest = -1;
    double most = -1.0;
    const auto consider = [&largest](double y, double pressure) {
      if (pressure > largest.pressure) largest = {pressure, y};
    };
    for (Index i = 0; i < n; ++i) {
      if (!(pressure_[i] > 0.0)) continue;
      const double distance = nearest(y_[i]);
      if (distance > half_width_[i]) {
        consider(y_[i], pressure_[i]);
        any_counts = true;
      }
      const double of_width = half_width_[i] > 0.0 ? distance / half_width_[i] : distance;
      if (of_width > most) farthest = i, most = of_width;
    }
    for (Index i = 0; i + 1 < n; ++i) {
      const Largest border = at_border(i);
      consider(border.y, border.pressure);
      any_counts = any_counts || border.pressure > 0.0;
    }
    // A contact too short for any place to count: the one farthest from the ends does.
    if (!any_counts && farthest >= 0) largest = {pressure_[farthest], y_[farthest]};
    return largest;
  }

 private:
  double nearest(double y) const {
    double least = std::numeric_limits<double>::infinity();
    for (double end : ends_) least = std::min(least, std::fabs(y - end));
    return least;
  }

  /// The place a half-width from an end between a strip and the next, if there is one, and its pressure.
  Largest at_border(Index i) const {
    const Index j = i + 1;
    if (!(pressure_[i] > 0.0 && pressure_[j] > 0.0)) return {};
    const double first = nearest(y_[i]), second = nearest(y_[j]);
    if ((first > half_width_[i]) == (second > half_width_[j])) return {};
    // The end that the strip next to it is within a half-width of, and the distance from it towards the other strip.
    const bool first_is_near = first <= half_width_[i];
    const double here = first_is_near ? y_[i] : y_[j], away = first_is_near ? 1.0 : -1.0;
    double end = ends_[0];
    for (double each : ends_)
      if (std::fabs(here - each) == (first_is_near ? first : second)) end = each;
    const double one = away * (y_[i] - end), other = away * (y_[j] - end);
    const double share = (one - half_width_[i]) / ((one - half_width_[i]) - (other - half_width_[j]));
    double power = share;
    if (one > 0.0 && other > 0.0 && one != other)
      power = std::log((one + share * (other - one)) / one) / std::log(other / one);
    const double place = y_[i] + share * (y_[j] - y_[i]);
    // A border of one end may lie close to another end.
    const double width_there = half_width_[i] + share * (half_width_[j] - half_width_[i]);
    if (!(nearest(place) >= (1.0 - SAME) * width_there)) return {0.0, place};
    return {std::pow(pressure_[i], 1.0 - power) * std::pow(pressure_[j], power), place};
  }

  View y_, ends_;
  Numbers pressure_, half_width_;
};

}  // namespace

Largest largest_pressure(const Level& level, double hertz_ratio, View singular) {
  return Maximum(level, hertz_ratio, singular).find();
}

}  // namespace nonhertz
