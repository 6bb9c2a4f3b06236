// Loads on strips from the positions up to which given fractions of the total load are carried.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "maps/contact_map.hpp"

namespace nonhertz {
namespace {

constexpr Index QUANTILES = ContactMap::QUANTILES;
using Places = std::array<double, QUANTILES>;

/// Return the angle at a place between two of `places`, by a cubic with their slopes, kept monotone.
double angle_at(const Places& places, Index segment, double y) {
  const double width = places[segment + 1] - places[segment];
  const double secant = 1.0 / width;
  double first = secant, last = secant;
  if (segment > 0 && places[segment - 1] < places[segment]) {
    const double wide = places[segment] - places[segment - 1];
    first = std::min((width / wide + wide / width) / (width + wide), 3.0 * secant);
  }
  if (segment + 2 < QUANTILES && places[segment + 1] < places[segment + 2]) {
    const double wide = places[segment + 2] - places[segment + 1];
    last = std::min((width / wide + wide / width) / (width + wide), 3.0 * secant);
  }
  first *= width, last *= width;
  const double s = (y - places[segment]) / width;
  const double rise = s * s * (3.0 - 2.0 * s) + s * (1.0 - s) * ((1.0 - s) * first - s * last);
  const double at = static_cast<double>(segment) + std::min(std::max(rise, 0.0), 1.0);
  return at * std::numbers::pi / static_cast<double>(QUANTILES - 1);
}

}  // namespace

void share_out(Places places, double load, View stations, Row strip_loads) {
  for (Index k = 1; k < QUANTILES; ++k) places[k] = std::max(places[k], places[k - 1]);
  double before = 0.0;
  Index segment = 0;
  for (Index station = 0; station < count_of(stations); ++station) {
    const double y = stations[station];
    while (segment < QUANTILES - 1 && places[segment + 1] <= y) ++segment;
    double angle = 0.0;
    if (y > places[0]) angle = segment == QUANTILES - 1 ? std::numbers::pi : angle_at(places, segment, y);
    const double sine = std::sin(0.5 * angle), upto = sine * sine;
    if (station > 0) strip_loads[station - 1] = load * std::max(upto - before, 0.0);
    before = upto;
  }
}

}  // namespace nonhertz
