// Where to look for a contact.
#pragma once

#include "grids/feasible.hpp"

namespace nonhertz {

/// The interval in which to look for the contact; finite even where the bodies are unbounded.
Pair bounded(const Model& model, const Prescription& given);

/// The same with what is known along it.
std::shared_ptr<const Region> region_of(const Model& model, const Prescription& given);

}  // namespace nonhertz
