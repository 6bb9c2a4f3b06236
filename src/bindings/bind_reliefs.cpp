// Formulas of profiles, and functions for those that the core has none of.
#include <nanobind/stl/array.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/vector.h>

#include "bindings/functions.hpp"
#include "bindings/rooms.hpp"

namespace nonhertz {
namespace {

/// A relief by one of the formulas.
template <class Formula, class... Parameters>
std::shared_ptr<Relief> relief(Parameters... parameters) {
  return std::make_shared<Relief>(Relief{Formula{std::move(parameters)...}});
}

}  // namespace

void bind_reliefs(nb::module_& m) {
  nb::class_<Cubics>(m, "Cubics").def(nb::init<Numbers, Matrix>(), "places"_a, "coefficients"_a);
  nb::class_<StripDisplacement>(m, "StripDisplacement")
      .def(nb::init<Matrix, double, double, double>(), "cubics"_a, "nearest"_a, "far"_a, "step"_a);
  nb::class_<Corner>(m, "Corner")
      .def(nb::init<double, double, double, double>(), "extent"_a, "radius"_a, "arc"_a, "slope"_a);
  using Shared = std::shared_ptr<Relief>;
  nb::class_<Relief>(m, "Relief")
      .def_static("straight", &relief<Straight>)
      .def_static("arcs", &relief<Arcs, double, double, double, double>, "radius"_a, "end_radius"_a, "junction"_a,
                  "end_summit"_a)
      .def_static("logarithmic", &relief<Logarithmic, double, double, double, double, double>, "amplitude"_a,
                  "length"_a, "rest"_a, "curved"_a, "at_end"_a)
      .def_static("conical", &relief<Conical, double>, "slope"_a)
      .def_static("tapered_ends", &relief<TaperedEnds, double, double>, "straight"_a, "slope"_a)
      .def_static("uniform_pressure",
                  &relief<UniformPressure, double, double, double, std::shared_ptr<StripDisplacement>>, "amplitude"_a,
                  "length"_a, "half_width"_a, "displacement"_a)
      .def_static(
          "polyline",
          [](Numbers y, Numbers values) {
            return relief<Tabulated>(Polyline{std::move(y), std::move(values)});
          },
          "y"_a, "values"_a)
      .def_static(
          "cubics",
          [](Numbers y, Matrix coefficients) {
            return relief<Tabulated>(Cubics{std::move(y), std::move(coefficients)});
          },
          "y"_a, "coefficients"_a)
      .def_static(
          "sum",
          [](const std::vector<Shared>& parts) {
            return std::make_shared<Relief>(Relief{Sum{{parts.begin(), parts.end()}}});
          },
          "parts"_a)
      .def_static("moved", &relief<Moved, Shared, double, double, bool, double, double>, "relief"_a, "scale"_a,
                  "shift"_a, "flip"_a, "low"_a, "high"_a)
      .def_static(
          "cornered",
          [](Shared land, double half_length, const Corner& corner, const std::array<std::array<double, 3>, 2>& ends) {
            const auto tangent = [&](int side) { return Tangent{ends[side][0], ends[side][1], ends[side][2]}; };
            return relief<Cornered>(std::move(land), half_length, corner, tangent(0), tangent(1));
          },
          "land"_a, "half_length"_a, "corner"_a, "tangents"_a)
      .def_static("function", &relief<Function, Function>, "of"_a)
      .def(
          "__call__",
          [](const Relief& self, View y) {
            Numbers h(y.size());
            self.fill(y, h);
            return h;
          },
          "y"_a, Released());
}

}  // namespace nonhertz
