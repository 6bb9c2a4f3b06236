#include "bodies/reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numbers/pack.hpp"

namespace nonhertz {
namespace {

// Widths over depths below which a strip's effect is integrated to 2e-11 by Gauss's rule of three points.
constexpr double NARROW = 0.06;
constexpr double MIDDLE_WEIGHT = 8.0 / 9.0, SIDE_WEIGHT = 5.0 / 9.0, SIDE = 0.7745966692414834;  // sqrt(0.6)

/// The displacement at depth 1 by a unit load at distance u.
double kernel(double u, double poisson_factor) {
  const double over = 1.0 / (1.0 + u * u);
  return std::sqrt(over) * (1.0 + poisson_factor * over);
}

/// The same for a load from far away up to u, up to a constant.
double kernel_until(double u, double poisson_factor) {
  const double root = std::sqrt(1.0 + u * u);
  return std::copysign(std::log(std::fabs(u) + root), u) + poisson_factor * u / root;
}

/// By Gauss's rule of three points, which is accurate enough for strips this narrow.
void fill_by_quadrature(const PointsAtDepth& of, double y, double depth, View edges, Row out) {
  const double inverse = 1.0 / depth, factor = of.poisson_factor;
  std::fill(out.begin(), out.end(), 0.0);
  for (const Term& term : of.terms) {
    const double offset = term.offset - y;
    for (std::size_t e = 0; e < out.size(); ++e) {
      const double half = 0.5 * (edges[e + 1] - edges[e]) * inverse;
      const double middle = (term.sign * 0.5 * (edges[e + 1] + edges[e]) + offset) * inverse;
      double total = MIDDLE_WEIGHT * kernel(middle, factor);
      total += SIDE_WEIGHT * kernel(middle - SIDE * half, factor);
      total += SIDE_WEIGHT * kernel(middle + SIDE * half, factor);
      out[e] += term.weight * half * total;
    }
  }
}

void fill_by_closed_form(const PointsAtDepth& of, double y, double depth, View edges, Row out) {
  const double inverse = 1.0 / depth;
  double before = 0.0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    double total = 0.0;
    for (const Term& term : of.terms) {
      const double u = (term.sign * edges[e] + (term.offset - y)) * inverse;
      total += term.sign * term.weight * kernel_until(u, of.poisson_factor);
    }
    if (e > 0) out[e - 1] = total - before;
    before = total;
  }
}

constexpr Index TILE = 4 * WIDTH;  // numbers processed at once: enough that no instruction waits for the previous one

/// Fill in a polynomial, highest power first, at places whose number is a multiple of the tile.
void fill_polynomial(View coefficients, View x, Row out) {
  for (Index first = 0; first < count_of(x); first += TILE) {
    Pack at[TILE / WIDTH], s[TILE / WIDTH] = {};
    for (int k = 0; k < TILE / WIDTH; ++k) at[k] = load(x.data() + first + WIDTH * k);
    for (double c : coefficients)
      for (int k = 0; k < TILE / WIDTH; ++k) s[k] = s[k] * at[k] + c;
    for (int k = 0; k < TILE / WIDTH; ++k) store(out.data() + first + WIDTH * k, s[k]);
  }
}

/// Fill in the correction for a free side face to the displacement at a depth below u by unit loads at v, distances
/// from the face.
void fill_by_face(double u, View v, double depth, const PointsAtDepth& of, Row aside, Row added) {
  const Index count = count_of(v);
  for (Index p = 0; p < count; ++p) {
    const double over = (u - v[p]) / std::max(u + v[p], std::numeric_limits<double>::min());
    aside[p] = 2.0 * over * over - 1.0;
  }
  fill_polynomial(of.over_image, aside, added);
  for (Index p = 0; p < count; ++p) {
    const double distance = u + v[p], moved = kernel(distance / depth, of.poisson_factor) / depth;
    added[p] *= distance > 0.0 ? moved : 0.0;
  }
}

/// Correction for free side faces, by Gauss's rule of three points on each strip.
void add_by_faces(const PointsAtDepth& of, View y, View depth, View edges, Matrix& out) {
  const Index strips = out.columns(), room = (3 * strips + TILE - 1) / TILE * TILE;
  Numbers v(room), share(room), aside(room), added(room);
  for (const auto& face : of.faces) {
    for (Index e = 0; e < strips; ++e) {
      const double half = 0.5 * (edges[e + 1] - edges[e]);
      const double middle = face.side * (face.place - 0.5 * (edges[e + 1] + edges[e]));
      for (int part = 0; part < 3; ++part) {
        v[3 * e + part] = std::max(middle + (part - 1) * SIDE * half, 0.0);
        share[3 * e + part] = face.weight * half * (part == 1 ? MIDDLE_WEIGHT : SIDE_WEIGHT);
      }
    }
    for (Index i = 0; i < out.rows(); ++i) {
      fill_by_face(std::max(face.side * (face.place - y[i]), 0.0), v, depth[i], of, aside, added);
      for (Index e = 0; e < strips; ++e)
        for (Index p = 3 * e; p < 3 * e + 3; ++p) out(i, e) += share[p] * added[p];
    }
  }
}

}  // namespace

