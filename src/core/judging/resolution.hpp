// Departure of the relief from parabolas between the strip centres, which a solution does not include.
#pragma once

#include <numbers>

#include "numbers/array.hpp"

namespace nonhertz {

inline constexpr int WITHIN = 9;
/// The k-th of the places within a strip, from -1/2 to 1/2.
inline constexpr double within(int k) { return (k + 0.5) / WITHIN - 0.5; }

/// The departure of the separation at these places from a parabola, root mean square [mm]; zero where it is infinite.
double departure(View separation);

/// K q / a that flattens a departure, over departure / width: a wave of amplitude A, sqrt(2) times its root mean
/// square, requires a pressure of A / (K l), and q / a is pi / 2 times the pressure.
inline constexpr double RIPPLE = 0.5 * std::numbers::pi * std::numbers::sqrt2;

}  // namespace nonhertz
