#include "subsurface/strip_load.hpp"

#include <algorithm>
#include <complex>

#include "subsurface/tails.hpp"

namespace nonhertz {
namespace {

constexpr double ERROR = 1e-8;  // of the contribution of a strip
// Beyond these distances, in half-widths and in its own length, a strip is not divided into pieces.
constexpr double FAR = 16.0, FAR_IN_LENGTHS = 6.0;
// Beyond this distance, in half-widths, nodes replace the closed form of the infinite strip, which begins to cancel.
constexpr double CLOSED_FORM = 8.0;

using Complex = std::complex<double>;

// Complex arithmetic as in textbooks: the library's own checks for infinities first, or depends on flags.
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

Complex complex_root(Complex of) {
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
  Complex root = product(complex_root({across - 1.0, deep}), complex_root({across + 1.0, deep}));
  if (root == 0.0) root = {1e-150, 0.0};
  const Complex outside = Complex(across, deep) + root, half = product(0.5, outside);
  const Complex log(std::log(std::hypot(half.real(), half.imag())), std::atan2(half.imag(), half.real()));
  const Complex potential = log + quotient(0.5, product(outside, outside));
  return {quotient(2.0, product(a, outside)), quotient(-2.0, product(product(a * a, root), outside)),
          potential + std::log(a)};
}

/// The sum of the distances from both edges of line loads within a of x = 0, over a, at a distance in y and z.
template <class Real>
Real to_edges(Real x, Real distance, Real a) {
  const Real across = x / a, apart = distance / a, square = apart * apart;
  return root_of((across - 1.0) * (across - 1.0) + square) + root_of((across + 1.0) * (across + 1.0) + square);
}

/// The first rule that suffices at a distance.
Index sufficient(double to_edges, const Numbers& enough) {
  Index rule = 0;
  while (rule < count_of(enough) - 1 && to_edges < enough[rule]) ++rule;
  return rule;
}

/// The signs of both tails that make up a segment, and of their components that are odd in y.
struct Signs {
  double even1, odd1, even2, odd2;
  bool operator==(const Signs&) const = default;
};

/// The same, and the fraction of the infinite strip that counts: 1 under the segment, and 1/2 exactly at one of its
/// ends, where the tail that begins at the point is half the infinite strip except for the odd components.
struct Sides {
  Signs signs;
  double whole;
};

/// `low` and `high` are the segment's ends relative to the point, positive if ahead of it.
const Sides& sides(double low, double high) {
  static constexpr Sides AHEAD{{1.0, 1.0, -1.0, -1.0}, 0.0}, BEHIND{{1.0, -1.0, -1.0, 1.0}, 0.0};
  static constexpr Sides FROM_HERE{{0.0, 1.0, -1.0, -1.0}, 0.5}, UP_TO_HERE{{0.0, -1.0, -1.0, 1.0}, 0.5};
  static constexpr Sides OVER{{-1.0, -1.0, -1.0, 1.0}, 1.0};
  return low > 0.0 ? AHEAD : high < 0.0 ? BEHIND : low == 0.0 ? FROM_HERE : high == 0.0 ? UP_TO_HERE : OVER;
}

/// The indices that represent strip j: a distant strip itself, pieces of a near one.
std::pair<Index, Index> pieces_of(Index j, double y, const Lamination& strips) {
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
      const Index rule = sufficient(to_edges(x, z, a), rules.enough);
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
  // Its singularity is only logarithmic, so that higher-order rules can be used that much closer.
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

/// Adds up the effect of pairs of tails at a point in their order; many at a time, in packs.
template <class Kind>
class Sum {
 public:
  Sum(double z, double poisson) : z_(z), poisson_(poisson) {}

  /// The signs of the tails that are added next. Pieces are in order, so that signs change only a few times.
  void turn_to(const Signs& signs) {
    if (signs == signs_) return;
    add_waiting();
    signs_ = signs;
  }
  void add(double X, double weight, double Y1, double Y2) {
    X_[count_] = X, weight_[count_] = weight, Y1_[count_] = Y1, Y2_[count_] = Y2;
    if (++count_ == ROOM) add_waiting();
  }
  /// Add as many pieces as a pack has numbers, with the same nodes and signs: one piece after the other.
  void add_pack(Pack x, Pack a, Pack load, Pack Y1, Pack Y2, View nodes, View weights) {
    add_waiting();
    const Pack z = Pack{} + z_;
    double done[6][ROOM];
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const Six<Pack> both = pair(x - a * nodes[k], load * weights[k], Y1, Y2, z);
      for (int c = 0; c < 6; ++c) store(done[c] + WIDTH * k, both[c]);
    }
    Six<double> total = total_;
    for (int piece = 0; piece < WIDTH; ++piece)
      for (std::size_t k = 0; k < nodes.size(); ++k)
        for (int c = 0; c < 6; ++c) total[c] += done[c][WIDTH * k + piece];
    total_ = total;
  }
  void add_whole(double weight, const Six<double>& of) {
    add_waiting();
    for (int c : {0, 1, 2, 4}) total_[c] += weight * of[c];
  }
  const Six<double>& total() {
    add_waiting();
    return total_;
  }

  static constexpr int ROOM = 64;

 private:
  /// The effect of pairs of tails.
  Six<Pack> pair(Pack X, Pack weight, Pack Y1, Pack Y2, Pack z) const {
    const Six<Pack> f = Kind::tail(X, Y1, z, poisson_), g = Kind::tail(X, Y2, z, poisson_);
    Six<Pack> both;
    for (int c : {0, 1, 2, 4}) both[c] = weight * (signs_.even1 * f[c] + signs_.even2 * g[c]);
    for (int c : {3, 5}) both[c] = weight * (signs_.odd1 * f[c] + signs_.odd2 * g[c]);
    return both;
  }

  void add_waiting() {
    if (count_ == 0) return;
    // The padding of the last pack is not added.
    for (int k = count_; k % WIDTH; ++k) X_[k] = weight_[k] = 0.0, Y1_[k] = Y2_[k] = 1.0;
    const Pack z = Pack{} + z_;
    double done[6][ROOM];
    for (int k = 0; k < count_; k += WIDTH) {
      const Six<Pack> both = pair(load(X_ + k), load(weight_ + k), load(Y1_ + k), load(Y2_ + k), z);
      for (int c = 0; c < 6; ++c) store(done[c] + k, both[c]);
    }
    add_in_turn(done, count_, total_);
    count_ = 0;
  }

  double z_, poisson_;
  Six<double> total_{};
  Signs signs_{};
  int count_ = 0;
  double X_[ROOM], weight_[ROOM], Y1_[ROOM], Y2_[ROOM];
};

/// Positions where both tails of each piece of a pack begin, and distances of their loads from the point (see
/// `to_edges`).
struct Distances {
  Pack Y1, Y2, to_edges;
};

/// No tail begins within `nearest` half-widths of the point.
Distances distances(double x, Pack low, Pack high, double z, Pack a, double nearest) {
  const Pack near = nearest * a, nearer = 1e-9 * a;
  const Pack least = root_of(larger(near * near - z * z, nearer * nearer));
  const Pack to_low = larger(-low, least), to_high = larger(high, least);
  const Pack Y2 = low >= 0.0 ? to_high : to_low;
  const Pack inside = (low == 0.0 || high == 0.0) ? least : to_high;
  const Pack Y1 = low > 0.0 ? larger(low, least) : high < 0.0 ? larger(-high, least) : inside;
  const Pack apart = smaller(Y1, Y2);
  return {Y1, Y2, to_edges(Pack{} + x, root_of(z * z + apart * apart), a)};
}

/// The rule that suffices for the pieces of a pack if it is the same for all, else -1.
Index shared_rule(Pack to_edges, const Numbers& enough) {
  const Index rule = sufficient(to_edges[0], enough);
  for (int k = 1; k < WIDTH; ++k)
    if (sufficient(to_edges[k], enough) != rule) return -1;
  return rule;
}

template <class Kind>
void add_up(const Lamination& strips, double poisson, View points, Row out) {
  const SemiEllipseRules& rules = semi_ellipse_rules();
  for (Index i = 0; i < count_of(points) / 3; ++i) {
    const double x = points[3 * i], y = points[3 * i + 1], z = points[3 * i + 2];
    Sum<Kind> sum(z, poisson);
    const auto add_piece = [&](Index p, double Y1, double Y2, double to_edges) {
      const double a = strips.half_width[p], q = Kind::SCALE * strips.line_load[p];
      const auto& [signs, whole] = sides(strips.low[p] - y, strips.high[p] - y);
      if (whole > 0.0) sum.add_whole(whole * q, Kind::whole(x, z, a, poisson));
      sum.turn_to(signs);
      const Index rule = sufficient(to_edges, rules.enough);
      for (Index k = rules.starts[rule]; k < rules.starts[rule + 1]; ++k)
        sum.add(x - a * rules.nodes[k], q * rules.weights[k], Y1, Y2);
    };
    for (Index j = 0; j + 1 < std::ssize(strips.first); ++j) {
      const auto [begin, end] = pieces_of(j, y, strips);
      for (Index p = begin; p < end; p += WIDTH) {
        const Index count = std::min<Index>(WIDTH, end - p);
        const auto of = [p, count](const Numbers& values) { return load_some(&values[p], count); };
        const Pack a = of(strips.half_width);
        const auto [Y1, Y2, to_edges] = distances(x, of(strips.low) - y, of(strips.high) - y, z, a, Kind::NEAREST);
        const auto& [signs, whole] = sides(strips.low[p] - y, strips.high[p + count - 1] - y);
        const Index rule = count == WIDTH && whole == 0.0 ? shared_rule(to_edges, rules.enough) : -1;
        if (rule >= 0 && SemiEllipseRules::LADDER[rule] * WIDTH <= Sum<Kind>::ROOM) {
          sum.turn_to(signs);
          const Index first = rules.starts[rule], nodes = SemiEllipseRules::LADDER[rule];
          sum.add_pack(Pack{} + x, a, Kind::SCALE * of(strips.line_load), Y1, Y2,
                       View(rules.nodes).subspan(first, nodes), View(rules.weights).subspan(first, nodes));
        } else {
          for (Index k = 0; k < count; ++k) add_piece(p + k, Y1[k], Y2[k], to_edges[k]);
        }
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
