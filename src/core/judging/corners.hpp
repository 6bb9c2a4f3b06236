// The corners of the profile at which a contact ends under pressure, on strips or on rows of cells.
//
// The pressure is singular there, as at a sharp end: it does not fall towards the corner, and beyond it the surfaces
// are apart. A contact that runs out next to a corner does not count, because its pressure falls to zero.
#pragma once

#include <functional>

#include "numbers/array.hpp"

namespace nonhertz {

/// Positions where profiles bend, and the data that distinguish a corner.
struct Bends {
  View places;                              ///< [mm]
  double compliance;                        ///< K of the contact [1/MPa]
  std::function<Numbers(View)> separation;  ///< at places [mm]
};

/// The corners [mm], ascending.
///
/// Arguments are for strips or rows between edges: largest pressure [MPa] and half-width [mm], zero out of contact.
Numbers corner_ends(const Bends& bends, View edges, View pressure, View half_width);

}  // namespace nonhertz
