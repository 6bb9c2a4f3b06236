// Sums whose rounding does not grow with their length.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

/// The sum by halves, and of up to 128 numbers in eight strands: the order in which numpy adds.
inline double sum_of(View values) {
  const Index n = count_of(values);
  if (n < 8) {
    double total = 0.0;
    for (double value : values) total += value;
    return total;
  }
  if (n > 128) {
    const Index half = n / 2 - n / 2 % 8;
    return sum_of(values.first(half)) + sum_of(values.subspan(half));
  }
  double strands[8];
  for (Index k = 0; k < 8; ++k) strands[k] = values[k];
  Index i = 8;
  for (; i + 8 <= n; i += 8)
    for (Index k = 0; k < 8; ++k) strands[k] += values[i + k];
  double total =
      ((strands[0] + strands[1]) + (strands[2] + strands[3])) + ((strands[4] + strands[5]) + (strands[6] + strands[7]));
  for (; i < n; ++i) total += values[i];
  return total;
}

}  // namespace nonhertz
