// Functions written in Python that the core calls, from any thread.
#pragma once

#include "bindings/arrays.hpp"
#include "bodies/reference.hpp"

namespace nonhertz {

/// A Python object that is let go of with the interpreter's lock, wherever that happens.
struct SharedCallable {
  nb::callable of;

  explicit SharedCallable(nb::callable function) : of(std::move(function)) {}
  SharedCallable(const SharedCallable&) = delete;
  ~SharedCallable() {
    const nb::gil_scoped_acquire lock;
    of.release().dec_ref();
  }
};

}  // namespace nonhertz

namespace nanobind::detail {

/// A function of whole arrays, called with the interpreter's lock from any thread.
template <>
struct type_caster<nonhertz::Function> {
  NB_TYPE_CASTER(nonhertz::Function, const_name("collections.abc.Callable[[") + make_caster<nonhertz::Numbers>::Name +
                                         const_name("], ") + make_caster<nonhertz::Numbers>::Name + const_name("]"))

  bool from_python(handle source, auto, cleanup_list*) noexcept {
    if (!isinstance<callable>(source)) return false;
    value = [function = std::make_shared<const nonhertz::SharedCallable>(borrow<callable>(source))](nonhertz::View y,
                                                                                                    nonhertz::Row out) {
      const gil_scoped_acquire lock;
      const auto values = cast<nonhertz::Numbers>(function->of(nonhertz::Numbers(y.begin(), y.end())));
      if (values.size() != y.size()) throw std::invalid_argument("a function must return as many numbers as it gets");
      std::copy(values.begin(), values.end(), out.begin());
    };
    return true;
  }
};

/// A function of places and edges, which returns a matrix of all by all strips.
template <>
struct type_caster<nonhertz::MatrixFunction> {
  using Vector = make_caster<nonhertz::Numbers>;
  NB_TYPE_CASTER(nonhertz::MatrixFunction, const_name("collections.abc.Callable[[") + Vector::Name + const_name(", ") +
                                               Vector::Name + const_name("], ") + make_caster<nonhertz::Matrix>::Name +
                                               const_name("]"))

  bool from_python(handle source, auto, cleanup_list*) noexcept {
    if (!isinstance<callable>(source)) return false;
    value = [function = std::make_shared<const nonhertz::SharedCallable>(borrow<callable>(source))](
                nonhertz::View y, nonhertz::View edges) {
      const gil_scoped_acquire lock;
      auto values = cast<nonhertz::Matrix>(
          function->of(nonhertz::Numbers(y.begin(), y.end()), nonhertz::Numbers(edges.begin(), edges.end())));
      if (values.rows() != nonhertz::count_of(y) || values.columns() + 1 != nonhertz::count_of(edges))
        throw std::invalid_argument("a displacement must have a row for each place and a column for each strip");
      return values;
    };
    return true;
  }
};

}  // namespace nanobind::detail
