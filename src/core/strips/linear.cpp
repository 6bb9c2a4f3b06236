#include "strips/linear.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numbers/pack.hpp"

namespace nonhertz {
namespace {

constexpr Index DEEP = 256;  // columns of a product added up at a time, whose rows stay in the cache

/// Rows of numbers `stride` apart.
template <class T>
struct Block {
  T* at;
  Index stride;

  Block shifted(Index rows, Index columns) const { return {at + rows * stride + columns, stride}; }
};

/// Subtract the product of `left` (depth columns) and `right` (depth rows) from one tile of PACKS packs across.
template <int PACKS>
inline void subtract_tile(Block<double> result, Block<const double> left, Block<const double> right, Index depth) {
  Pack sum[TALL][PACKS] = {};  // stays in registers once the loops over it are unrolled
  for (Index k = 0; k < depth; ++k)
#pragma GCC unroll 8
    for (int c = 0; c < PACKS; ++c) {
      const Pack row = load(right.at + k * right.stride + WIDTH * c);
#pragma GCC unroll 4
      for (int t = 0; t < TALL; ++t) sum[t][c] += left.at[t * left.stride + k] * row;
    }
#pragma GCC unroll 4
  for (int t = 0; t < TALL; ++t)
#pragma GCC unroll 8
    for (int c = 0; c < PACKS; ++c) {
      double* to = result.at + t * result.stride + WIDTH * c;
      store(to, load(to) - sum[t][c]);
    }
}

/// The same for rows x columns numbers, both whole tiles.
void subtract_tiles(Block<double> result, Block<const double> left, Block<const double> right, Index rows,
                    Index columns, Index depth) {
  for (Index i = 0; i < rows; i += TALL) {
    Index j = 0;
    for (; j + BLOCK <= columns; j += BLOCK)
      subtract_tile<BLOCK / WIDTH>(result.shifted(i, j), left.shifted(i, 0), right.shifted(0, j), depth);
    if (j < columns) subtract_tile<TALL / WIDTH>(result.shifted(i, j), left.shifted(i, 0), right.shifted(0, j), depth);
  }
}

/// Solve for some rows whose factors are below (`Lower`) or above the diagonal, in registers: columns are many.
template <int ROWS, bool Lower>
void substitute(Block<double> rows, Block<const double> matrix, Index columns) {
  double factor[ROWS][ROWS], inverse[ROWS];
  for (int k = 0; k < ROWS; ++k) {
    for (int other = 0; other < ROWS; ++other) factor[k][other] = matrix.at[k * matrix.stride + other];
    inverse[k] = 1.0 / factor[k][k];
  }
  for (Index j = 0; j < columns; j += WIDTH) {
    Pack x[ROWS];
#pragma GCC unroll 8
    for (int k = 0; k < ROWS; ++k) x[k] = load(rows.at + k * rows.stride + j);
#pragma GCC unroll 8
    for (int step = 0; step < ROWS; ++step) {
      const int k = Lower ? step : ROWS - 1 - step;
#pragma GCC unroll 8
      for (int other = Lower ? 0 : k + 1; other < (Lower ? k : ROWS); ++other) x[k] -= factor[k][other] * x[other];
      if (!Lower) x[k] *= inverse[k];
    }
#pragma GCC unroll 8
    for (int k = 0; k < ROWS; ++k) store(rows.at + k * rows.stride + j, x[k]);
  }
}

template <bool Lower>
void substitute(Block<double> rows, Block<const double> matrix, Index columns, Index width) {
  if (width == BLOCK)
    substitute<BLOCK, Lower>(rows, matrix, columns);
  else
    substitute<TALL, Lower>(rows, matrix, columns);
}

void subtract(double* __restrict row, const double* __restrict other, double factor, Index count) {
  for (Index j = 0; j < count; ++j) row[j] -= factor * other[j];
}

void scale(double* row, double factor, Index count) {
  for (Index j = 0; j < count; ++j) row[j] *= factor;
}

inline Pack larger(Pack one, Pack other) { return one > other ? one : other; }

/// The first of the largest in magnitude from `first` on, unless all are zero.
Index largest_of(const double* values, Index first, Index end) {
  Pack most = {};
  Index i = first;
  for (; i + WIDTH <= end; i += WIDTH) {
    const Pack x = load(values + i);
    most = larger(larger(x, -x), most);
  }
  double largest = 0.0;
  for (int k = 0; k < WIDTH; ++k) largest = std::max(largest, most[k]);
  for (; i < end; ++i) largest = std::max(largest, std::fabs(values[i]));
  for (i = first; i < end; ++i)
    if (std::fabs(values[i]) == largest) return i;
  return first;
}

}  // namespace

void System::reset(Index unknowns, Index sides) {
  const Index n = padded_size(unknowns);
  values_.resize(n, n + padded_size(sides));
  panel_.resize(BLOCK, n);
  for (Index i = 0; i < n; ++i) {
    const Row row = values_[i];
    std::fill(row.begin() + (i < unknowns ? unknowns : 0), row.begin() + n, 0.0);
    std::fill(row.begin() + n + (i < unknowns ? sides : 0), row.end(), 0.0);
    if (i >= unknowns) row[i] = 1.0;
  }
}

void System::solve() {
  const Index n = values_.rows(), columns = values_.columns();
  const auto at = [&](Index i, Index j) { return Block<double>{&values_(0, 0) + i * columns + j, columns}; };
  const auto from = [&](Index i, Index j) { return Block<const double>{at(i, j).at, columns}; };
  for (Index first = 0; first < n; first += BLOCK) {
    const Index width = std::min(BLOCK, n - first), beyond = first + width;
    pivot(first, width);
    substitute<true>(at(first, beyond), from(first, first), columns - beyond, width);
    subtract_tiles(at(beyond, beyond), from(beyond, first), from(first, beyond), n - beyond, columns - beyond, width);
  }
  for (Index first = (n - 1) / BLOCK * BLOCK; first >= 0; first -= BLOCK) {
    const Index width = std::min(BLOCK, n - first);
    substitute<false>(at(first, n), from(first, first), columns - n, width);
    subtract_tiles(at(0, n), from(0, first), from(first, n), first, columns - n, width);
  }
}

/// Eliminate within one block of columns, leaving the factors below the diagonal.
void System::pivot(Index first, Index width) {
  const Index n = values_.rows();
  for (Index i = first; i < n; ++i)
    for (Index c = 0; c < width; ++c) panel_(c, i) = values_(i, first + c);
  for (Index c = 0; c < width; ++c) {
    const Index k = first + c;
    double* column = panel_[c].data();
    const Index largest = largest_of(column, k, n);
    if (largest != k) {
      std::swap_ranges(&values_(k, first), values_[k].data() + values_.columns(), &values_(largest, first));
      for (Index other = 0; other < width; ++other) std::swap(panel_(other, k), panel_(other, largest));
    }
    scale(column + k + 1, 1.0 / column[k], n - k - 1);
    for (Index other = c + 1; other < width; ++other)
      subtract(panel_[other].data() + k + 1, column + k + 1, panel_(other, k), n - k - 1);
  }
  for (Index i = first; i < n; ++i)
    for (Index c = 0; c < width; ++c) values_(i, first + c) = panel_(c, i);
}

void System::subtract_product(const Matrix& left, const System& right) {
  const Index n = values_.rows(), width = values_.columns(), other = right.values_.columns();
  for (Index first = 0; first < n; first += DEEP)
    subtract_tiles({&values_(0, 0), width}, {&left.all()[first], left.columns()},
                   {&right.values_.all()[first * other + n], other}, n, n, std::min(DEEP, n - first));
}

}  // namespace nonhertz
