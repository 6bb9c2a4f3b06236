// What a contact is made of, and a model of it.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include "bindings/functions.hpp"
#include "bindings/rooms.hpp"
#include "bodies/model.hpp"
#include "numbers/dense.hpp"

namespace nonhertz {
namespace {

void bind_references(nb::module_& m) {
  nb::class_<TabulatedDiameter>(m, "TabulatedDiameter")
      .def(
          "__init__",
          [](TabulatedDiameter* self, Numbers y, Numbers diameter, double middle) {
            new (self) TabulatedDiameter{{std::move(y), std::move(diameter)}, middle};
          },
          "y"_a, "diameter"_a, "middle"_a);
  nb::class_<DepthInDiameters>(m, "DepthInDiameters")
      .def(nb::init<double, Curvature, Function>(), "diameters"_a, "curvature"_a, "refuse"_a);
  nb::class_<WholeRoller>(m, "WholeRoller")
      .def(
          "__init__",
          [](WholeRoller* self, Numbers z, Numbers outer, Matrix smooth, Matrix curved, double logarithm, double beta) {
            new (self) WholeRoller{{std::move(z), std::move(outer)},
                                   std::make_shared<const Matrix>(std::move(smooth)),
                                   std::make_shared<const Matrix>(std::move(curved)),
                                   logarithm,
                                   beta};
          },
          "z"_a, "outer"_a, "smooth"_a, "curved"_a, "logarithm"_a, "beta"_a)
      .def("by_width", &WholeRoller::by_width, "radius"_a)
      .def("displacement", &WholeRoller::displacement, "y"_a, "edges"_a, Released());
  nb::class_<FarImages>(m, "FarImages")
      .def(nb::init<Numbers, Numbers, double, double>(), "distance"_a, "weight"_a, "beyond"_a, "length"_a);
  nb::class_<PointsAtDepth::FreeFace>(m, "FreeFace")
      .def(nb::init<double, double, double>(), "place"_a, "side"_a, "weight"_a);
  nb::class_<PointsAtDepth>(m, "PointsAtDepth")
      .def(nb::init<Depth, double, std::vector<Term>, std::optional<FarImages>, std::vector<PointsAtDepth::FreeFace>,
                    Numbers>(),
           "depth"_a, "poisson_factor"_a, "terms"_a, "far"_a.none(), "faces"_a, "over_image"_a)
      .def("displacement", &PointsAtDepth::displacement, "y"_a, "edges"_a, Released());
  nb::class_<AxisOfCylinder>(m, "AxisOfCylinder")
      .def(nb::init<Depth, std::shared_ptr<Cubics>, std::vector<Term>>(), "diameter"_a, "smooth"_a, "terms"_a)
      .def("displacement", &AxisOfCylinder::displacement, "y"_a, "edges"_a, Released());
  nb::class_<OtherReference>(m, "OtherReference").def(nb::init<Depth, MatrixFunction>(), "below"_a, "displaced"_a);
  nb::class_<AxisOfRoller>(m, "AxisOfRoller")
      .def(nb::init<Depth, std::shared_ptr<WholeRoller>, double, double, double>(), "depth"_a, "whole"_a, "radius"_a,
           "middle"_a, "share"_a)
      .def("displacement", &AxisOfRoller::displacement, "y"_a, "edges"_a, Released())
      .def(
          "by_width",
          [](const AxisOfRoller& self, View y, double ratio) {
            Matrix sum(4, count_of(y));
            std::fill(sum.all().begin(), sum.all().end(), 0.0);
            add_by_width(self, y, ratio, sum);
            return sum;
          },
          "y"_a, "ratio"_a);
}

void bind_model(nb::module_& m) {
  nb::class_<Body>(m, "Body").def(nb::init<std::shared_ptr<Relief>, Curvature, double>(), "relief"_a, "curvature"_a,
                                  "modulus"_a);
  nb::class_<FreedFace>(m, "FreedFace")
      .def(nb::init<double, double, double, double>(), "y"_a, "side"_a, "image_weight"_a, "free"_a);
  nb::class_<Model>(m, "Model")
      .def(
          "__init__",
          [](Model* self, std::array<Body, 2> bodies, Kernel kernel, std::vector<Reference> references,
             std::vector<FreedFace> freed, double compliance, Pair interval, Numbers bends, Numbers crests,
             Function refuse) {
            new (self) Model({std::move(bodies), std::move(kernel), std::move(references), std::move(freed), compliance,
                              interval, std::move(bends), std::move(crests), std::move(refuse)});
          },
          "bodies"_a, "kernel"_a, "references"_a, "freed"_a, "compliance"_a, "interval"_a, "bends"_a, "crests"_a,
          "refuse"_a, Released())
      .def("separation", nb::overload_cast<View>(&Model::separation, nb::const_), "y"_a, Released())
      .def("curvature", &Model::curvature, "y"_a, Released())
      .def("sharper_curvature", &Model::sharper_curvature, "y"_a, Released())
      .def("min_depth", &Model::min_depth, "y"_a, Released())
      .def("by_width", &Model::by_width, "y"_a, Released())
      .def("at_depth", &Model::at_depth, "y"_a, "edges"_a, Released())
      .def("grid", &Model::grid, "edges"_a, Released())
      .def_prop_ro("kernel", &Model::kernel);
}

}  // namespace

void bind_bodies(nb::module_& m) {
  m.def(
      "product",
      [](const Matrix& a, const Matrix& b) {
        if (a.columns() != b.rows()) throw std::invalid_argument("a must have as many columns as b has rows");
        return product(a, b);
      },
      "a"_a, "b"_a, Released(), "a b, with the same last digits whatever the number of threads.");
  m.def(
      "solve_dense",
      [](Matrix a, Matrix b) {
        if (a.rows() != a.columns() || a.rows() != b.rows())
          throw std::invalid_argument("a must be square and have as many rows as b");
        return solve_dense(std::move(a), std::move(b));
      },
      "a"_a, "b"_a, Released(), "a^-1 b, with the same last digits whatever the number of threads.");
  bind_reliefs(m);
  bind_references(m);
  bind_model(m);
}

}  // namespace nonhertz
