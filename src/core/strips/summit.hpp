// Summits of the pressure: accuracy of resolved ones, and possible height of unresolved ones.
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

/// Relative sagitta of the pressure within a strip; 0 without pressure.
double sagitta(View pressure, Index at);

/// Whether the pressure falls on both sides of a strip, and extends further on at least one of them.
bool is_summit(View pressure, Index at);

/// Whether the pressure rises ever faster up to two strips from a strip, on at least one side.
bool is_cusp(View pressure, Index at);

/// Possible height of a summit that is narrower than its strip, zero if there is none.
double cusp(View pressure, Index at);

/// Whether a strip is so narrow that it lies on a corner of the profile.
bool is_on_corner(const Pressures& strips, Index at);

/// The strip centred on y, if it resolves a summit of the pressure within the contact.
std::optional<Index> resolved_summit(const Pressures& strips, double y);

/// The relative error of the pressure of a summit, estimated where it is, from those of two coarser grids.
///
/// The values of coarser grids at the same place show how accurate its pressure is, wherever their own maximum is. The
/// vertex of the parabola through the strip and its neighbours may lie beside its centre, and within the strip the
/// pressure departs from the assumed one. `regular`: whether the strips follow the ends of the contact.
double error_at_summit(const Pressures& strips, Index at, const Pressures& before, const Pressures& before_that,
                       bool regular);

/// The relative error of the largest pressure on a graded grid, from half of its strips; 0 where there is no summit.
double largest_summit_error(const Level& finest, const Level& half, double hertz_ratio);

// A summit towards which the pressure rises ever faster is narrower than its strips, as at a rounded corner. It may
// exceed them by this many times the sagitta that they show.
inline constexpr double CUSP = 8.0;
inline constexpr double SAFETY = 2.0;  // times the change from a coarser grid

}  // namespace nonhertz
