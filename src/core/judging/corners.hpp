// The corners of the profile at which a contact ends under pressure, on strips or on rows of cells.
//
// There the pressure has no limit, as at a sharp end: it does not fall towards the corner, and beyond it the surfaces
// are apart. A contact that runs out next to a corner does not count, because its pressure falls to zero.
#pragma once

#include <functional>

#include "numbers/array.hpp"

namespace nonhertz {

/// Where profiles bend, and what tells whether that is a corner.
struct Bends {
  View places;                              ///< [mm]
  double compliance;                        ///< K of the contact [1/MPa]
  std::function<Numbers(View)> separation;  ///< at places [mm]
};

/// The corners [mm], ascending.
///
/// Of strips or rows between edges: their largest pressure [MPa] and half-width [mm], zero out of contact.
Numbers corner_ends(const Bends& bends, View edges, View pressure, View half_width);

}  // namespace nonhertz
