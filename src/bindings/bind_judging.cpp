// How a solution is judged: what Python compares with limits and puts into words.
#include <nanobind/stl/array.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "bindings/arrays.hpp"
#include "bindings/functions.hpp"
#include "bindings/rooms.hpp"
#include "judging/corners.hpp"
#include "judging/judgement.hpp"

namespace nonhertz {
void bind_judging(nb::module_& m) {
  nb::enum_<EndKind>(m, "EndKind", nb::is_arithmetic())
      .value("RUN_OUT", EndKind::run_out)
      .value("FINITE", EndKind::finite)
      .value("SINGULAR", EndKind::singular)
      .value("CORNER", EndKind::corner)
      .value("CUT_OFF", EndKind::cut_off);
  nb::class_<End>(m, "End")
      .def_ro("kind", &End::kind)
      .def_ro("y", &End::y)
      .def_ro("width", &End::width)
      .def_ro("pressure", &End::pressure)
      .def_ro("image_weight", &End::image_weight)
      .def_ro("exponent", &End::exponent)
      .def_ro("correction_exponent", &End::correction_exponent);
  nb::class_<SingularEnd>(m, "SingularEnd")
      .def_ro("y", &SingularEnd::y)
      .def_ro("is_corner", &SingularEnd::is_corner)
      .def_ro("width", &SingularEnd::width);
  nb::class_<Errors>(m, "Errors")
      .def_ro("approach", &Errors::approach)
      .def_ro("load", &Errors::load)
      .def_ro("max_pressure", &Errors::max_pressure)
      .def_ro("moment", &Errors::moment)
      .def_ro("tilt", &Errors::tilt)
      .def_ro("left_by_modes", &Errors::left_by_modes)
      .def_ro("pressure_left_by_modes", &Errors::pressure_left_by_modes);
  nb::class_<Checks>(m, "Checks")
      .def_ro("length_ratio", &Checks::length_ratio)
      .def_ro("radius_ratio", &Checks::radius_ratio)
      .def_ro("depth_ratio", &Checks::depth_ratio)
      .def_ro("half_width", &Checks::half_width)
      .def_ro("unevenness", &Checks::unevenness)
      .def_ro("deepest", &Checks::deepest)
      .def_ro("pressed", &Checks::pressed)
      .def_ro("mean_pressure", &Checks::mean_pressure)
      .def_ro("missed", &Checks::missed)
      .def_ro("missed_y", &Checks::missed_y);
  nb::class_<Judgement>(m, "Judgement")
      .def_ro("contact", &Judgement::contact)
      .def_prop_ro("ends", [](const Judgement& self) { return self.ends.ends; })
      .def_prop_ro("singular", [](const Judgement& self) { return self.ends.singular; })
      .def_prop_ro("max_pressure", [](const Judgement& self) { return self.pressure.value; })
      .def_prop_ro("max_pressure_y", [](const Judgement& self) { return self.pressure.y; })
      .def_ro("max_half_width", &Judgement::half_width)
      .def_ro("peaks_at_corner", &Judgement::peaks_at_corner)
      .def_ro("penetration", &Judgement::penetration)
      .def_ro("errors", &Judgement::errors)
      .def_ro("checks", &Judgement::checks);
  nb::class_<Level>(m, "Level", "A state with the strips that it is of.")
      .def(
          "__init__",
          [](Level* self, const Model& model, Numbers edges, const State& state) {
            if (edges.size() != state.m.size() + 1) throw std::invalid_argument("strips must have one edge more");
            new (self) Level{model.springs(std::move(edges)), state};
          },
          "model"_a, "edges"_a, "state"_a);
  m.def(
      "judge",
      [](const Model& model, Flags by_force, Pair target, std::vector<Level> levels, double accuracy) {
        if (levels.empty()) throw std::invalid_argument("a solution has a level at least");
        return judge(model, {by_force, target}, {std::move(levels), accuracy});
      },
      "model"_a, "by_force"_a, "target"_a, "levels"_a, "accuracy"_a, Released());
  m.def(
      "values_that_count",
      [](View y, View values, View half_width, View ends) {
        if (y.empty() || values.size() != y.size() || half_width.size() != y.size())
          throw std::invalid_argument("places, values and half-widths must be as many");
        Counted result = values_that_count(y, values, half_width, ends);
        const Index at = result.at();
        return std::tuple(std::move(result.places), std::move(result.values), at);
      },
      "y"_a, "values"_a, "half_width"_a, "ends"_a);
  m.def(
      "corner_ends",
      [](View bends, double compliance, Function separation, View edges, View pressure, View half_width) {
        if (pressure.empty() || edges.size() != pressure.size() + 1 || half_width.size() != pressure.size())
          throw std::invalid_argument("rows must have an edge more than pressures and half-widths");
        const auto at = [of = std::move(separation)](View y) {
          Numbers h(y.size());
          of(y, h);
          return h;
        };
        return corner_ends({bends, compliance, at}, edges, pressure, half_width);
      },
      "bends"_a, "compliance"_a, "separation"_a, "edges"_a, "pressure"_a, "half_width"_a);
  m.def(
      "penetration",
      [](const Model& model, View edges, Pair rigid) {
        if (edges.size() < 2) throw std::invalid_argument("a strip has two edges");
        return penetration_of(model, edges, rigid);
      },
      "model"_a, "edges"_a, "rigid"_a, Released());
  m.def(
      "intervals",
      [](Numbers edges, View squares) {
        if (edges.size() != squares.size() + 1) throw std::invalid_argument("strips must have one edge more");
        Grid grid;
        for (std::size_t i = 0; i < squares.size(); ++i) grid.y.push_back(0.5 * (edges[i + 1] + edges[i]));
        grid.edges = std::move(edges);
        return intervals(grid, squares);
      },
      "edges"_a, "m"_a);
}

}  // namespace nonhertz
