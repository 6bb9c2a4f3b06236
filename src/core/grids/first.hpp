// The first strips of an automatic grid.
#pragma once

#include "bodies/model.hpp"

namespace nonhertz {

inline constexpr Index COARSE_STRIPS = 24;

/// Edges of equal strips that can meet the prescribed values: over the whole interval, or near where the bodies touch.
Numbers first_strips(const Model& model, const Prescription& prescribed, double low, double high);

}  // namespace nonhertz
