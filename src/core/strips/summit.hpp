// Summits of the pressure: how accurate strips resolve them, and how high those are that they do not resolve.
#pragma once

#include <optional>

#include "strips/strips.hpp"

namespace nonhertz {

/// The strips of a solution: half-widths [mm], K q / a, and K times the load of each.
struct Pressures {
  const Grid& grid;
  Numbers half_width, pressure, load;

  Pressures(const Level& level, double hertz_ratio);
};

/// By what share of itself the pressure bends within a strip; 0 without pressure.
double sagitta(View pressure, Index at);

/// Whether the pressure falls on both sides of a strip, and reaches further on one of them at least.
bool is_summit(View pressure, Index at);

/// Whether the pressure rises ever faster to within two strips of a strip, at least on one side.
bool is_cusp(View pressure, Index at);

/// How high the pressure of a strip may reach that is narrower than its summit, zero if there is none.
double cusp(View pressure, Index at);

/// Whether a strip is so narrow that it lies on a corner of the profile.
bool is_on_corner(const Pressures& strips, Index at);

/// The strip centred on y, if it resolves a summit of the pressure within the contact.
std::optional<Index> resolved_summit(const Pressures& strips, double y);

/// The relative error of the pressure of a summit, estimated where it is, from those of two coarser grids.
///
/// What coarser grids have there says how accurate its pressure is, wherever they have their own maximum. The summit of
/// the parabola through the strip and its neighbours may lie beside its centre, and within the strip the pressure
/// departs from what the strip assumes. `regular`: whether the strips follow the ends of the contact.
double error_at_summit(const Pressures& strips, Index at, const Pressures& before, const Pressures& before_that,
                       bool regular);

/// The relative error of the largest pressure on a graded grid, from half of its strips; 0 where there is no summit.
double largest_summit_error(const Level& finest, const Level& half, double hertz_ratio);

// A summit towards which the pressure rises ever faster is narrower than its strips, as on a rounded corner. It may
// stand out by this many of the sagittas that they show.
inline constexpr double CUSP = 8.0;
inline constexpr double SAFETY = 2.0;  // times the change from a coarser grid

}  // namespace nonhertz
