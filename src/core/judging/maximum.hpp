// The largest of some values along a contact that is independent of refinement.
#pragma once

#include "strips/strips.hpp"

namespace nonhertz {

/// A value, and its position [mm].
struct Largest {
  double value = 0.0, y = 0.0;
};

/// Places that may have the largest value, and the values there, zero where they do not count.
///
/// First those of the strips, then those between neighbouring strips.
struct Counted {
  Numbers places, values;

  /// Index of the largest; of those equal to rounding, such as mirrored maxima, the first along the contact.
  Index at() const;
  Largest largest() const;
};

/// Values of strips, or of rows of cells, that count: more than a half-width from ends at which they are singular.
///
/// Values are zero out of contact. In a contact too short for that, the value farthest from the ends, in half-widths,
/// counts.
Counted values_that_count(View y, View values, View half_width, View ends);

}  // namespace nonhertz
