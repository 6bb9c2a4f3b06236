// What the displacement of a body is measured against, and how it moves under the loads on its surface.
#pragma once

#include <optional>
#include <variant>

#include "bodies/section.hpp"
#include "bodies/whole_roller.hpp"
#include "strips/kernel.hpp"

namespace nonhertz {

/// Images of a series as line loads at multiples of the body's length; those beyond the last as an integral.
struct FarImages {
  Numbers distance, weight;  ///< of each on either side [mm]
  double beyond, length;     ///< where the integral begins, and of the body [mm]

  /// Their displacement at the surface less that at a depth, per unit of load.
  double less_depth(double depth, double poisson_factor) const;
};

/// Points below the centre line.
struct PointsAtDepth {
  Depth depth;
  double poisson_factor;         ///< 1 / (2 (1 - nu))
  std::vector<Term> terms;       ///< as for the surface, for this body alone
  std::optional<FarImages> far;  ///< of a series
  struct FreeFace {
    double place, side, weight;
  };
  std::vector<FreeFace> faces;  ///< side faces that are free of normal stress, too
  Numbers over_image;           ///< polynomial: what such a face adds far away over what the image does

  Matrix displacement(View y, View edges) const;
};

/// The axis of a solid cylinder of infinite length: what its displacement is less than that of a flat body.
struct AxisOfCylinder {
  Depth depth;                           ///< the diameter
  std::shared_ptr<const Cubics> smooth;  ///< the smooth part over a distance in radii; beyond, 1 / s is all there is
  std::vector<Term> terms;

  Matrix displacement(View y, View edges) const;
};

/// The axis of a whole roller: what its displacement is less than that of a flat body with free ends.
struct AxisOfRoller {
  Depth depth;  ///< the diameter, or the wall
  std::shared_ptr<const WholeRoller> whole;
  double radius, middle, share;  ///< [mm], and the share in the compliance

  Matrix displacement(View y, View edges) const;
};

/// Displacement at places of all strips between edges, worked out in Python, whose lock it takes.
using MatrixFunction = std::function<Matrix(View y, View edges)>;

/// Any other, whose displacement is a function of places and edges.
struct OtherReference {
  Depth depth;
  MatrixFunction displaced;

  Matrix displacement(View y, View edges) const { return displaced(y, edges); }
};

using Reference = std::variant<PointsAtDepth, AxisOfCylinder, AxisOfRoller, OtherReference>;

/// Displacement under places y per unit of K q of strips between edges, shape (places, strips).
Matrix displacement(const Reference& reference, View y, View edges);

/// Add what half-widths, times a ratio Hertz's, change on strips at y: coefficients of `WholeRoller::by_width` (rows).
void add_by_width(const AxisOfRoller& of, View y, double ratio, Matrix& out);

}  // namespace nonhertz
