#include "strips/continuation.hpp"

#include <algorithm>
#include <cmath>

namespace nonhertz {
namespace {

constexpr double NEARBY = 0.1;     // relative change up to which the last case serves as the start
constexpr std::size_t POINTS = 3;  // of a parabola
constexpr double FARTHEST = 2.0;   // steps ahead of the last one
constexpr double STRAIGHT = 1e-9;  // of a step: permitted distance of a prescription from the line through the last two
constexpr double BOUNDED = 2.0;    // factor by which a strip may change; beyond, it starts from its last value

bool is_similar(const Prescription& prescribed, const Pair& before, const State& state, double half_length) {
  const Pair& target = prescribed.target;
  double scale = std::fabs(target[1]);
  if (!prescribed.by_force[1])
    scale = std::fabs(state.rigid[0]) / half_length;
  else if (prescribed.by_force[0])
    scale = target[0] * half_length;
  return std::fabs(target[0] - before[0]) <= NEARBY * std::fabs(target[0]) &&
         std::fabs(target[1] - before[1]) <= NEARBY * scale;
}

/// Number of times `step` from one prescription to another; nothing if they are not in line.
std::optional<double> steps_between(const Pair& from, const Pair& to, const Pair& step) {
  std::optional<double> steps;
  for (int k = 0; k < 2; ++k) {
    const double way = to[k] - from[k];
    if (step[k] == 0.0 && way == 0.0) continue;
    const double own = way / step[k];
    if (!std::isfinite(own) || (steps && std::fabs(own - *steps) > STRAIGHT * std::fabs(own))) return std::nullopt;
    steps = own;
  }
  return steps;
}

double carried_on(const std::vector<double>& weights, const auto& value_in) {
  double value = 0.0;
  for (std::size_t k = 0; k < weights.size(); ++k) value += weights[k] * value_in(k);
  return value;
}

}  // namespace

void Continuation::add(const Prescription& prescribed, const State& solution) {
  if (!solution.converged()) return solved_.clear();
  if (solved_.size() == POINTS) solved_.pop_back();
  solved_.insert(solved_.begin(), {prescribed.target, solution});
}

std::optional<State> Continuation::next(const Prescription& prescribed, const Grid& grid) const {
  if (solved_.empty()) return std::nullopt;
  const auto& [target, last] = solved_[0];
  if (!is_similar(prescribed, target, last, grid.half_length())) return std::nullopt;
  State state = last;
  const auto by_solution = weights(prescribed.target);
  const auto carry_on = [&](double& value, const auto& value_in) {
    const double later = carried_on(by_solution, value_in);
    if (value / BOUNDED < later && later < BOUNDED * value) value = later;
  };
  for (Index i = 0; i < grid.count(); ++i) {
    const auto bears = [i](const Solved& solved) { return solved.state.m[i] > 0.0; };
    if (!std::all_of(solved_.begin(), solved_.begin() + std::ssize(by_solution), bears)) continue;
    carry_on(state.r[i], [&](std::size_t k) { return solved_[k].state.r[i]; });
    carry_on(state.m[i], [&](std::size_t k) { return solved_[k].state.m[i]; });
  }
  for (int k = 0; k < 2; ++k) {
    const double moved = carried_on(by_solution, [&](std::size_t of) { return solved_[of].state.rigid[k]; });
    state.rigid[k] = prescribed.by_force[k] ? moved : prescribed.target[k];
  }
  return state;
}

/// Weights of the last solutions in the next start: Lagrange polynomials over the steps between prescriptions.
std::vector<double> Continuation::weights(const Pair& target) const {
  std::vector<double> places{0.0};
  std::optional<double> ahead;
  if (solved_.size() > 1) {
    const Pair &last = solved_[0].target, &before = solved_[1].target;
    const Pair step{last[0] - before[0], last[1] - before[1]};
    ahead = steps_between(last, target, step);
    if (ahead && std::fabs(*ahead) <= FARTHEST) {
      places.push_back(-1.0);
      const auto third = solved_.size() > 2 ? steps_between(last, solved_[2].target, step) : std::nullopt;
      if (third && *third < -1.0) places.push_back(*third);
    }
  }
  std::vector<double> by_place(places.size(), 1.0);
  for (std::size_t k = 0; k < places.size(); ++k)
    for (std::size_t other = 0; other < places.size(); ++other)
      if (other != k) by_place[k] *= (*ahead - places[other]) / (places[k] - places[other]);
  return by_place;
}

}  // namespace nonhertz
