// Overlaps of the bodies where no strip is in contact: another contact that the strips have missed.
//
// Contact conditions are enforced only at strip centres. The bodies are therefore sampled again along their whole
// length, including every crest of the profiles and the vertices of parabolas through the samples.
#pragma once

#include "grids/sizes.hpp"

namespace nonhertz {

/// Whether there may be a contact without a strip, where the undeformed surfaces overlap most.
bool suspect(const Level& level, const Samples& along);

/// Places [mm], ascending, and the overlap of the surfaces there where no strip is in contact [mm].
///
/// Zero in contact and beside it, negative where the undeformed surfaces are apart; empty if all is in contact.
Samples sample_overlap(const Model& model, const Level& level, const Samples& along);

/// The vertices of parabolas through three neighbouring places each, where they are deeper than zero.
Numbers summits_of(View y, View depth);

/// The midpoints of intervals where the surfaces overlap between strips out of contact, and widths for strips there.
std::vector<Extra> overlaps(const Model& model, const Region& region, const Level& level);

}  // namespace nonhertz
