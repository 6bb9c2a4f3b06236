// A contact as strips of one element see it, whatever is prescribed and wherever they lie. Nothing in it changes after
// it is made, so that any number of threads may solve with it.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "bodies/reference.hpp"
#include "strips/strips.hpp"

namespace nonhertz {

inline constexpr int SAMPLES = 600;  // intervals along the bodies

struct Body {
  SharedRelief relief;
  Curvature curvature;
  double modulus;  ///< [MPa]
};

/// A side face that images are about, at low (-1) or high y.
struct FreedFace {
  double y, side, image_weight, free;
};

/// Places [mm] and the separation there [mm].
struct Samples {
  Numbers y, h;
};

/// Where the slope of the separation jumps [mm], ascending, and by how much [rad].
struct Kinks {
  Numbers place, turn;
};

/// A finite part of the axis, and what is known of the bodies along it.
struct Region {
  double low, high;
  Samples sampled;   ///< the separation at even places
  Samples surveyed;  ///< the same with the crests between them
  Kinks kinks;
};

struct Contact {
  std::array<Body, 2> bodies;
  Kernel kernel;
  std::vector<Reference> references;
  std::vector<FreedFace> freed;
  double compliance;      ///< K [1/MPa]
  Pair interval;          ///< where both can touch [mm], infinite on a side where neither ends
  Numbers bends, crests;  ///< where a relief bends, or may stand out between samples [mm], ascending
  Function refuse;        ///< the curvature in Python, which says what is wrong where both surfaces conform
};

class Model {
 public:
  explicit Model(Contact contact);

  const Contact& contact() const { return contact_; }
  const Kernel& kernel() const { return contact_.kernel; }
  double hertz_ratio() const { return contact_.kernel.element->hertz_ratio; }
  double low() const { return contact_.interval[0]; }
  double high() const { return contact_.interval[1]; }

  Numbers separation(View y) const;
  double separation(double y) const;
  /// Of both bodies [1/mm].
  Numbers curvature(View y) const;
  /// The larger of both in magnitude [1/mm].
  Numbers sharper_curvature(View y) const;
  /// The smaller of both depths [mm], infinite if neither body has one.
  Numbers min_depth(View y) const;
  /// Strips between these edges, with all that is known about them.
  std::shared_ptr<const Grid> grid(Numbers edges) const;
  /// The same for springs, which do not move one another: thousands of them stand without a matrix of all by all.
  std::shared_ptr<Grid> springs(Numbers edges) const;
  /// Displacement at any places of what it is measured against, per unit of K q of each strip.
  Matrix at_depth(View y, View edges) const;
  /// What half-widths change on strips at y: coefficients of `WholeRoller::by_width` (rows); empty without such.
  Matrix by_width(View y) const;

  /// The whole interval where both can touch; nullptr where that is endless.
  const std::shared_ptr<const Region>& region() const { return region_; }
  std::shared_ptr<const Region> region(double low, double high) const;
  /// The separation at even places between two; with the crests between them.
  Samples sampled(double low, double high) const;
  Samples surveyed(double low, double high) const;
  /// Those of the bends between two places whose slope jumps, looked at in steps of a fraction of their distance.
  Kinks kinks_among(View bends, double length) const;

 private:
  std::array<Numbers, 2> curvatures(View y) const;

  Contact contact_;
  std::shared_ptr<const Region> region_;
};

/// Edges of equal strips.
Numbers uniform(double low, double high, Index count);

}  // namespace nonhertz
