// Difference between a whole roller and a flat body with free ends: src/nonhertz/bodies/whole_roller.py has the theory.
#pragma once

#include <array>
#include <memory>

#include "numbers/interpolation.hpp"

namespace nonhertz {

/// Displacement of a whole roller minus that of a flat body with free ends; lengths in its radius.
struct WholeRoller {
  Polyline outer;                        ///< radius of the surface along the axis, from side face to side face
  std::shared_ptr<const Matrix> smooth;  ///< the smooth part, between normalised Legendre polynomials
  std::shared_ptr<const Matrix>
      curved;        ///< table of the curved part: values and slopes, without its logarithm and with it
  double logarithm;  ///< the factor of s ln s in the curved part
  double beta;       ///< (1 - 2 nu) / (2 (1 - nu)), the factor of the curved part in plane strain

  double half_length() const { return outer.places.back(); }
  /// Distance of the surface from the axis; the radius is measured normal to the surface.
  double girth(double z) const;
  /// C0 to C3 of the effect of its half-width b on a strip itself, relative to a strip of usual width:
  /// C0 + C1 b + (C2 ln b + C3) b^2, where the radius of the surface is in the unit of b.
  std::array<double, 4> by_width(double radius) const;
  /// Displacement at y under a unit load of usual width between neighbouring edges, shape (places, strips).
  Matrix displacement(View y, View edges) const;
};

}  // namespace nonhertz
