// Where the pressure is too pointed for its strips.
#pragma once

#include "strips/strips.hpp"

namespace nonhertz {

/// A largest pressure that is too pointed for its strips: the width wanted there, and what they have [mm].
struct Peak {
  double place, wanted, width;
};

/// Find it on either side of y = 0, where pressures are equal that mirror each other; a strip on y = 0 is on both.
///
/// What a strip bears is the mean over it: a sagitta of the pressure within it, of which a share of the pressure is
/// `allowed`, is missing from the maximum. At a kink the pressure has no limit.
std::vector<Peak> peaks_of(const Level& level, View kinks, double allowed);

}  // namespace nonhertz
