#include "strips/solving.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "strips/start.hpp"

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();
constexpr double LEAST_RISE = 1e-3;  // of the load: a smaller increment is not attempted
constexpr double BEYOND_HELP = 2.0;  // depth in half-widths below which a failed start is not retried
constexpr int RISES = 40;
// On more than PATIENT_STRIPS no other start is tried once failed ones have cost the equivalent of this many steps on
// that many strips, nor is the load raised: the cost of a step grows with the cube of the strips.
constexpr double RETRIED = 360.0;

enum Start { BEFORE, NEAR, SPRINGS, TOGETHER, SHORTENED, RAISED, STARTS };

bool within_reach(const Grid& grid, const Prescription& prescribed) {
  std::optional<Index> first, last;
  for (Index i = 0; i < grid.count(); ++i)
    if (std::isfinite(grid.separation[i])) last = i, first = first ? first : last;
  if (!first || !prescribed.both()) return first.has_value();
  const double arm = prescribed.target[1] / prescribed.target[0];
  return grid.y[*first] <= arm && arm <= grid.y[*last];
}

/// Run the loop from the present state, unless a body is thinner than its contact is wide.
void run(Newton& loop, const Grid& grid, const Prescription& prescribed, const Kernel& kernel, const Options& options,
         State& state) {
  std::fill(state.gap.begin(), state.gap.end(), 0.0);
  state.stiffness = {};
  state.status = Status::stagnated, state.steps = 0, state.residual = INFINITE;
  if (!too_thin(grid, kernel, state.m, HOPELESS)) loop.run(prescribed, options, state);
}

/// Run it from springs under a small load, which is raised in steps as large as possible.
///
/// A state that converged only at a fraction of the load is not a solution and is not marked as one.
void raise_load(Newton& loop, const Grid& grid, const Prescription& prescribed, const Kernel& kernel,
                const Options& options, State& state) {
  double reached = 0.0, share = 0.01;
  State last = state;
  for (int i = 0; i < RISES; ++i) {
    Prescription part = prescribed;
    for (int k = 0; k < 2; ++k)
      if (prescribed.by_force[k]) part.target[k] *= share;
    if (reached > 0.0)
      state = last;
    else
      start_from_springs(grid, part, kernel, state);
    run(loop, grid, part, kernel, options, state);
    if (state.converged() && share == 1.0) return;
    if (share - reached < LEAST_RISE) break;
    if (state.converged()) {
      last = state;
      reached = share, share = std::min(1.0, 2.0 * share);
    } else {
      share = 0.5 * (reached + share);
    }
  }
  state.status = Status::stagnated, state.residual = INFINITE;
}

}  // namespace

bool too_thin(const Grid& grid, const Kernel& kernel, View m, double least) {
  for (Index i = 0; i < count_of(m); ++i)
    if (grid.min_depth[i] < least * kernel.element->hertz_ratio * std::sqrt(m[i])) return true;
  return false;
}

State solve_on(const Grid& grid, const Prescription& prescribed, const Kernel& kernel, const Attempt& attempt) {
  Newton loop(grid, kernel);
  return solve_on(loop, prescribed, attempt);
}

State solve_on(Newton& loop, const Prescription& prescribed, const Attempt& attempt) {
  const Grid& grid = loop.grid();
  const Kernel& kernel = loop.kernel();
  const Index n = grid.count();
  State best(n), trial(n);
  best.residual = INFINITE;
  if (!within_reach(grid, prescribed)) return best;
  double spent = 0.0;
  for (int start = BEFORE; start < (attempt.patient ? STARTS : TOGETHER); ++start) {
    if (n > PATIENT_STRIPS && (spent > RETRIED || start == RAISED)) break;
    if (start == BEFORE) {
      if (!attempt.before) continue;
      trial = *attempt.before;
    } else if (start == NEAR) {
      if (attempt.near == nullptr || !attempt.near->state.converged()) continue;
      if (!start_from_other(*attempt.near, grid, prescribed, trial)) continue;
    } else {
      start_from_springs(grid, prescribed, kernel, trial);
      if (start >= SHORTENED && too_thin(grid, kernel, trial.m, BEYOND_HELP)) continue;
      if (start == RAISED && !prescribed.by_force[0]) continue;
    }
    Options options;
    options.tolerance = attempt.tolerance, options.eager = start != TOGETHER, options.stop = attempt.stop;
    if (start == SHORTENED) options.relaxation = 0.5;
    if (start == RAISED) {
      options.tolerance = TOLERANCE;
      raise_load(loop, grid, prescribed, kernel, options, trial);
    } else {
      run(loop, grid, prescribed, kernel, options, trial);
    }
    const double of_patient = static_cast<double>(n) / PATIENT_STRIPS;
    spent += trial.steps * of_patient * of_patient * of_patient;
    if (start <= SPRINGS || trial.converged() || trial.residual < best.residual) best = trial;
    if (best.converged()) break;
  }
  return best;
}

}  // namespace nonhertz
