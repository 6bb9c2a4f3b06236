// The loop: a semi-smooth Newton method for loads and half-widths of all strips at once.
//
// For each strip in contact the gap and its second derivative across vanish on the centre line; a strip whose m would
// turn negative leaves, one whose gap is negative enters. The curvature rows are linear in r: every step first solves
// them for r at the current m, so the step itself is a system in m alone, bordered by approach and tilt.
#pragma once

#include "numbers/stop.hpp"
#include "strips/influence.hpp"
#include "strips/linear.hpp"
#include "strips/strips.hpp"

namespace nonhertz {

// For a solution, and for a start on the next grid.
inline constexpr double TOLERANCE = 1e-11, ROUGH_TOLERANCE = 1e-6;

struct Options {
  double tolerance = TOLERANCE;  ///< largest relative residual of a solution
  double relaxation = 1.0;       ///< fraction of each step to take
  bool eager = true;             ///< whether the curvature rows are solved for r before every step
  bool follows = false;          ///< whether a solved contact follows another motion: see `Newton::resultant`
  const Stop* stop = nullptr;    ///< checked before every step
};

/// A Newton loop on one grid, with its work arrays.
class Newton {
 public:
  Newton(const Grid& grid, const Kernel& kernel);

  const Grid& grid() const { return grid_; }
  const Kernel& kernel() const { return kernel_; }

  /// Solve from the r, m and rigid motion in `state`, and store the result there.
  ///
  /// A contact that follows stops as soon as load and moment are accurate, and is not checked.
  void run(const Prescription& prescribed, const Options& options, State& state);
  /// K Q and K T of a contact that followed, including the last step's change: their errors are its square.
  const Pair& resultant() const { return resultant_; }
  /// Fill the gap everywhere and return the largest relative violation of contact and balance.
  double violation(const Prescription& prescribed, State& state);

 private:
  struct Weighed {
    double scale, noise, unsettled;
  };
  struct Largest {
    double residual, step;
  };

  void pair_lone_strip(const Prescription& prescribed, State& state) const;
  void find_active(const State& state);
  Weighed weigh(const Prescription& prescribed, const Options& options, State& state);
  double linearise(const Prescription& prescribed, const Options& options, State& state);
  void solve_curvature();
  void find_directions();
  void border(State& state);
  Pair rigid_step(const Prescription& prescribed) const;
  void sum_up();
  double combine(const Pair& rigid);
  bool update(double relaxation, State& state) const;
  bool enter(double overlap, State& state) const;
  bool mark_departures(const State& state);
  Weighed scales(const State& state) const;
  Pair balance(const Prescription& prescribed, const Pair& rigid, double load, double moment) const;
  double own_width(double required, double width) const;

  const Grid& grid_;
  const Kernel& kernel_;
  const double half_;
  Influence influence_;
  // The equations of the strips in contact, linearised at a state; one entry per such strip.
  std::vector<Index> active_;
  Blocks blocks_;
  System curved_, step_;  // F = d r / d (r mu) and r itself; the step for three right-hand sides
  Matrix loaded_;
  Numbers r_, m_, q_, missing_, weights_, lever_, unclosed_, bent_;
  Numbers moved_, changes_;                       // one of the solutions, and the resulting changes
  std::vector<std::array<double, 3>> d_r_, d_q_;  // relative changes for the residual and both rigid motions
  std::array<std::array<double, 3>, 2> response_{};
  std::vector<char> has_left_;  // strips that have left contact, some of which may have re-entered
  Pair resultant_{};
  Pair off_{};               // target minus current approach or load, and tilt or moment
  std::vector<Index> idle_;  // strips out of contact where the bodies are
  Numbers raised_;           // the surface there, or everywhere
};

/// Return the larger of two numbers, or NaN if either is.
inline double worse(double one, double other) { return std::isnan(one) || other <= one ? one : other; }

}  // namespace nonhertz
