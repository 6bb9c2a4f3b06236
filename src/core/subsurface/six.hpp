// Six components at a point, and the functions that take one number or a pack of them.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "numbers/pack.hpp"

namespace nonhertz {

inline constexpr double TWO_PI = 2.0 * std::numbers::pi;

/// sigma_x, sigma_y, sigma_z, tau_yz, tau_xz, tau_xy; or a displacement in the places of stresses of the same symmetry:
/// u_x, 0, u_z, u_y, 0, 0.
template <class Real>
using Six = std::array<Real, 6>;

/// Add the first `count` numbers of each component in turn, in the same order as without packs.
template <int ROOM>
void add_in_turn(const double (&waiting)[6][ROOM], int count, Six<double>& total) {
  Six<double> sum = total;
  for (int k = 0; k < count; ++k)
    for (int c = 0; c < 6; ++c) sum[c] += waiting[c][k];
  total = sum;
}

/// A function of each number of a pack.
template <class Function>
Pack map(Function function, Pack x) {
  for (int k = 0; k < WIDTH; ++k) x[k] = function(x[k]);
  return x;
}

inline double root_of(double x) { return std::sqrt(x); }
inline double log_of(double x) { return std::log(x); }
inline double angle_of(double y, double x) { return std::atan2(y, x); }
inline Pack root_of(Pack x) {
  return map([](double of) { return std::sqrt(of); }, x);
}
inline Pack log_of(Pack x) {
  return map([](double of) { return std::log(of); }, x);
}
inline Pack angle_of(Pack y, Pack x) {
  for (int k = 0; k < WIDTH; ++k) y[k] = std::atan2(y[k], x[k]);
  return y;
}

inline Pack larger(Pack a, Pack b) { return a < b ? b : a; }
inline Pack smaller(Pack a, Pack b) { return b < a ? b : a; }

}  // namespace nonhertz
