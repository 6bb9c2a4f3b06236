// Rollers between rings in equilibrium: the motion of the inner ring under given forces, moments and displacements.
//
// Every roller has a motion of its own, in which its contacts balance each other and the loads that speed gives it. It
// is found for a given motion of the ring, and with it the force on the ring and its exact derivative (static
// condensation):
//
//     f = sum_in A^T q            k = K_in - K_in (K_in + K_out)^-1 K_in        K = sum A^T S A
//
// with A the motion of a contact per motion of ring against roller and S its stiffness; K_in is of the contacts with
// the inner ring. The ring's motion is then found by Newton's method on the sum over all rollers. Contacts only push,
// and push harder the deeper they are pressed: both are the search for the lowest point of a convex function, so that a
// step which is shortened until the slope along it has fallen always leads on. Near the balance, ring and rollers step
// together; where such steps do not lead on, they step in turn, and the ring waits until every roller has ended its
// steps. Where nothing resists, as with a roller that touches nothing, there is nothing to balance, and it stays where
// it is. docs/explain/equilibrium.md has the details.
#pragma once

#include "bearing/assembly.hpp"
#include "numbers/stop.hpp"

namespace nonhertz {

/// What is given, and how well it is to be met.
struct Conditions {
  std::array<bool, 5> by_force;  ///< of which motions of the ring the force or moment is given
  double depth;                  ///< a penetration of the size to be expected [mm]
  double tolerance;              ///< what may be left of the balance of the ring, over the loads
  int steps;                     ///< the most that the ring takes, and a roller for each of them
};

/// What is given of one state, and where the search for it begins; rollers whose motion is NaN follow as equal springs.
struct Beginning {
  Vector<5> target, ring;
  std::vector<Vector<3>> rollers;
};

/// A state of a bearing in which the search ended.
struct Equilibrium {
  Vector<5> ring, force;  ///< motion of the inner ring, and forces and moments on it that hold it there
  Small<5, 5> stiffness;  ///< derivatives of the forces by the motions
  double residual;        ///< what is left of the balance of ring and rollers, over the loads
  int steps;              ///< Newton steps of the ring
  std::vector<Vector<3>> rollers;
  std::vector<Pose> poses;  ///< of their contacts
  std::vector<Answer> answers;
};

/// A step that is tried and shortened, of the ring or of a roller.
struct Trial {
  double slope = 0.0;  ///< along the step at its beginning
  double share = 0.0;  ///< how much of it is tried
  int shortened = 0;   ///< how often it was
  int steps = 0;       ///< how many were taken
  bool searching = false;
};

/// Begin to try a step, the whole of it first.
template <std::size_t N>
void try_whole(Trial& trial, const std::array<double, N>& off, const std::array<double, N>& step) {
  trial.slope = 0.0;
  for (std::size_t a = 0; a < N; ++a) trial.slope += off[a] * step[a];
  trial.share = 1.0, trial.shortened = 0, trial.searching = true;
  ++trial.steps;
}

/// Shorten a step that is tried, if the slope at its end points backwards; return whether it did, or end the step.
///
/// A step that falls short is good enough: the next goes on from there. A first slope below zero is rounding. Loads
/// grow faster the deeper bodies are pressed: a line through both slopes is zero before the best share, often where
/// the bodies are apart again, and the tangent at the end behind it.
template <std::size_t N>
bool shortened(Trial& trial, const std::array<double, N>& off, const std::array<double, N>& step,
               const std::array<std::array<double, N>, N>& stiffness) {
  constexpr double OVERSHOT = 0.5;  // of the slope along a step, by which it may point backwards at its end
  constexpr int SHORTENINGS = 30;
  const double first = trial.slope;
  double slope = 0.0, bend = 0.0;
  for (std::size_t a = 0; a < N; ++a) {
    slope += off[a] * step[a];
    for (std::size_t b = 0; b < N; ++b) bend += step[a] * stiffness[a][b] * step[b];
  }
  const bool backwards = slope < -OVERSHOT * first && first > 0.0;
  trial.searching = trial.searching && backwards && trial.shortened < SHORTENINGS;
  if (!trial.searching) return false;
  const double tangent = bend > 0.0 ? 1.0 + slope / (bend * trial.share) : 0.0;
  trial.share *= std::min(std::max(std::max(first / (first - slope), tangent), 0.1), 0.9);
  ++trial.shortened;
  return true;
}

/// The larger of two numbers, or NaN if either is.
inline double larger(double one, double other) { return std::isnan(other) || other > one ? other : one; }

inline constexpr double CAUTION = 8.0;     // penetrations that a step may add
inline constexpr double HELD_BACK = 1e-3;  // of loads over the penetration to be expected

/// The share of a step that presses nothing much deeper than so deep [mm].
inline double cautious(double moved, double deepest) {
  return moved <= CAUTION * deepest ? 1.0 : CAUTION * deepest / moved;
}

struct Ring {
  Vector<5> motion{}, before{}, step{};  ///< where it is, where its step began, and the whole step
  Vector<5> force{}, off{};              ///< on it, and what is left of its balance
  Small<5, 5> stiffness{};               ///< with rollers that follow in balance
  Trial trial;
};

struct Roller {
  Vector<3> motion{}, before{}, step{};  ///< where it is, where its own step began, and the whole step
  Vector<3> resting{}, follows{};  ///< where it was when the ring's step began, and how it follows the whole of it
  Vector<3> off{}, on_ring{};      ///< what is left of its balance, and the force of the inner ring on it
  double left = 0.0;               ///< the largest of what is left [N]
  Small<3, 3> whole{}, of_ring{};  ///< stiffness of all its contacts, and of those with the inner ring
  bool asked = true;               ///< whether its contacts are to answer
  Trial trial;
  std::span<Pose> poses;
  std::span<Answer> answers;
};

/// The search for one state: contacts answer where they are asked, and rollers and ring move on.
class Balance {
 public:
  Balance(const Assembly& assembly, const Conditions& conditions, const Beginning& begin, Index state);
  Balance(const Balance&) = delete;

  Equilibrium found(const Stop& stop);

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
  Vector<3> following(Index j, const Vector<5>& motion) const;
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
  const Index first_number_;  // of the rollers, counted through all states
  Ring ring_;
  std::vector<Pose> poses_;
  std::vector<Answer> answers_;
  std::vector<Roller> rollers_;
  Phase phase_ = Phase::together;
  double limit_;  // what may be left of the balance, over the loads, for the next step of ring and rollers together
  double left_;   // what is left, over the loads
  std::vector<int> times_;  // that the contacts of rollers have answered
  // Room for the questions to a law of many contacts.
  std::vector<Index> numbers_;
  std::vector<Pose> asked_poses_;
  std::vector<Answer> given_answers_;
};

/// Find many states; those of laws that begin anew with each are shared by threads, on which nothing depends.
std::vector<Equilibrium> equilibria(const Assembly& assembly, const Conditions& conditions,
                                    const std::vector<Beginning>& beginnings, int threads, const Stop& stop);

}  // namespace nonhertz
