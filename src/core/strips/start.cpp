#include "strips/start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nonhertz {
namespace {

/// Independent springs: positions, widths, and distances of the other body.
///
/// Each responds only to its own load, so that together they form a convex, piecewise linear problem with a solution
/// for any pair of prescribed quantities: by Newton's method for the approach, by false position for the tilt.
struct Bed {
  Numbers y, width, height;
  double stiffness = 0.0;

  struct Motion {
    double approach, tilt;
  };

  Motion balance(const Prescription& prescribed) const {
    double tilt = prescribed.target[1], other = tilt;
    if (prescribed.by_force[1]) std::tie(tilt, other) = tilts(prescribed);
    double approach = approach_at(tilt, prescribed);
    // Without contact the moment is also zero. For a nonzero target take the end of the bracket in contact.
    double deepest = -std::numeric_limits<double>::infinity();
    for (Index i = 0; i < count_of(y); ++i) deepest = std::max(deepest, approach + tilt * y[i] - height[i]);
    if (prescribed.target[1] != 0.0 && !(deepest > 0.0)) {
      tilt = other;
      approach = approach_at(tilt, prescribed);
    }
    return {approach, tilt};
  }

 private:
  /// Return the two ends of a short bracket around the tilt at which the moment is met.
  std::pair<double, double> tilts(const Prescription& prescribed) const {
    double low = 0.0, excess = excess_moment(0.0, prescribed);
    if (excess == 0.0) return {0.0, 0.0};
    double reach = 0.0, length = 0.0;
    for (Index i = 0; i < count_of(y); ++i) {
      reach = std::max(reach, std::fabs(y[i]));
      length += width[i];
    }
    double step = std::fabs(prescribed.target[0]) + std::fabs(prescribed.target[1]) / reach;
    if (prescribed.by_force[0]) step /= stiffness * length;
    double high = -std::copysign(step / reach, excess), over = excess_moment(high, prescribed);
    for (int i = 0; i < 200 && !(over * excess <= 0.0); ++i) {
      low = high, excess = over, high *= 2.0;
      over = excess_moment(high, prescribed);
    }
    constexpr int SECANTS = 30;
    // False position (Illinois variant): halve the value at an end that does not move.
    for (int i = 0; i < SECANTS; ++i) {
      if (over == 0.0 || std::fabs(high - low) <= 1e-10 * (std::fabs(high) + std::fabs(low))) break;
      const double middle = high - over * (high - low) / (over - excess), rest = excess_moment(middle, prescribed);
      if (rest * over < 0.0)
        low = high, excess = over;
      else
        excess *= 0.5;
      high = middle, over = rest;
    }
    return {high, low};
  }

  /// Return the approach at this tilt: the prescribed one, or the one at which the springs carry the load.
  ///
  /// With all springs acting, some in tension, the approach is too large. Dropping those in tension lowers it, and so
  /// on down to the exact answer.
  double approach_at(double tilt, const Prescription& prescribed) const {
    if (!prescribed.by_force[0]) return prescribed.target[0];
    double approach = std::numeric_limits<double>::infinity();
    for (Index i = 0; i <= count_of(y); ++i) {
      double carried = prescribed.target[0], bearing = 0.0;
      for (Index k = 0; k < count_of(y); ++k) {
        const double above = height[k] - tilt * y[k];
        if (above < approach) {
          bearing += stiffness * width[k];
          carried += stiffness * width[k] * above;
        }
      }
      const double lower = carried / bearing;
      if (!(lower < approach)) break;
      approach = lower;
    }
    return approach;
  }

  double excess_moment(double tilt, const Prescription& prescribed) const {
    const double approach = approach_at(tilt, prescribed);
    double moment = 0.0;
    for (Index i = 0; i < count_of(y); ++i)
      moment += width[i] * y[i] * std::max(approach + tilt * y[i] - height[i], 0.0);
    return stiffness * moment - prescribed.target[1];
  }
};

/// Return the value at `at` on the straight line between two neighbours, constant beyond both.
double interpolate(View y, View values, Index left, Index right, double at) {
  if (at <= y[left] || left == right) return values[left];
  if (at >= y[right]) return values[right];
  return values[left] + (at - y[left]) / (y[right] - y[left]) * (values[right] - values[left]);
}

/// Extrapolate m into the first idle strip after two in contact, if that gives less than the value there.
void continue_past_ends(View y, View m, Index step, Row extended) {
  const Index n = count_of(m);
  for (Index k = 2; k < n; ++k) {
    const Index at = step > 0 ? k : n - 1 - k, before = at - step, second = at - 2 * step;
    if (m[at] == 0.0 && m[before] > 0.0 && m[second] > 0.0) {
      const double slope = (m[before] - m[second]) / (y[before] - y[second]);
      extended[at] = std::min(extended[at], m[before] + slope * (y[at] - y[before]));
    }
  }
}

}  // namespace

