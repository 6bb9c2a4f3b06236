// Pressure peaks that are too pointed for their strips.
#pragma once

#include "strips/strips.hpp"

namespace nonhertz {

/// A largest pressure that is too pointed for its strips: the required and the present width there [mm].
struct Peak {
  double place, wanted, width;
};

/// Find it on each side of y = 0, since mirrored pressures are equal; a strip on y = 0 is on both sides.
///
/// The pressure of a strip is the mean over it: the maximum lacks a sagitta of the pressure within it, of which a
/// fraction of the pressure is `allowed`. At a kink the pressure is singular.
std::vector<Peak> peaks_of(const Level& level, View kinks, double allowed);

}  // namespace nonhertz
