// How strips act, the loop on one grid, and the check of what it ends with.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"
#include "strips/acceptance.hpp"
#include "strips/face_density.hpp"
#include "strips/follow.hpp"
#include "strips/solving.hpp"
#include "strips/start.hpp"

namespace nonhertz {
namespace {

template <class Owner>
void matrix_property(nb::class_<Owner>& owner, const char* name, Matrix Owner::*of) {
  owner.def_prop_ro(
      name,
      [of](nb::handle self) {
        const Matrix& matrix = nb::cast<const Owner&>(self).*of;
        const auto rows = static_cast<std::size_t>(matrix.rows()), columns = static_cast<std::size_t>(matrix.columns());
        return MatrixOut(matrix.all().data(), {rows, columns}, self);
      },
      nb::rv_policy::reference);
}

void bind_kernel(nb::module_& m) {
  nb::class_<Element> element(m, "Element");
  element
      .def(
          "__init__",
          [](Element* self, const Element& like, Numbers table) {
            new (self) Element(like);
            self->table = std::move(table);
          },
          "like"_a, "table"_a, "The same with another table: to see what a mistake in it would do.")
      .def_ro("name", &Element::name)
      .def_ro("line_factor", &Element::line_factor)
      .def_ro("hertz_ratio", &Element::hertz_ratio)
      .def_ro("far_constant", &Element::far_constant)
      .def_prop_ro("leading", [](const Element& self) {
        return std::array{self.table[LEADING_AT], self.table[LEADING_AT + 1], self.table[LEADING_AT + 2],
                          self.table[LEADING_AT + 3]};
      });
  view_property(element, "table", &Element::table);
  m.attr("POWERS") = POWERS;
  m.attr("SEMI_ELLIPTIC") = nb::cast(std::make_shared<const Element>(semi_elliptic()));
  m.attr("PARABOLIC") = nb::cast(std::make_shared<const Element>(parabolic()));
  m.def(
      "evaluate",
      [](const Element& of, View t) {
        Matrix quantities(count_of(t), 4);
        for (Index i = 0; i < count_of(t); ++i) {
          const Four s = evaluate(t[i], of.table.data());
          quantities(i, 0) = s.a(), quantities(i, 1) = s.ta(), quantities(i, 2) = s.b(), quantities(i, 3) = s.tb();
        }
        return quantities;
      },
      "element"_a, "t"_a, "A, t A', B and t B', shape (t, 4).");
  nb::class_<Term>(m, "Term").def(nb::init<double, double, double>(), "sign"_a, "offset"_a, "weight"_a);
  m.def(
      "face_densities",
      [](const Element& of, Numbers distances, Matrix weights, View u, View v) {
        if (weights.columns() != 2 * count_of(distances) || u.size() != v.size()) throw std::invalid_argument("shapes");
        Matrix quantities(2, count_of(u));
        face_densities(of, {std::move(distances), std::move(weights)}, u, v, quantities[0], quantities[1]);
        return quantities;
      },
      "element"_a, "distances"_a, "weights"_a, "u"_a, "v"_a, Released(),
      "What a free side face adds to displacement and curvature of a load of unit length, shape (2, u).");
  nb::class_<FaceTable>(m, "FaceTable").def(nb::init<Numbers>());
  m.def(
      "free_end",
      [](double u, double inner, double outer, const FaceTable& table, const Element& of) {
        Squares cache;
        const Four s = free_end(u, inner, outer, table.data(), of.table.data(), cache);
        return std::array{s.a(), s.ta(), s.b(), s.tb()};
      },
      "u"_a, "inner"_a, "outer"_a, "table"_a, "element"_a,
      "What a free side face adds to [A], [t A'], [B] and [t B'] of a strip, all distances in half-widths.");
  nb::class_<Face>(m, "Face").def(nb::init<double, double, double, std::shared_ptr<FaceTable>>(), "place"_a, "side"_a,
                                  "weight"_a, "table"_a);
  nb::class_<Kernel>(m, "Kernel")
      .def(nb::init<std::shared_ptr<Element>, std::vector<Term>, std::vector<Face>>(), "element"_a, "terms"_a,
           "faces"_a)
      .def_prop_ro("element", [](const Kernel& self) { return self.element; });
}

void bind_states(nb::module_& m) {
  nb::class_<Grid> grid(m, "Grid", "Strips side by side, with everything that is known before their loads are.");
  grid.def(
      "__init__",
      [](Grid* self, Numbers edges, Numbers curvature, Numbers separation, Numbers min_depth, Numbers sharper,
         Matrix at_depth, Matrix by_width) {
        Numbers y;
        for (std::size_t i = 0; i + 1 < edges.size(); ++i) y.push_back(0.5 * (edges[i + 1] + edges[i]));
        new (self) Grid{std::move(edges),     std::move(y),       std::move(separation), std::move(curvature),
                        std::move(min_depth), std::move(sharper), std::move(at_depth),   std::move(by_width)};
      },
      "edges"_a, "curvature"_a, "separation"_a, "min_depth"_a, "sharper"_a, "at_depth"_a, "by_width"_a);
  view_property(grid, "edges", &Grid::edges);
  view_property(grid, "y", &Grid::y);
  view_property(grid, "separation", &Grid::separation);
  view_property(grid, "curvature", &Grid::curvature);
  view_property(grid, "min_depth", &Grid::min_depth);
  view_property(grid, "sharper", &Grid::sharper);
  matrix_property(grid, "at_depth", &Grid::at_depth);
  matrix_property(grid, "by_width", &Grid::by_width);
  nb::enum_<Status>(m, "Status", nb::is_arithmetic())
      .value("CONVERGED", Status::converged)
      .value("ITERATION_LIMIT", Status::iteration_limit)
      .value("STAGNATED", Status::stagnated);
  nb::class_<State> state(m, "State", "The unknowns of strips, and what follows from them.");
  state
      .def(
          "__init__",
          [](State* self, Numbers r, Numbers m, Numbers gap, Pair rigid, std::array<Pair, 2> stiffness, Status status,
             int steps, double residual) {
            new (self) State(0);
            self->r = std::move(r), self->m = std::move(m), self->gap = std::move(gap);
            self->rigid = rigid, self->stiffness = stiffness;
            self->status = status, self->steps = steps, self->residual = residual;
          },
          "r"_a, "m"_a, "gap"_a, "rigid"_a, "stiffness"_a, "status"_a, "steps"_a, "residual"_a)
      .def_ro("rigid", &State::rigid)
      .def_ro("stiffness", &State::stiffness)
      .def_ro("status", &State::status)
      .def_ro("steps", &State::steps)
      .def_ro("residual", &State::residual);
  view_property(state, "r", &State::r);
  view_property(state, "m", &State::m);
  view_property(state, "gap", &State::gap);
}

void bind_solving(nb::module_& m) {
  m.def(
      "solve_on",
      [](const Grid& grid, Flags by_force, Pair target, const Kernel& kernel, std::shared_ptr<Grid> near_grid,
         std::shared_ptr<State> near_state, double tolerance, bool patient) {
        std::optional<Level> near;
        if (near_grid && near_state) near = Level{std::move(near_grid), *near_state};
        Attempt attempt;
        attempt.near = near ? &*near : nullptr, attempt.tolerance = tolerance, attempt.patient = patient;
        return solve_on(grid, {by_force, target}, kernel, attempt);
      },
      "grid"_a, "by_force"_a, "target"_a, "kernel"_a, "near_grid"_a.none() = nb::none(),
      "near_state"_a.none() = nb::none(), "tolerance"_a = TOLERANCE, "patient"_a = true, Released());
  nb::class_<Following>(m, "Following", "Strips on which solved contacts follow to other motions.")
      .def(
          "__init__",
          [](Following* self, std::shared_ptr<Grid> grid, const Kernel& kernel) {
            new (self) Following(std::move(grid), std::make_shared<const Kernel>(kernel));
          },
          "grid"_a, "kernel"_a)
      .def(
          "follow",
          [](Following& self, Pair motion, State state) {
            const std::optional<Pair> resultant = self.follow(motion, state);
            return std::pair(resultant, std::move(state));
          },
          "motion"_a, "state"_a, Released(), "K Q and K T, None if the contact got lost, and the state that is left.");
  m.attr("TOLERANCE") = TOLERANCE;
  m.attr("ROUGH_TOLERANCE") = ROUGH_TOLERANCE;
  m.attr("PATIENT_STRIPS") = PATIENT_STRIPS;
  m.def(
      "steady", [](std::array<Pair, 2> stiffness, double reach) { return steady(stiffness, reach); }, "stiffness"_a,
      "reach"_a);
  m.def(
      "coefficients",
      [](const Grid& grid, View m, const std::vector<Index>& active, const Kernel& kernel) {
        Numbers joined;
        Influence influence(grid, kernel);
        Blocks blocks;
        influence.keep_up(m);
        influence.coefficients(m, active, blocks);
        for (const Matrix& block : blocks) joined.insert(joined.end(), block.all().begin(), block.all().end());
        return array_of(std::move(joined), std::array{std::size_t{4}, m.size(), active.size()});
      },
      "grid"_a, "m"_a, "active"_a, "kernel"_a,
      "[A], [t A'], [B] and [t B'] of the active strips at the centres of all, shape (4, n, active).");
  m.def(
      "displacements",
      [](View y, const Grid& grid, Numbers r, Numbers m, const Kernel& kernel) {
        State state(0);
        state.r = std::move(r), state.m = std::move(m);
        return surface_displacement(y, grid, state, kernel);
      },
      "y"_a, "grid"_a, "r"_a, "m"_a, "kernel"_a, "Displacement on the surface, points at depth left out.");
  m.def("by_own_width", &by_own_width, "by_width"_a, "strip"_a, "a"_a);
}

}  // namespace

void bind_strips(nb::module_& m) {
  bind_kernel(m);
  bind_states(m);
  bind_solving(m);
}

}  // namespace nonhertz
