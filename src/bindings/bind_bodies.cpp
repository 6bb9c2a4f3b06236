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

using CurvatureIn = std::variant<double, TabulatedDiameter, FunctionIn>;

Curvature curvature(CurvatureIn of) {
  if (auto* callable = std::get_if<FunctionIn>(&of)) return function(std::move(*callable));
  if (auto* table = std::get_if<TabulatedDiameter>(&of)) return std::move(*table);
  return std::get<double>(of);
}

using DepthIn = std::variant<double, DepthInDiameters>;

Depth depth_of(DepthIn of) {
  return std::visit([](auto&& depth) { return Depth(std::move(depth)); }, std::move(of));
}

/// Do what takes long without the interpreter's lock.
template <class Work>
auto without_lock(Work work) {
  const nb::gil_scoped_release unlocked;
  return work();
}

/// Without the interpreter's lock, what a model says of places.
template <class Answer>
auto asked(Answer (Model::*of)(View) const) {
  return [of](const Model& self, const VectorIn& y) {
    Answer answer = without_lock([&] { return (self.*of)(view(y)); });
    if constexpr (std::is_same_v<Answer, Matrix>)
      return matrix_of(std::move(answer));
    else
      return array_of(std::move(answer));
  };
}

/// The same of places and edges.
template <class Of>
auto asked(Matrix (Of::*of)(View, View) const) {
  return [of](const Of& self, const VectorIn& y, const VectorIn& edges) {
    return matrix_of(without_lock([&] { return (self.*of)(view(y), view(edges)); }));
  };
}

void bind_references(nb::module_& m) {
  nb::class_<TabulatedDiameter>(m, "TabulatedDiameter")
      .def(
          "__init__",
          [](TabulatedDiameter* self, const VectorIn& y, const VectorIn& diameter, double middle) {
            new (self) TabulatedDiameter{polyline(y, diameter), middle};
          },
          "y"_a, "diameter"_a, "middle"_a);
  nb::class_<DepthInDiameters>(m, "DepthInDiameters")
      .def(
          "__init__",
          [](DepthInDiameters* self, double diameters, CurvatureIn of, FunctionIn refuse) {
            new (self) DepthInDiameters{diameters, curvature(std::move(of)), function(std::move(refuse))};
          },
          "diameters"_a, "curvature"_a, "refuse"_a);
  nb::class_<WholeRoller>(m, "WholeRoller")
      .def(
          "__init__",
          [](WholeRoller* self, const VectorIn& z, const VectorIn& outer, const MatrixIn& smooth,
             const MatrixIn& curved, double logarithm, double beta) {
            new (self) WholeRoller{polyline(z, outer), matrix(smooth), matrix(curved), logarithm, beta};
          },
          "z"_a, "outer"_a, "smooth"_a, "curved"_a, "logarithm"_a, "beta"_a)
      .def("by_width", &WholeRoller::by_width, "radius"_a)
      .def("displacement", asked(&WholeRoller::displacement), "y"_a, "edges"_a);
  nb::class_<FarImages>(m, "FarImages")
      .def(
          "__init__",
          [](FarImages* self, const VectorIn& distance, const VectorIn& weight, double beyond, double length) {
            new (self) FarImages{numbers(distance), numbers(weight), beyond, length};
          },
          "distance"_a, "weight"_a, "beyond"_a, "length"_a);
  nb::class_<PointsAtDepth::FreeFace>(m, "FreeFace")
      .def(nb::init<double, double, double>(), "place"_a, "side"_a, "weight"_a);
  nb::class_<PointsAtDepth>(m, "PointsAtDepth")
      .def(
          "__init__",
          [](PointsAtDepth* self, DepthIn depth, double factor, std::vector<Term> terms, std::optional<FarImages> far,
             std::vector<PointsAtDepth::FreeFace> faces, const VectorIn& over_image) {
            new (self)
                PointsAtDepth{depth_of(std::move(depth)), factor, std::move(terms), std::move(far), std::move(faces),
                              numbers(over_image)};
          },
          "depth"_a, "poisson_factor"_a, "terms"_a, "far"_a.none(), "faces"_a, "over_image"_a)
      .def("displacement", asked(&PointsAtDepth::displacement), "y"_a, "edges"_a);
  nb::class_<AxisOfCylinder>(m, "AxisOfCylinder")
      .def(
          "__init__",
          [](AxisOfCylinder* self, DepthIn diameter, std::shared_ptr<Cubics> smooth, std::vector<Term> terms) {
            new (self) AxisOfCylinder{depth_of(std::move(diameter)), std::move(smooth), std::move(terms)};
          },
          "diameter"_a, "smooth"_a, "terms"_a)
      .def("displacement", asked(&AxisOfCylinder::displacement), "y"_a, "edges"_a);
  nb::class_<OtherReference>(m, "OtherReference")
      .def(
          "__init__",
          [](OtherReference* self, FunctionIn below, MatrixFunctionIn displaced) {
            new (self) OtherReference{function(std::move(below)), matrix_function(std::move(displaced))};
          },
          "below"_a, "displaced"_a);
  nb::class_<AxisOfRoller>(m, "AxisOfRoller")
      .def(
          "__init__",
          [](AxisOfRoller* self, double depth, std::shared_ptr<WholeRoller> whole, double radius, double middle,
             double share) {
            new (self) AxisOfRoller{depth, std::move(whole), radius, middle, share};
          },
          "depth"_a, "whole"_a, "radius"_a, "middle"_a, "share"_a)
      .def("displacement", asked(&AxisOfRoller::displacement), "y"_a, "edges"_a)
      .def(
          "by_width",
          [](const AxisOfRoller& self, const VectorIn& y, double ratio) {
            Matrix found(4, y.size());
            std::fill(found.all().begin(), found.all().end(), 0.0);
            add_by_width(self, view(y), ratio, found);
            return matrix_of(std::move(found));
          },
          "y"_a, "ratio"_a);
}

