#include "judging/resolution.hpp"

#include <cmath>

namespace nonhertz {
namespace {

/// The parabolas within a strip, as three orthonormal rows over the places: numpy.linalg.qr(numpy.vander(places, 3)).
constexpr double PARABOLAS[3][WITHIN] = {
    {-0.6013168224022631, -0.3382407126012731, -0.15032920560056579, -0.037582301400141446, -0.0, -0.03758230140014148,
     -0.15032920560056579, -0.3382407126012731, -0.6013168224022631},
    {-0.5163977794943223, -0.3872983346207416, -0.2581988897471611, -0.12909944487358055, 0.0, 0.12909944487358063,
     0.2581988897471611, 0.3872983346207417, 0.5163977794943222},
    {0.17988183075407896, -0.11992122050271924, -0.3340662571147181, -0.4625532790819175, -0.5053822864043173,
     -0.4625532790819174, -0.33406625711471827, -0.11992122050271926, 0.17988183075407907}};

}  // namespace

double departure(View separation) {
  for (double h : separation)
    if (!std::isfinite(h)) return 0.0;
  double share[3] = {};
  for (int k = 0; k < WITHIN; ++k)
    for (int row = 0; row < 3; ++row) share[row] += separation[k] * PARABOLAS[row][k];
  double total = 0.0;
  for (int k = 0; k < WITHIN; ++k) {
    const double of_parabola = share[0] * PARABOLAS[0][k] + share[1] * PARABOLAS[1][k] + share[2] * PARABOLAS[2][k];
    total += (separation[k] - of_parabola) * (separation[k] - of_parabola);
  }
  return std::sqrt(total / WITHIN);
}

}  // namespace nonhertz
