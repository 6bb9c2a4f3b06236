#include "bodies/whole_roller.hpp"

#include <algorithm>
#include <cmath>

#include "numbers/legendre.hpp"

namespace nonhertz {
namespace {

constexpr double USUAL_WIDTH = 0.03;  // of a contact, half-width over radius, where it is not known
constexpr double FARTHEST = 25.0;     // radii, of the table
constexpr double NEAR = 0.2;          // radii; beyond, cubic polynomials also represent its logarithm, within 1e-9

/// The integral of the curved part from 0 to a distance: an odd function, by cubic polynomials.
double curved_within(double distance, const Matrix& table, double logarithm) {
  const double s = std::min(std::fabs(distance), FARTHEST), step = FARTHEST / static_cast<double>(table.rows() - 1);
  const Index at = std::min(static_cast<Index>(s / step), table.rows() - 2), kind = s < NEAR ? 0 : 2;
  const double x = s / step - static_cast<double>(at);
  const double start = table(at, kind), change = table(at + 1, kind) - start;
  const double first = step * table(at, kind + 1) - change, second = step * table(at + 1, kind + 1) - change;
  double integral = start + x * (change + (1.0 - x) * ((1.0 - x) * first - x * second));
  if (0.0 < s && s < NEAR) integral += logarithm * s * std::log(s);
  return std::copysign(integral, distance);
}

/// The curved part at y of loads up to an edge, and of their images, up to a constant.
double curved_until(double edge, double y, double radius, const WholeRoller& of) {
  const double twice = 2.0 * of.half_length();
  const auto within = [&](double s) { return curved_within(s / radius, *of.curved, of.logarithm); };
  return within(edge - y) - within(twice - edge - y) + within(edge + y + twice);
}

/// Projections of unit loads from the middle up to each edge (columns) on normalised polynomials (rows).
Matrix polynomials_of(View edges, double half_length, Index count) {
  Matrix projections(count, count_of(edges));
  Numbers values(count + 1);
  for (Index e = 0; e < count_of(edges); ++e) {
    legendre(std::clamp(edges[e] / half_length, -1.0, 1.0), values);
    // The integral of P_j is (P_(j+1) - P_(j-1)) / (2 j + 1).
    for (Index j = 0; j < count; ++j) {
      const double order = static_cast<double>(j);
      const double integral = j == 0 ? values[1] : (values[j + 1] - values[j - 1]) / (2.0 * order + 1.0);
      projections(j, e) = integral * std::sqrt((order + 0.5) * half_length);
    }
  }
  return projections;
}

/// Fill in the smooth part.
void fill_smooth(const WholeRoller& of, View y, View edges, Matrix& out) {
  const Matrix& matrix = *of.smooth;
  const Index count = matrix.rows(), strips = count_of(edges) - 1;
  const double half_length = of.half_length();
  const Matrix of_edges = polynomials_of(edges, half_length, count);
  Numbers values(count + 1), moved(count), until(edges.size());
  for (Index i = 0; i < count_of(y); ++i) {
    legendre(std::clamp(y[i] / half_length, -1.0, 1.0), values);
    std::fill(moved.begin(), moved.end(), 0.0);
    for (Index j = 0; j < count; ++j) {
      const double at = values[j] * std::sqrt((static_cast<double>(j) + 0.5) / half_length);
      for (Index k = 0; k < count; ++k) moved[k] += at * matrix(j, k);
    }
    std::fill(until.begin(), until.end(), 0.0);
    for (Index k = 0; k < count; ++k)
      for (Index e = 0; e <= strips; ++e) until[e] += moved[k] * of_edges(k, e);
    for (Index e = 0; e < strips; ++e) out(i, e) = until[e + 1] - until[e];
  }
}

}  // namespace

double WholeRoller::girth(double z) const {
  const View places = outer.places;
  const Index before = std::lower_bound(places.begin(), places.end(), z) - places.begin() - 1;
  const Index at = std::clamp(before, Index{0}, count_of(places) - 2);
  const double slope = (outer.values[at + 1] - outer.values[at]) / (places[at + 1] - places[at]);
  return outer.at(z) * (1.0 / std::hypot(1.0, slope));
}

std::array<double, 4> WholeRoller::by_width(double radius) const {
  const double linear = 4.0 / 3.0 * beta, square = 1.0 / 48.0 - 0.5 * std::log(2.0);
  const double usual = USUAL_WIDTH * (linear + USUAL_WIDTH * (0.25 * std::log(USUAL_WIDTH) + square));
  const double area = radius * radius;
  return {-usual, linear / radius, 0.25 / area, (square - 0.25 * std::log(radius)) / area};
}

Matrix WholeRoller::displacement(View y, View edges) const {
  const Index strips = count_of(edges) - 1;
  Matrix out(count_of(y), strips);
  fill_smooth(*this, y, edges, out);
  const double own = -by_width(1.0)[0];
  Numbers girths(strips);
  for (Index e = 0; e < strips; ++e) girths[e] = girth(0.5 * (edges[e + 1] + edges[e]));
  for (Index i = 0; i < count_of(y); ++i) {
    const double place = y[i], girth_here = girth(place);
    double radius = 0.0, low = 0.0;
    for (Index e = 0; e < strips; ++e) {
      // Waves around scale with the local radius of the surface.
      const double between = std::sqrt(girth_here * girths[e]);
      if (between != radius) {
        radius = between;
        low = curved_until(edges[e], place, radius, *this);
      }
      const double high = curved_until(edges[e + 1], place, radius, *this);
      out(i, e) += high - low;
      low = high;
      if ((edges[e] <= place && place < edges[e + 1]) || (e == strips - 1 && place == edges[e + 1])) out(i, e) += own;
    }
  }
  return out;
}

}  // namespace nonhertz
