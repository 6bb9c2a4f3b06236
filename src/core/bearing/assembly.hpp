// Rollers between an inner ring, which moves, and an outer ring at rest: the data that are constant during the search.
#pragma once

#include "bearing/law.hpp"
#include "bearing/small.hpp"

namespace nonhertz {

/// One contact of every roller of a row.
struct Joint {
  bool inner;          ///< whether the other body is the inner ring
  Small<2, 3> motion;  ///< approach and tilt per motion of ring against roller
  Numbers gap;         ///< gap between a centred ring and roller [mm], for each roller
  Law law;
  Index column;  ///< index of the contact among a roller's, from 0
  Index first;   ///< the number of the row's first roller
};

/// A contact of one roller.
struct RollerContact {
  Small<2, 3> motion{};
  double gap = 0.0;
  bool inner = false;
  Index law = NO_LAW;

  static constexpr Index NO_LAW = -1;  ///< for a contact that the roller does not have
};

/// A law that is evaluated for many contacts at once, and the rollers with these contacts.
struct Group {
  std::shared_ptr<GroupLaw> law;
  Index first, end;            ///< rollers
  std::vector<Index> columns;  ///< indices of their contacts
};

class Assembly {
 public:
  /// The ring's motion at each roller per motion of the inner ring; the load on every roller along x, along r, and its
  /// moment [N, N, N mm]; a lever that makes rotations of rollers comparable with displacements [mm]; and the
  /// approximate load on a roller per deflection to the power 10/9 [N].
  Assembly(std::vector<Small<3, 5>> ring, const std::vector<Joint>& joints, std::vector<Vector<3>> load, double lever,
           double stiffness);

  Index rollers() const { return static_cast<Index>(ring.size()); }
  std::span<const RollerContact> contacts(Index roller) const {
    return {&contacts_[static_cast<std::size_t>(roller * columns)], static_cast<std::size_t>(columns)};
  }
  const Law& law(const RollerContact& of) const { return laws_[static_cast<std::size_t>(of.law)]; }
  const std::vector<Group>& groups() const { return groups_; }

  std::vector<Small<3, 5>> ring;
  std::vector<Vector<3>> load;
  Index columns;  ///< largest number of contacts of a roller
  Vector<3> scale;
  Vector<5> reach;  ///< lever arms that convert the ring's moments to forces, and its rotations to displacements
  double stiffness;

 private:
  void join(const Joint& joint, Index law);

  std::vector<RollerContact> contacts_;
  std::vector<Law> laws_;
  std::vector<Group> groups_;
};

}  // namespace nonhertz
