// A contact for strips of one element, independent of loading and grid. It is immutable, so that any number of threads
// may use it.
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

/// Positions where the slope of the separation jumps [mm], ascending, and the jumps [rad].
struct Kinks {
  Numbers place, turn;
};

/// A finite part of the axis, with data of the bodies along it.
struct Region {
  double low, high;
  Samples samples;              ///< the separation at equidistant places
  Samples samples_with_crests;  ///< the same with the crests between them
  Kinks kinks;
};

struct Contact {
  std::array<Body, 2> bodies;
  Kernel kernel;
  std::vector<Reference> references;
  std::vector<FreedFace> freed;
  double compliance;      ///< K [1/MPa]
  Pair interval;          ///< on which both can touch [mm], infinite on a side where neither ends
  Numbers bends, crests;  ///< where a relief bends, or may have a peak between samples [mm], ascending
  Function refuse;        ///< the curvature in Python, which raises the error where both surfaces conform
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
  /// Combined curvature of both bodies [1/mm].
  Numbers curvature(View y) const;
  /// The larger of both in magnitude [1/mm].
  Numbers sharper_curvature(View y) const;
  /// The smaller of both depths [mm], infinite if neither body has one.
  Numbers min_depth(View y) const;
  /// Strips between these edges, with all their data.
  std::shared_ptr<const Grid> grid(Numbers edges) const;
  /// The same for independent springs: thousands of them without a full matrix.
  std::shared_ptr<Grid> springs(Numbers edges) const;
  /// Displacement of the reference points at any places, per unit of K q of each strip.
  Matrix at_depth(View y, View edges) const;
  /// Effect of half-widths on strips at y: coefficients of `WholeRoller::by_width` (rows); empty without whole rollers.
  Matrix by_width(View y) const;

  /// The whole interval where both can touch; nullptr if it is infinite.
  const std::shared_ptr<const Region>& region() const { return region_; }
  std::shared_ptr<const Region> region(double low, double high) const;
  /// The separation at equidistant places between two; and with the crests between them.
  Samples sample(double low, double high) const;
  Samples sample_with_crests(double low, double high) const;
  /// The bends between two places at which the slope jumps, tested with steps of a fraction of their distance.
  Kinks kinks_among(View bends, double length) const;

 private:
  std::array<Numbers, 2> curvatures(View y) const;

  Contact contact_;
  std::shared_ptr<const Region> region_;
};

/// Edges of equal strips.
Numbers uniform(double low, double high, Index count);

}  // namespace nonhertz
