#include "numbers/dense.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nonhertz {
namespace {

constexpr Index TALL = 4;  // rows processed at once, for which another row is loaded only once

/// Add `sign` times columns of `a`, from the first up to `end`, times rows of `b` to rows of `out` from `row` on.
template <Index rows>
void add_products(const Matrix& a, Index first, Index end, const Matrix& b, double sign, Index row, Matrix& out) {
  for (Index k = first; k < end; ++k) {
    double factor[rows];
    for (Index t = 0; t < rows; ++t) factor[t] = sign * a(row + t, k);
    const double* __restrict other = b[k].data();
    double* __restrict to[rows];
    for (Index t = 0; t < rows; ++t) to[t] = out[row + t].data();
    for (Index j = 0; j < b.columns(); ++j)
      for (Index t = 0; t < rows; ++t) to[t][j] += factor[t] * other[j];
  }
}

/// The same for all rows before `last`.
void add_all_products(const Matrix& a, Index first, Index end, const Matrix& b, double sign, Index row, Index last,
                      Matrix& out) {
  for (; row + TALL <= last; row += TALL) add_products<TALL>(a, first, end, b, sign, row, out);
  for (; row < last; ++row) add_products<1>(a, first, end, b, sign, row, out);
}

}  // namespace

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix out(a.rows(), b.columns());
  std::fill(out.all().begin(), out.all().end(), 0.0);
  add_all_products(a, 0, a.columns(), b, 1.0, 0, a.rows(), out);
  return out;
}

Matrix solve_dense(Matrix a, Matrix b) {
  const Index n = a.rows();
  // The factors of elimination replace the entries that they eliminate.
  for (Index k = 0; k < n; ++k) {
    Index pivot = k;
    for (Index i = k + 1; i < n; ++i)
      if (std::fabs(a(i, k)) > std::fabs(a(pivot, k))) pivot = i;
    if (pivot != k) {
      std::swap_ranges(a[k].begin(), a[k].end(), a[pivot].begin());
      std::swap_ranges(b[k].begin(), b[k].end(), b[pivot].begin());
    }
    const double inverse = 1.0 / a(k, k);
    for (Index i = k + 1; i < n; ++i) {
      const double factor = a(i, k) *= inverse;
      const double* __restrict other = a[k].data();
      double* __restrict row = a[i].data();
      for (Index j = k + 1; j < n; ++j) row[j] -= factor * other[j];
    }
  }
  for (Index first = 0; first < n; first += TALL) {
    const Index last = std::min(first + TALL, n);
    add_all_products(a, 0, first, b, -1.0, first, last, b);
    for (Index i = first + 1; i < last; ++i) add_products<1>(a, first, i, b, -1.0, i, b);
  }
  for (Index last = n; last > 0; last -= std::min(TALL, last)) {
    const Index first = std::max(last - TALL, Index{0});
    add_all_products(a, last, n, b, -1.0, first, last, b);
    for (Index i = last - 1; i >= first; --i) {
      add_products<1>(a, i + 1, last, b, -1.0, i, b);
      const double inverse = 1.0 / a(i, i);
      for (double& value : b[i]) value *= inverse;
    }
  }
  return b;
}

}  // namespace nonhertz
