// Contribution of a hollow roller to the field of a contact: the opposite contact, and the bending of the wall.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

/// A hollow roller under two contacts.
struct Wall {
  Index waves, through, along;  ///< numbers of modes, and of polynomials through the wall and along the roller
  Numbers modes;  ///< Chebyshev coefficients of the polar stress of each mode [MPa], (waves, 6, through, along)
  double top;     ///< end of the polynomials through the wall, as a fraction of it: the contact is above
  Numbers places, forces;  ///< of the point loads that represent the opposite contact [mm, N]
};

/// Add the stress [MPa] of the opposite contact and of all modes, at points (x, y, z in a row) nearer to this contact.
/// `along` is -1 and 1 at the faces; `outer` and `inner` are the radii of surface and bore [mm] there.
void add_wall(const Wall& wall, double poisson, View points, View along, View outer, View inner, Row out);

/// Add the stress of line loads [N/mm] that begin at `low` and `high` [mm] and extend away from the body.
void add_from_afar(double low, double high, double line_load, double poisson, View points, Row out);

}  // namespace nonhertz