void bind_model(nb::module_& m) {
  nb::class_<Body>(m, "Body").def(
      "__init__",
      [](Body* self, std::shared_ptr<Relief> relief, CurvatureIn of, double modulus) {
        new (self) Body{std::move(relief), curvature(std::move(of)), modulus};
      },
      "relief"_a, "curvature"_a, "modulus"_a);
  nb::class_<FreedFace>(m, "FreedFace")
      .def(nb::init<double, double, double, double>(), "y"_a, "side"_a, "image_weight"_a, "free"_a);
  nb::class_<Model>(m, "Model")
      .def(
          "__init__",
          [](Model* self, std::array<Body, 2> bodies, Kernel kernel, std::vector<Reference> references,
             std::vector<FreedFace> freed, double compliance, Pair interval, const VectorIn& bends,
             const VectorIn& crests, FunctionIn refuse) {
            Contact contact{std::move(bodies), std::move(kernel), std::move(references),
                            std::move(freed),  compliance,        interval,
                            numbers(bends),    numbers(crests),   function(std::move(refuse))};
            const nb::gil_scoped_release unlocked;
            new (self) Model(std::move(contact));
          },
          "bodies"_a, "kernel"_a, "references"_a, "freed"_a, "compliance"_a, "interval"_a, "bends"_a, "crests"_a,
          "refuse"_a)
      .def("separation", asked(static_cast<Numbers (Model::*)(View) const>(&Model::separation)), "y"_a)
      .def("curvature", asked(&Model::curvature), "y"_a)
      .def("sharper_curvature", asked(&Model::sharper_curvature), "y"_a)
      .def("min_depth", asked(&Model::min_depth), "y"_a)
      .def("by_width", asked(&Model::by_width), "y"_a)
      .def("at_depth", asked(&Model::at_depth), "y"_a, "edges"_a)
      .def(
          "grid", [](const Model& self, const VectorIn& edges) { return self.grid(numbers(edges)); }, "edges"_a)
      .def_prop_ro("kernel", &Model::kernel);
}

}  // namespace

void bind_bodies(nb::module_& m) {
  m.def(
      "product",
      [](const MatrixIn& a, const MatrixIn& b) {
        if (a.shape(1) != b.shape(0)) throw std::invalid_argument("a must have as many columns as b has rows");
        const Matrix left = copy_of(a), right = copy_of(b);
        return matrix_of(without_lock([&] { return product(left, right); }));
      },
      "a"_a, "b"_a, "a b, with the same last digits whatever the number of threads.");
  m.def(
      "solved",
      [](const MatrixIn& a, const MatrixIn& b) {
        if (a.shape(0) != a.shape(1) || a.shape(0) != b.shape(0))
          throw std::invalid_argument("a must be square and have as many rows as b");
        Matrix left = copy_of(a), right = copy_of(b);
        return matrix_of(without_lock([&] { return solved(std::move(left), std::move(right)); }));
      },
      "a"_a, "b"_a, "a^-1 b, with the same last digits whatever the number of threads.");
  bind_reliefs(m);
  bind_references(m);
  bind_model(m);
}

}  // namespace nonhertz
