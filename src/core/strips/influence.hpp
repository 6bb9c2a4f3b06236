// From strip loads to displacement and curvature on the centre line, per unit of compliance.
#pragma once

#include <array>
#include <vector>

#include "strips/free_end.hpp"
#include "strips/kernel.hpp"
#include "strips/strips.hpp"

namespace nonhertz {

/// [A], [t A'], [B] and [t B'] of some strips (columns) at the centres of all (rows).
using Blocks = std::array<Matrix, 4>;

/// How the strips of one grid act on one another.
///
/// What a strip does far away needs a short series in m only: all its terms, hundreds of images among them, are added
/// up once, and serve for as long as the strip is not wider than it may become, nor so narrow that it pays (`keep_up`).
class Influence {
 public:
  Influence(const Grid& grid, const Kernel& kernel);

  /// Work out what those strips do far away that have left the widths for which it was.
  void keep_up(View m);
  /// Fill in the coefficients of the strips `active`.
  void coefficients(View m, const std::vector<Index>& active, Blocks& out);
  /// Fill in the displacement at all centres under loads K q.
  void lift(View m, View q, Row out);

 private:
  struct Range {
    Index begin, end;
  };
  Row power(Index source, int k) { return powers_[source * (1 + POWERS) + k]; }
  Range& near(Index term, Index source) { return near_[term * n_ + source]; }
  void add_far_term(const Term& term, Index at);
  void add_beyond_face(const Face& face, Index at);
  void seen_from(Index source, double m);

  const Grid& grid_;
  const Kernel& kernel_;
  Index n_;
  std::vector<Range> near_;  // of each term and face, and source: the places that are not far
  Matrix powers_;            // of each source: the logarithm of far edge over near, and differences of 1 / y'^2k
  Numbers limits_;           // largest m for which this holds, 0 where nothing is known
  std::vector<char> stale_;  // which strips have to be worked out again
  std::vector<Four> seen_;   // what one source does at all places
  Numbers distance_, away_;  // room to work in
  Squares squares_;
};

/// What a free side face adds to [A], [t A'], [B] and [t B'] at y of a strip with 1/a = inverse.
Four added_by_face(double y, double low, double high, double inverse, const Face& face, const Element& element,
                   Squares& kept);

/// Displacement on the surface at any places, per unit of compliance, points at depth left out.
Numbers on_the_surface(View places, const Grid& grid, const State& state, const Kernel& kernel);

/// What its half-width a changes in [A] of a strip on itself, C0 + C1 a + (C2 ln a + C3) a^2, and a times the
/// derivative.
inline Pair by_own_width(const Matrix& by_width, Index strip, double a) {
  if (by_width.empty() || by_width(2, strip) == 0.0) return {};
  const double logarithmic = by_width(2, strip), linear = by_width(1, strip);
  const double square = logarithmic * std::log(a) + by_width(3, strip);
  return {by_width(0, strip) + a * (linear + a * square), a * (linear + a * (2.0 * square + logarithmic))};
}

/// [A] of a strip at its own centre and d(m [A])/dm.
inline Pair self_displacement(double width, double m, const double* table) {
  const Four s = evaluate(0.5 * width / std::sqrt(m), table);
  return {2.0 * s.a(), 2.0 * s.a() - s.ta()};
}

}  // namespace nonhertz
