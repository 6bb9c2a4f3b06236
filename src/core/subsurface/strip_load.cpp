#include "subsurface/strip_load.hpp"

#include <algorithm>
#include <complex>

#include "subsurface/tails.hpp"

namespace nonhertz {
namespace {

constexpr double ERROR = 1e-8;  // of the contribution of a strip
// Beyond these distances, in half-widths and in its own lengths, a strip is not divided into pieces.
constexpr double FAR = 16.0, FAR_IN_LENGTHS = 6.0;
// Beyond this distance, in half-widths, nodes replace the closed form of the infinite strip, which begins to cancel.
constexpr double CLOSED_FORM = 8.0;

using Complex = std::complex<double>;

// Complex arithmetic as in textbooks: the library's own looks for infinities first, or depends on flags.
Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

Complex quotient(double a, Complex b) {
  if (std::abs(b.real()) >= std::abs(b.imag())) {
    const double ratio = b.imag() / b.real(), scale = b.real() + b.imag() * ratio;
    return {(a + 0.0 * ratio) / scale, (0.0 - a * ratio) / scale};
  }
  const double ratio = b.real() / b.imag(), scale = b.real() * ratio + b.imag();
  return {(a * ratio + 0.0) / scale, (0.0 * ratio - a) / scale};
}

Complex root_of(Complex of) {
  const double a = of.real(), b = of.imag();
  if (a == 0.0 && b == 0.0) return {std::abs(b), b};
  const double half = std::sqrt((std::abs(a) + std::hypot(a, b)) * 0.5);
  if (a >= 0.0) return {half, b / (2.0 * half)};
  return {std::abs(b) / (2.0 * half), std::copysign(half, b)};
}

struct Infinite {
  Complex H, slope, potential;  ///< H, H' and the integral of p ln(zeta - xi) of unit line load
};

Infinite infinite(double x, double z, double a) {
  const double across = x / a, deep = z / a;
  // Two separate roots, for the branch that behaves like zeta far away.
  Complex root = product(root_of(Complex(across - 1.0, deep)), root_of(Complex(across + 1.0, deep)));
  if (root == 0.0) root = {1e-150, 0.0};
  const Complex outside = Complex(across, deep) + root, half = product(0.5, outside);
  const Complex log(std::log(std::hypot(half.real(), half.imag())), std::atan2(half.imag(), half.real()));
  const Complex potential = log + quotient(0.5, product(outside, outside));
  return {quotient(2.0, product(a, outside)), quotient(-2.0, product(product(a * a, root), outside)),
          potential + std::log(a)};
}

/// The first rule that suffices at a distance, in y and z, from line loads within a of x = 0.
Index sufficient(double x, double distance, double a, const Numbers& enough) {
  const double across = x / a, apart = distance / a, square = apart * apart;
  const double total =
      std::sqrt((across - 1.0) * (across - 1.0) + square) + std::sqrt((across + 1.0) * (across + 1.0) + square);
  Index rule = 0;
  while (rule < count_of(enough) - 1 && total < enough[rule]) ++rule;
  return rule;
}

/// Both tails that make up a segment: for each its distance, sign, and sign of components odd in y; and the fraction of
/// the infinite strip that counts: all of it under the segment, and half exactly at one of its ends, where the tail
/// that begins at the point is half the infinite strip except for the odd components.
struct Tails {
  double Y1, even1, odd1, Y2, even2, odd2, whole;
};

/// `low` and `high` are the segment's ends relative to the point, positive if ahead of it. No tail begins within
/// `nearest` half-widths of the point.
Tails tails(double low, double high, double z, double a, double nearest) {
  const double near = nearest * a, nearer = 1e-9 * a;
  const double least = std::sqrt(std::max(near * near - z * z, nearer * nearer));
  if (low > 0.0) return {std::max(low, least), 1.0, 1.0, std::max(high, least), -1.0, -1.0, 0.0};
  if (high < 0.0) return {std::max(-high, least), 1.0, -1.0, std::max(-low, least), -1.0, 1.0, 0.0};
  if (low == 0.0) return {least, 0.0, 1.0, std::max(high, least), -1.0, -1.0, 0.5};
  if (high == 0.0) return {least, 0.0, -1.0, std::max(-low, least), -1.0, 1.0, 0.5};
  return {std::max(high, least), -1.0, -1.0, std::max(-low, least), -1.0, 1.0, 1.0};
}

/// What represents strip j: the strip itself from afar, else its pieces.
std::pair<Index, Index> counted(Index j, double y, const Lamination& strips) {
  const double low = strips.low[j], high = strips.high[j], apart = std::max(low - y, y - high);
  if (apart > FAR * strips.half_width[j] && apart > FAR_IN_LENGTHS * (high - low)) return {j, j + 1};
  return {strips.first[j], strips.first[j + 1]};
}

struct Stress {
  static constexpr double SCALE = 1.0 / TWO_PI;
  // No tail begins nearer to a point than this, in half-widths: the smallest distance at which the rule of 256 nodes
  // meets the error bound. A piece that ends nearer to a point on the surface is lengthened by the difference, and its
  // neighbour shortened.
  static constexpr double NEAREST = 0.04;

