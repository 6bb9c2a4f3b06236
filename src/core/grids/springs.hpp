// Independent springs instead of the bodies: they show where to search for the contact.
#pragma once

#include "bodies/model.hpp"

namespace nonhertz {

inline constexpr Index FINE_STRIPS = 2000;  // spring strips, to find a contact that falls between a grid's centres

/// The response of springs between these edges, which is not a solution.
Level springs(const Model& model, const Prescription& prescribed, Numbers edges);

/// Whether any strip is in contact.
bool is_touching(const Level& level);

/// The edges between which springs are in contact, nothing if they are not in contact anywhere.
std::optional<Pair> spring_contact(const Level& level);

/// The interval within two places in which springs find contact, with a margin.
Pair neighbourhood(const Model& model, const Prescription& prescribed, double low, double high);

}  // namespace nonhertz
