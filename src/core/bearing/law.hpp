// How contacts of rollers answer approach and tilt: with load, moment, their derivatives and the overlap.
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
  double overlap = 0.0;  ///< of the undeformed bodies where they overlap most, negative where they are apart [mm]
};

/// Independent slices whose load is a power of their penetration.
struct Slices {
  Numbers y, relief;  ///< where they are, and how far the bodies are apart there [mm]
  double stiffness;   ///< load of a slice of a penetration of 1 mm [N]
  double exponent;

  Answer answer(const Pose& pose) const;
};

/// A map, which goes on in straight lines beyond its range.
struct MapLaw {
  Numbers table;  ///< of the numbers of a map those of its mean approach

  Answer answer(const Pose& pose) const;
};

/// A law that is asked for the contacts of many rollers at once, and may begin where it ended the last time.
class GroupLaw {
 public:
  virtual ~GroupLaw() = default;
  /// Rollers are counted through all states; poses and answers are of their contacts with this law, as many for each,
  /// one roller after another.
  virtual void answer(std::span<const Index> rollers, std::span<const Pose> poses, std::span<Answer> answers,
                      const Stop& stop) = 0;
};

using Law = std::variant<Slices, MapLaw, std::shared_ptr<GroupLaw>>;

}  // namespace nonhertz
