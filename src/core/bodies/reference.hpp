// What the displacement of a body is measured against, and how it moves under the loads on its surface.
#pragma once

#include <variant>

#include "strips/kernel.hpp"

namespace nonhertz {

/// Points at one depth below the centre line.
struct PointsAtDepth {
  double depth;             ///< [mm]
  double poisson_factor;    ///< 1 / (2 (1 - nu))
  std::vector<Term> terms;  ///< as for the surface, for this body alone
  struct FreeFace {
    double place, side, weight;
  };
  std::vector<FreeFace> faces;  ///< side faces that are free of normal stress, too
  Numbers over_image;           ///< polynomial: what such a face adds far away over what the image does
};

/// The axis of a whole cylindrical roller: what its displacement is less than that of a flat body with free ends.
struct AxisOfRoller {
  double radius, middle, share;          ///< [mm], and the share in the compliance
  double half_length;                    ///< [radii]
  std::shared_ptr<const Matrix> matrix;  ///< the smooth part, between normalised Legendre polynomials
  std::shared_ptr<const Matrix> curved;  ///< table of the curved part, made by Python once for a Poisson's ratio
  double logarithm, own;
};

using Reference = std::variant<PointsAtDepth, AxisOfRoller>;

/// Depth below the surface [mm], compared with which half-widths must be small.
double depth_of(const Reference& reference);

/// Add the displacement under places y per unit of K q of strips between edges, shape (places, strips).
void add_displacement(const Reference& reference, View y, View edges, Matrix& out);

}  // namespace nonhertz
