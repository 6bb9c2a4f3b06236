// A body across the contact: its curvature and its depth, which may vary along the axis.
#pragma once

#include <variant>

#include "bodies/relief.hpp"

namespace nonhertz {

/// A diameter that changes along the axis, linear between points.
struct TabulatedDiameter {
  Polyline diameter;  ///< [mm], over the distance from the middle of the body
  double middle;      ///< position of the middle [mm]
};

/// 1/R [1/mm], negative where concave: a constant, a table, or a function.
using Curvature = std::variant<double, TabulatedDiameter, Function>;

/// Depth in diameters of the body.
struct DepthInDiameters {
  double diameters;
  Curvature curvature;
  Function refuse;  ///< the same in Python, which raises the error where the body is not convex
};

/// Depth below the surface [mm], compared with which half-widths must be small.
using Depth = std::variant<double, DepthInDiameters, Function>;

void fill(const Curvature& curvature, View y, Row out);
void fill(const Depth& depth, View y, Row out);

}  // namespace nonhertz
