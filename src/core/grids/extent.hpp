// The intervals in contact, and the shape of the contact there.
#pragma once

#include <vector>

#include "strips/strips.hpp"

namespace nonhertz {

/// Intervals in contact [mm], up to where m, extrapolated linearly, vanishes.
std::vector<Pair> intervals(const Grid& grid, View m);
/// Whether a contact extends to the outer edge of its strips on that side, -1 or 1.
bool reaches(const Grid& grid, View m, int side);
/// Whether the strip around a place or one of its neighbours is in contact.
bool is_nearly_touching(const Grid& grid, View m, double place);
/// The largest half-width of the few strips in contact nearest to a place.
double width_near(const Grid& grid, View m, double place);
/// The distance from one end of a contact at which m is half its value at the nearest peak.
double fall(const Grid& grid, View m, double low, double high, int side);

}  // namespace nonhertz
