#include "strips/newton.hpp"

#include <algorithm>
#include <limits>

#include "numbers/products.hpp"

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();
// Once residual and step are this small, the remaining error is the square of the step, and the stiffness is accurate
// to SMALL_STEP. The same on the way to a finer grid, where the stiffness is not needed.
constexpr double NEARLY = 1e-8, SMALL_STEP = 1e-5, ROUGHLY_NEARLY = 1e-3, ROUGHLY_SMALL = 0.1;
constexpr int STEP_LIMIT = 60,
              FOLLOWING = 12;         // for a solve, and for a contact that follows to another approach and tilt
constexpr double LEAST_CHANGE = 0.3;  // smallest factor by which r may change in one step; its inverse is the largest
constexpr double WIDEST = 1e4;        // half-width over half the length, beyond which the iteration has diverged
// A strip enters only if its overlap exceeds this fraction of the residual; otherwise the active set oscillates.
constexpr double LET_SETTLE = 0.1;
// Fraction of a step while a strip that has left and re-entered is far from settled: full steps would drive it out
// again.
constexpr double AFTER_RETURN = 0.5;

double imbalance(const Prescription& prescribed, const Pair& off, double load) {
  double largest = 0.0;
  const double reference = prescribed.by_force[0] ? prescribed.target[0] : load;
  for (int k = 0; k < 2; ++k)
    if (prescribed.by_force[k]) largest = worse(largest, std::fabs(off[k]) / reference);
  return largest;
}

double sum(View values) {
  double total = 0.0;
  for (double value : values) total += value;
  return total;
}

double largest_of(View values) {
  double largest = 0.0;
  for (double value : values) largest = worse(largest, value);
  return largest;
}

}  // namespace

Newton::Newton(const Grid& grid, const Kernel& kernel)
    : grid_(grid), kernel_(kernel), half_(grid.half_length()), influence_(grid, kernel) {}

void Newton::run(const Prescription& prescribed, const Options& options, State& state) {
  const bool rough = options.tolerance > TOLERANCE;
  const double nearly = rough ? ROUGHLY_NEARLY : NEARLY, small_step = rough ? ROUGHLY_SMALL : SMALL_STEP;
  const auto ends = [&state](Status status, int steps, double residual) {
    state.status = status, state.steps = steps, state.residual = residual;
  };
  has_left_.assign(grid_.count(), false);
  bool has_returned = false;
  double residual = INFINITE;
  const int limit = options.follows ? FOLLOWING : STEP_LIMIT;
  for (int step = 0; step < limit; ++step) {
    if (options.stop != nullptr) options.stop->look();
    pair_lone_strip(prescribed, state);
    find_active(state);
    if (active_.empty()) return ends(Status::stagnated, step, residual);
    influence_.keep_up(state.m);
    const auto [scale, noise, unsettled] = weigh(prescribed, options, state);
    double least = state.gap[0];
    for (double gap : state.gap) least = -worse(-least, -gap);
    residual = worse(unsettled, -(least + noise) / scale);
    // A strip whose m is NaN is not active and appears in no residual.
    if (!std::isfinite(residual) || !std::isfinite(sum(state.m))) return ends(Status::stagnated, step, residual);
    find_directions();
    border(state);
    if (residual < options.tolerance && !options.follows) {
      for (std::size_t k = 0; k < active_.size(); ++k) state.gap[active_[k]] = unclosed_[k];
      return ends(Status::converged, step, residual);
    }
    const Pair rigid = rigid_step(prescribed);
    const double largest = combine(rigid);
    const double widest = largest_of(state.m), too_wide = WIDEST * half_;
    if (widest > too_wide * too_wide || !std::isfinite(largest)) return ends(Status::stagnated, step, residual);
    if (options.follows && residual < nearly && largest < small_step) {
      sum_up();
      return ends(Status::converged, step, residual);
    }
    const double relaxation = has_returned && residual > ROUGHLY_NEARLY ? AFTER_RETURN : options.relaxation;
    state.rigid[0] += relaxation * rigid[0];
    state.rigid[1] += relaxation * rigid[1] / half_;
    const bool changed = update(relaxation, state);
    const bool entered = enter(noise + LET_SETTLE * unsettled * scale, state);
    has_returned = mark_departures(state) || has_returned;
    if (!options.follows && residual < nearly && largest < small_step && !changed && !entered) {
      const double worst = violation(prescribed, state);
      if (worst < options.tolerance) return ends(Status::converged, step + 1, worst);
    }
  }
  ends(Status::iteration_limit, STEP_LIMIT, residual);
}

