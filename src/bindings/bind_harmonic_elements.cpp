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
          [](HarmonicElements* self, double poisson, const VectorIn& across, const VectorIn& along,
             const MatrixIn& outer, const MatrixIn& inner, const MatrixIn& outer_slope, const MatrixIn& inner_slope,
             const MatrixIn& values, const MatrixIn& slopes, const VectorIn& points, const VectorIn& weights,
             bool bored, bool symmetric) {
            Mesh mesh{numbers(across),      numbers(along),       copy_of(outer),  copy_of(inner),
                      copy_of(outer_slope), copy_of(inner_slope), copy_of(values), copy_of(slopes),
                      numbers(points),      numbers(weights),     bored,           symmetric};
            new (self) HarmonicElements(std::move(mesh), poisson);
          },
          "poisson"_a, "across"_a, "along"_a, "outer"_a, "inner"_a, "outer_slope"_a, "inner_slope"_a, "values"_a,
          "slopes"_a, "points"_a, "weights"_a, "bored"_a, "symmetric"_a)
      .def(
          "works",
          [](const HarmonicElements& self, const std::vector<int>& waves, const MatrixIn& loads,
             const MatrixIn& readings, int threads) {
            std::vector<Matrix> found;
            {
              const nb::gil_scoped_release release;
              found = self.works(waves, copy_of(loads), copy_of(readings), threads);
            }
            std::vector<MatrixOut> arrays;
            for (Matrix& each : found) arrays.push_back(matrix_of(std::move(each)));
            return arrays;
          },
          "waves"_a, "loads"_a, "readings"_a, "threads"_a = 1)
      .def(
          "displacement",
          [](const HarmonicElements& self, int waves, const MatrixIn& loads) {
            Matrix found;
            {
              const nb::gil_scoped_release release;
              found = self.displacement(waves, copy_of(loads));
            }
            return matrix_of(std::move(found));
          },
          "waves"_a, "loads"_a);
  nb::class_<LogarithmicTable>(m, "LogarithmicTable")
      .def("__init__", [](LogarithmicTable* self, double first, double step, const MatrixIn& pieces) {
        new (self) LogarithmicTable{first, step, copy_of(pieces)};
      });
  m.def(
      "flat_modes",
      [](const LogarithmicTable& loads, const LogarithmicTable& planes, const LogarithmicTable& curved,
         const MatrixIn& weights, const VectorIn& distances, const VectorIn& image, const VectorIn& face,
         double half_length, const VectorIn& places, const MatrixIn& points, const MatrixIn& radius) {
        Matrix effect;
        {
          const nb::gil_scoped_release release;
          const FlatModes flat{loads,          planes,        curved,     copy_of(weights), numbers(distances),
                               numbers(image), numbers(face), half_length};
          effect = effect_of(flat, view(places), copy_of(points), copy_of(radius));
        }
        return matrix_of(std::move(effect));
      },
      "loads"_a, "planes"_a, "curved"_a, "weights"_a, "distances"_a, "image"_a, "face"_a, "half_length"_a, "places"_a,
      "points"_a, "radius"_a);
}

}  // namespace nonhertz
