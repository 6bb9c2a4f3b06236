#include "maps/contact_map.hpp"

#include <algorithm>
#include <cmath>

namespace nonhertz {
namespace {

constexpr Index ORDER = 6, CELL = ORDER * ORDER;  // coefficients of a polynomial of degree 5
constexpr Index HEAD = sizeof(MapHead) / sizeof(double);
constexpr double THIRD = 1.0 / 3.0;
// Newton's method converges quadratically, and one linear step follows: a last step of 1e-5 leaves 1e-20.
constexpr int STEPS = 60;
constexpr double CLOSE = 1e-5;
// Relative to the slope of an approach quadratic in x: keeps the stiffness finite for any coefficients.
constexpr double LEAST_SLOPE = 1e-3;

double cube(double value) { return value * (value * value); }

/// asinh(angle / scale), and its derivatives by x, which determines the scale, and by the angle.
TiltCoordinate stretch(double angle, double scale, double scale_x, double scale_xx) {
  const double root = std::sqrt(angle * angle + scale * scale);
  const double rate = -angle / (scale * root);  // by the scale
  const double rate_scale = angle * (2.0 * scale * scale + angle * angle) / (scale * scale * cube(root));
  return {
      std::asinh(angle / scale),     rate * scale_x,     1.0 / root, rate * scale_xx + rate_scale * scale_x * scale_x,
      -scale / cube(root) * scale_x, -angle / cube(root)};
}

/// Index of the interval, of `count` between borders, that contains a place.
Index interval(const double* borders, Index count, double place) {
  Index low = 0, high = count;
  while (high - low > 1) {
    const Index middle = (low + high) / 2;
    (place >= borders[middle] ? low : high) = middle;
  }
  return low;
}

double polynomial(const double* coefficients, double t, double u) {
  double f = 0.0;
  for (Index i = ORDER - 1; i >= 0; --i) {
    double g = 0.0;
    for (Index j = ORDER - 1; j >= 0; --j) g = g * u + coefficients[ORDER * i + j];
    f = f * t + g;
  }
  return f;
}

/// A polynomial in t and u with its first and second derivatives.
struct Derivatives {
  double f = 0.0, t = 0.0, u = 0.0, tt = 0.0, tu = 0.0, uu = 0.0;
};

Derivatives derivatives(const double* coefficients, double t, double u) {
  Derivatives p;
  for (Index i = ORDER - 1; i >= 0; --i) {
    double g = 0.0, g_u = 0.0, g_uu = 0.0;
    for (Index j = ORDER - 1; j >= 0; --j) {
      g_uu = g_uu * u + g_u;
      g_u = g_u * u + g;
      g = g * u + coefficients[ORDER * i + j];
    }
    p.tt = p.tt * t + p.t;
    p.t = p.t * t + p.f;
    p.f = p.f * t + g;
    p.tu = p.tu * t + p.u;
    p.u = p.u * t + g_u;
    p.uu = p.uu * t + g_uu;
  }
  p.tt = 2.0 * p.tt, p.uu = 2.0 * p.uu;
  return p;
}

/// A state at a neighbouring approach and tilt: load and moment are continued linearly.
MapState continue_linearly(const MapState& of, double approach, double tilt) {
  const double by = approach - of.approach, turn = tilt - of.tilt;
  MapState state = of;
  state.approach = approach, state.tilt = tilt;
  state.load = of.load + of.load_by_approach * by + of.load_by_tilt * turn;
  state.moment = of.moment + of.load_by_tilt * by + of.moment_by_tilt * turn;
  return state;
}

MapState unloaded_state(double approach, double tilt, bool inside) {
  return {approach, tilt, 0.0, 0.0, 0.0, 0.0, 0.0, inside};
}

}  // namespace

TiltCoordinate MapHead::tilt_coordinate(double x, double tilt) const {
  if (widening == 0.0) {
    const double slope = 1.0 / (highest_tilt - lowest_tilt);
    return {(tilt - lowest_tilt) * slope, 0.0, slope, 0.0, 0.0, 0.0};
  }
  const double scale = narrow + widening * cube(x);
  const double scale_x = 3.0 * widening * (x * x), scale_xx = 6.0 * widening * x;
  const TiltCoordinate w = stretch(tilt - centre, scale, scale_x, scale_xx);
  const TiltCoordinate low = stretch(lowest_tilt - centre, scale, scale_x, scale_xx);
  const TiltCoordinate high = stretch(highest_tilt - centre, scale, scale_x, scale_xx);
  const double span = high.z - low.z, span_x = high.by_x - low.by_x, span_xx = high.by_x_twice - low.by_x_twice;
  const double z = (w.z - low.z) / span;
  const double z_x = (w.by_x - low.by_x - z * span_x) / span;
  const double z_g = w.by_tilt / span;
  const double z_xx = (w.by_x_twice - low.by_x_twice - z * span_xx - 2.0 * z_x * span_x) / span;
  const double z_xg = (w.by_x_and_tilt - z_g * span_x) / span;
  return {z, z_x, z_g, z_xx, z_xg, w.by_tilt_twice / span};
}

ContactMap::ContactMap(const double* numbers)
    : head_(*reinterpret_cast<const MapHead*>(numbers)),
      load_cells_(static_cast<Index>(head_.load_cells)),
      tilt_cells_(static_cast<Index>(head_.tilt_cells)),
      x_borders_(numbers + HEAD),
      z_borders_(x_borders_ + load_cells_ + 1),
      mean_approach_(z_borders_ + tilt_cells_ + 1),
      others_(mean_approach_ + CELL * load_cells_ * tilt_cells_) {}

Index ContactMap::size_of_mean_approach(const MapHead& head) {
  const auto load_cells = static_cast<Index>(head.load_cells), tilt_cells = static_cast<Index>(head.tilt_cells);
  return HEAD + load_cells + tilt_cells + 2 + CELL * load_cells * tilt_cells;
}

Index ContactMap::size(const MapHead& head) {
  const auto cells = static_cast<Index>(head.load_cells) * static_cast<Index>(head.tilt_cells);
  return size_of_mean_approach(head) + CELL * (QUANTILES + 2) * cells;
}

double ContactMap::within(double tilt) const { return std::min(std::max(tilt, head_.lowest_tilt), head_.highest_tilt); }

ContactMap::Place ContactMap::place(double x, double z) const {
  const Index i = interval(x_borders_, load_cells_, x), j = interval(z_borders_, tilt_cells_, z);
  const double by_width = 1.0 / (x_borders_[i + 1] - x_borders_[i]);
  const double by_height = 1.0 / (z_borders_[j + 1] - z_borders_[j]);
  return {i * tilt_cells_ + j, (x - x_borders_[i]) * by_width, (z - z_borders_[j]) * by_height, by_width, by_height};
}

ContactMap::Surface ContactMap::at(double x, double tilt) const {
  const TiltCoordinate z = head_.tilt_coordinate(x, tilt);
  const Place at = place(x, z.z);
  const Derivatives p = derivatives(mean_approach_ + CELL * at.cell, at.t, at.u);
  const double f_x = p.t * at.by_width, f_xx = p.tt * (at.by_width * at.by_width);
  const double f_z = p.u * at.by_height, f_zz = p.uu * (at.by_height * at.by_height);
  const double f_xz = p.tu * (at.by_width * at.by_height);
  const double by_x = f_x + f_z * z.by_x;
  const double by_x_twice = f_xx + (2.0 * f_xz + f_zz * z.by_x) * z.by_x + f_z * z.by_x_twice;
  const double arm_x = -((f_xz + f_zz * z.by_x) * z.by_tilt + f_z * z.by_x_and_tilt);
  const double arm_g = -(f_zz * z.by_tilt * z.by_tilt + f_z * z.by_tilt_twice);
  return {p.f + THIRD * x * by_x, THIRD * (4.0 * by_x + x * by_x_twice), -f_z * z.by_tilt, arm_x, arm_g};
}

/// The approach of first touch and moment / load there, from the first row of a polynomial.
ContactMap::Touch ContactMap::first_touch(double tilt) const {
  const TiltCoordinate z = head_.tilt_coordinate(0.0, tilt);
  const Place at = place(0.0, z.z);
  const double* coefficients = mean_approach_ + CELL * at.cell;
  double f = 0.0, f_u = 0.0;
  for (Index power = ORDER - 1; power >= 0; --power) {
    f_u = f_u * at.u + f;
    f = f * at.u + coefficients[power];
  }
  return {f, -f_u * at.by_height * z.by_tilt};
}

/// Find x at an approach beyond first touch: 1 where the approach is beyond that under the largest load.
ContactMap::Pressed ContactMap::press(double tilt, double first, double approach) const {
  const double target = std::sqrt(approach - first);
  double low = 0.0, high = 1.0;
  Pressed now{1.0, 0.0, at(1.0, tilt)};
  double slope = now.surface.approach_by_x;
  now.last = now.surface.approach;
  if (approach >= now.last) return now;
  // Between no load and the largest the root of the rise is nearly linear in x; the slope adds curvature.
  const double ratio = target / std::sqrt(now.last - first);
  const double bent = slope > 0.0 ? now.x + (1.0 - 2.0 * (now.last - first) / slope) * (1.0 - ratio) : 1.0;
  now.x = std::min(ratio * std::min(std::max(bent, 0.5), 2.0), 1.0);
  bool close = false;
  for (int step = 1; step < STEPS; ++step) {
    now.surface = at(now.x, tilt);
    if (close) break;
    const double reached = now.surface.approach;
    slope = now.surface.approach_by_x;
    (reached > approach ? high : low) = now.x;
    const double root = std::sqrt(std::max(reached - first, 0.0));
    double better = slope > 0.0 && root > 0.0 ? now.x + (target - root) * 2.0 * root / slope : -1.0;
    if (!(low <= better && better <= high)) better = 0.5 * (low + high);
    close = std::abs(better - now.x) <= CLOSE * now.x;
    now.x = better;
  }
  return now;
}

MapState ContactMap::state(double x, double tilt, const Surface& surface, bool inside) const {
  const double slope = std::max(surface.approach_by_x, LEAST_SLOPE * head_.rise * x);
  const double load = head_.max_load * cube(x);
  const double moment_by_load = surface.arm + THIRD * x * surface.arm_by_x;
  const double stiffness = 3.0 * head_.max_load * x * x / slope;
  const double by_tilt = moment_by_load * stiffness;
  return {surface.approach,
          tilt,
          load,
          load * surface.arm,
          stiffness,
          by_tilt,
          load * surface.arm_by_tilt + moment_by_load * by_tilt,
          inside};
}

MapState ContactMap::at_approach(double approach, double tilt) const {
  const double near = within(tilt);
  const Touch first = first_touch(near);
  // Beyond the range of tilts the first touch is continued linearly.
  const double level = approach + first.arm * (tilt - near);
  if (!(level > first.approach)) return unloaded_state(approach, tilt, near == tilt);
  const Pressed touch = press(near, first.approach, level);
  const bool inside = near == tilt && level <= touch.last;
  const MapState result = continue_linearly(state(touch.x, near, touch.surface, inside), approach, tilt);
  return result.load > 0.0 ? result : unloaded_state(approach, tilt, inside);
}

MapState ContactMap::at_load(double load, double tilt) const {
  const double near = within(tilt);
  const bool inside = near == tilt && 0.0 <= load && load <= head_.max_load;
  if (!(load > 0.0)) {
    const Touch first = first_touch(near);
    return unloaded_state(first.approach - first.arm * (tilt - near), tilt, inside);
  }
  const double x = std::min(std::pow(load / head_.max_load, THIRD), 1.0);
  const MapState border = state(x, near, at(x, near), inside);
  if (inside) return border;
  const double by = (load - border.load - border.load_by_tilt * (tilt - near)) / border.load_by_approach;
  return continue_linearly(border, border.approach + by, tilt);
}

ContactMap::Under ContactMap::under(double load, double tilt) const {
  const double x = std::min(std::pow(load / head_.max_load, THIRD), 1.0);
  return {x, place(x, head_.tilt_coordinate(x, within(tilt)).z)};
}

double ContactMap::quantity(const Place& at, Index number) const {
  return polynomial(others_ + CELL * ((QUANTILES + 2) * at.cell + number), at.t, at.u);
}

PressureAndWidth ContactMap::pressures(double load, double tilt) const {
  if (!(load > 0.0)) return {0.0, 0.0};
  const auto [x, at] = under(load, tilt);
  return {x * std::max(quantity(at, 0), 0.0), x * std::max(quantity(at, 1), 0.0)};
}

void ContactMap::share(double load, double tilt, View stations, Row strip_loads) const {
  std::fill(strip_loads.begin(), strip_loads.end(), 0.0);
  if (!(load > 0.0)) return;
  const Place at = under(load, tilt).at;
  std::array<double, QUANTILES> places;
  for (Index k = 0; k < QUANTILES; ++k)
    places[k] = std::min(std::max(quantity(at, k + 2), head_.low_end), head_.high_end);
  share_out(places, load, stations, strip_loads);
}

}  // namespace nonhertz