/// Put a neighbour in contact beside a lone strip that must carry load and moment: one strip cannot.
void Newton::pair_lone_strip(const Prescription& prescribed, State& state) const {
  if (!prescribed.both()) return;
  Index alone = 0, count = 0;
  for (Index i = 0; i < grid_.count(); ++i)
    if (state.m[i] > 0.0) alone = i, ++count;
  if (count != 1) return;
  const double arm = prescribed.target[1] / prescribed.target[0] - grid_.y[alone];
  const Index other = alone + (arm > 0.0 ? 1 : -1);
  if (std::fabs(arm) > 1e-12 * grid_.width(alone) && 0 <= other && other < grid_.count()) {
    state.m[other] = 1e-3 * state.m[alone];
    state.r[other] = state.r[alone];
  }
}

void Newton::find_active(const State& state) {
  active_.clear();
  for (Index i = 0; i < grid_.count(); ++i)
    if (state.m[i] > 0.0) active_.push_back(i);
}

/// Linearise; fill in the gap of idle strips, and return the largest residual without them.
Newton::Weighed Newton::weigh(const Prescription& prescribed, const Options& options, State& state) {
  const double unbent = linearise(prescribed, options, state);
  auto [scale, noise, unsettled] = scales(state);
  idle_.clear(), raised_.clear();
  for (Index i = 0; i < grid_.count(); ++i) {
    // Where there is no body the gap is infinite, whatever the displacement.
    const bool idle = !(state.m[i] > 0.0);
    state.gap[i] = idle ? -state.interference(grid_, i) : 0.0;
    if (idle && std::isfinite(state.gap[i])) idle_.push_back(i), raised_.push_back(state.gap[i]);
  }
  add_products([this](Index i) { return blocks_[0][idle_[i]].data(); }, q_, raised_);
  for (std::size_t i = 0; i < idle_.size(); ++i) state.gap[idle_[i]] = raised_[i];
  double largest = 0.0;
  for (double value : unclosed_) largest = worse(largest, std::fabs(value));
  unsettled = worse((largest - noise) / scale, unbent);
  return {scale, noise, worse(unsettled, imbalance(prescribed, off_, sum(weights_)))};
}

/// Return the deepest interference in contact, and the rounding error of a gap, a difference of large lengths.
Newton::Weighed Newton::scales(const State& state) const {
  double deepest = -INFINITE, longest = 0.0;
  for (Index i : active_) {
    deepest = worse(deepest, state.interference(grid_, i));
    longest = worse(longest, std::fabs(grid_.separation[i]));
  }
  const double moved = std::fabs(state.rigid[0]) + std::fabs(state.rigid[1]) * half_;
  return {deepest > 0.0 ? deepest : moved, 1e-15 * (moved + longest), 0.0};
}

/// Set up the equations at a state, with r from the curvature rows; return these rows' largest residual.
double Newton::linearise(const Prescription& prescribed, const Options& options, State& state) {
  const Index k = static_cast<Index>(active_.size()), at = padded_size(k);
  influence_.coefficients(state.m, active_, blocks_);
  solve_curvature();
  for (Numbers* numbers : {&r_, &m_, &q_, &missing_, &weights_, &lever_}) numbers->resize(k);
  for (Index i = 0; i < k; ++i) {
    const Index source = active_[i];
    const double required = curved_(i, at + k), before = state.r[source];
    m_[i] = state.m[source];
    // Far from the solution it may not even be positive.
    r_[i] = options.eager ? std::min(std::max(required, LEAST_CHANGE * before), before / LEAST_CHANGE) : before;
    if (std::isnan(before)) r_[i] = before;
    missing_[i] = required - r_[i];
    state.r[source] = r_[i];
    q_[i] = r_[i] * m_[i];
    weights_[i] = q_[i] * grid_.width(source);
    lever_[i] = grid_.y[source] / half_;
  }
  unclosed_.assign(k, 0.0), bent_.assign(k, 0.0);
  add_products([this](Index i) { return blocks_[0][active_[i]].data(); }, q_, unclosed_);
  add_products([this](Index i) { return blocks_[2][active_[i]].data(); }, r_, bent_);
  double load = 0.0, moment = 0.0, unbent = 0.0;
  for (Index i = 0; i < k; ++i) {
    const Index source = active_[i];
    unclosed_[i] -= state.interference(grid_, source);
    unbent = worse(unbent, std::fabs(bent_[i] / grid_.curvature[source] - 1.0));
    load += weights_[i];
    moment += weights_[i] * lever_[i];
  }
  off_ = balance(prescribed, state.rigid, load, moment);
  return unbent;
}

