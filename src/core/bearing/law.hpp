// Contact laws of rollers: load, moment, their derivatives and the overlap as functions of approach and tilt.
#pragma once

#include <memory>
#include <span>
#include <variant>

#include "numbers/array.hpp"
#include "numbers/stop.hpp"

namespace nonhertz {

struct Pose {
  double approach, tilt;  ///< [mm], [rad]
};

struct Answer {
  double load = 0.0, moment = 0.0;  ///< [N], [N mm]
  double load_by_approach = 0.0, load_by_tilt = 0.0, moment_by_approach = 0.0, moment_by_tilt = 0.0;
  double overlap = 0.0;  ///< largest overlap of the undeformed bodies, negative where they are apart [mm]
};

/// Independent slices whose load is a power of their penetration.
struct Slices {
  Numbers y, relief;  ///< positions, and separation of the bodies there [mm]
  double stiffness;   ///< load on a slice at a penetration of 1 mm [N]
  double exponent;

  Answer answer(const Pose& pose) const;
};

/// A map, which is continued linearly beyond its range.
struct MapLaw {
  Numbers table;  ///< the numbers of a map for its mean approach

  Answer answer(const Pose& pose) const;
};

/// A law that is evaluated for the contacts of many rollers at once, and may start from its previous results.
class GroupLaw {
 public:
  virtual ~GroupLaw() = default;
  /// Rollers are numbered through all states; poses and answers are those of their contacts with this law, the same
  /// number for each roller, one roller after another.
  virtual void answer(std::span<const Index> rollers, std::span<const Pose> poses, std::span<Answer> answers,
                      const Stop& stop) = 0;
};

using Law = std::variant<Slices, MapLaw, std::shared_ptr<GroupLaw>>;

}  // namespace nonhertz
