// The shape of a body along its axis: formulas of the catalogue, and functions of the user's.
#pragma once

#include <functional>
#include <limits>
#include <variant>
#include <vector>

#include "numbers/array.hpp"

namespace nonhertz {

/// A middle and two ends, each a circular arc, the same on both sides; an infinite radius makes a straight middle.
struct Arcs {
  double radius, end_radius, junction, end_summit;
};

/// amplitude ln(1 / (1 - (1 - rest) s^2)), s from a straight middle to the end; never more than at_end up to there.
struct Logarithmic {
  double amplitude, length, rest, curved, at_end;
};

/// Any other profile: fills in its relief at many places at once. Called from Python, it takes the interpreter's lock.
struct Function {
  std::function<void(View y, Row h)> fill;
};

using Formula = std::variant<Arcs, Logarithmic, Function>;

/// A formula with its relief multiplied, then shifted along the axis, then flipped.
struct Moved {
  Formula formula;
  double scale = 1.0, shift = 0.0;
  bool flip = false;
  double low = -std::numeric_limits<double>::infinity(), high = -low;  ///< where the formula is defined
};

/// Formulas on top of one another, on a body at some place along y.
struct Relief {
  std::vector<Moved> parts;
  double position = 0.0;
  double low = -std::numeric_limits<double>::infinity(), high = -low;  ///< where all are defined

  /// Add the relief [mm] at places y [mm].
  void add_to(View y, Row h) const;
};

}  // namespace nonhertz
