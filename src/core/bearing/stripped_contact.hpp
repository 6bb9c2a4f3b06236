// A contact between roller and ring by the strip-element method, on strips that are reused from one pose to the next.
#pragma once

#include <map>

#include "bearing/law.hpp"
#include "bodies/model.hpp"
#include "strips/follow.hpp"

namespace nonhertz {

/// Thrown where a contact of a roller has no solution.
struct Unsolved {
  Pose pose;
};

/// A contact solved on strips.
struct LaidContact {
  Level level;
  Pose laid_for;  ///< for which the strips were laid
  double depth;   ///< and the penetration there [mm]
  Pose pose;      ///< of the solution
  Answer answer;  ///< times K, except for the overlap
};
using SharedContact = std::shared_ptr<const LaidContact>;

/// The parts that do not depend on approach and tilt, and the loops on strips.
class StrippedContact {
 public:
  explicit StrippedContact(std::shared_ptr<const Model> model);
  StrippedContact(const StrippedContact&) = delete;

  double half_length() const { return 0.5 * (high_ - low_); }
  double compliance() const { return model_->contact().compliance; }
  const Samples& samples() const { return samples_; }

  /// Number of loops kept.
  std::size_t loops() const { return loops_.size(); }

  /// Largest overlap of the undeformed bodies [mm].
  Numbers penetration(std::span<const Pose> poses) const;
  /// About so many strips, nearly equal.
  std::shared_ptr<const Grid> lay_evenly(Index strips) const;

  /// A contact solved on strips of the automatic grid; throws Unsolved.
  SharedContact lay(const Pose& pose, double depth, const Stop& stop) const;
  /// A contact solved anew on given strips; nothing if it has no solution.
  SharedContact solve(std::shared_ptr<const Grid> strips, const Pose& pose, double depth, const Stop& stop) const;
  /// A contact solved at another pose on its strips, from its present state; nothing if it has no solution.
  SharedContact solve(const LaidContact& before, const Pose& pose, const Stop& stop) const;
  /// A contact that follows to another pose on its strips, which is faster; nothing if that fails.
  SharedContact follow(const LaidContact& before, const Pose& pose);
  /// A first guess of this contact, with the other ring, from one on strips that suit both.
  LaidContact on_strips_of(const LaidContact& other) const;

 private:
  SharedContact with_answer(LaidContact contact) const;

  std::shared_ptr<const Model> model_;
  std::shared_ptr<const Kernel> kernel_;
  double low_, high_;
  Samples samples_;
  std::map<const Grid*, Following> loops_;  // each keeps its grid alive
};

}  // namespace nonhertz
