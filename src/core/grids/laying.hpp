// Laying of strips: edges in steps of the width given by the size function.
//
// A strip is centred on y = 0 if that is in contact, so that the centre pressure is a strip's own value, and edges lie
// on the ends of the contact and of the bodies and on kinks.
#pragma once

#include "grids/sizes.hpp"

namespace nonhertz {

/// Positions, and the number of strips between the first and each.
struct Path {
  Numbers place, count;
};

/// The strips required by a coarser solution: paths from the centre to both ends, whose strips can be counted.
class Plan {
 public:
  /// `coarseness`: widths over those tuned on random contacts; `limit`: the most strips on one interval of contact at a
  /// coarseness of 1.
  Plan(const Level& from, const Model& model, const Region& region, const std::vector<Extra>& extras, double coarseness,
       double limit);

  /// Return the edges of strips, `share` times the required number.
  Numbers lay(double share) const;

 private:
  Path left_, right_;
  Numbers marks_;
  double centre_, most_;  // largest number of strips
};

}  // namespace nonhertz
