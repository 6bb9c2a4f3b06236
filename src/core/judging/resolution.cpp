#include "judging/resolution.hpp"

#include <array>
#include <cmath>

namespace nonhertz {
namespace {

/// The parabolas within a strip, as three orthonormal rows over the places.
std::array<std::array<double, WITHIN>, 3> parabolas() {
  std::array<std::array<double, WITHIN>, 3> rows{};
  for (int power = 0; power < 3; ++power) {
    for (int k = 0; k < WITHIN; ++k) rows[power][k] = std::pow(within(k), power);
    for (int other = 0; other < power; ++other) {
      double along = 0.0;
      for (int k = 0; k < WITHIN; ++k) along += rows[power][k] * rows[other][k];
      for (int k = 0; k < WITHIN; ++k) rows[power][k] -= along * rows[other][k];
    }
    double square = 0.0;
    for (double each : rows[power]) square += each * each;
    for (double& each : rows[power]) each /= std::sqrt(square);
  }
  return rows;
}

}  // namespace

double departure(View separation) {
  static const auto rows = parabolas();
  std::array<double, 3> share{};
  for (int k = 0; k < WITHIN; ++k) {
    if (!std::isfinite(separation[k])) return 0.0;
    for (int row = 0; row < 3; ++row) share[row] += separation[k] * rows[row][k];
  }
  double total = 0.0;
  for (int k = 0; k < WITHIN; ++k) {
    const double off = separation[k] - (share[0] * rows[0][k] + share[1] * rows[1][k] + share[2] * rows[2][k]);
    total += off * off;
  }
  return std::sqrt(total / WITHIN);
}

}  // namespace nonhertz
