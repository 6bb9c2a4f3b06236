#include "subsurface/face_table.hpp"

#include <algorithm>
#include <array>

#include "numbers/legendre.hpp"

namespace nonhertz {
namespace {

/// The four cubic splines that are nonzero between a knot and the next, at x.
std::array<double, 4> cubic_splines(double x, const double* knot) {
  std::array<double, 4> splines{1.0};
  for (int degree = 1; degree <= 3; ++degree) {
    double carried = 0.0;
    for (int k = 0; k < degree; ++k) {
      const double right = knot[k + 1], left = knot[k + 1 - degree], share = splines[k] / (right - left);
      splines[k] = carried + (right - x) * share;
      carried = (x - left) * share;
    }
    splines[degree] = carried;
  }
  return splines;
}

}  // namespace

Matrix at_nodes(const LoadPanels& panels, View k, View edges, const Matrix& steps) {
  const Index count = count_of(panels.edges) - 1, nodes = count_of(panels.weights);
  const double last = panels.edges[count];
  Matrix loads(count_of(k), count * nodes), integrals(count, nodes);
  Numbers polynomials(nodes + 1), up_to(count);
  for (Index m = 0; m < count_of(k); ++m) {
    std::ranges::fill(integrals.all(), 0.0);
    std::ranges::fill(up_to, 0.0);
    double beyond_all = 0.0;
    for (Index i = 0; i < count_of(edges); ++i) {
      const double at = k[m] * edges[i], step = steps(m, i);
      if (at >= last) {
        beyond_all += step;
        continue;
      }
      const auto above = std::ranges::lower_bound(panels.edges, at);
      const Index panel = std::max<Index>(above - panels.edges.begin() - 1, 0);
      const double low = panels.edges[panel], high = panels.edges[panel + 1], half = 0.5 * (high - low) * step;
      legendre((2.0 * at - low - high) / (high - low), polynomials);
      // From the low end of the panel: (P_n+1 - P_n-1) / (2 n + 1).
      const Row of_panel = integrals[panel];
      of_panel[0] += half * (polynomials[1] + 1.0);
      for (Index n = 1; n < nodes; ++n)
        of_panel[n] += half * ((polynomials[n + 1] - polynomials[n - 1]) / (2.0 * n + 1.0));
      up_to[panel] += step;
    }
    double beyond = beyond_all;
    for (Index panel = count - 1; panel >= 0; --panel) {
      const double half = 0.5 * (panels.edges[panel + 1] - panels.edges[panel]);
      for (Index j = 0; j < nodes; ++j) {
        double sum = beyond * half * panels.weights[j];
        for (Index n = 0; n < nodes; ++n) sum += integrals(panel, n) * panels.to_nodes(n, j);
        loads(m, panel * nodes + j) = sum;
      }
      beyond += up_to[panel];
    }
  }
  return loads;
}

Matrix between_distances(View knots, View log_k, View log_r, const Matrix& coefficients) {
  const Index splines = count_of(knots) - 4, columns = coefficients.columns() / splines;
  const double first = knots[3], last = knots[splines];
  Matrix table(count_of(log_k) * count_of(log_r), columns);
  for (Index m = 0; m < count_of(log_k); ++m) {
    Index at = 3;
    for (Index r = 0; r < count_of(log_r); ++r) {
      const Row values = table[m * count_of(log_r) + r];
      std::ranges::fill(values, 0.0);
      const double x = std::max(log_k[m] + log_r[r], first);
      if (x > last) continue;
      while (at < splines - 1 && x >= knots[at + 1]) ++at;
      const std::array<double, 4> shares = cubic_splines(x, &knots[at]);
      for (int s = 0; s < 4; ++s) {
        const View of = coefficients[m].subspan((at - 3 + s) * columns, columns);
        for (Index c = 0; c < columns; ++c) values[c] += shares[s] * of[c];
      }
    }
  }
  return table;
}

}  // namespace nonhertz
