#include "bodies/reference.hpp"

#include <algorithm>

namespace nonhertz {
namespace {

// Widths over depths below which a strip's effect is integrated to 2e-11 by Gauss's rule of three points.
constexpr double NARROW = 0.06;
constexpr double GAUSS_WEIGHTS[] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0}, GAUSS_SIDE = 0.774596669241483377;

/// The displacement at depth 1 by a unit load at distance u.
double kernel(double u, double poisson_factor) {
  const double over = 1.0 / (1.0 + u * u);
  return std::sqrt(over) * (1.0 + poisson_factor * over);
}

/// The same by a load from far away up to u, to a constant.
double kernel_until(double u, double poisson_factor) {
  const double root = std::sqrt(1.0 + u * u);
  return std::copysign(std::log(std::fabs(u) + root), u) + poisson_factor * u / root;
}

double polynomial(View coefficients, double x) {
  double s = 0.0;
  for (double c : coefficients) s = s * x + c;
  return s;
}

void add(const PointsAtDepth& of, View y, View edges, Matrix& out) {
  const Index strips = count_of(edges) - 1;
  const double inverse = 1.0 / of.depth;
  double widest = 0.0;
  for (Index e = 0; e < strips; ++e) widest = std::max(widest, edges[e + 1] - edges[e]);
  const bool narrow = widest < NARROW * of.depth;
  for (Index i = 0; i < count_of(y); ++i)
    for (const Term& term : of.terms) {
      const double offset = term.offset - y[i];
      double before = 0.0;
      for (Index e = 0; e <= strips; ++e) {
        if (narrow && e < strips) {
          const double half = 0.5 * (edges[e + 1] - edges[e]) * inverse;
          const double middle = (term.sign * 0.5 * (edges[e + 1] + edges[e]) + offset) * inverse;
          double total = 0.0;
          for (int part = 0; part < 3; ++part)
            total += GAUSS_WEIGHTS[part] * kernel(middle + (part - 1) * GAUSS_SIDE * half, of.poisson_factor);
          out(i, e) += term.weight * half * total;
        } else if (!narrow) {
          const double until = kernel_until((term.sign * edges[e] + offset) * inverse, of.poisson_factor);
          if (e > 0) out(i, e - 1) += term.sign * term.weight * (until - before);
          before = until;
        }
      }
    }
  for (const auto& face : of.faces)
    for (Index i = 0; i < count_of(y); ++i) {
      const double u = std::max(face.side * (face.place - y[i]), 0.0);
      for (Index e = 0; e < strips; ++e) {
        const double half = 0.5 * (edges[e + 1] - edges[e]);
        const double middle = face.side * (face.place - 0.5 * (edges[e + 1] + edges[e]));
        for (int part = 0; part < 3; ++part) {
          const double v = std::max(middle + (part - 1) * GAUSS_SIDE * half, 0.0), distance = u + v;
          if (!(distance > 0.0)) continue;
          const double aside = (u - v) / distance, over = polynomial(of.over_image, 2.0 * aside * aside - 1.0);
          out(i, e) += face.weight * half * GAUSS_WEIGHTS[part] * over *
                       (kernel(distance * inverse, of.poisson_factor) * inverse);
        }
      }
    }
}

/// Legendre polynomials at x, brought to between -1 and 1.
void legendre(double x, Row out) {
  x = std::min(std::max(x, -1.0), 1.0);
  out[0] = 1.0, out[1] = x;
  for (Index j = 1; j + 1 < count_of(out); ++j)
    out[j + 1] = ((2.0 * j + 1.0) * x * out[j] - j * out[j - 1]) / (j + 1.0);
}

/// The integral of the curved part from 0 to a distance: an odd function, by cubic polynomials.
double curved_within(double distance, const AxisOfRoller& of) {
  constexpr double FARTHEST = 25.0, NEAR = 0.2;  // radii; beyond NEAR polynomials follow the logarithm, too
  const Matrix& table = *of.curved;
  const Index places = table.rows();
  const double s = std::min(std::fabs(distance), FARTHEST), step = FARTHEST / (places - 1);
  const Index at = std::min(static_cast<Index>(s / step), places - 2), kind = s < NEAR ? 0 : 2;
  const double x = s / step - at;
  const double start = table(at, kind), change = table(at + 1, kind) - start;
  const double first = step * table(at, kind + 1) - change, second = step * table(at + 1, kind + 1) - change;
  double found = start + x * (change + (1.0 - x) * ((1.0 - x) * first - x * second));
  if (0.0 < s && s < NEAR) found += of.logarithm * s * std::log(s);
  return std::copysign(found, distance);
}

/// The curved part at y of loads up to an edge, from any place on, and of their images.
double curved_until(double edge, double y, const AxisOfRoller& of) {
  return curved_within(edge - y, of) - curved_within(2.0 * of.half_length - edge - y, of) +
         curved_within(edge + y + 2.0 * of.half_length, of);
}

void add(const AxisOfRoller& of, View y, View edges, Matrix& out) {
  const Matrix& matrix = *of.matrix;
  const Index strips = count_of(edges) - 1, count = matrix.rows();
  Numbers values(count + 1), at(count), moved(count), ends(edges.size());
  Matrix of_edges(count_of(edges), count);
  for (Index e = 0; e <= strips; ++e) {
    ends[e] = (edges[e] - of.middle) / of.radius;
    legendre(ends[e] / of.half_length, values);
    // The integral of P_j is (P_(j+1) - P_(j-1)) / (2 j + 1).
    for (Index j = 0; j < count; ++j) {
      const double integral = j == 0 ? values[1] : (values[j + 1] - values[j - 1]) / (2.0 * j + 1.0);
      of_edges(e, j) = integral * std::sqrt((j + 0.5) * of.half_length);
    }
  }
  for (Index i = 0; i < count_of(y); ++i) {
    const double place = (y[i] - of.middle) / of.radius;
    legendre(place / of.half_length, values);
    std::fill(moved.begin(), moved.end(), 0.0);
    for (Index j = 0; j < count; ++j) at[j] = values[j] * std::sqrt((j + 0.5) / of.half_length);
    for (Index j = 0; j < count; ++j)
      for (Index k = 0; k < count; ++k) moved[k] += at[j] * matrix(j, k);
    double before = 0.0, curved_before = 0.0;
    for (Index e = 0; e <= strips; ++e) {
      double smooth = 0.0;
      for (Index k = 0; k < count; ++k) smooth += moved[k] * of_edges(e, k);
      const double curved = curved_until(ends[e], place, of);
      if (e > 0) {
        const bool within = (ends[e - 1] <= place && place < ends[e]) || (e == strips && place == ends[e]);
        out(i, e - 1) -= of.share * (smooth - before + (curved - curved_before) + (within ? of.own : 0.0));
      }
      before = smooth, curved_before = curved;
    }
  }
}

}  // namespace

double depth_of(const Reference& reference) {
  if (const auto* points = std::get_if<PointsAtDepth>(&reference)) return points->depth;
  return 2.0 * std::get<AxisOfRoller>(reference).radius;
}

void add_displacement(const Reference& reference, View y, View edges, Matrix& out) {
  std::visit([&](const auto& of) { add(of, y, edges, out); }, reference);
}

}  // namespace nonhertz
