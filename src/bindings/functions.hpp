// Functions written in Python that the core calls, from any thread.
#pragma once

#include "bindings/arrays.hpp"
#include "bodies/relief.hpp"

namespace nonhertz {

/// A Python object that is let go of with the interpreter's lock, wherever that happens.
struct Held {
  nb::callable of;

  explicit Held(nb::callable function) : of(std::move(function)) {}
  Held(const Held&) = delete;
  ~Held() {
    const nb::gil_scoped_acquire lock;
    of.release().dec_ref();
  }
};

/// A function of whole arrays.
using FunctionIn = nb::typed<nb::callable, VectorOut(VectorOut)>;

/// The same for the core, called with the interpreter's lock from any thread.
inline Function function(FunctionIn of) {
  return [held = std::make_shared<const Held>(std::move(of))](View y, Row out) {
    const nb::gil_scoped_acquire lock;
    const nb::ndarray<nb::numpy, const double, nb::ndim<1>> places(y.data(), {y.size()});
    const auto values = nb::cast<VectorIn>(held->of(nb::cast(places, nb::rv_policy::copy)));
    if (values.size() != y.size()) throw std::invalid_argument("a function must return as many numbers as it gets");
    std::copy_n(values.data(), values.size(), out.begin());
  };
}

/// A function of places and edges, which returns a matrix of all by all strips.
using MatrixFunctionIn = nb::typed<nb::callable, MatrixOut(VectorOut, VectorOut)>;

inline std::function<Matrix(View, View)> matrix_function(MatrixFunctionIn of) {
  return [held = std::make_shared<const Held>(std::move(of))](View y, View edges) {
    const nb::gil_scoped_acquire lock;
    const auto copied = [](View values) { return array_of(Numbers(values.begin(), values.end())); };
    const auto values = nb::cast<MatrixIn>(held->of(copied(y), copied(edges)));
    if (values.shape(0) != y.size() || values.shape(1) + 1 != edges.size())
      throw std::invalid_argument("a displacement must have a row for each place and a column for each strip");
    return copy_of(values);
  };
}

inline Polyline polyline(const VectorIn& places, const VectorIn& values) { return {numbers(places), numbers(values)}; }

}  // namespace nonhertz
