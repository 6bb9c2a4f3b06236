// The interval in which a contact is searched.
#pragma once

#include "grids/feasible.hpp"

namespace nonhertz {

/// The interval that contains the contact; finite even where the bodies are unbounded.
Pair bound_contact(const Model& model, const Prescription& prescribed);

/// The same with the data along it.
std::shared_ptr<const Region> region_of(const Model& model, const Prescription& prescribed);

}  // namespace nonhertz
