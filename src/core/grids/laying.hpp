// Where the strips lie: a size function, the target strip width at each y, and edges in steps of that width.
//
// Small where the contact ends, at sharp ends, at kinks and where the profile bends sharply, it grows in proportion to
// the distance from there. The sizes come from a solution on a coarser grid.
#pragma once

#include "bodies/model.hpp"

namespace nonhertz {

/// How fine a grid is to be.
struct Fineness {
  double coarseness;  ///< widths over those tuned on random contacts
  double share;       ///< strips over those that the size function asks for
  double limit;       ///< the most strips on one interval of contact, at a coarseness of 1
};

/// A further place that needs strips, and the width wanted there [mm].
struct Extra {
  double place, width;
};

/// Return the edges of the strips that a coarser solution calls for.
Numbers lay(const Level& from, const Model& model, const std::vector<Extra>& extras, const Fineness& fineness);

/// Intervals in contact [mm], up to where m, continued linearly, vanishes.
std::vector<Pair> intervals(const Grid& grid, View m);
/// Whether a contact extends to the outer edge of its strips on that side, -1 or 1.
bool reaches(const Grid& grid, View m, int side);
/// Whether the strip around a place or one of its neighbours is in contact.
bool nearly_touching(const Grid& grid, View m, double place);

inline constexpr int MOST_BENDS = 12;  // of more, none stands out

}  // namespace nonhertz
