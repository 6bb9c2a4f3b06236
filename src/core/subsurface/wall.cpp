#include "subsurface/wall.hpp"

#include <algorithm>

#include "subsurface/tails.hpp"

namespace nonhertz {
namespace {

/// Chebyshev's polynomials at x.
void polynomials(double x, Numbers& out) {
  out[0] = 1.0;
  out[1] = x;
  for (std::size_t k = 2; k < out.size(); ++k) out[k] = 2.0 * x * out[k - 1] - out[k - 2];
}

/// The stress of point loads on a half-space, seen from the opposite side.
Six<double> opposite(const Wall& wall, double poisson, double x, double y, double z) {
  const double lateral = 1.0 - 2.0 * poisson;
  Six<double> stress{};
  for (std::size_t k = 0; k < wall.places.size(); ++k) {
    const double Y = y - wall.places[k], force = wall.forces[k] / TWO_PI;
    const double R = std::sqrt(x * x + Y * Y + z * z), cube = R * R * R, fifth = 3.0 * z / (cube * R * R);
    const double g = 1.0 / (R * (R + z)), w = (2.0 * R + z) / (cube * (R + z) * (R + z));
    stress[0] += force * (lateral * (g - w * Y * Y) - fifth * x * x);
    stress[1] += force * (lateral * (g - w * x * x) - fifth * Y * Y);
    stress[2] -= force * fifth * z * z;
    stress[3] += force * fifth * Y * z;
    stress[4] -= force * fifth * x * z;
    stress[5] -= force * (lateral * w - fifth) * x * Y;
  }
  return stress;
}

/// The polar stress of all modes: rr, tt, yy, rt, ry, ty.
Six<double> bending_stress(const Wall& wall, double theta, const Numbers& by_radius, const Numbers& by_place) {
  Six<double> stress{};
  const double* mode = wall.modes.data();
  for (Index n = 0; n < wall.waves; ++n) {
    const double cosine = std::cos(2.0 * n * theta), sine = std::sin(2.0 * n * theta);
    for (int c = 0; c < 6; ++c) {
      double amplitude = 0.0;
      for (Index p = 0; p < wall.through; ++p)
        for (Index q = 0; q < wall.along; ++q) amplitude += by_radius[p] * by_place[q] * *mode++;
      stress[c] += amplitude * (c == 3 || c == 5 ? sine : cosine);
    }
  }
  return stress;
}

}  // namespace

void add_wall(const Wall& wall, double poisson, View points, View along, View outer, View inner, Row out) {
  Numbers by_radius(wall.through), by_place(wall.along);
  for (Index i = 0; i < count_of(points) / 3; ++i) {
    const double x = points[3 * i], y = points[3 * i + 1], deep = points[3 * i + 2];
    double* total = out.data() + 6 * i;
    const Six<double> of_loads = opposite(wall, poisson, -x, y, 2.0 * outer[i] - deep);
    for (int c = 0; c < 6; ++c) total[c] += of_loads[c];
    const double z = outer[i] - deep;
    const double share = std::min((std::sqrt(x * x + z * z) - inner[i]) / (outer[i] - inner[i]), 1.0);
    polynomials(2.0 * share / wall.top - 1.0, by_radius);
    polynomials(along[i], by_place);
    const double theta = std::atan2(x, z), cosine = std::cos(theta), sine = std::sin(theta);
    const auto [rr, tt, yy, rt, ry, ty] = bending_stress(wall, theta, by_radius, by_place);
    total[0] += rr * sine * sine + tt * cosine * cosine + 2.0 * rt * sine * cosine;
    total[1] += yy;
    total[2] += rr * cosine * cosine + tt * sine * sine - 2.0 * rt * sine * cosine;
    total[3] += ty * sine - ry * cosine;
    total[4] += (tt - rr) * sine * cosine + rt * (sine * sine - cosine * cosine);
    total[5] += ry * sine + ty * cosine;
  }
}

void add_from_afar(double low, double high, double line_load, double poisson, View points, Row out) {
  const double scale = line_load / TWO_PI;
  for (Index i = 0; i < count_of(points) / 3; ++i) {
    const double x = points[3 * i], y = points[3 * i + 1], z = points[3 * i + 2];
    const Six<double> f = stress_tail(x, high - y, z, poisson), g = stress_tail(x, y - low, z, poisson);
    double* total = out.data() + 6 * i;
    for (int c : {0, 1, 2, 4}) total[c] += scale * (f[c] + g[c]);
    for (int c : {3, 5}) total[c] += scale * (f[c] - g[c]);
  }
}

}  // namespace nonhertz
