#include "bodies/relief.hpp"

#include <algorithm>
#include <cmath>

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();

/// The drop of a circle at a distance from its summit; infinite beyond the circle.
double drop_of_circle(double radius, double y) {
  const double size = std::fabs(radius), distance = std::fabs(y);
  const double inside = std::max((size - distance) * (size + distance), 0.0);
  // R - sqrt(R^2 - y^2) would lose to cancellation the few micrometres that matter beside metres of radius.
  const double drop = distance * distance / (size + std::sqrt(inside));
  return distance <= size ? std::copysign(1.0, radius) * drop : INFINITE;
}

void fill(const Arcs& of, View y, Row h) {
  const double at_junction = drop_of_circle(of.end_radius, of.junction - of.end_summit);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double distance = std::fabs(y[i]);
    double drop = drop_of_circle(of.end_radius, std::max(distance, of.junction) - of.end_summit);
    if (std::isfinite(of.radius)) drop = drop_of_circle(of.radius, std::min(distance, of.junction)) + drop;
    h[i] = drop - at_junction;
  }
}

void fill(const Logarithmic& of, View y, Row h) {
  constexpr double FAR = 1e100, BEYOND = 1e150;  // so that no square overflows
  const double half = 0.5 * of.curved, straight = of.length - of.curved;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double distance = std::min(std::fabs(y[i]), FAR);
    const double share = std::min(std::max(distance - 0.5 * straight, 0.0) / half, BEYOND);
    // 1 - s, measured from the end, where a difference of nearly equal numbers is exact.
    const double to_end = std::max((0.5 * of.length - distance) / half, -BEYOND);
    const double argument = to_end * (1.0 + share) + of.rest * share * share;
    double drop = argument > 0.0 ? -std::log(argument) : INFINITE;
    // In the middle, s itself is accurate.
    if (to_end > 0.5) drop = -std::log1p(-(1.0 - of.rest) * std::min(share, 0.5) * std::min(share, 0.5));
    // With zero amplitude there is a body up to the pole, and none from there outwards.
    const double relief = std::isinf(drop) ? INFINITE : of.amplitude * drop;
    h[i] = (to_end >= 0.0 ? std::min(relief, of.at_end) : relief) + 0.0;
  }
}

void fill(const Function& of, View y, Row h) { of.fill(y, h); }

/// Move a place back; one within the moved extent stays within it, though rounding could put it outside.
double moved_back(double y, double by, double low, double high) {
  if (by == 0.0) return y;
  const bool within = low + by <= y && y <= high + by;
  return within ? std::clamp(y - by, low, high) : y - by;
}

}  // namespace

void Relief::add_to(View y, Row h) const {
  Numbers place(y.size()), relief(y.size());
  for (const Moved& part : parts) {
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double on_body = moved_back(y[i], position, low, high);
      place[i] = moved_back(part.flip ? -on_body : on_body, part.shift, part.low, part.high);
    }
    std::visit([&](const auto& formula) { fill(formula, place, relief); }, part.formula);
    for (std::size_t i = 0; i < y.size(); ++i) {
      // A plain product would turn "no body here" into NaN (factor 0) or an infinite peak (factor < 0).
      h[i] += part.scale == 1.0 ? relief[i] : std::isfinite(relief[i]) ? part.scale * relief[i] : INFINITE;
    }
  }
}

}  // namespace nonhertz
