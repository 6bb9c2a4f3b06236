// A pressure on the surface of a half-space, with its mirror images.
#pragma once

#include <variant>
#include <vector>

#include "strips/kernel.hpp"
#include "subsurface/rectangles.hpp"
#include "subsurface/strip_load.hpp"

namespace nonhertz {

struct Load {
  std::variant<Lamination, Panels> of;
};

/// Six components of the stress [MPa] at points (x, y, z in a row), or of the shear modulus times the displacement,
/// of the load and its images together.
void below_load(const Load& load, const std::vector<Term>& terms, double poisson, bool displaced, View points, Row out);

}  // namespace nonhertz
