// Arrays of numpy as spans of the core, and the other way round.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <algorithm>
#include <array>
#include <functional>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <vector>

#include "numbers/array.hpp"

namespace nonhertz {

namespace nb = nanobind;
using namespace nb::literals;

/// Arrays that Python passes: in C order, read only.
template <class Scalar>
using ArrayIn = nb::ndarray<const Scalar, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using VectorIn = ArrayIn<double>;
using MatrixIn = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;
using VectorOut = nb::ndarray<nb::numpy, const double, nb::ndim<1>>;
using MatrixOut = nb::ndarray<nb::numpy, const double, nb::ndim<2>>;

using Flags = std::array<bool, 2>;  // whether load and moment are prescribed, not approach and tilt
using Released = nb::call_guard<nb::gil_scoped_release>;

/// Numbers as an array that cannot be written to and keeps their owner.
inline VectorOut view_of(View values, nb::handle owner) { return VectorOut(values.data(), {values.size()}, owner); }

/// Values as an array of some shape that owns them.
template <class Scalar, std::size_t N>
auto array_of(std::vector<Scalar> values, const std::array<std::size_t, N>& shape) {
  auto owned = std::make_unique<std::vector<Scalar>>(std::move(values));
  const Scalar* data = owned->data();
  nb::capsule owner(owned.release(), [](void* p) noexcept { delete static_cast<std::vector<Scalar>*>(p); });
  return nb::ndarray<nb::numpy, const Scalar, nb::ndim<N>>(data, N, shape.data(), owner);
}

template <class Scalar>
using WritableOf = nb::ndarray<nb::numpy, Scalar>;
using Writable = WritableOf<double>;

/// Values as an array of a shape that owns them, and may be written to.
template <class Scalar>
WritableOf<Scalar> writable(std::vector<Scalar> values, std::initializer_list<std::size_t> shape) {
  auto owned = std::make_unique<std::vector<Scalar>>(std::move(values));
  Scalar* data = owned->data();
  nb::capsule owner(owned.release(), [](void* p) noexcept { delete static_cast<std::vector<Scalar>*>(p); });
  return WritableOf<Scalar>(data, shape, owner);
}

/// Rows of so many numbers as values of a type that consists of as many.
template <class Value>
std::vector<Value> rows_of(const Matrix& matrix) {
  constexpr Index SIZE = sizeof(Value) / sizeof(double);
  if (matrix.columns() != SIZE) throw std::invalid_argument("array must have as many columns as a value has numbers");
  std::vector<Value> rows(static_cast<std::size_t>(matrix.rows()));
  std::copy_n(matrix.all().data(), matrix.all().size(), reinterpret_cast<double*>(rows.data()));
  return rows;
}

/// A property that is a view of numbers of its owner.
template <class Owner, class Of>
void view_property(nb::class_<Owner>& owner, const char* name, Of of) {
  owner.def_prop_ro(
      name, [of](nb::handle self) { return view_of(std::invoke(of, nb::cast<const Owner&>(self)), self); },
      nb::rv_policy::reference);
}

}  // namespace nonhertz

// What functions of the core take and return: views of arrays, and copies of them.
namespace nanobind::detail {

template <>
struct type_caster<nonhertz::View> {
  using Array = make_caster<nonhertz::VectorIn>;
  template <typename>
  using Cast = nonhertz::View;
  static constexpr auto Name = Array::Name;
  Array array;

  bool from_python(handle source, auto flags, cleanup_list* cleanup) noexcept {
    return array.from_python(source, flags, cleanup);
  }
  template <typename>
  static constexpr bool can_cast() {
    return true;
  }
  operator nonhertz::View() { return {array.value.data(), array.value.size()}; }
};

template <class Scalar>
struct vector_caster {
  using Array = make_caster<nonhertz::ArrayIn<Scalar>>;
  NB_TYPE_CASTER(std::vector<Scalar>, Array::Name)

  bool from_python(handle source, auto flags, cleanup_list* cleanup) noexcept {
    Array array;
    if (!array.from_python(source, flags, cleanup)) return false;
    value.assign(array.value.data(), array.value.data() + array.value.size());
    return true;
  }
  static handle from_cpp(std::vector<Scalar> values, rv_policy, cleanup_list* cleanup) noexcept {
    const std::array shape{values.size()};
    const auto array = nonhertz::array_of(std::move(values), shape);
    return make_caster<decltype(array)>::from_cpp(array, rv_policy::automatic, cleanup);
  }
};

template <>
struct type_caster<nonhertz::Numbers> : vector_caster<double> {};
template <>
struct type_caster<std::vector<nonhertz::Index>> : vector_caster<nonhertz::Index> {};

template <>
struct type_caster<nonhertz::Matrix> {
  using Array = make_caster<nonhertz::MatrixIn>;
  NB_TYPE_CASTER(nonhertz::Matrix, Array::Name)

  bool from_python(handle source, auto flags, cleanup_list* cleanup) noexcept {
    Array array;
    if (!array.from_python(source, flags, cleanup)) return false;
    value.resize(static_cast<nonhertz::Index>(array.value.shape(0)),
                 static_cast<nonhertz::Index>(array.value.shape(1)));
    std::copy_n(array.value.data(), array.value.size(), value.all().begin());
    return true;
  }
  static handle from_cpp(nonhertz::Matrix values, rv_policy, cleanup_list* cleanup) noexcept {
    auto owned = std::make_unique<nonhertz::Matrix>(std::move(values));
    const double* data = owned->all().data();
    const auto rows = static_cast<std::size_t>(owned->rows()), columns = static_cast<std::size_t>(owned->columns());
    capsule owner(owned.release(), [](void* p) noexcept { delete static_cast<nonhertz::Matrix*>(p); });
    return make_caster<nonhertz::MatrixOut>::from_cpp(nonhertz::MatrixOut(data, {rows, columns}, owner),
                                                      rv_policy::automatic, cleanup);
  }
};

}  // namespace nanobind::detail
