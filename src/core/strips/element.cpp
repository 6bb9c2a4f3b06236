#include "strips/element.hpp"

#include <array>
#include <numbers>

namespace nonhertz {
namespace {

constexpr double PI = std::numbers::pi;
constexpr double CANCELLING = 8.0;  // beyond it the closed forms cancel, and the series has LONG_SERIES terms
constexpr int LONG_SERIES = 11;
constexpr int MEANS = 10;  // arithmetic-geometric means from 1 and SMALL until both agree to the last bit
constexpr int NODES = DEGREE + 1;

/// The functions and constants that distinguish elements.
struct Shape {
  double far_constant;
  std::array<double, 4> leading;                // for t -> 0: A' = l0 ln(l1/t), B = l2 t ln(l3/t)
  double (*moment)(int), (*slope_moment)(int);  // k -> int phi xi^2k and int psi xi^2k
  Four (*closed_forms)(double t);               // A', t A', B, t B'; the first is not A
};

/// The far series in 1/t^2, lowest power first; A without ln(2 t).
std::vector<Four> series(const Shape& shape, int terms) {
  std::vector<Four> coefficients;
  double binomial = 1.0;  // of -1/2 over k
  for (int k = 0; k < terms; ++k) {
    const double phi = binomial * shape.moment(k), psi = binomial * shape.slope_moment(k);
    coefficients.push_back({k == 0 ? shape.far_constant : -phi / (2 * k), phi, psi, -2 * k * psi});
    binomial *= -(0.5 + k) / (k + 1);
  }
  return coefficients;
}

/// Chebyshev polynomials of the first kind at x.
std::array<double, NODES + 1> chebyshev(double x) {
  std::array<double, NODES + 1> t{1.0, x};
  for (int k = 2; k <= NODES; ++k) t[k] = 2.0 * x * t[k - 1] - t[k - 2];
  return t;
}

using Values = std::array<double, NODES>;

/// The nodes of an interpolation, and conversions of values there.
struct Interpolation {
  Values nodes;
  std::array<std::array<double, NODES + 1>, NODES> at_nodes;  // Chebyshev polynomials
  std::array<Values, NODES> powers{};                         // their coefficients, lowest power first

  Interpolation() {
    for (int n = 0; n < NODES; ++n) {
      nodes[n] = std::cos(PI * (2 * (NODES - n) - 1) / (2.0 * NODES));
      at_nodes[n] = chebyshev(nodes[n]);
    }
    powers[0][0] = powers[1][1] = 1.0;
    for (int k = 2; k < NODES; ++k)
      for (int p = 0; p < NODES; ++p) powers[k][p] = (p > 0 ? 2.0 * powers[k - 1][p - 1] : 0.0) - powers[k - 2][p];
  }

