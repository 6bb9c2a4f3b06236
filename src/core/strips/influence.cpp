#include "strips/influence.hpp"

#include <algorithm>
#include <limits>

#include "numbers/products.hpp"

namespace nonhertz {
namespace {

constexpr double SHORT = 0.25;  // width over distance below which nine terms of a logarithm's series are exact
// The far field of a strip is computed for an m this many times as large, and again once m exceeds that or falls below
// this fraction of it, when the far field begins closer.
constexpr double ROOM = 1.2, LEAST_SHARE = 0.25;

/// Add the effect of a source on places from begin to end, at these distances from its nearer edge.
void add_far(double* powers, Index stride, Index begin, Index end, const double* distance, double width,
             double weight) {
  double nearest = std::numeric_limits<double>::infinity();
  for (Index i = begin; i < end; ++i) nearest = std::min(nearest, distance[i]);
  if (width < SHORT * nearest)
    for (Index i = begin; i < end; ++i) {  // ln(far / near) = 2 artanh(z), by its series
      const double z = width / (2.0 * distance[i] + width), x = z * z;
      const double later = 1.0 / 9.0 + x * (1.0 / 11.0 + x * (1.0 / 13.0 + x * (1.0 / 15.0 + x / 17.0)));
      const double series = 1.0 + x * (1.0 / 3.0 + x * (0.2 + x * (1.0 / 7.0 + x * later)));
      powers[i] += 2.0 * weight * z * series;
    }
  else
    for (Index i = begin; i < end; ++i) powers[i] += weight * std::log1p(width / distance[i]);
  constexpr Index TILE = 8;
  for (Index first = begin; first < end; first += TILE) {
    const Index count = std::min(TILE, end - first);
    double inner[TILE], outer[TILE], inner_power[TILE], outer_power[TILE];
    for (Index i = 0; i < TILE; ++i) {
      const double nearer = distance[first + std::min(i, count - 1)], farther = nearer + width;
      const double inverse = 1.0 / (nearer * farther), of_inner = farther * inverse, of_outer = nearer * inverse;
      inner[i] = of_inner * of_inner, outer[i] = of_outer * of_outer;
      inner_power[i] = outer_power[i] = weight;
    }
    for (int k = 1; k <= POWERS; ++k) {
      double change[TILE];
      for (Index i = 0; i < TILE; ++i) {
        inner_power[i] *= inner[i], outer_power[i] *= outer[i];
        change[i] = outer_power[i] - inner_power[i];
      }
      double* power = powers + k * stride + first;
      for (Index i = 0; i < count; ++i) power[i] += change[i];
    }
  }
}

/// Fill in the four functions of the far field of one source.
void from_afar(const double* powers, double m, const double* table, std::vector<Four>& seen) {
  const Index n = static_cast<Index>(seen.size());
  std::array<Four, 1 + POWERS> factors;
  factors[0] = {1.0, 0.0, 0.0, 0.0};
  double power = 1.0;
  for (int k = 1; k <= POWERS; ++k) {
    power *= m;
    const double a = power * table[POWERS_AT + 2 * k - 2], b = power * table[POWERS_AT + 2 * k - 1];
    factors[k] = {a, -2.0 * k * a, b, -2.0 * k * b};
  }
  for (Index i = 0; i < n; ++i) {
    Four s = powers[i] * factors[0];
    for (int k = 1; k <= POWERS; ++k) s += powers[k * n + i] * factors[k];
    seen[i] = s;
  }
}

}  // namespace

Influence::Influence(const Grid& grid, const Kernel& kernel)
    : grid_(grid),
      kernel_(kernel),
      n_(grid.count()),
      near_((kernel.terms.size() + kernel.faces.size()) * n_),
      powers_(n_ * (1 + POWERS), n_),
      limits_(n_),
      stale_(n_),
      seen_(n_),
      distance_(n_) {}

void Influence::keep_up(View m) {
  bool some = false;
  for (Index j = 0; j < n_; ++j) {
    stale_[j] = m[j] > limits_[j] || (m[j] > 0.0 && m[j] < LEAST_SHARE * limits_[j]);
    if (!stale_[j]) continue;
    some = true;
    limits_[j] = ROOM * m[j];
    for (int k = 0; k <= POWERS; ++k) std::fill(power(j, k).begin(), power(j, k).end(), 0.0);
  }
  if (!some) return;
  Index at = 0;
  for (const Term& term : kernel_.terms) add_far_term(term, at++);
  for (const Face& face : kernel_.faces) add_beyond_face(face, at++);
}

void Influence::add_far_term(const Term& term, Index at) {
  const Numbers& y = grid_.y;
  for (Index j = 0; j < n_; ++j) {
    if (!stale_[j]) continue;
    const double low = term.sign * grid_.low(j) + term.offset, high = term.sign * grid_.high(j) + term.offset;
    const double left = std::min(low, high), right = std::max(low, high), width = grid_.width(j);
    const double reach = REMOTE * std::sqrt(limits_[j]);
    Index before = 0;
    while (before < n_ && y[before] <= left - reach) ++before;
    Index after = before;
    while (after < n_ && y[after] < right + reach) ++after;
    near(at, j) = {before, after};
    for (Index i = 0; i < before; ++i) distance_[i] = left - y[i];
    for (Index i = after; i < n_; ++i) distance_[i] = y[i] - right;
    add_far(power(j, 0).data(), n_, 0, before, distance_.data(), width, term.weight);
    add_far(power(j, 0).data(), n_, after, n_, distance_.data(), width, term.weight);
  }
}

void Influence::add_beyond_face(const Face& face, Index at) {
  const double* table = face.table->data();
  const auto away_from_face = [&face](double y) { return std::max(face.side * (face.place - y), 0.0); };
  Numbers u(n_);
  for (Index i = 0; i < n_; ++i) u[i] = away_from_face(grid_.y[i]);
  Matrix terms[2] = {Matrix(1 + POWERS, n_ + TILE), Matrix(1 + POWERS, n_ + TILE)}, work(2, n_ + TILE);
  for (Index j = 0; j < n_; ++j) {
    if (!stale_[j]) continue;
    const double of_low = away_from_face(grid_.low(j)), of_high = away_from_face(grid_.high(j));
    Matrix &low = terms[j % 2], &high = terms[1 - j % 2];
    // Neighbouring strips share the edge between them.
    if (j == 0 || !stale_[j - 1]) far_terms(u, of_low, table, low, work);
    far_terms(u, of_high, table, high, work);
    const double inner = std::min(of_low, of_high), outer = std::max(of_low, of_high);
    const double away = AWAY * std::sqrt(limits_[j]);
    Index begin = 0, end = 0;
    for (Index i = 0; i < n_; ++i)
      if (u[i] + inner < away) begin = end == 0 ? i : begin, end = i + 1;
    near(at, j) = {begin, end};
    const double weight = face.side * face.weight;
    for (int k = 0; k <= POWERS; ++k) {
      Row to = power(j, k);
      const auto add = [&](Index from, Index until) {
        for (Index i = from; i < until; ++i) to[i] += weight * (low(k, i) - high(k, i));
      };
      add(0, begin);
      add(end, n_);
    }
    for (Index i = 0; i < n_; ++i)
      if (inner <= u[i] && u[i] < outer && !(begin <= i && i < end))
        for (int k = 0; k <= POWERS; ++k) power(j, k)[i] += face.weight * far_whole(u[i], k, table);
  }
}

void Influence::seen_from(Index source, double m) {
  const Element& element = *kernel_.element;
  const double *y = grid_.y.data(), *table = element.table.data();
  const double inverse = 1.0 / std::sqrt(m), low = grid_.low(source), high = grid_.high(source);
  from_afar(power(source, 0).data(), m, table, seen_);
  Index at = 0;
  for (const Term& term : kernel_.terms) {
    const double upper = term.sign * high + term.offset, lower = term.sign * low + term.offset;
    const double weight = term.sign * term.weight;
    const auto [begin, end] = near(at++, source);
    for (Index i = begin; i < end; ++i)
      seen_[i] += weight * (evaluate((upper - y[i]) * inverse, table) - evaluate((lower - y[i]) * inverse, table));
  }
  for (const Face& face : kernel_.faces) {
    const auto [begin, end] = near(at++, source);
    for (Index i = begin; i < end; ++i)
      seen_[i] += face.weight * face_influence(y[i], low, high, inverse, face, element, squares_);
  }
  const auto [own, slope] = by_own_width(grid_.by_width, source, 1.0 / inverse);
  seen_[source] += {own, -slope, 0.0, 0.0};
}

void Influence::coefficients(View m, const std::vector<Index>& active, Blocks& out) {
  const Index k = static_cast<Index>(active.size());
  for (Matrix& block : out) block.resize(n_, k);
  for (Index j = 0; j < k; ++j) {
    seen_from(active[j], m[active[j]]);
    for (Index i = 0; i < n_; ++i) {
      const Four& s = seen_[i];
      out[0](i, j) = s.a(), out[1](i, j) = s.ta(), out[2](i, j) = s.b(), out[3](i, j) = s.tb();
    }
  }
  if (grid_.at_depth.empty()) return;
  for (Index i = 0; i < n_; ++i)
    for (Index j = 0; j < k; ++j) out[0](i, j) -= grid_.at_depth(i, active[j]);
}

void Influence::lift(View m, View q, Row out) {
  std::fill(out.begin(), out.end(), 0.0);
  for (Index j = 0; j < n_; ++j) {
    if (!(m[j] > 0.0)) continue;
    seen_from(j, m[j]);
    for (Index i = 0; i < n_; ++i) out[i] += q[j] * seen_[i].a();
  }
  if (grid_.at_depth.empty()) return;
  away_.resize(n_);
  for (Index j = 0; j < n_; ++j) away_[j] = -q[j];
  add_products([this](Index i) { return grid_.at_depth[i].data(); }, away_, out);
}

Four face_influence(double y, double low, double high, double inverse, const Face& face, const Element& element,
                    Squares& cache) {
  const double u = std::max(face.side * (face.place - y), 0.0) * inverse;
  const double one = face.side * (face.place - low) * inverse, other = face.side * (face.place - high) * inverse;
  const double inner = std::max(std::min(one, other), 0.0), outer = std::max({one, other, 0.0});
  return free_end(u, inner, outer, face.table->data(), element.table.data(), cache);
}

Numbers surface_displacement(View places, const Grid& grid, const State& state, const Kernel& kernel) {
  const double* table = kernel.element->table.data();
  Numbers displacement(places.size());
  Squares cache;
  for (Index j = 0; j < grid.count(); ++j) {
    if (!(state.m[j] > 0.0)) continue;
    const double a = std::sqrt(state.m[j]), inverse = 1.0 / a, q = state.r[j] * state.m[j];
    const double own = by_own_width(grid.by_width, j, a)[0];
    for (Index i = 0; i < count_of(places); ++i) {
      const bool at_end = j == grid.count() - 1 && places[i] == grid.high(j);
      double seen = at_end || (grid.low(j) <= places[i] && places[i] < grid.high(j)) ? own : 0.0;
      for (const Term& term : kernel.terms) {
        const double offset = term.offset - places[i];
        const double upper = evaluate((term.sign * grid.high(j) + offset) * inverse, table).a();
        const double lower = evaluate((term.sign * grid.low(j) + offset) * inverse, table).a();
        seen += term.sign * term.weight * (upper - lower);
      }
      for (const Face& face : kernel.faces)
        seen += face.weight *
                face_influence(places[i], grid.low(j), grid.high(j), inverse, face, *kernel.element, cache).a();
      displacement[i] += q * seen;
    }
  }
  return displacement;
}

}  // namespace nonhertz
