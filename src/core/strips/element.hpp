// The two strip elements, each four functions of one variable t = y'/a, read from one table of polynomials.
//
// The table is flat: polynomials on eight intervals per octave of t, located from the bits of t without a logarithm,
// then a far series, leading terms, and the factors of t^-2k (docs/explain/theory.md has the functions).
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "numbers/array.hpp"
#include "numbers/pack.hpp"

namespace nonhertz {

// The table covers [SMALL, FAR]; below it the leading terms are exact to rounding, beyond it a short series is.
inline constexpr int SMALL_EXPONENT = -30, FAR_EXPONENT = 8, INTERVALS_PER_OCTAVE = 8, DEGREE = 8;
inline constexpr double SMALL = 1.0 / (1 << 30), FAR = 256.0;
inline constexpr int SHORT_SERIES = 4;
// Beyond t = REMOTE the powers t^-2 to t^-2 POWERS give A and B to 1e-13.
inline constexpr double REMOTE = 10.0;
inline constexpr int POWERS = 5;
// Offsets of the parts of the table.
inline constexpr Index SERIES_AT = Index{FAR_EXPONENT - SMALL_EXPONENT} * INTERVALS_PER_OCTAVE * (DEGREE + 1) * 4;
inline constexpr Index LEADING_AT = SERIES_AT + SHORT_SERIES * 4;
inline constexpr Index POWERS_AT = LEADING_AT + 4;

/// A strip with a fixed shape of the pressure across.
struct Element {
  std::string name;
  double line_factor;   ///< kappa: in a line contact a^2 = kappa K q rho
  double hertz_ratio;   ///< from the element's half-width to that of the Hertz line contact of equal load
  double far_constant;  ///< A(t) - ln(2 t) at infinity
  Numbers table;
  std::array<double, 2> (*smoothed)(double t);  ///< (1/pi) int phi t / (xi^2 + t^2), t > 0, and its second derivative
};

Element semi_elliptic();
Element parabolic();

/// Four polynomials in one variable; their coefficients alternate, highest powers first.
inline Four polynomials(const double* coefficients, int count, double x) {
  Four s;
  for (int k = 0; k < count; ++k) s = x * s + Four::from(coefficients + 4 * k);
  return s;
}

Four evaluate_far(double t, const double* table);
Four evaluate_small(double t, const double* table);

/// Return A, t A', B and t B' at t, which are odd in t.
inline Four evaluate(double t, const double* table) {
  const double size = std::fabs(t);
  if (!(size < FAR)) return evaluate_far(t, table);  // NaN included, which must not become an index
  if (size < SMALL) return evaluate_small(t, table);
  // The bits of a double are its exponent followed by its mantissa: the top three bits of that number the intervals.
  const auto bits = std::bit_cast<std::uint64_t>(size);
  const auto interval = (bits >> 49) - std::uint64_t{1023 + SMALL_EXPONENT} * INTERVALS_PER_OCTAVE;
  const double place = static_cast<double>(static_cast<std::int64_t>(bits & ((std::uint64_t{1} << 49) - 1)));
  const double x = place * (2.0 / (std::uint64_t{1} << 49)) - 1.0;
  const Four s = polynomials(table + interval * (4 * (DEGREE + 1)), DEGREE + 1, x);
  return t < 0.0 ? -s : s;
}

}  // namespace nonhertz