  static Six<Pack> tail(Pack X, Pack Y, Pack z, double poisson) { return stress_tail(X, Y, z, poisson); }
  /// 2 pi times the stress of an infinite strip under unit line load.
  static Six<double> whole(double x, double z, double a, double poisson) {
    double s_x = 0.0, s_z = 0.0, s_xz = 0.0;
    if (std::abs(x) + z < CLOSED_FORM * a) {
      const auto [H, slope, _] = infinite(x, z, a);
      s_x = 2.0 * (H.imag() + z * slope.real()), s_z = 2.0 * (H.imag() - z * slope.real());
      s_xz = -2.0 * z * slope.imag();
    } else {
      const SemiEllipseRules& rules = semi_ellipse_rules();
      const Index rule = sufficient(x, z, a, rules.enough);
      for (Index k = rules.starts[rule]; k < rules.starts[rule + 1]; ++k) {
        const double X = x - a * rules.nodes[k], square = X * X + z * z;
        const double common = -4.0 * rules.weights[k] * z / (square * square);
        s_x += common * X * X;
        s_z += common * z * z;
        s_xz += common * X * z;
      }
    }
    return {s_x, poisson * (s_x + s_z), s_z, 0.0, s_xz, 0.0};
  }
};

struct Displacement {
  static constexpr double SCALE = 0.5 / TWO_PI;
  // Its singularity is only logarithmic: higher-order rules reach so much closer.
  static constexpr double NEAREST = 0.0025;

  static Six<Pack> tail(Pack X, Pack Y, Pack z, double poisson) { return displacement_tail(X, Y, z, poisson); }
  /// 4 pi G times the displacement, as `displacement_tail` gives it and up to the same constants.
  static Six<double> whole(double x, double z, double a, double poisson) {
    const auto [H, slope, potential] = infinite(x, z, a);
    const double turned = std::numbers::pi - 2.0 * potential.imag();
    const double u_x = 2.0 * z * H.real() - (1.0 - 2.0 * poisson) * turned;
    return {u_x, 0.0, -4.0 * (1.0 - poisson) * potential.real() - 2.0 * z * H.imag(), 0.0, 0.0, 0.0};
  }
};

/// Adds up what pairs of tails do at a point, in the order in which they come; many at a time, for packs of them.
template <class Kind>
class Sum {
 public:
  Sum(double z, double poisson) : z_(z), poisson_(poisson) {}

  void add(double X, double weight, const Tails& of) {
    X_[count_] = X, weight_[count_] = weight;
    Y1_[count_] = of.Y1, even1_[count_] = of.even1, odd1_[count_] = of.odd1;
    Y2_[count_] = of.Y2, even2_[count_] = of.even2, odd2_[count_] = of.odd2;
    if (++count_ == ROOM) add_waiting();
  }
  void add_whole(double weight, const Six<double>& of) {
    add_waiting();
    for (int c : {0, 1, 2, 4}) total_[c] += weight * of[c];
  }
  const Six<double>& total() {
    add_waiting();
    return total_;
  }

