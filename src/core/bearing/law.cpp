#include "bearing/law.hpp"

#include <cmath>
#include <limits>

#include "maps/contact_map.hpp"

namespace nonhertz {

Answer Slices::answer(const Pose& pose) const {
  Answer sum;
  sum.overlap = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < y.size(); ++k) {
    const double depth = pose.approach + pose.tilt * y[k] - relief[k];
    sum.overlap = std::max(sum.overlap, depth);
    if (!(depth > 0.0)) continue;
    // The power for the derivative first: multiplications are cheap.
    const double slope = stiffness * std::pow(depth, exponent - 1.0);
    sum.load += slope * depth;
    sum.moment += slope * depth * y[k];
    sum.load_by_approach += exponent * slope;
    sum.load_by_tilt += exponent * slope * y[k];
    sum.moment_by_tilt += exponent * slope * (y[k] * y[k]);
  }
  sum.moment_by_approach = sum.load_by_tilt;
  return sum;
}

Answer MapLaw::answer(const Pose& pose) const {
  const ContactMap map(table.data());
  const MapState state = map.at_approach(pose.approach, pose.tilt);
  const double first_touch = map.at_load(0.0, pose.tilt).approach;
  return {state.load,         state.moment,         state.load_by_approach,     state.load_by_tilt,
          state.load_by_tilt, state.moment_by_tilt, pose.approach - first_touch};
}

}  // namespace nonhertz
