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

using RangesIn = nb::ndarray<const std::int64_t, nb::shape<-1, 2>, nb::c_contig, nb::device::cpu>;
using PointsIn = nb::ndarray<const double, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;
using SixesInOut = nb::ndarray<double, nb::shape<-1, 6>, nb::c_contig, nb::device::cpu>;

std::vector<Panels::Range> ranges(const RangesIn& array) {
  std::vector<Panels::Range> ranges;
  for (std::size_t i = 0; i < array.shape(0); ++i) ranges.push_back({array(i, 0), array(i, 1)});
  return ranges;
}

View view(const PointsIn& array) { return {array.data(), array.size()}; }
Row row(const SixesInOut& array) { return {array.data(), array.size()}; }

}  // namespace

void bind_subsurface(nb::module_& m) {
  nb::class_<Load>(m, "SurfaceLoad")
      .def(
          "six",
          [](const Load& self, const PointsIn& points, const Matrix& terms, double poisson, bool displaced) {
            Numbers six(6 * points.shape(0));
            {
              const nb::gil_scoped_release released;
              below_load(self, rows_of<Term>(terms), poisson, displaced, view(points), six);
            }
            return writable(std::move(six), {points.shape(0), 6});
          },
          "points"_a, "terms"_a, "poisson"_a, "displaced"_a);
  m.def(
      "strip_load",
      [](Numbers low, Numbers high, Numbers line_load, Numbers half_width, std::vector<Index> first) {
        return Load{
            Lamination{std::move(low), std::move(high), std::move(line_load), std::move(half_width), std::move(first)}};
      },
      "low"_a, "high"_a, "line_load"_a, "half_width"_a, "first"_a);
  m.def(
      "rectangles",
      [](Numbers x_edges, Numbers y_edges, Matrix pressure, const RangesIn& columns, const RangesIn& rows,
         Numbers middle, Numbers half, std::vector<Index> starts, Matrix nodes, Matrix weights, Matrix ellipses) {
        return Load{Panels{std::move(x_edges), std::move(y_edges), std::move(pressure), ranges(columns), ranges(rows),
                           std::move(middle), std::move(half), std::move(starts), std::move(nodes), std::move(weights),
                           std::move(ellipses)}};
      },
      "x_edges"_a, "y_edges"_a, "pressure"_a, "columns"_a, "rows"_a, "middle"_a, "half"_a, "starts"_a, "nodes"_a,
      "weights"_a, "ellipses"_a);
  nb::class_<SemiEllipseRules> rules(m, "SemiEllipseRules");
  rules.def_ro("starts", &SemiEllipseRules::starts);
  view_property(rules, "nodes", &SemiEllipseRules::nodes);
  view_property(rules, "weights", &SemiEllipseRules::weights);
  view_property(rules, "enough", &SemiEllipseRules::enough);
  m.def("semi_ellipse_rules", &semi_ellipse_rules, nb::rv_policy::reference);
  m.def("stress_tail", &stress_tail<double>, "X"_a, "Y"_a, "z"_a, "poisson"_a);
  m.def("displacement_tail", &displacement_tail<double>, "X"_a, "Y"_a, "z"_a, "poisson"_a);
  m.def(
      "add_from_afar",
      [](const PointsIn& points, double low, double high, double line_load, double poisson, const SixesInOut& total) {
        add_from_afar(low, high, line_load, poisson, view(points), row(total));
      },
      Released());
  m.def(
      "at_nodes",
      [](View panels, const Matrix& to_nodes, View weights, View k, View edges, const Matrix& steps) {
        return at_nodes({panels, to_nodes, weights}, k, edges, steps);
      },
      "panels"_a, "to_nodes"_a, "weights"_a, "k"_a, "edges"_a, "steps"_a, Released());
  m.def("between_distances", &between_distances, "knots"_a, "log_k"_a, "log_r"_a, "coefficients"_a, Released());
  nb::class_<Wall>(m, "Wall")
      .def("__init__",
           [](Wall* self, const nb::ndarray<const double, nb::ndim<4>, nb::c_contig, nb::device::cpu>& modes,
              double top, Numbers places, Numbers forces) {
             const auto extent = [&modes](int axis) { return static_cast<Index>(modes.shape(axis)); };
             new (self)
                 Wall{extent(0), extent(2),         extent(3),        {modes.data(), modes.data() + modes.size()},
                      top,       std::move(places), std::move(forces)};
           })
      .def(
          "add",
          [](const Wall& self, const PointsIn& points, View along, View outer, View inner, double poisson,
             const SixesInOut& total) { add_wall(self, poisson, view(points), along, outer, inner, row(total)); },
          Released());
}

}  // namespace nonhertz
