// Starts of the Newton loop: independent springs, or the solution on another grid.
#pragma once

#include "strips/kernel.hpp"
#include "strips/strips.hpp"

namespace nonhertz {

/// Fill in r, m and the rigid motion of independent springs (a Winkler foundation).
void start_from_springs(const Grid& grid, const Prescription& prescribed, const Kernel& kernel, State& state);

/// Fill in r, m and the rigid motion from a solution on other strips; return whether any strip is in contact.
bool start_from_other(const Level& other, const Grid& grid, const Prescription& prescribed, State& state);

}  // namespace nonhertz
