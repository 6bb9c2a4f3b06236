#include "strips/linear.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "numbers/pack.hpp"

namespace nonhertz {
namespace {

constexpr int TALL = 4;      // the height of a tile
constexpr Index DEEP = 256;  // columns of a product that are added up at a time, whose rows stay in the cache

/// Numbers in rows that are `stride` apart.
template <class T>
struct Block {
  T* at;
  Index stride;
};

/// Subtract the product of `left` (depth columns) and `right` (depth rows) from rows x columns numbers, whole tiles.
void subtract_tiles(Block<double> result, Block<const double> left, Block<const double> right, Index rows,
                    Index columns, Index depth) {
  constexpr int PACKS = BLOCK / WIDTH;
  for (Index i = 0; i < rows; i += TALL)
    for (Index j = 0; j < columns; j += BLOCK) {
      Pack sum[TALL][PACKS] = {};  // stays in registers once the loops over it are unrolled
      for (Index k = 0; k < depth; ++k)
#pragma GCC unroll 8
        for (int c = 0; c < PACKS; ++c) {
          const Pack row = load(right.at + k * right.stride + j + WIDTH * c);
#pragma GCC unroll 4
          for (int t = 0; t < TALL; ++t) sum[t][c] += left.at[(i + t) * left.stride + k] * row;
        }
#pragma GCC unroll 4
      for (int t = 0; t < TALL; ++t)
#pragma GCC unroll 8
        for (int c = 0; c < PACKS; ++c) {
          double* to = result.at + (i + t) * result.stride + j + WIDTH * c;
          store(to, load(to) - sum[t][c]);
        }
    }
}

void subtract(double* __restrict row, const double* __restrict other, double factor, Index count) {
  for (Index j = 0; j < count; ++j) row[j] -= factor * other[j];
}

void scale(double* row, double factor, Index count) {
  for (Index j = 0; j < count; ++j) row[j] *= factor;
}

}  // namespace

void System::reset(Index unknowns, Index sides) {
  const Index n = padded(unknowns);
  unknowns_ = unknowns;
  values_.resize(n, n + padded(sides));
  panel_.resize(BLOCK, n);
  std::fill(values_.all().begin(), values_.all().end(), 0.0);
  for (Index i = unknowns; i < n; ++i) values_(i, i) = 1.0;
}

void System::solve() {
  const Index n = values_.rows(), columns = values_.columns();
  const auto at = [this](Index i, Index j) { return &values_(i, j); };
  for (Index first = 0; first < n; first += BLOCK) {
    const Index beyond = first + BLOCK;
    pivot(first);
    for (Index k = first + 1; k < beyond; ++k)
      for (Index other = first; other < k; ++other)
        subtract(at(k, 0) + beyond, at(other, 0) + beyond, *at(k, other), columns - beyond);
    if (beyond < n)
      subtract_tiles({at(beyond, 0) + beyond, columns}, {at(beyond, first), columns}, {at(first, 0) + beyond, columns},
                     n - beyond, columns - beyond, BLOCK);
  }
  for (Index first = n - BLOCK; first >= 0; first -= BLOCK) {
    for (Index k = first + BLOCK - 1; k >= first; --k) {
      for (Index other = k + 1; other < first + BLOCK; ++other)
        subtract(at(k, n), at(other, n), *at(k, other), columns - n);
      scale(at(k, n), 1.0 / *at(k, k), columns - n);
    }
    subtract_tiles({at(0, n), columns}, {at(0, first), columns}, {at(first, n), columns}, first, columns - n, BLOCK);
  }
}

/// Eliminate within one block of columns, leaving the factors below the diagonal.
void System::pivot(Index first) {
  const Index n = values_.rows();
  for (Index i = first; i < n; ++i)
    for (Index c = 0; c < BLOCK; ++c) panel_(c, i) = values_(i, first + c);
  for (Index c = 0; c < BLOCK; ++c) {
    const Index k = first + c;
    double* column = panel_[c].data();
    Index largest = k;
    for (Index i = k + 1; i < n; ++i)
      if (std::fabs(column[i]) > std::fabs(column[largest])) largest = i;
    if (largest != k) {
      std::swap_ranges(&values_(k, first), values_[k].data() + values_.columns(), &values_(largest, first));
      for (Index other = 0; other < BLOCK; ++other) std::swap(panel_(other, k), panel_(other, largest));
    }
    scale(column + k + 1, 1.0 / column[k], n - k - 1);
    for (Index other = c + 1; other < BLOCK; ++other)
      subtract(panel_[other].data() + k + 1, column + k + 1, panel_(other, k), n - k - 1);
  }
  for (Index i = first; i < n; ++i)
    for (Index c = 0; c < BLOCK; ++c) values_(i, first + c) = panel_(c, i);
}

void System::subtract_product(const Matrix& left, const System& right) {
  const Index n = values_.rows(), width = values_.columns(), other = right.values_.columns();
  for (Index first = 0; first < n; first += DEEP)
    subtract_tiles({&values_(0, 0), width}, {&left.all()[first], left.columns()},
                   {&right.values_.all()[first * other + n], other}, n, n, std::min(DEEP, n - first));
}

}  // namespace nonhertz
