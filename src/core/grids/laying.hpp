// Where the strips lie: edges in steps of the width that the size function asks for.
//
// A strip is centred on y = 0 where that is in contact, so that the centre pressure is a strip's own value, and edges
// lie on the ends of the contact and of the bodies and on kinks.
#pragma once

#include "grids/sizes.hpp"

namespace nonhertz {

/// How fine a grid is to be.
struct Fineness {
  double coarseness;  ///< widths over those tuned on random contacts
  double share;       ///< strips over those that the size function asks for
  double limit;       ///< the most strips on one interval of contact, at a coarseness of 1
};

/// Return the edges of the strips that a coarser solution calls for.
Numbers lay(const Level& from, const Model& model, const Region& region, const std::vector<Extra>& extras,
            const Fineness& fineness);

}  // namespace nonhertz
