#include "strips/free_end.hpp"

#include <algorithm>

namespace nonhertz {
namespace {

constexpr double CLOSE = 1.0 / (1 << -FIRST_OCTAVE), TINY = 1e-300;
constexpr double LOGARITHMIC = 16.0 * CLOSE;  // both distances up to this count as close to the edge
constexpr std::array<int, POWERS + 1> DIRECTION_DEGREES{20, 16, 12, 10, 8, 8};

// Offsets of the parts of the table.
constexpr Index SQUARE = 4 * (SQUARE_DEGREE + 1) * (SQUARE_DEGREE + 1);
constexpr Index FAR_AT = OCTAVES * OCTAVES * SQUARE;
constexpr Index POLYNOMIALS = 20 + 16 + 12 + 10 + 8 + 8 + POWERS + 1;
constexpr Index BEYOND_AT = FAR_AT + POLYNOMIALS;
constexpr Index WHOLE_AT = BEYOND_AT + POLYNOMIALS;
constexpr Index LOGARITHM_AT = WHOLE_AT + POWERS + 1;
constexpr Index SLOPES_AT = WHOLE_AT + POWERS + 2;

struct Octave {
  Index number;
  double place;  // from -1 to 1
};

Octave octave_of(double size) {
  const auto bits = std::bit_cast<std::uint64_t>(size);
  const auto number = (bits >> 52) - std::uint64_t{1023 + FIRST_OCTAVE};
  if (number >= std::uint64_t{OCTAVES}) return {OCTAVES - 1, 1.0};
  constexpr auto ONE = std::uint64_t{1} << 52;
  const double place = static_cast<double>(static_cast<std::int64_t>(bits & (ONE - 1)));
  return {static_cast<Index>(number), place * (2.0 / ONE) - 1.0};
}

/// The four functions within the table.
Four square(double u, double v, const double* table, Square& cache) {
  const auto [row, x] = octave_of(u);
  const auto [column, z] = octave_of(v);
  const Index at = (row * OCTAVES + column) * SQUARE;
  if (cache.of != table + at || cache.v != z) {
    cache.of = table + at, cache.v = z;
    for (int power = 0; power <= SQUARE_DEGREE; ++power)
      cache.polynomials[power] = polynomials(table + at + 4 * (SQUARE_DEGREE + 1) * power, SQUARE_DEGREE + 1, z);
  }
  Four s;
  for (const Four& polynomial : cache.polynomials) s = x * s + polynomial;
  return s;
}

double far_term(double u, double v, int k, Index at, const double* table) {
  const bool counts_on = u < v;
  const double* c = table + (counts_on ? BEYOND_AT : FAR_AT) + at;
  const double larger = std::max({u, v, TINY}), x = 2.0 * std::min(u, v) / larger - 1.0, w = 1.0 / (larger * larger);
  double total = 0.0;
  for (int i = 0; i <= DIRECTION_DEGREES[k]; ++i) total = total * x + c[i];
  for (int i = 0; i < k; ++i) total *= w;
  if (!counts_on) return total;
  return k == 0 ? -total + table[LOGARITHM_AT] * std::log(v) : -total;
}

/// The far-field correction.
Four series(double u, double inner, double outer, const double* table, const double* element) {
  Four s;
  Index at = 0;
  for (int k = 0; k <= POWERS; ++k) {
    double part = far_term(u, outer, k, at, table) - far_term(u, inner, k, at, table);
    if (inner <= u && u < outer) part += far_whole(u, k, table);
    if (k == 0) {
      s = {part, 0.0, 0.0, 0.0};
    } else {
      const double of_a = part * element[POWERS_AT + 2 * k - 2], of_b = part * element[POWERS_AT + 2 * k - 1];
      s += {of_a, -2.0 * k * of_a, of_b, -2.0 * k * of_b};
    }
    at += DIRECTION_DEGREES[k] + 1;
  }
  return s;
}

/// H, (u d/du + v d/dv) H, C and (u d/du + v d/dv) C, for v within the table.
Four up_to(double u, double v, const double* table, const double* element, Square& cache) {
  if (v <= 0.0) return {};
  if (u >= AWAY) return series(u, 0.0, v, table, element);
  // Close to the edge h and c vary only with the logarithm of the distance.
  const double scale = std::max(1.0, std::min(CLOSE / std::max(std::min(u, v), TINY), LOGARITHMIC / std::max(u, v)));
  const double place = std::max(scale * u, CLOSE), edge = scale * v;
  const double share = std::min(edge / CLOSE, 1.0) / scale;
  const Four s = square(place, std::max(edge, CLOSE), table, cache);
  const double grown = v * std::log(scale), h = table[SLOPES_AT] * grown, c = table[SLOPES_AT + 1] * grown;
  return share * s + Four(h, h, c, c);
}

/// The polynomials of some places, the k-th multiplied by w^k; c: start of their coefficients.
///
/// Also evaluated beyond the last place, up to the end of a tile, for which there is room.
void far_polynomials(const Matrix& work, Index begin, Index end, double sign, const double* c, Matrix& terms) {
  constexpr int PACKS = TILE / WIDTH;
  for (Index first = begin; first < end; first += TILE) {
    Pack place[PACKS], weight[PACKS];
    for (int p = 0; p < PACKS; ++p) {
      place[p] = load(&work[0][first + WIDTH * p]);
      weight[p] = load(&work[1][first + WIDTH * p]);
    }
    const double* coefficients = c;
    for (int k = 0; k <= POWERS; ++k) {
      Pack total[PACKS] = {};
      for (int i = 0; i <= DIRECTION_DEGREES[k]; ++i) {
        const double coefficient = sign * *coefficients++;
#pragma GCC unroll 8
        for (int p = 0; p < PACKS; ++p) total[p] = total[p] * place[p] + coefficient;
      }
      for (int i = 0; i < k; ++i)
#pragma GCC unroll 8
        for (int p = 0; p < PACKS; ++p) total[p] *= weight[p];
      for (int p = 0; p < PACKS; ++p) store(&terms[k][first + WIDTH * p], total[p]);
    }
  }
}

}  // namespace

Four free_end(double u, double inner, double outer, const double* table, const double* element, Squares& cache) {
  if (u + inner >= AWAY) return series(u, inner, outer, table, element);
  // The rest is beyond the table, in the far field.
  const double last = std::max(std::min(outer, AWAY), inner);
  const Four low = up_to(u, inner, table, element, cache[0]), high = up_to(u, last, table, element, cache[1]);
  return outer > last ? high - low + series(u, last, outer, table, element) : high - low;
}

double far_whole(double u, int k, const double* table) {
  if (k == 0) return table[WHOLE_AT] - table[LOGARITHM_AT] * std::log(u);
  return table[WHOLE_AT + k] * std::pow(u, -2.0 * k);
}

void far_terms(View u, double v, const double* table, Matrix& terms, Matrix& work) {
  const Index n = count_of(u);
  Row x = work[0], w = work[1];
  for (Index i = 0; i < n; ++i) {
    const double larger = std::max({u[i], v, TINY});
    x[i] = 2.0 * std::min(u[i], v) / larger - 1.0, w[i] = 1.0 / (larger * larger);
  }
  std::fill(x.begin() + n, x.end(), 0.0);
  std::fill(w.begin() + n, w.end(), 0.0);
  // Places from begin to before end are integrated from infinity.
  Index begin = 0, end = 0;
  while (end < n && u[end] < v) ++end;
  if (end == 0) {
    begin = end = n;
    while (begin > 0 && u[begin - 1] < v) --begin;
  }
  far_polynomials(work, 0, begin, 1.0, table + FAR_AT, terms);
  far_polynomials(work, begin, end, -1.0, table + BEYOND_AT, terms);
  far_polynomials(work, end, n, 1.0, table + FAR_AT, terms);
  const double grown = begin < end ? table[LOGARITHM_AT] * std::log(v) : 0.0;
  for (Index i = begin; i < end; ++i) terms(0, i) += grown;
}

}  // namespace nonhertz