  Values to_chebyshev(const Values& values) const {
    Values c{};
    for (int k = 0; k < NODES; ++k)
      for (int n = 0; n < NODES; ++n) c[k] += (k == 0 ? 1.0 : 2.0) / NODES * values[n] * at_nodes[n][k];
    return c;
  }
};

/// The integral of a Chebyshev series from -1 to each node, and to 1.
std::pair<Values, double> integrate(const Values& c, const Interpolation& by) {
  std::array<double, NODES + 1> of{};
  for (int k = 0; k < NODES; ++k) {
    of[k + 1] += k == 0 ? c[0] : c[k] / (2.0 * (k + 1));
    if (k > 1) of[k - 1] -= c[k] / (2.0 * (k - 1));
    if (k == 1) of[0] += 0.0;  // a constant, which cancels in the difference
  }
  const auto sum = [&of](const auto& t) {
    double total = 0.0;
    for (int k = NODES; k >= 0; --k) total += of[k] * t[k];
    return total;
  };
  const double at_low = sum(chebyshev(-1.0));
  Values within;
  for (int n = 0; n < NODES; ++n) within[n] = sum(by.at_nodes[n]) - at_low;
  return {within, sum(chebyshev(1.0)) - at_low};
}

/// The table that `evaluate` reads.
Numbers table_of(const Shape& shape) {
  const Interpolation by;
  const auto far = series(shape, LONG_SERIES);
  Numbers table;
  table.reserve(POWERS_AT + 2 * POWERS);
  // A is the integral of A' from 0, interval by interval.
  double before = shape.leading[0] * SMALL * (std::log(shape.leading[1] / SMALL) + 1.0);
  for (int octave = SMALL_EXPONENT; octave < FAR_EXPONENT; ++octave)
    for (int part = 0; part < INTERVALS_PER_OCTAVE; ++part) {
      const double unit = std::ldexp(1.0, octave), low = unit * (1.0 + part / double{INTERVALS_PER_OCTAVE});
      const double half = unit / (2 * INTERVALS_PER_OCTAVE);
      std::array<Values, 4> values;
      Values slope;
      for (int n = 0; n < NODES; ++n) {
        const double t = low + half * (1.0 + by.nodes[n]), x = 1.0 / (t * t);
        Four f;
        if (low < CANCELLING) {
          f = shape.closed_forms(t);
        } else {
          for (int k = LONG_SERIES - 1; k >= 0; --k) f = x * f + far[k];
          f += {std::log(2.0 * t), 0.0, 0.0, 0.0};
        }
        slope[n] = f.a();
        values[0][n] = f.a(), values[1][n] = f.ta(), values[2][n] = f.b(), values[3][n] = f.tb();
      }
      if (low < CANCELLING) {
        const auto [within, whole] = integrate(by.to_chebyshev(slope), by);
        for (int n = 0; n < NODES; ++n) values[0][n] = before + half * within[n];
        before += half * whole;
      }
      std::array<Values, 4> powers{};
      for (int kind = 0; kind < 4; ++kind) {
        const Values c = by.to_chebyshev(values[kind]);
        for (int k = NODES - 1; k >= 0; --k)
          for (int p = 0; p <= k; ++p) powers[kind][p] += c[k] * by.powers[k][p];
      }
      for (int p = DEGREE; p >= 0; --p)
        for (const Values& of_kind : powers) table.push_back(of_kind[p]);
    }
  for (int k = SHORT_SERIES - 1; k >= 0; --k)
    table.insert(table.end(), {far[k].a(), far[k].ta(), far[k].b(), far[k].tb()});
  table.insert(table.end(), shape.leading.begin(), shape.leading.end());
  for (int k = 1; k <= POWERS; ++k) table.insert(table.end(), {far[k].a(), far[k].b()});
  return table;
}

/// Binomial coefficient of 2 k over k, over 4^k.
double central(int k) {
  double product = 1.0;
  for (int i = 1; i <= k; ++i) product *= (2.0 * i - 1.0) / (2.0 * i);
  return product;
}

/// By the arithmetic-geometric mean (DLMF 19.8.5 and 19.8.6), which does not cancel in K - E.
Four semi_elliptic_forms(double t) {
  const double square = t * t, k2 = 1.0 / (1.0 + square), other = square / (1.0 + square);
  double a = 1.0, b = std::sqrt(other), total = 0.5 * k2, weight = 0.5;
  for (int i = 0; i < MEANS; ++i) {
    const double difference = 0.5 * (a - b), product = a * b;
    a = 0.5 * (a + b), b = std::sqrt(product), weight *= 2.0;
    total += weight * difference * difference;
  }
  const double first = 0.5 * PI / a, excess = first * total, slope = 4.0 / PI * std::sqrt(1.0 + square) * excess;
  return {slope, t * slope, 4.0 / PI * std::sqrt(other) * first, 4.0 / PI * t * std::sqrt(k2) * excess};
}

Four parabolic_forms(double t) {
  const double root = std::sqrt(1.0 + t * t), inverse = std::asinh(1.0 / t);
  double slope = 1.0 / root + 1.5 * ((1.0 + 0.5 * t * t) * inverse - (1.0 + t * t / 6.0) / root);
  slope -= 0.25 * (root + t * t / root);
  return {slope, t * slope, 3.0 * t * inverse, 3.0 * t * (inverse - 1.0 / root)};
}

std::array<double, 2> semi_elliptic_smoothed(double t) {
  const double root = std::sqrt(1.0 + t * t);
  return {2.0 / PI / (root + t), 2.0 / PI / (root * root * root)};
}

std::array<double, 2> parabolic_smoothed(double t) {
  if (t <= CANCELLING) {
    const double angle = std::atan(1.0 / t), square = 1.0 + t * t;
    return {1.5 / PI * (square * angle - t), 3.0 / PI * (angle - t / square)};
  }
  // (1 + t^2) arctan(1/t) - t and arctan(1/t) - t / (1 + t^2), by their series in 1 / t
  const double x = 1.0 / (t * t);
  double value = 0.0, second = 0.0, power = 1.0;
  for (int k = 0; k < LONG_SERIES; ++k, power *= -x) {
    value += power * (1.0 / (2 * k + 1) - 1.0 / (2 * k + 3));
    second += power * (1.0 - 1.0 / (2 * k + 3));
  }
  return {1.5 / PI / t * value, 3.0 / PI * x / t * second};
}

}  // namespace

/// Reusner's element: semi-elliptic across, exact for line contacts and elliptical Hertz contacts.
Element semi_elliptic() {
  const Shape shape{
      std::numbers::ln2 + 0.5,
      {4.0 / PI, 4.0 / std::numbers::e, 4.0 / PI, 4.0},
      [](int k) { return central(k) / (k + 1); },
      [](int k) { return 2.0 * central(k); },
      semi_elliptic_forms,
  };
  return {"semi-elliptic", 4.0, 1.0, shape.far_constant, table_of(shape), semi_elliptic_smoothed};
}

/// The paper's element: parabolic across, with the bias that this shape introduces.
Element parabolic() {
  const Shape shape{
      4.0 / 3.0,
      {1.5, 2.0 / std::sqrt(std::numbers::e), 3.0, 2.0},
      [](int k) { return 3.0 / ((2 * k + 1) * (2 * k + 3)); },
      [](int k) { return 3.0 / (2 * k + 1); },
      parabolic_forms,
  };
  return {"parabolic", 6.0, std::sqrt(2.0 / 3.0), shape.far_constant, table_of(shape), parabolic_smoothed};
}

Four evaluate_far(double t, const double* table) {
  const double size = std::fabs(t);
  Four s = polynomials(table + SERIES_AT, SHORT_SERIES, 1.0 / (size * size));
  s += {std::log(2.0 * size), 0.0, 0.0, 0.0};
  return t < 0.0 ? -s : s;
}

Four evaluate_small(double t, const double* table) {
  const double size = std::fabs(t), *leading = table + LEADING_AT;
  if (size == 0.0) return {};
  const double slope = leading[0] * std::log(leading[1] / size), of_b = leading[2] * std::log(leading[3] / size);
  return {t * (slope + leading[0]), t * slope, t * of_b, t * (of_b - leading[2])};
}

}  // namespace nonhertz