double FarImages::less_depth(double depth, double poisson_factor) const {
  double total = 0.0;
  for (std::size_t k = 0; k < distance.size(); ++k) {
    const double square = distance[k] * distance[k] + depth * depth;
    total += (1.0 / distance[k] - (1.0 + poisson_factor * (depth * depth) / square) / std::sqrt(square)) * weight[k];
  }
  const double u = beyond / depth;
  const double rest = std::asinh(u) - std::log(2.0 * u) + poisson_factor * (u / std::hypot(1.0, u) - 1.0);
  return total + rest / length * weight.back();
}

Matrix PointsAtDepth::displacement(View y, View edges) const {
  Numbers below(y.size());
  fill(depth, y, below);
  Matrix out(count_of(y), count_of(edges) - 1);
  double widest = 0.0;
  for (Index e = 0; e < out.columns(); ++e) widest = std::max(widest, edges[e + 1] - edges[e]);
  for (Index i = 0; i < out.rows(); ++i) {
    const auto fill_row = widest < NARROW * below[i] ? fill_by_quadrature : fill_by_closed_form;
    fill_row(*this, y[i], below[i], edges, out[i]);
  }
  if (!faces.empty()) add_by_faces(*this, y, below, edges, out);
  if (!far) return out;
  double last = 0.0, less = 0.0;
  for (Index i = 0; i < out.rows(); ++i) {
    if (below[i] != last) last = below[i], less = far->less_depth(last, poisson_factor);
    for (Index e = 0; e < out.columns(); ++e) out(i, e) -= less * (edges[e + 1] - edges[e]);
  }
  return out;
}

Matrix AxisOfCylinder::displacement(View y, View edges) const {
  const double farthest = smooth->places.back();
  const double in_reach = smooth->at(farthest) - std::asinh(farthest);
  const auto until = [&](double s) {  // by a uniform load from 0 up to a distance
    const double size = std::fabs(s);
    const double integral =
        size < farthest ? smooth->at(size) - std::asinh(size) : in_reach - std::log(size / farthest);
    return s < 0.0 ? -integral : integral;
  };
  Numbers diameter(y.size());
  fill(depth, y, diameter);
  Matrix out(count_of(y), count_of(edges) - 1);
  std::fill(out.all().begin(), out.all().end(), 0.0);
  for (Index i = 0; i < out.rows(); ++i)
    for (const Term& term : terms) {
      const auto at = [&](Index e) { return until((term.sign * edges[e] + term.offset - y[i]) / (0.5 * diameter[i])); };
      double low = at(0);
      for (Index e = 0; e < out.columns(); ++e) {
        const double high = at(e + 1);
        out(i, e) -= term.sign * term.weight * (high - low);
        low = high;
      }
    }
  return out;
}

Matrix AxisOfRoller::displacement(View y, View edges) const {
  const auto in_radii = [this](View places) {
    Numbers scaled(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) scaled[i] = (places[i] - middle) / radius;
    return scaled;
  };
  Matrix out = whole->displacement(in_radii(y), in_radii(edges));
  for (double& value : out.all()) value = -share * value;
  return out;
}

Matrix displacement(const Reference& reference, View y, View edges) {
  return std::visit([&](const auto& of) { return of.displacement(y, edges); }, reference);
}

void add_by_width(const AxisOfRoller& of, View y, double ratio, Matrix& out) {
  for (Index i = 0; i < count_of(y); ++i) {
    const auto terms = of.whole->by_width(of.radius / ratio * of.whole->girth((y[i] - of.middle) / of.radius));
    for (Index k = 0; k < 4; ++k) out(k, i) += of.share * terms[k];
  }
}

}  // namespace nonhertz