/// Return target minus current approach or load, and tilt or moment; a tilt as the approach at the end.
Pair Newton::balance(const Prescription& prescribed, const Pair& rigid, double load, double moment) const {
  return {prescribed.by_force[0] ? prescribed.target[0] - load : prescribed.target[0] - rigid[0],
          prescribed.by_force[1] ? prescribed.target[1] / half_ - moment : (prescribed.target[1] - rigid[1]) * half_};
}

/// Solve the curvature rows for F = d r / d (r mu), mu being the relative changes of m, and for r itself.
void Newton::solve_curvature() {
  const Index k = static_cast<Index>(active_.size()), at = padded_size(k);
  curved_.reset(k, k + 1);
  for (Index i = 0; i < k; ++i) {
    const Index source = active_[i];
    for (Index j = 0; j < k; ++j) {
      curved_(i, j) = blocks_[2](source, j);
      curved_(i, at + j) = 0.5 * blocks_[3](source, j);
    }
    curved_(i, at + k) = grid_.curvature[source];
  }
  curved_.solve();
}

/// Find the relative changes of r and of q for the residual and both rigid motions.
///
/// With v = r mu the gap rows are [A] m (missing + F v) + ([A] - [t A'] / 2) m v = sides.
void Newton::find_directions() {
  const Index k = static_cast<Index>(active_.size()), at = padded_size(k);
  step_.reset(k, 3);
  loaded_.resize(at, at);
  std::fill(loaded_.all().begin(), loaded_.all().end(), 0.0);
  for (Index i = 0; i < k; ++i) {
    const Index source = active_[i];
    for (Index j = 0; j < k; ++j) {
      const double own = blocks_[0](source, j), change = blocks_[1](source, j);
      loaded_(i, j) = -own * m_[j];
      step_(i, j) = (own - 0.5 * change) * m_[j];
    }
  }
  step_.subtract_product(loaded_, curved_);
  // Clear the padding after the product, so that it stays decoupled.
  for (Index i = 0; i < at; ++i)
    for (Index j = k; j < at; ++j) step_(i, j) = i == j ? 1.0 : 0.0;
  changes_.assign(k, 0.0);
  add_products([this](Index i) { return loaded_[i].data(); }, missing_, changes_);
  for (Index i = 0; i < k; ++i) {
    step_(i, at) = changes_[i] - unclosed_[i];
    step_(i, at + 1) = 1.0;
    step_(i, at + 2) = lever_[i];
  }
  step_.solve();
  d_r_.resize(k), d_q_.resize(k), moved_.resize(k);
  for (int side = 0; side < 3; ++side) {
    if (side == 0)
      changes_ = missing_;
    else
      changes_.assign(k, 0.0);
    for (Index j = 0; j < k; ++j) moved_[j] = step_(j, at + side);
    add_products([&](Index i) { return &curved_(i, at); }, moved_, changes_);
    for (Index i = 0; i < k; ++i) {
      d_r_[i][side] = changes_[i] / r_[i];
      d_q_[i][side] = d_r_[i][side] + moved_[i] / r_[i];
    }
  }
}

/// Find the changes of load and of moment / half for the residual and both rigid motions, and the stiffness.
void Newton::border(State& state) {
  response_ = {};
  for (std::size_t i = 0; i < active_.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const double change = weights_[i] * d_q_[i][k];
      response_[0][k] += change;
      response_[1][k] += change * lever_[i];
    }
  state.stiffness[0] = {response_[0][1], response_[0][2] * half_};
  state.stiffness[1] = {response_[1][1] * half_, response_[1][2] * half_ * half_};
}

/// Return the changes of approach and of tilt times half length that meet the prescribed pair.
Pair Newton::rigid_step(const Prescription& prescribed) const {
  double a = 1.0, b = 0.0, c = 0.0, d = 1.0;
  auto [first, second] = off_;
  // A single strip has no stiffness against tilt, like a ball: a tiny addition to the diagonal keeps its tilt
  // unchanged.
  const double ridge = 1e-14 * std::fabs(response_[0][1]);
  if (prescribed.by_force[0]) {
    a = response_[0][1] + ridge, b = response_[0][2];
    first -= response_[0][0];
  }
  if (prescribed.by_force[1]) {
    c = response_[1][1], d = response_[1][2] + ridge;
    second -= response_[1][0];
  }
  const double determinant = a * d - b * c;
  return {(first * d - second * b) / determinant, (second * a - first * c) / determinant};
}

/// Add up load and moment, including the step.
void Newton::sum_up() {
  resultant_ = {response_[0][0], response_[1][0]};
  for (std::size_t k = 0; k < active_.size(); ++k) {
    resultant_[0] += weights_[k];
    resultant_[1] += weights_[k] * lever_[k];
  }
  resultant_[1] *= half_;
}

