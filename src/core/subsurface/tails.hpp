// Closed forms of a semi-infinite line load on a half-space; nonhertz/subsurface/tails.py derives them.
#pragma once

#include "subsurface/six.hpp"

namespace nonhertz {

/// 2 pi times the stress of the tail, Y > 0.
template <class Real>
[[gnu::always_inline]] inline Six<Real> stress_tail(Real X, Real Y, Real z, double poisson) {
  const Real R = root_of(X * X + Y * Y + z * z);
  const Real inverse = 1.0 / R, sum_inverse = 1.0 / (R + Y);
  const Real c = inverse * sum_inverse, cube = inverse * inverse * inverse;
  const Real T = (2.0 * R + Y) * cube * sum_inverse * sum_inverse;
  const Real lateral = (1.0 - 2.0 * poisson) * inverse / (R + z), zT = z * T;
  return {-zT * X * X - lateral * Y,
          -z * (2.0 * poisson * c + Y * cube) + lateral * Y,
          -zT * z * z,
          z * z * cube,
          -zT * z * X,
          X * (z * cube - lateral)};
}

/// 4 pi G times its displacement, u_y and u_z up to constants common to two tails.
template <class Real>
Six<Real> displacement_tail(Real X, Real Y, Real z, double poisson) {
  const Real R = root_of(X * X + Y * Y + z * z);
  const double lateral = 1.0 - 2.0 * poisson;
  const Real c = 1.0 / (R * (R + Y)), none{};
  return {z * X * c - 2.0 * lateral * angle_of(X, Y + R + z),
          none,
          -2.0 * (1.0 - poisson) * log_of(R + Y) + z * z * c,
          -z / R - lateral * log_of(R + z),
          none,
          none};
}

}  // namespace nonhertz
