#include "bodies/harmonic_elements.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

namespace nonhertz {
namespace {

constexpr Index D = DEGREE_OF_ELEMENTS, BETWEEN = D - 1;            // nodes between the ends of an element's border
constexpr Index SQUARE = NODES * NODES, INNER = BETWEEN * BETWEEN;  // nodes of an element, and inside it
constexpr Index U = 0, V = 1, W = 2;

constexpr bool is_inside(Index a, Index b) { return 0 < a && a < D && 0 < b && b < D; }

/// The order in which an element's nodes are eliminated: inner nodes first.
struct Order {
  std::array<Index, SQUARE> of_node{}, node_at{};
  constexpr Order() {
    Index inside = 0, border = INNER;
    for (Index node = 0; node < SQUARE; ++node) {
      of_node[node] = is_inside(node / NODES, node % NODES) ? inside++ : border++;
      node_at[of_node[node]] = node;
    }
  }
};
constexpr Order ORDER;

/// Add the products of `left` and `right`, polynomials (columns) at points (rows), times their weights.
void add_products(const Matrix& left, const Matrix& right, View weights, Matrix& out) {
  for (Index q = 0; q < left.rows(); ++q)
    for (Index i = 0; i < SQUARE; ++i) {
      const double factor = weights[q] * left(q, i);
      double* row = out[i].data();
      const double* other = right[q].data();
      for (Index j = 0; j < SQUARE; ++j) row[j] += factor * other[j];
    }
}

/// Back-substitute for the eliminated unknowns of a front; the others are in `x`, which has a row for each unknown.
///
/// The rows of loads begin at `loads`; there are none if that is the size of the front.
void solve_backwards(const Front& front, Index eliminated, Index loads, Index first_load, Index step, Matrix& x) {
  const Index columns = x.columns();
  for (Index i = eliminated - 1; i >= 0; --i) {
    double* row = x[i].data();
    for (Index e = 0; e < columns; ++e) row[e] = loads < front.size() ? front(loads + first_load + step * e, i) : 0.0;
    for (Index j = i + 1; j < x.rows(); ++j) {
      const double factor = front(j, i);
      const double* other = x[j].data();
      if (factor != 0.0)
        for (Index e = 0; e < columns; ++e) row[e] -= factor * other[e];
    }
    const double inverse = 1.0 / front(i, i);
    for (Index e = 0; e < columns; ++e) row[e] *= inverse;
  }
}

}  // namespace

HarmonicElements::HarmonicElements(Mesh mesh, double poisson)
    : mesh_(std::move(mesh)), poisson_(poisson), lambda_(2.0 * poisson / (1.0 - 2.0 * poisson)) {
  for (Index j = 0; j < along(); ++j)
    for (Index i = 0; i < across(); ++i) products_.push_back(products(i, j));
}

HarmonicElements::Products HarmonicElements::products(Index across, Index along) const {
  const double half_s = 0.5 * (mesh_.across[across + 1] - mesh_.across[across]);
  const double half_z = 0.5 * (mesh_.along[along + 1] - mesh_.along[along]);
  Matrix by_r(SQUARE, SQUARE), by_t(SQUARE, SQUARE), by_z(SQUARE, SQUARE);
  Numbers measure(SQUARE);
  for (Index q = 0; q < NODES; ++q)
    for (Index p = 0; p < NODES; ++p) {
      const double share = mesh_.across[across] + half_s * (1.0 + mesh_.points[q]);
      const double wall = mesh_.outer(along, p) - mesh_.inner(along, p);
      const double radius = mesh_.inner(along, p) + share * wall;
      const double slope =
          mesh_.inner_slope(along, p) + share * (mesh_.outer_slope(along, p) - mesh_.inner_slope(along, p));
      const Index at = q * NODES + p;
      measure[at] = half_s * half_z * mesh_.weights[q] * mesh_.weights[p] * wall * radius;
      for (Index a = 0; a < NODES; ++a)
        for (Index b = 0; b < NODES; ++b) {
          const double along_s = mesh_.slopes(q, a) / half_s * mesh_.values(p, b);
          by_r(at, a * NODES + b) = along_s / wall;
          by_t(at, a * NODES + b) = mesh_.values(q, a) * mesh_.values(p, b) / radius;
          // At constant r, s changes with z.
          by_z(at, a * NODES + b) = mesh_.values(q, a) * mesh_.slopes(p, b) / half_z - slope / wall * along_s;
        }
    }
  const auto product = [&](const Matrix& left, const Matrix& right) {
    Matrix out(SQUARE, SQUARE);
    std::fill(out.all().begin(), out.all().end(), 0.0);
    add_products(left, right, measure, out);
    return out;
  };
  return {product(by_r, by_r), product(by_t, by_t), product(by_z, by_z),
          product(by_r, by_t), product(by_r, by_z), product(by_t, by_z)};
}

/// Return the stiffness of an element whose inner nodes are eliminated.
Front HarmonicElements::element(const Products& of, int waves) const {
  const double n = waves, stiff = 2.0 + lambda_;
  Front front(3 * SQUARE);
  for (Index row = 0; row < SQUARE; ++row)
    for (Index column = 0; column <= row; ++column) {
      const Index i = ORDER.node_at[row], j = ORDER.node_at[column], p = 3 * row, q = 3 * column;
      const double rr = of.rr(i, j), tt = of.tt(i, j), zz = of.zz(i, j), rt = of.rt(i, j), tr = of.rt(j, i);
      const double rz = of.rz(i, j), zr = of.rz(j, i), tz = of.tz(i, j), zt = of.tz(j, i);
      front(p + U, q + U) = stiff * (rr + tt) + lambda_ * (rt + tr) + zz + n * n * tt;
      front(p + V, q + V) = n * n * stiff * tt + rr - rt - tr + tt + zz;
      front(p + W, q + W) = stiff * zz + rr + n * n * tt;
      front(p + U, q + V) = n * (lambda_ * rt + (stiff + 1.0) * tt - tr);
      front(p + V, q + U) = n * (lambda_ * tr + (stiff + 1.0) * tt - rt);
      front(p + U, q + W) = lambda_ * (rz + tz) + zr;
      front(p + W, q + U) = lambda_ * (zr + zt) + rz;
      front(p + V, q + W) = n * (lambda_ * tz - zt);
      front(p + W, q + V) = n * (lambda_ * zt - tz);
    }
  front.eliminate(3 * INNER);
  return front;
}

/// Return the index of an element's unknown in its strip: between its lines, then at high y, then at low y.
Index HarmonicElements::place(Index across, Index node, Index component) const {
  const Index a = node / NODES, b = node % NODES;
  if (b == 0) return inside() + line() + 3 * (across * D + a) + component;
  if (b == D) return inside() + 3 * (across * D + a) + component;
  return ((across + a / D) * BETWEEN + b - 1) * 3 + component;
}

/// Fix the displacements that vanish on the axis of a solid body, at nodes from the unknown `first` on.
void HarmonicElements::hold_axis(Front& front, Index first, Index nodes, int waves) const {
  if (mesh_.bored) return;
  for (Index node = 0; node < nodes; ++node)
    for (Index component : {U, V, W})
      if (component != W || waves) front.hold(first + 3 * node + component);
}

HarmonicElements::Factors HarmonicElements::eliminate(int waves, const Matrix& loads, bool keep) const {
  const Index surface = rows() - 1, count = loads.rows(), columns = this->columns();
  const auto add_loads = [&](Front& front, Index unknown, Index column, Index first_load) {
    for (Index e = 0; e < count; ++e) {
      front(first_load + e, unknown + U) += loads(e, column);
      if (waves) front(first_load + e, unknown + W) += loads(e, columns + column);
    }
  };
  Factors factors;
  Front passed(line() + count);  // Schur complement of all strips at higher y: a line of nodes, and the loads
  for (Index j = along() - 1; j >= 0; --j) {
    const Index gone = inside() + line(), first_load = gone + line();
    Front strip(first_load + count);
    for (Index i = 0; i < across(); ++i) {
      Front stiff = element(products_[j * across() + i], waves);
      std::array<Index, 3 * SQUARE> places{};
      for (Index p = 3 * INNER; p < 3 * SQUARE; ++p) places[p] = place(i, ORDER.node_at[p / 3], p % 3);
      for (Index p = 3 * INNER; p < 3 * SQUARE; ++p)
        for (Index q = 3 * INNER; q <= p; ++q)
          strip(std::max(places[p], places[q]), std::min(places[p], places[q])) += stiff(p, q);
      if (keep) factors.elements.push_back(std::move(stiff));
    }
    for (Index p = 0; p < passed.size(); ++p)
      for (Index q = 0; q <= p; ++q)
        strip(p < line() ? inside() + p : first_load + p - line(),
              q < line() ? inside() + q : first_load + q - line()) += passed(p, q);
    for (Index b = 1; b < D; ++b) add_loads(strip, inside() - 3 * (D - b), j * D + b, first_load);
    add_loads(strip, inside() + 3 * surface, j * D + D, first_load);
    hold_axis(strip, 0, BETWEEN, waves);
    hold_axis(strip, inside(), 1, waves);
    strip.eliminate(gone);
    for (Index p = 0; p < passed.size(); ++p)
      for (Index q = 0; q <= p; ++q) passed(p, q) = strip(gone + p, gone + q);
    if (keep) factors.strips.push_back(std::move(strip));
  }
  add_loads(passed, 3 * surface, 0, line());
  hold_axis(passed, 0, 1, waves);
  for (int odd = 0; odd < (mesh_.symmetric ? 2 : 1); ++odd) {
    Front& last = factors.last[odd];
    last.reset(passed.size());
    for (Index p = 0; p < passed.size(); ++p)
      for (Index q = 0; q <= p; ++q) last(p, q) = passed(p, q);
    for (Index row = 0; row <= surface; ++row)
      for (Index component : {U, V, W}) {
        const bool by_symmetry = mesh_.symmetric && (component == W) != (odd == 1);
        const bool drifts = !waves && (component == V || (component == W && row == 0));  // torsion, and along the axis
        if (by_symmetry || drifts) last.hold(3 * row + component);
      }
    last.eliminate(line());
  }
  return factors;
}

Matrix HarmonicElements::work(int waves, const Matrix& loads, const Matrix& readings) const {
  const Index count = loads.rows(), both = count + readings.rows();
  Matrix all(both, loads.columns());
  std::copy(loads.all().begin(), loads.all().end(), all.all().begin());
  std::copy(readings.all().begin(), readings.all().end(), all.all().begin() + loads.rows() * loads.columns());
  const Factors factors = eliminate(waves, all, false);
  // The shear modulus is 1: 1 / mu = 2 pi K / (1 - nu).
  const double scale = -2.0 * std::numbers::pi / (1.0 - poisson_);
  const bool same = readings.rows() == 0;
  Matrix out(same ? count : readings.rows(), count);
  for (Index i = 0; i < out.rows(); ++i)
    for (Index j = 0; j < count; ++j) {
      const Index row = line() + (same ? std::max(i, j) : count + i), column = line() + (same ? std::min(i, j) : j);
      const bool apart = mesh_.symmetric && (i + j) % 2 == 1;
      out(i, j) = apart ? 0.0 : scale * factors.last[mesh_.symmetric ? j % 2 : 0](row, column);
    }
  return out;
}

std::vector<Matrix> HarmonicElements::works(const std::vector<int>& waves, const Matrix& loads, const Matrix& readings,
                                            int threads) const {
  std::vector<Matrix> out(waves.size());
  std::atomic<std::size_t> next = 0;
  const auto work_off = [&] {
    for (std::size_t k = next++; k < waves.size(); k = next++) out[k] = work(waves[k], loads, readings);
  };
  std::vector<std::jthread> others;
  for (int k = 1; k < threads; ++k) others.emplace_back(work_off);
  work_off();
  others.clear();  // joins them
  return out;
}

Matrix HarmonicElements::displacement(int waves, const Matrix& loads) const {
  const Factors factors = eliminate(waves, loads, true);
  const Index count = loads.rows(), rows = this->rows(), columns = this->columns();
  const double scale = 2.0 * std::numbers::pi / (1.0 - poisson_);
  Matrix out(count, 3 * rows * columns);
  const int kinds = mesh_.symmetric ? 2 : 1;
  for (int odd = 0; odd < kinds; ++odd) {
    const Index these = (count - odd + kinds - 1) / kinds;
    const auto put = [&](const Matrix& x, Index unknown, Index component, Index row, Index column) {
      for (Index e = 0; e < these; ++e)
        out(odd + kinds * e, (component * rows + row) * columns + column) = scale * x(unknown, e);
    };
    Matrix low(line(), these), strip(inside() + 2 * line(), these), element(3 * SQUARE, these);
    solve_backwards(factors.last[odd], line(), line(), odd, kinds, low);
    for (Index j = 0; j < along(); ++j) {
      const Index reverse = along() - 1 - j, gone = inside() + line();
      for (Index p = 0; p < line(); ++p) std::copy_n(low[p].data(), these, strip[gone + p].data());
      solve_backwards(factors.strips[reverse], gone, gone + line(), odd, kinds, strip);
      for (Index i = 0; i < across(); ++i) {
        for (Index p = 3 * INNER; p < 3 * SQUARE; ++p)
          std::copy_n(strip[place(i, ORDER.node_at[p / 3], p % 3)].data(), these, element[p].data());
        const Front& front = factors.elements[reverse * across() + i];
        solve_backwards(front, 3 * INNER, front.size(), odd, kinds, element);
        for (Index p = 0; p < 3 * SQUARE; ++p) {
          const Index node = ORDER.node_at[p / 3];
          put(element, p, p % 3, i * D + node / NODES, j * D + node % NODES);
        }
      }
      for (Index p = 0; p < line(); ++p) std::copy_n(strip[inside() + p].data(), these, low[p].data());
    }
  }
  return out;
}

}  // namespace nonhertz
