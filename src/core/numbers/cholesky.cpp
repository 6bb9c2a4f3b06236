#include "numbers/cholesky.hpp"

#include <algorithm>
#include <cmath>

#include "numbers/pack.hpp"

namespace nonhertz {
namespace {

constexpr Index DEEP = 32;          // columns eliminated at a time
constexpr int TALL = 4, BROAD = 8;  // numbers of a tile, which stays in registers

constexpr Index whole(Index count) { return (count + BROAD - 1) / BROAD * BROAD; }

/// Subtract the product of columns i and j of `panel`, `depth` rows, from the tile at (i, j).
void subtract_tile(double* tile, Index stride, const Matrix& panel, Index depth, Index i, Index j) {
  constexpr int PACKS = BROAD / WIDTH;
  Pack sum[TALL][PACKS] = {};
  for (Index k = 0; k < depth; ++k) {
    const double* row = panel[k].data();
#pragma GCC unroll 8
    for (int c = 0; c < PACKS; ++c) {
      const Pack right = load(row + j + WIDTH * c);
#pragma GCC unroll 4
      for (int t = 0; t < TALL; ++t) sum[t][c] += row[i + t] * right;
    }
  }
#pragma GCC unroll 4
  for (int t = 0; t < TALL; ++t)
#pragma GCC unroll 8
    for (int c = 0; c < PACKS; ++c) {
      double* to = tile + t * stride + WIDTH * c;
      store(to, load(to) - sum[t][c]);
    }
}

}  // namespace

void Front::reset(Index size) {
  size_ = size;
  values_.resize(whole(size), whole(size));
  panel_.resize(DEEP, whole(size));
  std::fill(values_.all().begin(), values_.all().end(), 0.0);
}

void Front::hold(Index unknown) {
  for (Index j = 0; j < unknown; ++j) values_(unknown, j) = 0.0;
  for (Index i = unknown + 1; i < size_; ++i) values_(i, unknown) = 0.0;
  values_(unknown, unknown) = 1.0;
}

void Front::eliminate(Index count) {
  for (Index first = 0; first < count; first += DEEP) {
    const Index depth = std::min(DEEP, count - first), beyond = first + depth;
    factor(first, depth);
    // Whole tiles from a multiple of their width on: columns before `beyond` are factors, and are restored afterwards.
    const Index start = beyond / BROAD * BROAD, rows = values_.rows();
    for (Index i = start; i < rows; i += TALL)
      for (Index j = start; j < i + TALL; j += BROAD)
        subtract_tile(&values_(i, j), values_.columns(), panel_, depth, i, j);
    for (Index k = 0; k < depth; ++k)
      for (Index i = first + k; i < size_; ++i) values_(i, first + k) = panel_(k, i);
  }
}

/// Fill in the panel with `count` columns of the factor, zero before their diagonal.
void Front::factor(Index first, Index count) {
  const Index rows = values_.rows();
  for (Index k = 0; k < count; ++k) {
    std::fill_n(panel_[k].data(), first + k, 0.0);
    for (Index i = first + k; i < rows; ++i) panel_(k, i) = values_(i, first + k);
  }
  for (Index k = 0; k < count; ++k) {
    double* __restrict column = panel_[k].data();
    for (Index other = 0; other < k; ++other) {
      const double* __restrict before = panel_[other].data();
      const double factor = before[first + k];
      for (Index i = first + k; i < rows; ++i) column[i] -= factor * before[i];
    }
    const double inverse = 1.0 / std::sqrt(column[first + k]);
    for (Index i = first + k; i < rows; ++i) column[i] *= inverse;
  }
}

}  // namespace nonhertz
