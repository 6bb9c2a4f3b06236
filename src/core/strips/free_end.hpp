// Correction for a side face free of normal stress to the displacement and curvature of strips and their images.
//
// All functions are read from one table, which Python makes once for a Poisson's ratio: polynomials on squares that
// double in size away from the face, then series in 1/a^2 (docs/explain/side-faces.md).
#pragma once

#include <array>

#include "strips/element.hpp"

namespace nonhertz {

inline constexpr int FIRST_OCTAVE = -14, LAST_OCTAVE = 2, OCTAVES = LAST_OCTAVE - FIRST_OCTAVE;
inline constexpr int SQUARE_DEGREE = 9;
inline constexpr double AWAY = 4.0;  // half-widths: from there on the series hold

/// The polynomials in u of one place, which the next place along the same strip often shares.
struct Square {
  const double* of = nullptr;  ///< its position in the table of a face
  double v = 0.0;
  std::array<Four, SQUARE_DEGREE + 1> polynomials;
};

/// The polynomials at both edges of a strip.
using Squares = std::array<Square, 2>;

/// Return the correction to [A], [t A'], [B] and [t B'] of a strip.
///
/// u, inner, outer: distances of the place and of both edges of the strip from the face, in half-widths, not negative;
/// table: that of the face; element: the table of the element.
Four free_end(double u, double inner, double outer, const double* table, const double* element, Squares& cache);

/// Places whose polynomials are evaluated at a time: enough that no instruction waits for the previous one.
inline constexpr int TILE = 16;

/// The terms of the far series, integrated over the loads up to v, or for u < v over those beyond, with a minus sign.
///
/// u ascends or descends; terms has 1 + POWERS rows, the k-th with the unit length^-2k, work has two; all have TILE
/// columns more than places.
void far_terms(View u, double v, const double* table, Matrix& terms, Matrix& work);

/// Difference between the two ways of integration in `far_terms`: to be added if v = u is within a strip.
double far_whole(double u, int k, const double* table);

}  // namespace nonhertz
