#include "numbers/interpolation.hpp"

#include <algorithm>
#include <cmath>

namespace nonhertz {
namespace {

/// The interval between ascending places that contains x: the last that begins at x or before.
Index interval_of(double x, View places) {
  return std::upper_bound(places.begin(), places.end(), x) - places.begin() - 1;
}

}  // namespace

double Polyline::at(double x) const {
  if (std::isnan(x)) return x;
  const Index j = interval_of(x, places);
  if (j < 0) return values.front();
  if (j + 1 >= count_of(places)) return values.back();
  if (places[j] == x) return values[j];
  const double slope = (values[j + 1] - values[j]) / (places[j + 1] - places[j]);
  const double from_low = slope * (x - places[j]) + values[j];
  // A slope that overflows gives NaN from one side, perhaps not from the other.
  return std::isnan(from_low) ? slope * (x - places[j + 1]) + values[j + 1] : from_low;
}

double Cubics::at(double x) const {
  const Index piece = std::clamp(interval_of(x, places), Index{0}, count_of(places) - 2);
  const View c = coefficients[piece];
  // From the lowest power upwards, in the order of PPoly.
  const double s = x - places[piece], square = s * s;
  return c[3] + c[2] * s + c[1] * square + c[0] * (square * s);
}

}  // namespace nonhertz
