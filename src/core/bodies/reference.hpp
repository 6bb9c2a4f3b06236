// Reference points of a body's displacement, and their motion under the loads on its surface.
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
  double beyond, length;     ///< start of the integral, and length of the body [mm]

  /// Their displacement at the surface minus that at a depth, per unit of load.
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
  std::vector<FreeFace> faces;  ///< side faces that are also free of normal stress
  Numbers over_image;           ///< polynomial: far-field correction of such a face over the effect of the image

  Matrix displacement(View y, View edges) const;
};

/// The axis of a solid cylinder of infinite length: displacement of a flat body minus that of the cylinder.
struct AxisOfCylinder {
  Depth depth;  ///< the diameter
  std::shared_ptr<const Cubics>
      smooth;  ///< the smooth part over a distance in radii; beyond its end only 1 / s remains
  std::vector<Term> terms;

  Matrix displacement(View y, View edges) const;
};

/// The axis of a whole roller: displacement of a flat body with free ends minus that of the roller.
struct AxisOfRoller {
  Depth depth;  ///< the diameter, or the wall thickness
  std::shared_ptr<const WholeRoller> whole;
  double radius, middle, share;  ///< [mm], and the share in the compliance

  Matrix displacement(View y, View edges) const;
};

/// Displacement at places of all strips between edges, computed in Python, whose lock it takes.
using MatrixFunction = std::function<Matrix(View y, View edges)>;

/// Any other reference, whose displacement is a function of places and edges.
struct OtherReference {
  Depth depth;
  MatrixFunction displaced;

  Matrix displacement(View y, View edges) const { return displaced(y, edges); }
};

using Reference = std::variant<PointsAtDepth, AxisOfCylinder, AxisOfRoller, OtherReference>;

/// Displacement under places y per unit of K q of strips between edges, shape (places, strips).
Matrix displacement(const Reference& reference, View y, View edges);

/// Add the effect of half-widths, `ratio` times Hertz's, on strips at y: coefficients of `WholeRoller::by_width`
/// (rows).
void add_by_width(const AxisOfRoller& of, View y, double ratio, Matrix& out);

}  // namespace nonhertz
