// The shape of a body along its axis: formulas of the catalogue, and functions of the user's.
#pragma once

#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "numbers/interpolation.hpp"

namespace nonhertz {

/// Numbers at many places at once, computed in Python, whose lock it takes.
using Function = std::function<void(View y, Row out)>;

/// No relief.
struct Straight {};

/// A middle and two ends, each a circular arc, the same on both sides; an infinite radius makes a straight middle.
struct Arcs {
  double radius, end_radius, junction, end_summit;
};

/// amplitude ln(1 / (1 - (1 - rest) s^2)), s from a straight middle to the end; at most at_end up to there.
struct Logarithmic {
  double amplitude, length, rest, curved, at_end;
};

/// A constant slope along the whole axis.
struct Conical {
  double slope;
};

/// A straight middle and two ends of constant slope.
struct TaperedEnds {
  double straight, slope;
};

/// The displacement function of a strip with a semi-elliptic pressure: cubic polynomials in ln t.
struct StripDisplacement {
  Matrix cubics;              ///< of each cell, lowest power first
  double nearest, far, step;  ///< range in t and step in ln t
};

/// The relief that makes the pressure uniform along a contact.
struct UniformPressure {
  double amplitude, length, half_width;
  std::shared_ptr<const StripDisplacement> displacement;
};

/// A curve through points, outside of which there is no body.
struct Tabulated {
  std::variant<Polyline, Cubics> curve;
};

struct Relief;
using SharedRelief = std::shared_ptr<const Relief>;

/// A sum of reliefs.
struct Sum {
  std::vector<SharedRelief> parts;
};

/// A relief multiplied, then shifted along the axis, then flipped.
struct Moved {
  SharedRelief relief;
  double scale, shift;
  bool flip;
  double low, high;  ///< extent before it is moved
};

/// A corner at either end: an arc that continues straight.
struct Corner {
  double extent, radius, arc,
      slope;  ///< lengths along the axis of the corner and of its arc; a radius of 0 makes an edge
};

/// Beginning of the tangent that continues the land: distance from the middle, relief and outward slope.
struct Tangent {
  double distance, relief, slope;
};

/// A land with a corner at both ends, which begins with the slope of the land.
struct Cornered {
  SharedRelief land;
  double half_length;
  Corner corner;
  Tangent low, high;
};

struct Relief {
  std::variant<Straight, Arcs, Logarithmic, Conical, TaperedEnds, UniformPressure, Tabulated, Sum, Moved, Cornered,
               Function>
      formula;

  /// Fill in the relief [mm] at places y [mm], infinite where there is no body.
  void fill(View y, Row h) const;
};

}  // namespace nonhertz
