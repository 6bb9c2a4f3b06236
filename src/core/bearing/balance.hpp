// Rollers between rings in equilibrium: the motion of the inner ring under given forces, moments and displacements.
//
// Every roller has its own motion, in which its contacts balance each other and the loads due to speed. It is computed
// for a given motion of the ring, and with it the force on the ring and its exact derivative (static condensation):
//
//     f = sum_in A^T q            k = K_in - K_in (K_in + K_out)^-1 K_in        K = sum A^T S A
//
// with A the motion of a contact per motion of ring relative to roller and S its stiffness; K_in belongs to the
// contacts with the inner ring. The ring's motion is then found by Newton's method on the sum over all rollers.
// Contacts only push, with a force that increases with the penetration: both problems are minimisations of a convex
// function, so that a step shortened until the slope along it has decreased always makes progress. Near the balance,
// ring and rollers step together; where such steps fail, they step in turn, and the ring waits until every roller has
// finished its steps. Without resistance, as for a roller without contact, there is nothing to balance, and the roller
// stays where it is. docs/explain/equilibrium.md has the details.
#pragma once

#include "bearing/assembly.hpp"
#include "numbers/stop.hpp"

namespace nonhertz {

/// The kind of given values, and the accuracy with which they are met.
struct Conditions {
  std::array<bool, 5> by_force;  ///< for each motion of the ring, whether its force or moment is given
  double depth;                  ///< expected size of penetrations [mm]
  double tolerance;              ///< permitted residual of the balance of the ring, over the loads
  int steps;                     ///< largest number for the ring, and for a roller within each of them
};

/// The given values of one state and the start of its search; rollers whose motion is NaN start as equal springs.
struct Beginning {
  Vector<5> target, ring;
  std::vector<Vector<3>> rollers;
};

/// The state of a bearing in which the search ended.
struct Equilibrium {
  Vector<5> ring, force;  ///< motion of the inner ring, and forces and moments on it in equilibrium
  Small<5, 5> stiffness;  ///< derivatives of the forces by the motions
  double residual;        ///< residual of the balance of ring and rollers, over the loads
  int steps;              ///< Newton steps of the ring
  std::vector<Vector<3>> rollers;
  std::vector<Pose> poses;  ///< of their contacts
  std::vector<Answer> answers;
};

/// A trial step of the ring or of a roller, which may be shortened.
struct Trial {
  double slope = 0.0;   ///< along the step at its beginning
  double share = 0.0;   ///< fraction of it that is tried
  int shortenings = 0;  ///< of this step
  int steps = 0;        ///< number of steps taken
  bool searching = false;
};

/// Begin a trial step with its full length.
template <std::size_t N>
void try_whole(Trial& trial, const std::array<double, N>& off, const std::array<double, N>& step) {
  trial.slope = 0.0;
  for (std::size_t a = 0; a < N; ++a) trial.slope += off[a] * step[a];
  trial.share = 1.0, trial.shortenings = 0, trial.searching = true;
  ++trial.steps;
}

/// Shorten a trial step if the slope at its end points backwards and return true, or end the step.
///
/// A step that falls short is good enough: the next continues from there. A first slope below zero is rounding. Since
/// loads grow faster with penetration, the line through both slopes vanishes before the best fraction, often where the
/// bodies are apart again, and the tangent at the end vanishes beyond it.
template <std::size_t N>
bool shorten(Trial& trial, const std::array<double, N>& off, const std::array<double, N>& step,
             const std::array<std::array<double, N>, N>& stiffness) {
  constexpr double OVERSHOT = 0.5;  // of the slope along a step: permitted backward slope at its end
  constexpr int SHORTENINGS = 30;
  const double first = trial.slope;
  double slope = 0.0, bend = 0.0;
  for (std::size_t a = 0; a < N; ++a) {
    slope += off[a] * step[a];
    for (std::size_t b = 0; b < N; ++b) bend += step[a] * stiffness[a][b] * step[b];
  }
  const bool backwards = slope < -OVERSHOT * first && first > 0.0;
  trial.searching = trial.searching && backwards && trial.shortenings < SHORTENINGS;
  if (!trial.searching) return false;
  const double tangent = bend > 0.0 ? 1.0 + slope / (bend * trial.share) : 0.0;
  trial.share *= std::min(std::max(std::max(first / (first - slope), tangent), 0.1), 0.9);
  ++trial.shortenings;
  return true;
}

/// The larger of two numbers, or NaN if either is.
inline double larger(double one, double other) { return std::isnan(other) || other > one ? other : one; }

inline constexpr double CAUTION = 8.0;      // a step may add this many penetrations
inline constexpr double RESISTANCE = 1e-3;  // of loads over the expected penetration

/// The fraction of a step that increases no penetration much beyond a depth [mm].
inline double cautious(double moved, double deepest) {
  return moved <= CAUTION * deepest ? 1.0 : CAUTION * deepest / moved;
}

struct Ring {
  Vector<5> motion{}, before{}, step{};  ///< its position, the start of its step, and the whole step
  Vector<5> force{}, off{};              ///< force on it, and residual of its balance
  Small<5, 5> stiffness{};               ///< with rollers that follow in balance
  Trial trial;
};

struct Roller {
  Vector<3> motion{}, before{}, step{};  ///< its position, the start of its own step, and the whole step
  Vector<3> resting{},
      follows{};               ///< its position at the start of the ring's step, and its motion over the whole of it
  Vector<3> off{}, on_ring{};  ///< residual of its balance, and the force of the inner ring on it
  double residual = 0.0;       ///< largest component of the residual [N]
  Small<3, 3> whole{}, of_ring{};  ///< stiffness of all its contacts, and of those with the inner ring
  bool pending = true;             ///< whether its contacts are to be evaluated
  Trial trial;
  std::span<Pose> poses;
  std::span<Answer> answers;
};

/// The search for one state: contacts are evaluated where requested, and rollers and ring move on.
class Balance {
 public:
  Balance(const Assembly& assembly, const Conditions& conditions, const Beginning& begin, Index state);
  Balance(const Balance&) = delete;