 private:
  static constexpr int ROOM = 64;

  void add_waiting() {
    // What fills up the last pack is not added.
    for (int k = count_; k % WIDTH; ++k) X_[k] = 0.0, Y1_[k] = Y2_[k] = 1.0;
    const Pack z = Pack{} + z_;
    double done[6][ROOM];
    for (int k = 0; k < count_; k += WIDTH) {
      const Pack X = load(X_ + k), weight = load(weight_ + k);
      const Six<Pack> f = Kind::tail(X, load(Y1_ + k), z, poisson_), g = Kind::tail(X, load(Y2_ + k), z, poisson_);
      const Pack even1 = load(even1_ + k), even2 = load(even2_ + k), odd1 = load(odd1_ + k), odd2 = load(odd2_ + k);
      for (int c : {0, 1, 2, 4}) store(done[c] + k, weight * (even1 * f[c] + even2 * g[c]));
      for (int c : {3, 5}) store(done[c] + k, weight * (odd1 * f[c] + odd2 * g[c]));
    }
    Six<double> total = total_;
    for (int k = 0; k < count_; ++k)
      for (int c = 0; c < 6; ++c) total[c] += done[c][k];
    total_ = total;
    count_ = 0;
  }

  double z_, poisson_;
  Six<double> total_{};
  int count_ = 0;
  double X_[ROOM], Y1_[ROOM], Y2_[ROOM];
  double weight_[ROOM] = {}, even1_[ROOM] = {}, odd1_[ROOM] = {}, even2_[ROOM] = {}, odd2_[ROOM] = {};
};

template <class Kind>
void add_up(const Lamination& strips, double poisson, View points, Row out) {
  const SemiEllipseRules& rules = semi_ellipse_rules();
  for (Index i = 0; i < count_of(points) / 3; ++i) {
    const double x = points[3 * i], y = points[3 * i + 1], z = points[3 * i + 2];
    Sum<Kind> sum(z, poisson);
    for (Index j = 0; j + 1 < std::ssize(strips.first); ++j) {
      const auto [begin, end] = counted(j, y, strips);
      for (Index p = begin; p < end; ++p) {
        const double a = strips.half_width[p], q = Kind::SCALE * strips.line_load[p];
        const Tails both = tails(strips.low[p] - y, strips.high[p] - y, z, a, Kind::NEAREST);
        if (both.whole > 0.0) sum.add_whole(both.whole * q, Kind::whole(x, z, a, poisson));
        const double apart = std::min(both.Y1, both.Y2);
        const Index rule = sufficient(x, std::sqrt(z * z + apart * apart), a, rules.enough);
        for (Index k = rules.starts[rule]; k < rules.starts[rule + 1]; ++k)
          sum.add(x - a * rules.nodes[k], q * rules.weights[k], both);
      }
    }
    std::ranges::copy(sum.total(), out.begin() + 6 * i);
  }
}

SemiEllipseRules made() {
  SemiEllipseRules rules;
  rules.starts.push_back(0);
  for (const Index count : SemiEllipseRules::LADDER) {
    for (Index k = 1; k <= count; ++k) {
      const double angle = std::numbers::pi * k / (count + 1.0), sine = std::sin(angle);
      rules.nodes.push_back(std::cos(angle));
      rules.weights.push_back(2.0 / (count + 1.0) * (sine * sine));
    }
    rules.starts.push_back(rules.starts.back() + count);
    rules.enough.push_back(2.0 * std::cosh(-std::log(ERROR) / (2.0 * count)));
  }
  return rules;
}

}  // namespace

const SemiEllipseRules& semi_ellipse_rules() {
  static const SemiEllipseRules rules = made();
  return rules;
}

void below_strips(const Lamination& strips, double poisson, bool displaced, View points, Row out) {
  (displaced ? add_up<Displacement> : add_up<Stress>)(strips, poisson, points, out);
}

}  // namespace nonhertz
