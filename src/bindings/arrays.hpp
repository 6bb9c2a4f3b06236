// Arrays of numpy as spans of the core, and the other way round.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <algorithm>
#include <array>
#include <memory>

#include "numbers/array.hpp"

namespace nonhertz {

namespace nb = nanobind;
using namespace nb::literals;

/// Arrays that Python passes: of doubles, in C order, read only.
using VectorIn = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using MatrixIn = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using VectorOut = nb::ndarray<nb::numpy, const double, nb::ndim<1>>;
using MatrixOut = nb::ndarray<nb::numpy, const double, nb::ndim<2>>;

inline View view(const VectorIn& array) { return {array.data(), array.size()}; }
inline Numbers numbers(const VectorIn& array) { return {array.data(), array.data() + array.size()}; }

inline Matrix copy_of(const MatrixIn& array) {
  Matrix copy(static_cast<Index>(array.shape(0)), static_cast<Index>(array.shape(1)));
  std::copy_n(array.data(), array.size(), copy.all().begin());
  return copy;
}

inline std::shared_ptr<const Matrix> matrix(const MatrixIn& array) {
  return std::make_shared<const Matrix>(copy_of(array));
}

/// Numbers as an array that cannot be written to and keeps their owner.
inline VectorOut view_of(View values, nb::handle owner) { return VectorOut(values.data(), {values.size()}, owner); }

/// Numbers as an array of some shape that owns them.
template <std::size_t N>
auto array_of(Numbers values, const std::array<std::size_t, N>& shape) {
  auto kept = std::make_unique<Numbers>(std::move(values));
  const double* data = kept->data();
  nb::capsule owner(kept.release(), [](void* p) noexcept { delete static_cast<Numbers*>(p); });
  return nb::ndarray<nb::numpy, const double, nb::ndim<N>>(data, N, shape.data(), owner);
}
inline VectorOut array_of(Numbers values) {
  const std::array shape{values.size()};
  return array_of(std::move(values), shape);
}

/// Rows and columns as an array that owns them.
inline MatrixOut matrix_of(Matrix values) {
  auto kept = std::make_unique<Matrix>(std::move(values));
  const double* data = kept->all().data();
  const auto rows = static_cast<std::size_t>(kept->rows()), columns = static_cast<std::size_t>(kept->columns());
  nb::capsule owner(kept.release(), [](void* p) noexcept { delete static_cast<Matrix*>(p); });
  return MatrixOut(data, {rows, columns}, owner);
}

}  // namespace nonhertz
