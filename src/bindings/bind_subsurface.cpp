// The field below a pressure.
#include <nanobind/stl/array.h>
#include <nanobind/stl/vector.h>

#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"
#include "subsurface/face_table.hpp"
#include "subsurface/load.hpp"
#include "subsurface/tails.hpp"
#include "subsurface/wall.hpp"

namespace nonhertz {
namespace {

using IndicesIn = nb::ndarray<const std::int64_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using RangesIn = nb::ndarray<const std::int64_t, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using PointsIn = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using TermsIn = PointsIn;
using SixesOut = nb::ndarray<nb::numpy, double, nb::shape<-1, 6>>;
using SixesInOut = nb::ndarray<double, nb::shape<-1, 6>, nb::c_contig, nb::device::cpu>;

std::vector<Index> indices(const IndicesIn& array) { return {array.data(), array.data() + array.size()}; }

std::vector<Panels::Range> ranges(const RangesIn& array) {
  std::vector<Panels::Range> found;
  for (std::size_t i = 0; i < array.shape(0); ++i) found.push_back({array(i, 0), array(i, 1)});
  return found;
}

View view(const PointsIn& array) { return {array.data(), array.size()}; }
Row row(const SixesInOut& array) { return {array.data(), array.size()}; }

std::vector<Term> terms_of(const TermsIn& array) {
  std::vector<Term> found;
  for (std::size_t i = 0; i < array.shape(0); ++i) found.push_back({array(i, 0), array(i, 1), array(i, 2)});
  return found;
}

/// Six numbers for each of some points, which what is called fills in while Python goes on.
template <class Fill>
SixesOut sixes(std::size_t count, Fill fill) {
  auto values = std::make_unique_for_overwrite<double[]>(6 * count);
  {
    const nb::gil_scoped_release released;
    fill(Row{values.get(), 6 * count});
  }
  double* data = values.get();
  nb::capsule owner(values.release(), [](void* p) noexcept { delete[] static_cast<double*>(p); });
  return SixesOut(data, {count, 6}, owner);
}

/// What is computed while Python goes on.
template <class Compute>
MatrixOut released(Compute compute) {
  Matrix found;
  {
    const nb::gil_scoped_release others;
    found = compute();
  }
  return matrix_of(std::move(found));
}

}  // namespace

void bind_subsurface(nb::module_& m) {
  nb::class_<Load>(m, "SurfaceLoad")
      .def(
          "six",
          [](const Load& self, const PointsIn& points, const TermsIn& terms, double poisson, bool displaced) {
            return sixes(points.shape(0), [&, images = terms_of(terms)](Row out) {
              below_load(self, images, poisson, displaced, view(points), out);
            });
          },
          "points"_a, "terms"_a, "poisson"_a, "displaced"_a, nb::rv_policy::reference);
  m.def(
      "strip_load",
      [](const VectorIn& low, const VectorIn& high, const VectorIn& line_load, const VectorIn& half_width,
         const IndicesIn& first) {
        return Load{Lamination{numbers(low), numbers(high), numbers(line_load), numbers(half_width), indices(first)}};
      },
      "low"_a, "high"_a, "line_load"_a, "half_width"_a, "first"_a);
  m.def(
      "rectangles",
      [](const VectorIn& x_edges, const VectorIn& y_edges, const MatrixIn& pressure, const RangesIn& columns,
         const RangesIn& rows, const VectorIn& middle, const VectorIn& half, const IndicesIn& starts,
         const MatrixIn& nodes, const MatrixIn& weights, const MatrixIn& ellipses) {
        return Load{Panels{numbers(x_edges), numbers(y_edges), copy_of(pressure), ranges(columns), ranges(rows),
                           numbers(middle), numbers(half), indices(starts), copy_of(nodes), copy_of(weights),
                           copy_of(ellipses)}};
      },
      "x_edges"_a, "y_edges"_a, "pressure"_a, "columns"_a, "rows"_a, "middle"_a, "half"_a, "starts"_a, "nodes"_a,
      "weights"_a, "ellipses"_a);
  nb::class_<SemiEllipseRules>(m, "SemiEllipseRules")
      .def_prop_ro(
          "nodes", [](nb::handle self) { return view_of(nb::cast<const SemiEllipseRules&>(self).nodes, self); },
          nb::rv_policy::reference)
      .def_prop_ro(
          "weights", [](nb::handle self) { return view_of(nb::cast<const SemiEllipseRules&>(self).weights, self); },
          nb::rv_policy::reference)
      .def_ro("starts", &SemiEllipseRules::starts)
      .def_prop_ro(
          "enough", [](nb::handle self) { return view_of(nb::cast<const SemiEllipseRules&>(self).enough, self); },
          nb::rv_policy::reference);
  m.def("semi_ellipse_rules", &semi_ellipse_rules, nb::rv_policy::reference);
  m.def("stress_tail", &stress_tail<double>, "X"_a, "Y"_a, "z"_a, "poisson"_a);
  m.def("displacement_tail", &displacement_tail<double>, "X"_a, "Y"_a, "z"_a, "poisson"_a);
  m.def(
      "add_from_afar",
      [](const PointsIn& points, double low, double high, double line_load, double poisson, const SixesInOut& total) {
        add_from_afar(low, high, line_load, poisson, view(points), row(total));
      },
      nb::call_guard<nb::gil_scoped_release>());
  m.def(
      "at_nodes",
      [](const VectorIn& panels, const MatrixIn& to_nodes, const VectorIn& weights, const VectorIn& k,
         const VectorIn& edges, const MatrixIn& steps) {
        const Matrix to = copy_of(to_nodes), of_edges = copy_of(steps);
        const LoadPanels on{nonhertz::view(panels), to, nonhertz::view(weights)};
        return released([&] { return at_nodes(on, nonhertz::view(k), nonhertz::view(edges), of_edges); });
      },
      "panels"_a, "to_nodes"_a, "weights"_a, "k"_a, "edges"_a, "steps"_a, nb::rv_policy::reference);
  m.def(
      "between_distances",
      [](const VectorIn& knots, const VectorIn& log_k, const VectorIn& log_r, const MatrixIn& coefficients) {
        const Matrix of_splines = copy_of(coefficients);
        return released([&] {
          return between_distances(nonhertz::view(knots), nonhertz::view(log_k), nonhertz::view(log_r), of_splines);
        });
      },
      "knots"_a, "log_k"_a, "log_r"_a, "coefficients"_a, nb::rv_policy::reference);
  nb::class_<Wall>(m, "Wall")
      .def("__init__",
           [](Wall* self, const nb::ndarray<const double, nb::ndim<4>, nb::c_contig, nb::device::cpu>& modes,
              double top, const VectorIn& places, const VectorIn& forces) {
             const auto extent = [&modes](int axis) { return static_cast<Index>(modes.shape(axis)); };
             new (self)
                 Wall{extent(0), extent(2),       extent(3),      Numbers(modes.data(), modes.data() + modes.size()),
                      top,       numbers(places), numbers(forces)};
           })
      .def(
          "add",
          [](const Wall& self, const PointsIn& points, const VectorIn& along, const VectorIn& outer,
             const VectorIn& inner, double poisson, const SixesInOut& total) {
            add_wall(self, poisson, view(points), nonhertz::view(along), nonhertz::view(outer), nonhertz::view(inner),
                     row(total));
          },
          nb::call_guard<nb::gil_scoped_release>());
}

}  // namespace nonhertz
