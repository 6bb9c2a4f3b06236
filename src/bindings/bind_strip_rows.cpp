// Many cases in rows of arrays, as Python's levels hand them to the loop: a grid in each row, or one for all.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"
#include "strips/acceptance.hpp"
#include "strips/follow.hpp"
#include "strips/solving.hpp"

namespace nonhertz {
namespace {

using Flags = std::array<bool, 2>;
using CubeIn = nb::ndarray<const double, nb::ndim<3>, nb::c_contig, nb::device::cpu>;
using IndicesIn = nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
template <int Dimensions>
using Out = nb::ndarray<double, nb::ndim<Dimensions>, nb::c_contig, nb::device::cpu>;
using IndicesOut = nb::ndarray<std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;

View row_of(const MatrixIn& rows, Index row, Index count) {
  return {rows.data() + row * static_cast<Index>(rows.shape(1)), static_cast<std::size_t>(count)};
}

Numbers copy_of(View values) { return {values.begin(), values.end()}; }

Numbers centres(View edges) {
  Numbers y(edges.size() - 1);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = 0.5 * (edges[i + 1] + edges[i]);
  return y;
}

/// The left upper part of one of many matrices; none if they have no columns.
Matrix part_of(const CubeIn& matrices, Index at, Index rows, Index columns) {
  if (matrices.size() == 0) return {};
  const Index height = static_cast<Index>(matrices.shape(1)), width = static_cast<Index>(matrices.shape(2));
  Matrix part(rows, columns);
  for (Index i = 0; i < rows; ++i) std::copy_n(matrices.data() + (at * height + i) * width, columns, part[i].begin());
  return part;
}

/// `nonhertz.strip.records.Grids`.
struct GridRows {
  IndicesIn counts;
  MatrixIn edges, y, curvature, separation, min_depth, sharper;
  CubeIn at_depth, by_width;

  explicit GridRows(const nb::object& of)
      : counts(nb::cast<IndicesIn>(of[0])),
        edges(nb::cast<MatrixIn>(of[1])),
        y(nb::cast<MatrixIn>(of[2])),
        curvature(nb::cast<MatrixIn>(of[3])),
        separation(nb::cast<MatrixIn>(of[4])),
        min_depth(nb::cast<MatrixIn>(of[5])),
        sharper(nb::cast<MatrixIn>(of[6])),
        at_depth(nb::cast<CubeIn>(of[7])),
        by_width(nb::cast<CubeIn>(of[8])) {}

  bool shared() const { return counts.size() == 1; }
  std::shared_ptr<const Grid> grid(Index case_number) const {
    const Index row = shared() ? 0 : case_number, n = counts.data()[row];
    auto grid = std::make_shared<Grid>();
    grid->edges = copy_of(row_of(edges, row, n + 1));
    grid->y = copy_of(row_of(y, row, n));
    grid->separation = copy_of(row_of(separation, row, n));
    grid->curvature = copy_of(row_of(curvature, row, n));
    grid->min_depth = copy_of(row_of(min_depth, row, n));
    grid->sharper = copy_of(row_of(sharper, row, n));
    grid->at_depth = part_of(at_depth, row, n, n);
    grid->by_width = part_of(by_width, row, 4, n);
    return grid;
  }
};

/// `nonhertz.strip.records.States`.
struct StateRows {
  IndicesIn counts;
  MatrixIn edges;
  Out<2> r, m, rigid, gap;
  Out<3> stiffness;
  IndicesOut status, steps;
  Out<1> residual;

  explicit StateRows(const nb::object& of)
      : counts(nb::cast<IndicesIn>(of[0])),
        edges(nb::cast<MatrixIn>(of[1])),
        r(nb::cast<Out<2>>(of[2], false)),
        m(nb::cast<Out<2>>(of[3], false)),
        rigid(nb::cast<Out<2>>(of[4], false)),
        gap(nb::cast<Out<2>>(of[5], false)),
        stiffness(nb::cast<Out<3>>(of[6], false)),
        status(nb::cast<IndicesOut>(of[7], false)),
        steps(nb::cast<IndicesOut>(of[8], false)),
        residual(nb::cast<Out<1>>(of[9], false)) {}

  Index cases() const { return static_cast<Index>(status.size()); }
  Index count(Index at) const { return counts.data()[counts.size() == 1 ? 0 : at]; }
  bool converged(Index at) const { return status.data()[at] == static_cast<int>(Status::converged); }
  View edges_of(Index at) const { return row_of(edges, edges.shape(0) == 1 ? 0 : at, count(at) + 1); }

