// The influence of strips on both surfaces.
#pragma once

#include <memory>
#include <vector>

#include "strips/element.hpp"

namespace nonhertz {

/// The load itself, sign 1, offset 0, or a mirror image of it: at sign y + offset, weight times.
struct Term {
  double sign, offset, weight;
};

/// The table read by `free_end`, for one Poisson's ratio.
struct FaceTable {
  Numbers numbers;
  const double* data() const { return numbers.data(); }
};

/// A side face that is also free of normal stress: -1 at low, 1 at high y.
struct Face {
  double place, side, weight;
  std::shared_ptr<const FaceTable> table;
};

struct Kernel {
  std::shared_ptr<const Element> element;
  std::vector<Term> terms;
  std::vector<Face> faces;
};

}  // namespace nonhertz
