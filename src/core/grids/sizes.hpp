// The size function: the target strip width at each y, from a solution on a coarser grid.
//
// It is small where the contact ends, at sharp ends, at kinks and where the profile bends sharply, grows in proportion
// to the distance from there, and is nowhere less than a fraction of the half-width, below which the strip model breaks
// down.
#pragma once

#include "bodies/model.hpp"
#include "grids/extent.hpp"

namespace nonhertz {

/// A further place that needs strips, and the target width there [mm].
struct Extra {
  double place, width;
};

/// The size function by a coarse solution.
class Sizes {
 public:
  Sizes(const Level& from, const Model& model, const Region& region, const std::vector<Extra>& extras,
        double coarseness);

  /// The target strip width at y; away from the features `by` times as wide.
  double operator()(double y, double by) const;
  /// y = 0 if it is in contact, else the middle of the longest interval in contact.
  double centre() const;
  /// The positions of edges, ascending.
  Numbers marks() const;
  /// The number of intervals in contact.
  Index pieces() const { return static_cast<Index>(contact_.size()); }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  /// A place with narrow strips: up to the distance `slow` widths grow slowly; an edge lies there if it is `marked`.
  struct Feature {
    double place, width, slow;
    bool marked;
  };

  void add_ends(const Level& from, const Region& region, double coarseness);
  void add_kinks(const Level& from, const Kinks& kinks, double depth);
  void add_extras(const Region& region, const std::vector<Extra>& extras);
  void bound_by_sag(const Samples& samples, const State& state, double deepest, double coarseness, double narrowest);

  std::vector<Pair> contact_;
  std::vector<Feature> features_;
  double low_, high_, length_;
  double sample_low_, sample_step_;
  Numbers sample_width_;
  double largest_, largest_outside_, growth_;
};

inline constexpr int MOST_BENDS = 12;  // if there are more, none is treated specially

}  // namespace nonhertz
