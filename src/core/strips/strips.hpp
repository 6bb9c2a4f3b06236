// Common structures of the core: a grid, the prescribed values, and the state reached by the loop.
//
// Loads are multiplied by the compliance K of the contact, so that K q has the unit of a length and K Q of its square.
#pragma once

#include <array>
#include <memory>

#include "numbers/array.hpp"

namespace nonhertz {

using Pair = std::array<double, 2>;

/// Strips, with all their data other than loads.
struct Grid {
  Numbers edges;                  ///< ascending [mm]
  Numbers y;                      ///< centres [mm]
  Numbers separation, curvature;  ///< h [mm] and 1/rho [1/mm] at the centres
  Numbers min_depth, sharper;     ///< the smaller of both depths [mm], the larger of both curvatures in magnitude
  Matrix at_depth;                ///< displacement of the reference points per K q; empty if they do not move
  Matrix by_width;                ///< effect of a on the strip itself, rows C0 to C3; empty on flat surfaces

  Index count() const { return count_of(y); }
  double low(Index i) const { return edges[i]; }
  double high(Index i) const { return edges[i + 1]; }
  double width(Index i) const { return edges[i + 1] - edges[i]; }
  double half_length() const { return 0.5 * (edges.back() - edges.front()); }
};

/// Whether load or approach, and moment or tilt, are given, and their values.
struct Prescription {
  std::array<bool, 2> by_force;
  Pair target;  ///< K Q [mm^2] or delta [mm]; K T [mm^3] or gamma [rad]

  bool both() const { return by_force[0] && by_force[1]; }
};

enum class Status { converged, iteration_limit, stagnated };

/// The unknowns of strips, and derived values.
struct State {
  Numbers r, m;                     ///< K q / a^2 and a^2; m = 0 marks a strip out of contact
  Numbers gap;                      ///< on the centre line [mm]
  Pair rigid{};                     ///< approach and tilt
  std::array<Pair, 2> stiffness{};  ///< K d(Q, T) / d(approach, tilt)
  Status status = Status::stagnated;
  int steps = 0;
  double residual = 0.0;

  explicit State(Index n) : r(n), m(n), gap(n) {}
  bool converged() const { return status == Status::converged; }
  double interference(const Grid& grid, Index i) const { return rigid[0] + rigid[1] * grid.y[i] - grid.separation[i]; }
};

/// A state with its strips.
struct Level {
  std::shared_ptr<const Grid> grid;
  State state;
};

}  // namespace nonhertz
