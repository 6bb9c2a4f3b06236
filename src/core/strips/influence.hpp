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

/// The influence of the strips of one grid on one another.
///
/// The far field of a strip is a short series in m: all its terms, including hundreds of images, are added up once, and
/// remain valid until the strip exceeds a width, or is so narrow that an update pays (`keep_up`).
class Influence {
 public:
  Influence(const Grid& grid, const Kernel& kernel);

  /// Update the far field of strips whose widths have left its range.
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
  std::vector<Range> near_;  // for each term and face, and source: the places in the near field
  Matrix powers_;            // for each source: the logarithm of far edge over near edge, and differences of 1 / y'^2k
  Numbers limits_;           // largest m for which this is valid, 0 if not computed
  std::vector<char> stale_;  // strips to be updated
  std::vector<Four> seen_;   // effect of one source on all places
  Numbers distance_, away_;  // work arrays
  Squares squares_;
};

/// Correction for a free side face to [A], [t A'], [B] and [t B'] at y of a strip with 1/a = inverse.
Four face_influence(double y, double low, double high, double inverse, const Face& face, const Element& element,
                    Squares& cache);

/// Displacement on the surface at any places, per unit of compliance, without points at depth.
Numbers surface_displacement(View places, const Grid& grid, const State& state, const Kernel& kernel);

/// Effect of its half-width a on [A] of a strip on itself, C0 + C1 a + (C2 ln a + C3) a^2, and a times the derivative.
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