  State get(Index at) const {
    const Index n = count(at);
    State state(n);
    std::copy_n(row(r, at), n, state.r.begin());
    std::copy_n(row(m, at), n, state.m.begin());
    std::copy_n(row(gap, at), n, state.gap.begin());
    for (int k = 0; k < 2; ++k) {
      state.rigid[k] = rigid.data()[2 * at + k];
      for (int j = 0; j < 2; ++j) state.stiffness[k][j] = stiffness.data()[4 * at + 2 * k + j];
    }
    state.status = static_cast<Status>(status.data()[at]), state.steps = static_cast<int>(steps.data()[at]);
    state.residual = residual.data()[at];
    return state;
  }
  void put(Index at, const State& state) const {
    std::copy(state.r.begin(), state.r.end(), row(r, at));
    std::copy(state.m.begin(), state.m.end(), row(m, at));
    std::copy(state.gap.begin(), state.gap.end(), row(gap, at));
    for (int k = 0; k < 2; ++k) {
      rigid.data()[2 * at + k] = state.rigid[k];
      for (int j = 0; j < 2; ++j) stiffness.data()[4 * at + 2 * k + j] = state.stiffness[k][j];
    }
    status.data()[at] = static_cast<int>(state.status), steps.data()[at] = state.steps;
    residual.data()[at] = state.residual;
  }
  /// A case where it is known at least where its strips are.
  Level level(Index at) const {
    auto grid = std::make_shared<Grid>();
    grid->edges = copy_of(edges_of(at));
    grid->y = centres(grid->edges);
    return {grid, get(at)};
  }

 private:
  static double* row(const Out<2>& rows, Index at) { return rows.data() + at * static_cast<Index>(rows.shape(1)); }
};

Pair target_of(const MatrixIn& targets, Index at) { return {targets.data()[2 * at], targets.data()[2 * at + 1]}; }

void solve_on_strips(const nb::object& grids, Flags by_force, const MatrixIn& targets, const Kernel& kernel,
                     const nb::object& near_states, const nb::object& states, double tolerance, bool patient) {
  const GridRows rows(grids);
  const StateRows near(near_states), found(states);
  const nb::gil_scoped_release released;
  std::shared_ptr<const Grid> grid;
  std::optional<State> before;
  for (Index at = 0; at < static_cast<Index>(targets.shape(0)); ++at) {
    if (!grid || !rows.shared()) grid = rows.grid(at);
    std::optional<Level> other;
    if (near.cases() > 0 && near.converged(at)) other = near.level(at);
    Attempt attempt;
    attempt.near = other ? &*other : nullptr;
    // On the way to a grid of its own a case depends on no other.
    if (rows.shared() && tolerance == TOLERANCE && before) {
      attempt.before = &*before;
      attempt.of_before = {by_force, target_of(targets, at - 1)};
    }
    attempt.tolerance = tolerance, attempt.patient = patient;
    State state = solve_on(*grid, {by_force, target_of(targets, at)}, kernel, attempt);
    found.put(at, state);
    before = std::move(state);
  }
}

/// Which states meet everything that is prescribed, and are steady.
std::vector<bool> met_by(const nb::object& grids, Flags by_force, const MatrixIn& targets, const Kernel& kernel,
                         const nb::object& states) {
  const GridRows rows(grids);
  const StateRows found(states);
  std::vector<bool> met(static_cast<std::size_t>(found.cases()));
  const nb::gil_scoped_release released;
  std::shared_ptr<const Grid> grid;
  for (Index at = 0; at < found.cases(); ++at) {
    if (!grid || !rows.shared()) grid = rows.grid(at);
    const Index n = grid->count();
    State state = found.get(at);
    state.r.resize(n), state.m.resize(n), state.gap.resize(n);
    const Shortfall unmet = first_unmet(*grid, {by_force, target_of(targets, at)}, kernel, state);
    met[at] = unmet.condition == Unmet::none && steady(*grid, state);
  }
  return met;
}

}  // namespace

void bind_strip_rows(nb::module_& m) {
  m.def("solve_on_strips", &solve_on_strips, "grids"_a, "by_force"_a, "targets"_a, "kernel"_a, "near"_a, "found"_a,
        "tolerance"_a, "patient"_a, "Solve every case on its strips, overwriting found.");
  m.def("met_by", &met_by, "grids"_a, "by_force"_a, "targets"_a, "kernel"_a, "states"_a);
  m.def(
      "first_unmet",
      [](const nb::object& grids, Flags by_force, Pair target, const Kernel& kernel, const VectorIn& q,
         const VectorIn& half_width, const VectorIn& gap, Pair motion) {
        const auto grid = GridRows(grids).grid(0);
        const Answer answer{numbers(q), numbers(half_width), numbers(gap), motion};
        const Shortfall found = first_unmet(*grid, {by_force, target}, kernel, answer);
        return std::tuple(static_cast<int>(found.condition), found.found, found.at);
      },
      "grids"_a, "by_force"_a, "target"_a, "kernel"_a, "q"_a, "half_width"_a, "gap"_a, "motion"_a,
      "The first condition that is not met, the value found, and the strip where it was found.");
  nb::class_<Following>(m, "Following", nb::is_weak_referenceable())
      .def(
          "__init__",
          [](Following* self, const nb::object& grids, std::shared_ptr<Kernel> kernel) {
            new (self) Following(GridRows(grids).grid(0), std::move(kernel));
          },
          "grids"_a, "kernel"_a)
      .def(
          "follow",
          [](Following& self, Pair motion, const nb::object& states) {
            const StateRows found(states);
            const State before = found.get(0);
            State state = before;
            std::optional<Pair> resultant;
            {
              const nb::gil_scoped_release released;
              resultant = self.follow(motion, state);
            }
            // How it was solved is still said of the case that it follows.
            state.status = before.status, state.steps = before.steps, state.residual = before.residual;
            if (resultant) found.put(0, state);
            return resultant;
          },
          "motion"_a, "found"_a, "Let a solved case follow to another approach and tilt; return K Q and K T.");
}

}  // namespace nonhertz
