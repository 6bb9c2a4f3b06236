// Penetration of the undeformed bodies: the approach beyond first touch at the tilt of the solution.
#include <algorithm>
#include <cmath>

#include "judging/judgement.hpp"

namespace nonhertz {

/// Exact if it is deepest at an edge, a centre or a crest; elsewhere a parabola through three of them gives the place,
/// and the separation there the depth, so that an error of the place has only a second-order effect.
double penetration_of(const Model& model, View edges, const Pair& rigid) {
  Numbers y(edges.begin(), edges.end());
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) y.push_back(0.5 * (edges[i + 1] + edges[i]));
  for (double crest : model.contact().crests)
    if (edges.front() < crest && crest < edges.back()) y.push_back(crest);
  std::sort(y.begin(), y.end());
  y.erase(std::unique(y.begin(), y.end()), y.end());
  Numbers depth = model.separation(y);
  for (std::size_t i = 0; i < y.size(); ++i) depth[i] = rigid[0] + rigid[1] * y[i] - depth[i];
  const Index at = std::max_element(depth.begin(), depth.end()) - depth.begin();
  const Index middle = std::clamp(at, Index{1}, count_of(y) - 2);
  const double to_left = y[middle] - y[middle - 1], to_right = y[middle + 1] - y[middle];
  const double left = (depth[middle] - depth[middle - 1]) / to_left;
  const double right = (depth[middle + 1] - depth[middle]) / to_right;
  const double vertex = y[middle] + (left * to_right + right * to_left) / (2.0 * (left - right));
  // Infinite relief, or a straight line, has no vertex.
  const double place = std::clamp(std::isfinite(vertex) ? vertex : y[middle], y[middle - 1], y[middle + 1]);
  return std::max(depth[at], rigid[0] + rigid[1] * place - model.separation(place));
}

}  // namespace nonhertz