void start_from_springs(const Grid& grid, const Prescription& prescribed, const Kernel& kernel, State& state) {
  // Mirrored if the moment is negative, so that two mirrored cases start identically to the last bit.
  const double side = prescribed.by_force[1] && prescribed.target[1] < 0.0 ? -1.0 : 1.0;
  const Index n = grid.count();
  double half = 0.0;
  for (Index i = 0; i < n; ++i) {
    half += 0.5 * grid.width(i);
    state.r[i] = grid.curvature[i] / kernel.element->line_factor;
    state.m[i] = 0.0;
  }
  state.rigid = {};
  Bed bed;
  for (Index k = 0; k < n; ++k) {
    const Index i = side > 0.0 ? k : n - 1 - k;
    if (!std::isfinite(grid.separation[i])) continue;
    bed.y.push_back(side * grid.y[i]);
    bed.width.push_back(grid.width(i));
    bed.height.push_back(grid.separation[i]);
  }
  if (bed.y.empty()) return;
  const Prescription turned{prescribed.by_force, {prescribed.target[0], side * prescribed.target[1]}};
  // One logarithm for the whole contact, from its largest half-width.
  double largest = 0.05 * half;
  for (int i = 0; i < 3; ++i) {
    bed.stiffness = 1.0 / (2.0 * (std::log(std::max(2.0 * half / largest, 1.5)) + 1.2));
    const auto [approach, tilt] = bed.balance(turned);
    state.rigid = {approach, side * tilt};
    double widest = 0.0;
    for (Index k = 0; k < n; ++k) {
      const double depth = state.interference(grid, k);
      state.m[k] = depth > 0.0 ? depth * bed.stiffness / state.r[k] : 0.0;
      widest = std::max(widest, state.m[k]);
    }
    largest = std::max(std::sqrt(widest), 1e-6 * half);
  }
}

bool start_from_other(const Level& other, const Grid& grid, const Prescription& prescribed, State& state) {
  const Numbers& near_y = other.grid->y;
  const State& near = other.state;
  // m passes linearly through zero where the contact ends: the first idle strip gets the value that continues the line,
  // so that strips are in or out of contact according to the actual end.
  Numbers extended = near.m;
  for (Index side : {1, -1}) continue_past_ends(near_y, near.m, side, extended);
  std::vector<Index> bearing;
  for (Index i = 0; i < count_of(near.m); ++i)
    if (near.m[i] > 0.0) bearing.push_back(i);
  const Index last = count_of(near_y) - 1, last_bearing = static_cast<Index>(bearing.size()) - 1;
  bool any_touches = false;
  Index behind = 0, behind_bearing = 0;
  for (Index i = 0; i < grid.count(); ++i) {
    const double y = grid.y[i];
    while (behind + 1 < last && near_y[behind + 1] <= y) ++behind;
    while (behind_bearing + 1 < last_bearing && near_y[bearing[behind_bearing + 1]] <= y) ++behind_bearing;
    const double m = interpolate(near_y, extended, behind, std::min(behind + 1, last), y);
    const Index beside = bearing[std::min(behind_bearing + 1, last_bearing)];
    state.r[i] = interpolate(near_y, near.r, bearing[behind_bearing], beside, y);
    state.m[i] = m > 0.0 && std::isfinite(grid.separation[i]) ? m : 0.0;
    any_touches = any_touches || state.m[i] > 0.0;
  }
  for (int k = 0; k < 2; ++k) state.rigid[k] = prescribed.by_force[k] ? near.rigid[k] : prescribed.target[k];
  return any_touches;
}

}  // namespace nonhertz
