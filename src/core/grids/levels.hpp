// Grids solved from coarse to fine: each solution is the start of the next and determines its strips.
//
// On strips that are wide compared with the half-width the Newton loop converges from springs; on narrow ones it needs
// a start with the shape of the contact, which a coarser level provides. The levels also give an error estimate.
#pragma once

#include <deque>
#include <limits>

#include "grids/laying.hpp"
#include "grids/region.hpp"
#include "strips/continuation.hpp"
#include "strips/solving.hpp"

namespace nonhertz {

// Measured on 300 random contacts of the usual profiles: at the coarseness of `search.cpp` the error of the approach is
// below ACCURACY, and mostly below this fraction of the change from half the strips.
inline constexpr double ACCURACY = 1e-4, LEFT_OF_CHANGE = 0.4;

/// The relative errors that an automatic grid aims for.
struct Accuracy {
  double of_motion = ACCURACY;                                   ///< of the approach, or of the load
  double of_pressure = std::numeric_limits<double>::infinity();  ///< of the largest pressure, if requested
};

/// Solutions of one case, finest first; coarser ones that did not converge are left out.
struct Levels {
  std::vector<Level> levels;
  double accuracy =
      0.0;  ///< target if the first two levels are a grid with its edges on the ends, and half of it; else 0
};

/// Solve one case on a graded grid adapted to the contact; throws Refused, or Stopped.
Levels solve_automatically(const Model& model, const Prescription& prescribed, const Accuracy& accuracy,
                           const Stop* stop = nullptr);

using Grids = std::vector<std::shared_ptr<const Grid>>;

/// A number of equal strips where the bodies can touch, and half as many down to a few; finest first.
Grids equal_grids(const Model& model, const Prescription& prescribed, Index count);
/// Strips between given edges, and coarser ones that leave out every other edge.
Grids given_grids(const Model& model, Numbers edges);

/// A grid with its loop, and the extrapolation of its solutions.
struct Track {
  Track(std::shared_ptr<const Grid> of, const Kernel& kernel) : grid(std::move(of)), loop(*grid, kernel) {}

  std::shared_ptr<const Grid> grid;
  std::shared_ptr<const Grid> light;  ///< the same without the full matrix, for results
  Newton loop;
  Continuation solutions;
};

/// Solve one case on given grids, finest first, on which others may have been solved before.
Levels solve_on_grids(std::deque<Track>& tracks, const Prescription& prescribed, const Stop* stop = nullptr);

}  // namespace nonhertz
