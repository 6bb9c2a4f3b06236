#include "strips/face_density.hpp"

namespace nonhertz {

void face_densities(const Element& element, const FaceWeights& face, View u, View v, Row h, Row c) {
  const Index images = count_of(face.distances), degrees = face.weights.rows(), width = face.weights.columns();
  Numbers weight(width);
  for (Index i = 0; i < count_of(u); ++i) {
    const double both = u[i] + v[i], aside = (u[i] - v[i]) / both, x = 2.0 * aside * aside - 1.0;
    std::fill(weight.begin(), weight.end(), 0.0);
    double basis = 1.0, next = x;
    for (Index k = 0; k < degrees; ++k) {
      const double* of_degree = face.weights[k].data();
      for (Index j = 0; j < width; ++j) weight[j] += basis * of_degree[j];
      const double after = 2.0 * x * next - basis;
      basis = next, next = after;
    }
    h[i] = c[i] = 0.0;
    for (Index j = 0; j < images; ++j) {
      const double t = both * face.distances[j];
      const Four s = evaluate(t, element.table.data());
      const auto [smoothed, curved] = element.smoothed(t);
      h[i] += weight[j] * (s.ta() / t) + weight[images + j] * smoothed;
      c[i] += weight[j] * (s.tb() / t) + weight[images + j] * curved;
    }
  }
}

}  // namespace nonhertz
