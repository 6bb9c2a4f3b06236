// What a contact is made of, and a model of it.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"
#include "bodies/model.hpp"

namespace nonhertz {
namespace {

/// A profile of the user's: called with the interpreter's lock, wherever it is needed.
Function function(nb::callable profile) {
  return {[profile = std::move(profile)](View y, Row h) {
    const nb::gil_scoped_acquire lock;
    const auto places = VectorOut(y.data(), {y.size()}, nb::none());
    const auto relief = nb::cast<VectorIn>(profile(nb::cast(places, nb::rv_policy::copy)));
    if (relief.size() != y.size()) throw std::invalid_argument("relief must have the shape of y");
    std::copy_n(relief.data(), relief.size(), h.begin());
  }};
}

}  // namespace

void bind_bodies(nb::module_& m) {
  nb::class_<Arcs>(m, "Arcs").def(nb::init<double, double, double, double>());
  nb::class_<Logarithmic>(m, "Logarithmic").def(nb::init<double, double, double, double, double>());
  nb::class_<Function>(m, "Function")
      .def("__init__", [](Function* self, nb::typed<nb::callable, VectorOut(VectorOut)> of) {
        new (self) Function(function(std::move(of)));
      });
  nb::class_<Moved>(m, "Moved").def(nb::init<Formula, double, double, bool, double, double>());
  nb::class_<Relief>(m, "Relief").def(nb::init<std::vector<Moved>, double, double, double>());
  nb::class_<Body>(m, "Body").def(nb::init<Relief, double, double>());
  nb::class_<FreedFace>(m, "FreedFace").def(nb::init<double, double, double, double>());
  nb::class_<PointsAtDepth::FreeFace>(m, "FreeFace").def(nb::init<double, double, double>());
  nb::class_<PointsAtDepth>(m, "PointsAtDepth")
      .def("__init__", [](PointsAtDepth* self, double depth, double factor, std::vector<Term> terms,
                          std::vector<PointsAtDepth::FreeFace> faces, const VectorIn& over_image) {
        new (self) PointsAtDepth{depth, factor, std::move(terms), std::move(faces), numbers(over_image)};
      });
  nb::class_<AxisOfRoller>(m, "AxisOfRoller")
      .def("__init__", [](AxisOfRoller* self, double radius, double middle, double share, double half_length,
                          const MatrixIn& smooth, const MatrixIn& curved, double logarithm, double own) {
        new (self) AxisOfRoller{radius, middle, share, half_length, matrix(smooth), matrix(curved), logarithm, own};
      });
  nb::class_<Model>(m, "Model")
      .def("__init__",
           [](Model* self, std::array<Body, 2> bodies, std::shared_ptr<Element> element, std::vector<Term> terms,
              std::vector<Face> faces, std::vector<Reference> references, std::vector<FreedFace> freed,
              double compliance, Pair interval, const VectorIn& bends, const VectorIn& crests) {
             new (self) Model(Contact{std::move(bodies),
                                      {std::move(element), std::move(terms), std::move(faces)},
                                      std::move(references),
                                      std::move(freed),
                                      compliance,
                                      interval,
                                      numbers(bends),
                                      numbers(crests)});
           })
      .def("separation", [](const Model& self, const VectorIn& y) { return nb::cast(self.separation(numbers(y))); });
}

}  // namespace nonhertz
