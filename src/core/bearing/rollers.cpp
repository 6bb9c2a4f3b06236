// The steps of rollers towards their balance.
#include <cmath>

#include "bearing/balance.hpp"

namespace nonhertz {
namespace {

// Factor on a step that is to end beyond the contact, larger than the power of any law, where less than the second of
// the loads would remain.
constexpr double LETS_GO = 2.0, NOTHING_LEFT = 0.1;
constexpr double STIFFENING = 10.0 / 9.0;  // power of the deflection with which the load of a roller grows

/// Change of approach and tilt of a contact by a step of a roller.
Pose closer(const RollerContact& contact, const Vector<3>& step) {
  Pose added{0.0, 0.0};
  for (Index a = 0; a < 3; ++a) {
    added.approach -= contact.motion[0][a] * step[a];
    added.tilt -= contact.motion[1][a] * step[a];
  }
  return added;
}

}  // namespace

/// Request evaluation of a roller's contacts at the present positions of roller and ring.
void Balance::ask(Index j) {
  Roller& roller = rollers_[j];
  roller.pending = true;
  const auto contacts = assembly_.contacts(j);
  for (Index c = 0; c < assembly_.columns; ++c) {
    Pose pose{-contacts[c].gap, 0.0};
    for (Index a = 0; a < 3; ++a) {
      double moved = -roller.motion[a];
      if (contacts[c].inner)
        for (Index b = 0; b < 5; ++b) moved += assembly_.ring[j][a][b] * ring_.motion[b];
      pose.approach += contacts[c].motion[0][a] * moved;
      pose.tilt += contacts[c].motion[1][a] * moved;
    }
    roller.poses[c] = pose;
  }
}

void Balance::ask_all() {
  for (Index j = 0; j < assembly_.rollers(); ++j) rollers_[j].trial.steps = 0, ask(j);
}

/// Add up the forces on a roller, and its stiffness.
void Balance::add_up(Index j) {
  Roller& roller = rollers_[j];
  roller.off = assembly_.load[j], roller.on_ring = {}, roller.whole = {}, roller.of_ring = {};
  const auto contacts = assembly_.contacts(j);
  for (Index c = 0; c < assembly_.columns; ++c) {
    const Small<2, 3>& m = contacts[c].motion;
    const Answer& answer = roller.answers[c];
    for (Index a = 0; a < 3; ++a) {
      const double force = m[0][a] * answer.load + m[1][a] * answer.moment;
      roller.off[a] += force;
      if (contacts[c].inner) roller.on_ring[a] += force;
      const double by_approach = m[0][a] * answer.load_by_approach + m[1][a] * answer.moment_by_approach;
      const double by_tilt = m[0][a] * answer.load_by_tilt + m[1][a] * answer.moment_by_tilt;
      for (Index b = 0; b < 3; ++b) {
        const double stiff = by_approach * m[0][b] + by_tilt * m[1][b];
        roller.whole[a][b] += stiff;
        if (contacts[c].inner) roller.of_ring[a][b] += stiff;
      }
    }
  }
  roller.residual = largest(roller.off);
}

/// The largest of forces and moment on a roller, in terms of force [N].
double Balance::largest(const Vector<3>& forces) const {
  double most = 0.0;
  for (Index a = 0; a < 3; ++a) most = std::max(most, std::abs(forces[a]) / assembly_.scale[a]);
  return most;
}

/// The largest of displacements and rotation of a roller, in terms of displacement [mm].
double Balance::largest_motion(const Vector<3>& step) const {
  double most = 0.0;
  for (Index a = 0; a < 3; ++a) most = larger(most, std::abs(step[a] * assembly_.scale[a]));
  return most;
}

/// The load of a roller [N] to which the residual of its balance is relative.
double Balance::size() const {
  double size = 0.0;
  for (Index b = 0; b < 5; ++b)
    if (conditions_.by_force[b])
      size = std::max(size, std::abs(target_[b]) / assembly_.reach[b] / static_cast<double>(rollers_.size()));
  for (Index j = 0; j < assembly_.rollers(); ++j) {
    double borne = 0.0;
    for (const Answer& answer : rollers_[j].answers) borne += answer.load;
    size = std::max(std::max(size, borne), largest(assembly_.load[j]));
  }
  return size;
}

/// Move rollers as if all contacts were equal, half-way between the rings; barrels turn with the inner ring.
void Balance::follow_alike() {
  Answer alike;
  alike.load_by_approach = 1.0, alike.moment_by_tilt = assembly_.scale[2] * assembly_.scale[2] / 3.0;
  for (Index j = 0; j < assembly_.rollers(); ++j) {
    std::fill(rollers_[j].answers.begin(), rollers_[j].answers.end(), alike);
    add_up(j);
    std::fill(rollers_[j].answers.begin(), rollers_[j].answers.end(), Answer{});
    rollers_[j].motion = guided_motion(j, ring_.motion);
  }
}

/// Motion of a roller with the ring if its contacts keep their stiffness.
Vector<3> Balance::guided_motion(Index j, const Vector<5>& motion) const {
  const Roller& roller = rollers_[j];
  const Vector<3> pushed = product(roller.of_ring, product(assembly_.ring[j], motion));
  const auto follows = eliminate(roller.whole, column(pushed), assembly_.scale);
  return {follows[0][0], follows[1][0], follows[2][0]};
}

/// Move the rollers whose residual exceeds a limit [N]; return whether there are any.
bool Balance::rollers_step(double enough) {
  bool any = false;
  for (Index j = 0; j < assembly_.rollers(); ++j) {
    Roller& roller = rollers_[j];
    if (!shorten(roller.trial, roller.off, roller.step, roller.whole)) {
      roller.pending = roller.residual > enough && roller.trial.steps < conditions_.steps;
      if (!roller.pending) continue;
      roller.before = roller.motion, roller.step = roller_step(j);
      try_whole(roller.trial, roller.off, roller.step);
    }
    for (Index a = 0; a < 3; ++a) roller.motion[a] = roller.before[a] + roller.trial.share * roller.step[a];
    ask(j);
    any = true;
  }
  return any;
}

/// A step of a roller towards its balance, with the ring at rest.
Vector<3> Balance::roller_step(Index j) const {
  const Roller& roller = rollers_[j];
  // As for the ring: without resistance a roller moves in the direction of its load, in small steps.
  const double resistance = RESISTANCE * roller.residual / conditions_.depth;
  Small<3, 3> matrix = roller.whole;
  for (Index a = 0; a < 3; ++a) matrix[a][a] += resistance * (assembly_.scale[a] * assembly_.scale[a]);
  const auto solved = eliminate(matrix, column(roller.off), assembly_.scale);
  Vector<3> step{solved[0][0], solved[1][0], solved[2][0]};
  if (is_let_go(j, step)) step = times(LETS_GO, step);
  step = times(cautious(largest_motion(step), deepest(j)), step);
  return times(share_of_step(j, step), step);
}

/// Penetration of the contacts of a roller, or its expected value [mm].
double Balance::deepest(Index j) const {
  double deepest = conditions_.depth;
  for (const Answer& answer : rollers_[j].answers) deepest = std::max(deepest, answer.overlap);
  return deepest;
}

/// Whether a step takes an unloaded roller out of contact: it is to end clear of the rings. A load that grows with a
/// power of the penetration falls only by a certain factor in every step towards zero.
bool Balance::is_let_go(Index j, const Vector<3>& step) const {
  for (const double load : assembly_.load[j])
    if (load != 0.0) return false;
  const auto contacts = assembly_.contacts(j);
  double now = 0.0, then = 0.0;
  for (Index c = 0; c < assembly_.columns; ++c) {
    const Answer& answer = rollers_[j].answers[c];
    const Pose added = closer(contacts[c], step);
    now += answer.load;
    then += std::max(answer.load + answer.load_by_approach * added.approach + answer.load_by_tilt * added.tilt, 0.0);
  }
  return then <= NOTHING_LEFT * now;
}

/// The fraction of a roller's step that increases no penetration much beyond that by the residual.
///
/// Rollers loaded only by speed cross the clearance of the bearing, and must arrive with a small penetration: contacts
/// hundreds of times too deep take long to solve.
double Balance::share_of_step(Index j, const Vector<3>& step) const {
  const auto contacts = assembly_.contacts(j);
  const double expected = std::pow(rollers_[j].residual / assembly_.stiffness, 1.0 / STIFFENING);
  double share = 1.0;
  for (Index c = 0; c < assembly_.columns; ++c) {
    const Answer& answer = rollers_[j].answers[c];
    const Pose added = closer(contacts[c], step);
    // Loaded contacts deepen where they are loaded, within the reach of their stiffness; open ones at an end of the
    // roller.
    double middle = 0.0, reach = assembly_.scale[2];
    if (answer.load_by_approach > 0.0) {
      middle = answer.load_by_tilt / answer.load_by_approach;
      reach = std::sqrt(3.0 * std::max(answer.moment_by_tilt / answer.load_by_approach - middle * middle, 0.0));
    }
    const double now = answer.overlap;
    const double then = now + added.approach + middle * added.tilt + reach * std::abs(added.tilt);
    const double most = CAUTION * std::max(now, expected);
    if (then > most) share = std::min(share, (most - now) / (then - now));
  }
  return share;
}

}  // namespace nonhertz
