// The search as a whole, and the steps of the ring; the steps of rollers are in rollers.cpp.
#include "bearing/balance.hpp"

#include <limits>

namespace nonhertz {
namespace {

constexpr double OF_ROLLER = 0.1;  // permitted residual of a roller's balance, over the ring's tolerance
constexpr double NO_LOAD = 1e-8;   // of the largest load: residual of the balance of a roller that has lifted off
// Ring and rollers step together while the residual of the balance, over the loads, is below the first, and every step
// reduces it to at most this fraction.
constexpr double CLOSE = 0.5, LEADS_ON = 0.3;
constexpr double MOST_STRAY = 0.4;  // fraction of the rollers that may first have to approach their balance separately
// Largest numbers of evaluations of slices and maps (of 5,000 random bearings none took 2,000), and of the contacts of
// one roller where they have to be solved (random bearings take 50 at most).
constexpr int MOST_ROUNDS = 10'000, MOST_ASKED = 100;

}  // namespace

Balance::Balance(const Assembly& assembly, const Conditions& conditions, const Beginning& begin, Index state)
    : assembly_(assembly),
      conditions_(conditions),
      target_(begin.target),
      first_number_(state * assembly.rollers()),
      poses_(assembly.ring.size() * static_cast<std::size_t>(assembly.columns)),
      answers_(poses_.size()),
      rollers_(assembly.ring.size()),
      limit_(CLOSE),
      residual_(std::numeric_limits<double>::infinity()),
      times_(rollers_.size()) {
  const auto columns = static_cast<std::size_t>(assembly.columns);
  for (std::size_t j = 0; j < rollers_.size(); ++j) {
    rollers_[j].poses = std::span(poses_).subspan(j * columns, columns);
    rollers_[j].answers = std::span(answers_).subspan(j * columns, columns);
  }
  ring_.motion = begin.ring;
  follow_alike();
  for (std::size_t j = 0; j < rollers_.size(); ++j)
    if (!std::isnan(begin.rollers[j][0])) rollers_[j].motion = begin.rollers[j];
  ask_all();
}

Equilibrium Balance::solve(const Stop& stop) {
  do stop.look();
  while (answer(stop) && advance());
  Equilibrium state{ring_.motion, ring_.force, ring_.stiffness, residual_, ring_.trial.steps, {}, {}, {}};
  for (const Roller& roller : rollers_) state.rollers.push_back(roller.motion);
  state.poses = std::move(poses_), state.answers = std::move(answers_);
  return state;
}

/// Evaluate the requested contacts; return whether the limit of evaluations is not yet exceeded.
bool Balance::answer(const Stop& stop) {
  const bool solved = !assembly_.groups().empty();
  int most = 0;
  for (const int times : times_) most = std::max(most, times);
  if (most >= (solved ? MOST_ASKED : MOST_ROUNDS)) return false;
  for (Index j = 0; j < assembly_.rollers(); ++j) {
    Roller& roller = rollers_[j];
    times_[j] += solved ? roller.pending : 1;
    if (!roller.pending) continue;
    const auto contacts = assembly_.contacts(j);
    for (Index c = 0; c < assembly_.columns; ++c) {
      if (contacts[c].law == RollerContact::NO_LAW) continue;
      const Law& law = assembly_.law(contacts[c]);
      if (const auto* slices = std::get_if<Slices>(&law)) roller.answers[c] = slices->answer(roller.poses[c]);
      if (const auto* map = std::get_if<MapLaw>(&law)) roller.answers[c] = map->answer(roller.poses[c]);
    }
  }
  for (const Group& group : assembly_.groups()) answer(group, stop);
  return true;
}

void Balance::answer(const Group& group, const Stop& stop) {
  numbers_.clear(), asked_poses_.clear();
  for (Index j = group.first; j < group.end; ++j) {
    if (!rollers_[j].pending) continue;
    numbers_.push_back(first_number_ + j);
    for (const Index c : group.columns) asked_poses_.push_back(rollers_[j].poses[c]);
  }
  given_answers_.resize(asked_poses_.size());
  group.law->answer(numbers_, asked_poses_, given_answers_, stop);
  auto next = given_answers_.begin();
  for (const Index number : numbers_)
    for (const Index c : group.columns) rollers_[number - first_number_].answers[c] = *next++;
}

/// Use the results, and move to where contacts are evaluated next; return whether there are any. If not, the balance is
/// found or no step remains.
bool Balance::advance() {
  for (Index j = 0; j < assembly_.rollers(); ++j)
    if (rollers_[j].pending) add_up(j);
  const double size = this->size();
  Trial& trial = ring_.trial;
  if (phase_ == Phase::together) {
    const double enough = OF_ROLLER * limit_ * size;
    const bool stepped = trial.steps > 0;
    // A few rollers that leave or enter the load zone are no reason to give up a step that suits all others.
    const auto stray =
        std::count_if(rollers_.begin(), rollers_.end(), [&](const Roller& r) { return r.residual > enough; });
    if (!stepped || static_cast<double>(stray) <= MOST_STRAY * static_cast<double>(rollers_.size())) {
      if (rollers_step(enough)) return true;
      const Imbalance off = condense(size);
      const double residual = std::max(off.ring, off.rollers / OF_ROLLER);
      if (residual <= conditions_.tolerance) return false;
      if (residual <= limit_ && trial.steps < conditions_.steps) {
        step_together(off.loads);
        limit_ = std::min(CLOSE, LEADS_ON * residual);
        return true;
      }
    }
    phase_ = Phase::in_turn;
    if (stepped) {
      // The last step made no progress.
      for (Roller& roller : rollers_) roller.trial.searching = false;
      move_along(0.0);
      return true;
    }
  }
  if (rollers_step(OF_ROLLER * conditions_.tolerance * size)) return true;
  const Imbalance off = condense(size);
  if (!shorten(trial, ring_.off, ring_.step, ring_.stiffness)) {
    const auto& by_force = conditions_.by_force;
    const bool displaced = std::none_of(by_force.begin(), by_force.end(), [](bool flag) { return flag; });
    if (residual_ <= conditions_.tolerance || displaced || trial.steps >= conditions_.steps) return false;
    follow_ring(off.loads);
    try_whole(trial, ring_.off, ring_.step);
  }
  move_along(trial.share);
  return true;
}

/// Add up the forces on the ring, its stiffness with rollers that follow in balance, and the load on a roller.
Balance::Imbalance Balance::condense(double size) {
  ring_.force = {}, ring_.stiffness = {};
  double most = 0.0, sum = 0.0, worst = rollers_[0].residual;
  for (const Roller& roller : rollers_) most = std::max(most, largest(roller.on_ring));
  for (Index j = 0; j < assembly_.rollers(); ++j) {
    const Roller& roller = rollers_[j];
    // The stiffness of slices varies with the ninth root of their overlap: 1e-19 mm, which is rounding, gives a per
    // cent.
    if (largest(roller.on_ring) <= NO_LOAD * most) continue;
    const Small<3, 5>& at = assembly_.ring[j];
    Small<3, 3> stiff = product(roller.of_ring, eliminate(roller.whole, roller.of_ring, assembly_.scale));
    for (Index a = 0; a < 3; ++a)
      for (Index b = 0; b < 3; ++b) stiff[a][b] = roller.of_ring[a][b] - stiff[a][b];
    const Small<3, 5> turned = product(stiff, at);
    for (Index b = 0; b < 5; ++b)
      for (Index a = 0; a < 3; ++a) {
        ring_.force[b] += at[a][b] * roller.on_ring[a];
        for (Index d = 0; d < 5; ++d) ring_.stiffness[b][d] += at[a][b] * turned[a][d];
      }
  }
  for (const Roller& roller : rollers_) {
    sum += std::abs(roller.on_ring[0]);
    sum += std::abs(roller.on_ring[1]);
    worst = larger(worst, roller.residual);
  }
  double residual = 0.0, loads = std::max(std::numeric_limits<double>::min(), sum);
  for (Index b = 0; b < 5; ++b) {
    ring_.off[b] = conditions_.by_force[b] ? target_[b] - ring_.force[b] : 0.0;
    if (!conditions_.by_force[b]) continue;
    loads = std::max(loads, std::abs(target_[b]) / assembly_.reach[b]);
    residual = std::max(residual, std::abs(ring_.off[b]) / assembly_.reach[b]);
  }
  const double of_rollers = size > 0.0 ? worst / size : 0.0;
  residual_ = std::max(residual / loads, of_rollers);
  return {residual / loads, of_rollers, loads};
}

/// Move ring and rollers at once, near the balance.
void Balance::step_together(double loads) {
  // The motion of the rollers with the ring at rest, and its effect on the ring.
  for (Index j = 0; j < assembly_.rollers(); ++j) {
    Roller& roller = rollers_[j];
    roller.step = roller_step(j);
    const Vector<3> pushed = product(roller.of_ring, roller.step);
    for (Index a = 0; a < 3; ++a)
      for (Index b = 0; b < 5; ++b)
        if (conditions_.by_force[b]) ring_.off[b] += assembly_.ring[j][a][b] * pushed[a];
  }
  follow_ring(loads);
  for (Roller& roller : rollers_)
    for (Index a = 0; a < 3; ++a) roller.follows[a] += roller.step[a];
  ++ring_.trial.steps;
  move_along(1.0);
}

/// Compute a step of the ring, and how rollers follow it.
void Balance::follow_ring(double loads) {
  const auto& by_force = conditions_.by_force;
  ring_.before = ring_.motion;
  // A small stiffness against all motions, so that a ring without contact moves in the direction of its load.
  const double resistance = RESISTANCE * std::min(residual_, 1.0) * loads / conditions_.depth;
  Small<5, 5> matrix{};
  for (Index a = 0; a < 5; ++a) {
    for (Index b = 0; b < 5; ++b) matrix[a][b] = by_force[a] && by_force[b] ? ring_.stiffness[a][b] : 0.0;
    matrix[a][a] += by_force[a] ? resistance * (assembly_.reach[a] * assembly_.reach[a]) : 1.0;
  }
  const auto step = eliminate(matrix, column(ring_.off), {1.0, 1.0, 1.0, 1.0, 1.0});
  for (Index b = 0; b < 5; ++b) ring_.step[b] = step[b][0];
  double most = conditions_.depth, moved = 0.0;
  for (Index j = 0; j < assembly_.rollers(); ++j) {
    Roller& roller = rollers_[j];
    roller.resting = roller.motion;
    most = std::max(most, deepest(j));
    roller.follows = guided_motion(j, ring_.step);
    const Vector<3> at_roller = product(assembly_.ring[j], ring_.step);
    for (Index a = 0; a < 2; ++a) moved = larger(moved, std::abs(at_roller[a]));
  }
  // No step increases a penetration much beyond its present or expected value.
  const double share = cautious(moved, most);
  ring_.step = times(share, ring_.step);
  for (Roller& roller : rollers_) {
    // A roller with little stiffness would move too far.
    roller.follows = times(share, roller.follows);
    roller.follows = times(cautious(largest_motion(roller.follows), most), roller.follows);
  }
}

/// Move the ring by a fraction of its step, and the rollers with it.
void Balance::move_along(double share) {
  for (Index b = 0; b < 5; ++b) ring_.motion[b] = ring_.before[b] + share * ring_.step[b];
  for (Roller& roller : rollers_)
    for (Index a = 0; a < 3; ++a) roller.motion[a] = roller.resting[a] + share * roller.follows[a];
  ask_all();
}

}  // namespace nonhertz
