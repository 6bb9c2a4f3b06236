// What whole rollers are made of: finite elements for bodies of revolution, and the waves of flat bodies.
#include <nanobind/stl/vector.h>

#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"
#include "bodies/flat_modes.hpp"
#include "bodies/harmonic_elements.hpp"

namespace nonhertz {

void bind_harmonic_elements(nb::module_& m) {
  nb::class_<HarmonicElements>(m, "HarmonicElements")
      .def(
          "__init__",
          [](HarmonicElements* self, double poisson, Numbers across, Numbers along, Matrix outer, Matrix inner,
             Matrix outer_slope, Matrix inner_slope, Matrix values, Matrix slopes, Numbers points, Numbers weights,
             bool bored, bool symmetric) {
            Mesh mesh{std::move(across),
                      std::move(along),
                      std::move(outer),
                      std::move(inner),
                      std::move(outer_slope),
                      std::move(inner_slope),
                      std::move(values),
                      std::move(slopes),
                      std::move(points),
                      std::move(weights),
                      bored,
                      symmetric};
            new (self) HarmonicElements(std::move(mesh), poisson);
          },
          "poisson"_a, "across"_a, "along"_a, "outer"_a, "inner"_a, "outer_slope"_a, "inner_slope"_a, "values"_a,
          "slopes"_a, "points"_a, "weights"_a, "bored"_a, "symmetric"_a)
      .def("works", &HarmonicElements::works, "waves"_a, "loads"_a, "readings"_a, "threads"_a = 1, Released())
      .def("displacement", &HarmonicElements::displacement, "waves"_a, "loads"_a, Released());
  nb::class_<LogarithmicTable>(m, "LogarithmicTable").def(nb::init<double, double, Matrix>());
  m.def(
      "flat_modes",
      [](const LogarithmicTable& loads, const LogarithmicTable& planes, const LogarithmicTable& curved, Matrix weights,
         Numbers distances, Numbers image, Numbers face, double half_length, View places, const Matrix& points,
         const Matrix& radius) {
        const FlatModes flat{
            loads,           planes,     curved, std::move(weights), std::move(distances), std::move(image),
            std::move(face), half_length};
        return effect_of(flat, places, points, radius);
      },
      "loads"_a, "planes"_a, "curved"_a, "weights"_a, "distances"_a, "image"_a, "face"_a, "half_length"_a, "places"_a,
      "points"_a, "radius"_a, Released());
}

}  // namespace nonhertz