  Equilibrium solve(const Stop& stop);

 private:
  enum class Phase { together, in_turn };
  struct Imbalance {
    double ring, rollers;  ///< over the loads, and over the load of a roller
    double loads;          ///< [N]
  };

  bool answer(const Stop& stop);
  void answer(const Group& group, const Stop& stop);
  bool advance();
  void follow_alike();
  void ask(Index j);
  void ask_all();
  void add_up(Index j);
  double largest(const Vector<3>& forces) const;
  double largest_motion(const Vector<3>& step) const;
  double size() const;
  Vector<3> guided_motion(Index j, const Vector<5>& motion) const;
  bool rollers_step(double enough);
  Vector<3> roller_step(Index j) const;
  double deepest(Index j) const;
  bool is_let_go(Index j, const Vector<3>& step) const;
  double share_of_step(Index j, const Vector<3>& step) const;
  Imbalance condense(double size);
  void step_together(double loads);
  void follow_ring(double loads);
  void move_along(double share);

  const Assembly& assembly_;
  const Conditions& conditions_;
  const Vector<5> target_;
  const Index first_number_;  // of the rollers, numbered through all states
  Ring ring_;
  std::vector<Pose> poses_;
  std::vector<Answer> answers_;
  std::vector<Roller> rollers_;
  Phase phase_ = Phase::together;
  double limit_;            // residual below which ring and rollers take the next step together, over the loads
  double residual_;         // residual, over the loads
  std::vector<int> times_;  // number of evaluations of the contacts of rollers
  // Buffers for evaluations of a law of many contacts.
  std::vector<Index> numbers_;
  std::vector<Pose> asked_poses_;
  std::vector<Answer> given_answers_;
};

/// Find many states; states with laws that keep no history are distributed over threads, without effect on the results.
std::vector<Equilibrium> equilibria(const Assembly& assembly, const Conditions& conditions,
                                    const std::vector<Beginning>& beginnings, int threads, const Stop& stop);

}  // namespace nonhertz
