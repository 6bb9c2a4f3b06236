#include "bodies/relief.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();
constexpr double PI = 3.141592653589793;
constexpr double SAME_PLACE = 1e-9;  // of a length: positions closer to its end than this count as at the end

/// The drop of a circle at a distance from its summit; infinite beyond the circle.
double drop_of_circle(double radius, double y) {
  const double size = std::fabs(radius), distance = std::fabs(y);
  const double inside = std::max((size - distance) * (size + distance), 0.0);
  // R - sqrt(R^2 - y^2) would lose the few micrometres that matter to cancellation if R is metres.
  const double drop = distance * distance / (size + std::sqrt(inside));
  return distance <= size ? std::copysign(1.0, radius) * drop : INFINITE;
}

/// A position moved back; one within rounding of an end of the extent is placed at the end.
double moved_back(double y, double by, double low, double high) {
  if (by == 0.0) return y;
  const double place = y - by, room = SAME_PLACE * (high - low);
  if (!std::isfinite(room)) return place;
  if (std::fabs(place - low) <= room) return low;
  return std::fabs(place - high) <= room ? high : place;
}

void fill(const Straight&, View, Row h) { std::fill(h.begin(), h.end(), 0.0); }

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
    // 1 - s, measured from the end, where the difference of nearly equal numbers is exact.
    const double to_end = std::max((0.5 * of.length - distance) / half, -BEYOND);
    const double argument = to_end * (1.0 + share) + of.rest * (share * share);
    double drop = argument > 0.0 ? -std::log(argument) : INFINITE;
    // In the middle, s itself is accurate.
    const double inner = std::min(share, 0.5);
    if (to_end > 0.5) drop = -std::log1p(-(1.0 - of.rest) * (inner * inner));
    // With zero amplitude there is a body up to the pole, but none beyond.
    const double relief = std::isinf(drop) ? INFINITE : of.amplitude * drop;
    h[i] = (to_end >= 0.0 ? std::min(relief, of.at_end) : relief) + 0.0;
  }
}

void fill(const Conical& of, View y, Row h) {
  for (std::size_t i = 0; i < y.size(); ++i) h[i] = of.slope * y[i];
}

void fill(const TaperedEnds& of, View y, Row h) {
  for (std::size_t i = 0; i < y.size(); ++i) h[i] = of.slope * std::max(std::fabs(y[i]) - 0.5 * of.straight, 0.0);
}

double displacement(double t, const StripDisplacement& of) {
  const double size = std::fabs(t);
  if (size < of.nearest) return std::copysign(4.0 / PI * size * std::log(4.0 / std::max(size, 1e-300)), t);
  if (size > of.far) {
    const double inverse = std::pow(size, -2.0);
    const double series = inverse * (1.0 / 16.0 - 3.0 / 256.0 * inverse);
    return std::copysign(-0.5 * std::log(inverse / 16.0) + 0.5 + series, t);
  }
  const double position = (std::log(size) - std::log(of.nearest)) / of.step;
  const Index cell = std::min(static_cast<Index>(position), of.cubics.rows() - 1);
  const double s = position - static_cast<double>(cell);
  const View c = of.cubics[cell];
  return std::copysign(c[0] + s * (c[1] + s * (c[2] + s * c[3])), t);
}

void fill(const UniformPressure& of, View y, Row h) {
  const double half = 0.5 * of.length, middle = displacement(half / of.half_width, *of.displacement);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double ends = displacement((half - y[i]) / of.half_width, *of.displacement) +
                        displacement((half + y[i]) / of.half_width, *of.displacement);
    h[i] = of.amplitude * (2.0 * middle - ends);
  }
}

void fill(const Tabulated& of, View y, Row h) {
  const auto from = [&](const auto& curve) {
    const double low = curve.places.front(), high = curve.places.back();
    for (std::size_t i = 0; i < y.size(); ++i) h[i] = low <= y[i] && y[i] <= high ? curve.at(y[i]) : INFINITE;
  };
  std::visit(from, of.curve);
}

void fill(const Sum& of, View y, Row h) {
  Numbers relief(y.size());
  std::fill(h.begin(), h.end(), 0.0);
  for (const SharedRelief& part : of.parts) {
    part->fill(y, relief);
    for (std::size_t i = 0; i < y.size(); ++i) h[i] += relief[i];
  }
}

void fill(const Moved& of, View y, Row h) {
  Numbers places(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) places[i] = moved_back(of.flip ? -y[i] : y[i], of.shift, of.low, of.high);
  of.relief->fill(places, h);
  if (of.scale == 1.0) return;
  // A plain product would turn "no body here" into NaN (factor 0) or an infinite peak (factor < 0).
  for (double& relief : h) relief = std::isfinite(relief) ? of.scale * relief : INFINITE;
}

/// Drop of a corner below the tangent at its beginning.
double drop(const Corner& of, double distance) {
  const double straight = std::max(distance - of.arc, 0.0) * of.slope;
  return of.radius == 0.0 ? straight : straight + drop_of_circle(of.radius, std::min(distance, of.arc));
}

void fill(const Cornered& of, View y, Row h) {
  Numbers on_land(y.size());
  for (std::size_t i = 0; i < y.size(); ++i) on_land[i] = std::min(std::max(y[i], -of.low.distance), of.high.distance);
  of.land->fill(on_land, h);
  const double land_end = of.half_length - of.corner.extent;
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (!(y[i] < -of.low.distance || y[i] > of.high.distance)) continue;
    const Tangent& end = y[i] < 0.0 ? of.low : of.high;
    const double distance = std::fabs(y[i]), within = std::min(distance, of.half_length);
    const double tangent = end.relief + end.slope * (within - end.distance);
    const double on_corner = std::min(std::max(within - land_end, 0.0), of.corner.extent);
    h[i] = distance > of.half_length ? INFINITE : tangent + drop(of.corner, on_corner);
  }
}

void fill(const Function& of, View y, Row h) { of(y, h); }

}  // namespace

void Relief::fill(View y, Row h) const {
  std::visit([&](const auto& of) { nonhertz::fill(of, y, h); }, formula);
}

}  // namespace nonhertz
