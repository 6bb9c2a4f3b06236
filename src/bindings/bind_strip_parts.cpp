// Parts of the loop by themselves, as tests look at them.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>

#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"
#include "strips/newton.hpp"
#include "strips/start.hpp"

namespace nonhertz {
namespace {

System system_of(const Matrix& matrix, const Matrix& sides) {
  System system;
  system.reset(matrix.rows(), sides.columns());
  for (Index i = 0; i < matrix.rows(); ++i) {
    for (Index j = 0; j < matrix.rows(); ++j) system(i, j) = matrix(i, j);
    for (Index j = 0; j < sides.columns(); ++j) system(i, system.sides() + j) = sides(i, j);
  }
  return system;
}

/// Rows and columns of a system from some column on.
Matrix part_of(const System& system, Index from, Index rows, Index columns) {
  Matrix part(rows, columns);
  for (Index i = 0; i < rows; ++i)
    for (Index j = 0; j < columns; ++j) part(i, j) = system(i, from + j);
  return part;
}

}  // namespace

void bind_strip_parts(nb::module_& m) {
  m.attr("BLOCK") = BLOCK;
  m.def(
      "solve_linear",
      [](const Matrix& matrix, const Matrix& sides) {
        System system = system_of(matrix, sides);
        system.solve();
        return part_of(system, system.sides(), matrix.rows(), sides.columns());
      },
      "matrix"_a, "sides"_a);
  m.def(
      "subtract_product",
      [](const Matrix& from, const Matrix& left, const Matrix& right) {
        System system = system_of(from, right);
        const Index n = from.rows();
        Matrix factor(padded_size(n), padded_size(n));
        std::fill(factor.all().begin(), factor.all().end(), 0.0);
        for (Index i = 0; i < n; ++i) std::copy_n(left[i].begin(), n, factor[i].begin());
        system.subtract_product(factor, system_of(from, right));
        return part_of(system, 0, n, n);
      },
      "from_matrix"_a, "left"_a, "right"_a, "A square matrix less the product of two others.");
  m.def(
      "newton",
      [](const Grid& grid, Flags by_force, Pair target, const Kernel& kernel, State state, double tolerance,
         double relaxation, bool eager) {
        Options options;
        options.tolerance = tolerance, options.relaxation = relaxation, options.eager = eager;
        Newton(grid, kernel).run({by_force, target}, options, state);
        return state;
      },
      "grid"_a, "by_force"_a, "target"_a, "kernel"_a, "state"_a, "tolerance"_a = TOLERANCE, "relaxation"_a = 1.0,
      "eager"_a = true);
  m.def(
      "violation",
      [](const Grid& grid, Flags by_force, Pair target, const Kernel& kernel, State state) {
        const double violation = Newton(grid, kernel).violation({by_force, target}, state);
        return std::pair(violation, state);
      },
      "grid"_a, "by_force"_a, "target"_a, "kernel"_a, "state"_a,
      "The largest relative violation of contact and balance, and the state with its gaps.");
  m.def(
      "start_from_springs",
      [](const Grid& grid, Flags by_force, Pair target, const Kernel& kernel) {
        State state(grid.count());
        start_from_springs(grid, {by_force, target}, kernel, state);
        return state;
      },
      "grid"_a, "by_force"_a, "target"_a, "kernel"_a, "The response of independent springs, not a solution.");
  m.def(
      "start_from_other",
      [](std::shared_ptr<Grid> other, const State& solved, const Grid& grid, Flags by_force, Pair target) {
        std::optional<State> state(grid.count());
        const Level near{std::move(other), solved};
        if (!start_from_other(near, grid, {by_force, target}, *state)) state.reset();
        return state;
      },
      "other"_a, "solved"_a, "grid"_a, "by_force"_a, "target"_a);
}

}  // namespace nonhertz