/// Put the step for this motion in the first columns, and return the largest change of r or of m.
double Newton::combine(const Pair& rigid) {
  double largest = 0.0;
  for (std::size_t i = 0; i < d_r_.size(); ++i) {
    d_r_[i][0] += rigid[0] * d_r_[i][1] + rigid[1] * d_r_[i][2];
    d_q_[i][0] += rigid[0] * d_q_[i][1] + rigid[1] * d_q_[i][2];
    largest = worse(largest, worse(std::fabs(d_r_[i][0]), std::fabs(d_q_[i][0] - d_r_[i][0])));
  }
  return largest;
}

/// Apply the relative steps of r and q; return whether a strip left or was held back.
bool Newton::update(double relaxation, State& state) const {
  bool changed = false;
  for (std::size_t k = 0; k < active_.size(); ++k) {
    const Index i = active_[k];
    const double rho = d_r_[k][0], sigma = d_q_[k][0], mu = relaxation * (sigma - rho);
    const double old_r = state.r[i], old_m = state.m[i];
    state.r[i] = old_r * std::min(std::max(1.0 + relaxation * rho, LEAST_CHANGE), 1.0 / LEAST_CHANGE);
    if (mu > 15.0) {
      changed = true;
      state.m[i] = 16.0 * old_m;
    } else if (mu < -0.9) {
      // Its own effect, m [A](m), is a concave function through zero: a leaving strip takes the m that satisfies its
      // own equation, which stops nearly idle strips from oscillating in and out.
      changed = true;
      const double required = blocks_[0](i, k) * (1.0 + relaxation * sigma) - 0.5 * blocks_[1](i, k) * mu;
      state.m[i] = required > 0.0 ? own_width(old_m * required * old_r / state.r[i], grid_.width(i)) : 0.0;
    } else {
      state.m[i] = old_m * (1.0 + mu);
    }
  }
  return changed;
}

/// Put strips with more than this overlap in contact, with r from the nearest strip in contact.
bool Newton::enter(double overlap, State& state) const {
  bool entered = false;
  for (Index i = 0; i < grid_.count(); ++i) {
    if (!(state.gap[i] < -overlap)) continue;
    entered = true;
    Index nearest = active_[0];
    for (Index j : active_)
      if (std::abs(j - i) < std::abs(nearest - i)) nearest = j;
    state.r[i] = state.r[nearest] * grid_.curvature[i] / grid_.curvature[nearest];
    state.m[i] = own_width(-state.gap[i] / state.r[i], grid_.width(i));
  }
  return entered;
}

/// Mark the strips that have left; return whether one that had left before is back.
bool Newton::mark_departures(const State& state) {
  bool any = false;
  for (Index i = 0; i < grid_.count(); ++i) any = any || (has_left_[i] && state.m[i] > 0.0);
  for (Index i : active_) has_left_[i] = has_left_[i] || !(state.m[i] > 0.0);
  return any;
}

/// Return m with m [A](m) = required, by Newton's method on a concave increasing function.
double Newton::own_width(double required, double width) const {
  double m = 0.25 * required;
  for (int i = 0; i < 40; ++i) {
    const auto [value, slope] = self_displacement(width, m, kernel_.element->table.data());
    const double better = std::max(m - (m * value - required) / slope, 0.05 * m);
    if (std::fabs(better - m) < 1e-6 * m) return better;
    m = better;
  }
  return m;
}

double Newton::violation(const Prescription& prescribed, State& state) {
  const Index n = grid_.count();
  influence_.keep_up(state.m);
  q_.resize(n), raised_.resize(n);
  for (Index i = 0; i < n; ++i) q_[i] = state.r[i] * state.m[i];
  influence_.lift(state.m, q_, raised_);
  double worst = 0.0, deepest = -INFINITE, load = 0.0, moment = 0.0;
  for (Index i = 0; i < n; ++i) {
    const double depth = state.interference(grid_, i);
    state.gap[i] = std::isfinite(depth) ? raised_[i] - depth : -depth;
    if (!(state.m[i] > 0.0)) {
      worst = worse(worst, -state.gap[i]);
      continue;
    }
    worst = worse(worst, std::fabs(state.gap[i]));
    deepest = worse(deepest, depth);
    const double carried = q_[i] * grid_.width(i);
    load += carried;
    moment += carried * grid_.y[i];
  }
  const Pair off = balance(prescribed, state.rigid, load, moment / half_);
  find_active(state);
  return worse((worst - scales(state).noise) / deepest, imbalance(prescribed, off, load));
}

}  // namespace nonhertz
