// A solve, many solves, and what they return: arrays are views of the result's own memory.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"
#include "solve/batch.hpp"

namespace nonhertz {
namespace {

/// A new array with one number per strip.
template <class Value>
VectorOut made(const Result& result, Value value) {
  const State& state = result.finest().state;
  auto values = std::make_unique<Numbers>(state.r.size());
  for (std::size_t i = 0; i < values->size(); ++i) (*values)[i] = value(state, i);
  const Numbers& kept = *values;
  nb::capsule owner(values.release(), [](void* p) noexcept { delete static_cast<Numbers*>(p); });
  return VectorOut(kept.data(), {kept.size()}, owner);
}

}  // namespace

void bind_solve(nb::module_& m) {
  const auto of_state = [](auto member) {
    return [member](const Result& self) { return self.finest().state.*member; };
  };
  nb::class_<Result>(m, "Result")
      .def_prop_ro("status", of_state(&State::status))
      .def_prop_ro("rigid", of_state(&State::rigid))
      .def_prop_ro("stiffness", of_state(&State::stiffness))
      .def_prop_ro("steps", of_state(&State::steps))
      .def_prop_ro(
          "edges", [](nb::handle self) { return view_of(nb::cast<const Result&>(self).finest().grid->edges, self); },
          nb::rv_policy::reference)
      .def_prop_ro(
          "r", [](nb::handle self) { return view_of(nb::cast<const Result&>(self).finest().state.r, self); },
          nb::rv_policy::reference)
      .def_prop_ro(
          "m", [](nb::handle self) { return view_of(nb::cast<const Result&>(self).finest().state.m, self); },
          nb::rv_policy::reference)
      .def_prop_ro(
          "gap", [](nb::handle self) { return view_of(nb::cast<const Result&>(self).finest().state.gap, self); },
          nb::rv_policy::reference)
      .def_prop_ro(
          "q",
          [](const Result& self) { return made(self, [](const State& s, std::size_t i) { return s.r[i] * s.m[i]; }); },
          nb::rv_policy::reference)
      .def_prop_ro(
          "a",
          [](const Result& self) {
            return made(self, [](const State& s, std::size_t i) { return std::sqrt(s.m[i]); });
          },
          nb::rv_policy::reference)
      .def_prop_ro("resultant",
                   [](const Result& self) {
                     Pair found{};
                     const auto& [grid, state] = self.finest();
                     for (Index i = 0; i < grid->count(); ++i) {
                       const double carried = state.r[i] * state.m[i] * grid->width(i);
                       found[0] += carried, found[1] += carried * grid->y[i];
                     }
                     return found;
                   })
      .def_prop_ro("grids", [](const Result& self) { return self.levels.levels.size(); })
      .def_prop_ro("unmet",
                   [](const Result& self) {
                     return std::tuple(static_cast<int>(self.shortfall.condition), self.shortfall.found,
                                       self.shortfall.at);
                   })
      .def_ro("is_steady", &Result::is_steady)
      .def_prop_ro(
          "judgement", [](const Result& self) -> const Judgement& { return self.judgement.value(); },
          nb::rv_policy::reference_internal);
  nb::class_<Automatic>(m, "Automatic").def(nb::init<double>());
  m.def(
      "solve",
      [](const Model& model, std::array<bool, 2> by_force, Pair target, const Strips& strips) {
        return solve(model, {by_force, target}, strips);
      },
      "model"_a, "by_force"_a, "target"_a, "strips"_a, nb::call_guard<nb::gil_scoped_release>());
  m.def("solve_many", &solve_many, "model"_a, "by_force"_a, "targets"_a, "strips"_a, "threads"_a = 1,
        nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace nonhertz
