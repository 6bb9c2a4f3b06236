// A map: a fast surrogate of a contact, evaluated without allocations and with exact derivatives.
//
// At a tilt gamma the state of a contact is a function of its load Q, and of one surface D(x, gamma), its *mean
// approach*: the approach averaged over all loads from 0 to Q, with x = (Q / Q_most)^(1/3). Then
//
//     approach  delta = d(Q D) / dQ = D + x/3 dD/dx,        moment  T = -Q dD/dgamma,
//
// because Q D is the complementary energy, whose derivatives are the approach and the negative moment. Derivatives of
// both follow from second derivatives of D, and the stiffness is symmetric for any D. D is a spline of degree 5,
// evaluated from one polynomial of 6 x 6 coefficients in each of its cells. If approach and tilt are given, x is found
// by Newton's method on the square root of approach - first touch, which is nearly linear in x.
//
// Across tilts the spline has the coordinate z = asinh((gamma - centre) / (narrow + widening x^3)), scaled to 0 ... 1.
// A body that touches along a straight length tips over between its ends within a tilt proportional to the load; in z
// this range has the same width at every load. Without such a length, widening is zero and z is proportional to the
// tilt.
//
// The distribution of the load along the contact is stored as the positions up to which the contact carries given
// fractions of it. These move smoothly where the load on a fixed strip would have a kink as the contact reaches it.
#pragma once

#include <array>

#include "numbers/array.hpp"

namespace nonhertz {

/// A contact at an approach and a tilt; outside the range of the map load and moment are continued linearly.
struct MapState {
  double approach, tilt;                                  ///< [mm], [rad]
  double load, moment;                                    ///< [N], [N mm]
  double load_by_approach, load_by_tilt, moment_by_tilt;  ///< moment_by_approach is load_by_tilt
  bool inside;                                            ///< whether the point is in the range of the map
};

struct PressureAndWidth {
  double max_pressure, max_half_width;  ///< [MPa], [mm]
};

/// z at x and a tilt, and its derivatives by both.
struct TiltCoordinate {
  double z, by_x, by_tilt, by_x_twice, by_x_and_tilt, by_tilt_twice;
};

/// The range of a map and the three numbers of its tilt coordinate: the first numbers of a map.
struct MapHead {
  double max_load, lowest_tilt, highest_tilt;  ///< [N], [rad]
  double centre, narrow, widening;             ///< [rad]
  double rise;                                 ///< typical growth of the approach up to the largest load [mm]
  double low_end, high_end;                    ///< of the contact [mm]
  double load_cells, tilt_cells;               ///< numbers of cells

  TiltCoordinate tilt_coordinate(double x, double tilt) const;
};

/// A view of the numbers of a map in one row: `MapHead`, the borders of cells in x, then in z, and for every cell 36
/// coefficients of the mean approach; then, cell by cell and 36 for each, those of largest pressure / x, of largest
/// half-width / x and of the positions up to which the contact carries sin^2(k pi / 48) of the load, k = 0 ... 24.
class ContactMap {
 public:
  static constexpr Index QUANTILES = 25;

  explicit ContactMap(const double* numbers);

  /// Return the number of numbers of a map, from its head.
  static Index size(const MapHead& head);
  /// The same up to the coefficients of the mean approach, the only ones that `pressed` and `loaded` read.
  static Index size_of_mean_approach(const MapHead& head);

  /// Return the state at an approach [mm] and a tilt [rad]; out of contact load, moment and stiffness are zero.
  MapState at_approach(double approach, double tilt) const;

  /// Return the state under a load [N] and at a tilt [rad]; without load that of first touch, without stiffness.
  MapState at_load(double load, double tilt) const;

  /// Return largest pressure and half-width; outside the range those of the nearest load and tilt within it.
  PressureAndWidth pressures(double load, double tilt) const;

  /// Fill in the loads on the strips between ascending stations [mm].
  void share(double load, double tilt, View stations, Row strip_loads) const;

 private:
  /// Location of a point: the index of its cell, the place in it from 0 to 1, and one over the cell's sizes.
  struct Place {
    Index cell;
    double t, u, by_width, by_height;
  };
  struct Under {
    double x;
    Place at;
  };
  /// Approach and moment / load ("arm") at x and a tilt, with their derivatives.
  struct Surface {
    double approach, approach_by_x, arm, arm_by_x, arm_by_tilt;
  };
  struct Touch {
    double approach, arm;
  };
  struct Pressed {
    double x, last;  ///< last: the approach under the largest load
    Surface surface;
  };

  Place place(double x, double z) const;
  Under under(double load, double tilt) const;
  Surface at(double x, double tilt) const;
  Touch first_touch(double tilt) const;
  Pressed press(double tilt, double first, double approach) const;
  MapState state(double x, double tilt, const Surface& surface, bool inside) const;
  double within(double tilt) const;
  double quantity(const Place& at, Index number) const;

  const MapHead& head_;
  Index load_cells_, tilt_cells_;
  const double *x_borders_, *z_borders_, *mean_approach_, *others_;
};

/// Fill in the load on the strips between stations from positions up to which sin^2(k pi / 48) of it is carried.
void share_out(std::array<double, ContactMap::QUANTILES> places, double load, View stations, Row strip_loads);

}  // namespace nonhertz
