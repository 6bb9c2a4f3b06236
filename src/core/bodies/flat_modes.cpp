#include "bodies/flat_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nonhertz {

double LogarithmicTable::at(double logarithm) const {
  const double place = (logarithm - first) / step;
  if (place <= 0.0) return pieces(0, 3) + pieces(0, 2) * (logarithm - first);
  const Index piece = std::min(static_cast<Index>(place), pieces.rows() - 1);
  const double x = std::min(place, static_cast<double>(pieces.rows())) * step - static_cast<double>(piece) * step;
  const View c = pieces[piece];
  return ((c[0] * x + c[1]) * x + c[2]) * x + c[3];
}

Matrix effect_of(const FlatModes& flat, View places, const Matrix& points, const Matrix& radius) {
  constexpr double TINY = std::numeric_limits<double>::min();
  const Index degrees = flat.weights.rows(), count = count_of(flat.distances);
  Numbers away(flat.distances), added(2 * count);
  for (double& distance : away) distance = std::log(distance);
  Matrix out(points.rows(), points.columns());
  for (Index i = 0; i < points.rows(); ++i)
    for (Index j = 0; j < points.columns(); ++j) {
      const double y = places[i], point = points(i, j), scale = std::log(radius(i, j));
      const double direct = std::log(std::max(std::fabs(point - y), TINY)) - scale;
      double total = flat.loads.at(direct) - flat.curved.at(direct);
      for (int side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1.0 : -1.0;
        const double u = flat.half_length - sign * y, v = std::max(flat.half_length - sign * point, TINY);
        const double image = std::log(u + v) - scale, aside = (u - v) / (u + v);
        total += flat.image[side] * flat.loads.at(image) - flat.curved.at(image);
        std::fill(added.begin(), added.end(), 0.0);
        const double x = 2.0 * aside * aside - 1.0;
        double before = x, polynomial = 1.0;  // as if from the polynomial of degree -1, which is that of degree 1
        for (Index k = 0; k < degrees; ++k) {
          const double* row = flat.weights[k].data();
          for (Index m = 0; m < 2 * count; ++m) added[m] += polynomial * row[m];
          const double next = 2.0 * x * polynomial - before;
          before = polynomial, polynomial = next;
        }
        double by_face = 0.0;
        for (Index m = 0; m < count; ++m)
          by_face += added[m] * flat.loads.at(image + away[m]) + added[count + m] * flat.planes.at(image + away[m]);
        total += flat.face[side] * by_face;
      }
      out(i, j) = total;
    }
  return out;
}

}  // namespace nonhertz
