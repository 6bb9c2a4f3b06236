// The strips that an automatic grid begins with.
#pragma once

#include "bodies/model.hpp"

namespace nonhertz {

inline constexpr Index COARSE_STRIPS = 24;

/// Edges of equal strips that can meet what is prescribed: all along the interval, or near where the bodies touch.
Numbers first_strips(const Model& model, const Prescription& given, double low, double high);

}  // namespace nonhertz
