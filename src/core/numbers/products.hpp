// Sums of products in a fixed order, vectorised by hand: a compiler must not reorder them itself.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

/// Add the products of rows and a vector to sums, each in order, four at a time so that no sum waits for itself.
template <class RowOf>
void add_products(RowOf row_of, View x, Row sums) {
  const Index n = count_of(x), count = count_of(sums);
  Index i = 0;
  for (; i + 4 <= count; i += 4) {
    const double *a = row_of(i), *b = row_of(i + 1), *c = row_of(i + 2), *d = row_of(i + 3);
    double of_a = sums[i], of_b = sums[i + 1], of_c = sums[i + 2], of_d = sums[i + 3];
    for (Index j = 0; j < n; ++j) of_a += a[j] * x[j], of_b += b[j] * x[j], of_c += c[j] * x[j], of_d += d[j] * x[j];
    sums[i] = of_a, sums[i + 1] = of_b, sums[i + 2] = of_c, sums[i + 3] = of_d;
  }
  for (; i < count; ++i) {
    const double* row = row_of(i);
    for (Index j = 0; j < n; ++j) sums[i] += row[j] * x[j];
  }
}

}  // namespace nonhertz
