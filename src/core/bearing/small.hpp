// Vectors and matrices of three motions of a roller and five of a ring, by value.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "numbers/array.hpp"

namespace nonhertz {

template <std::size_t N>
using Vector = std::array<double, N>;
template <std::size_t Rows, std::size_t Columns>
using Small = std::array<std::array<double, Columns>, Rows>;

template <std::size_t Rows, std::size_t Inner, std::size_t Columns>
Small<Rows, Columns> product(const Small<Rows, Inner>& left, const Small<Inner, Columns>& right) {
  Small<Rows, Columns> result{};
  for (std::size_t a = 0; a < Rows; ++a)
    for (std::size_t b = 0; b < Columns; ++b)
      for (std::size_t k = 0; k < Inner; ++k) result[a][b] += left[a][k] * right[k][b];
  return result;
}

template <std::size_t Rows, std::size_t Inner>
Vector<Rows> product(const Small<Rows, Inner>& left, const Vector<Inner>& right) {
  Vector<Rows> result{};
  for (std::size_t a = 0; a < Rows; ++a)
    for (std::size_t k = 0; k < Inner; ++k) result[a] += left[a][k] * right[k];
  return result;
}

template <std::size_t N>
Small<N, 1> column(const Vector<N>& values) {
  Small<N, 1> result;
  for (std::size_t a = 0; a < N; ++a) result[a][0] = values[a];
  return result;
}

template <std::size_t N>
Vector<N> times(double factor, Vector<N> values) {
  for (double& value : values) value *= factor;
  return values;
}

/// Solve linear equations by elimination, and return the solutions; motions without stiffness remain zero.
///
/// Scales are the lengths that make motions comparable. Stiffness is positive definite and nearly symmetric: pivoting
/// is not needed.
template <std::size_t N, std::size_t Sides>
Small<N, Sides> eliminate(Small<N, N> matrix, Small<N, Sides> right, const Vector<N>& scale) {
  constexpr double RIDGE = 1e-13;  // of the stiffness, for motions without stiffness
  double size = 0.0;
  for (std::size_t a = 0; a < N; ++a) size = std::max(size, std::abs(matrix[a][a]) / (scale[a] * scale[a]));
  for (std::size_t a = 0; a < N; ++a) matrix[a][a] += (size > 0.0 ? RIDGE * size : 1.0) * (scale[a] * scale[a]);
  for (std::size_t k = 0; k < N; ++k)
    for (std::size_t a = k + 1; a < N; ++a) {
      const double part = matrix[a][k] / matrix[k][k];
      for (std::size_t b = k + 1; b < N; ++b) matrix[a][b] -= part * matrix[k][b];
      for (std::size_t s = 0; s < Sides; ++s) right[a][s] -= part * right[k][s];
    }
  for (std::size_t k = N; k-- > 0;) {
    for (std::size_t a = k + 1; a < N; ++a)
      for (std::size_t s = 0; s < Sides; ++s) right[k][s] -= matrix[k][a] * right[a][s];
    for (std::size_t s = 0; s < Sides; ++s) right[k][s] /= matrix[k][k];
  }
  return right;
}

}  // namespace nonhertz
