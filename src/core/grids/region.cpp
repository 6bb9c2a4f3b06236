#include "grids/region.hpp"

#include <algorithm>
#include <cmath>

#include "grids/springs.hpp"

namespace nonhertz {
namespace {

// In radii of curvature across the contact: resolution and extent of the search on infinite bodies.
constexpr double NEAREST_LOOK = 1e-9, FARTHEST_LOOK = 1e4;
constexpr int LOOKS = 130;

/// Edges of strips whose width grows in proportion to the distance from y = 0, within the bodies.
Numbers growing_edges(const Model& model) {
  const double radius = 1.0 / model.curvature(Numbers{0.0})[0];
  const double first = std::log10(NEAREST_LOOK), step = (std::log10(FARTHEST_LOOK) - first) / (LOOKS - 1);
  Numbers edges{0.0};
  for (int i = 0; i < LOOKS; ++i) {
    double distance = std::pow(10.0, static_cast<double>(i) * step + first);
    if (i == 0) distance = NEAREST_LOOK;
    if (i == LOOKS - 1) distance = FARTHEST_LOOK;
    edges.push_back(radius * distance);
    edges.push_back(-radius * distance);
  }
  return edges;
}

/// The places within an interval, ascending, and its ends if there are places beyond them.
Numbers clip(Numbers places, double low, double high) {
  for (double& y : places) y = std::min(std::max(y, low), high);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// Distance from y = 0 up to which the separation is finite, on places on one side: their end, or a wall.
double finite_up_to(const Model& model, const Numbers& beyond) {
  const Numbers h = model.separation(beyond);
  const auto wall = std::find_if(h.begin(), h.end(), [](double separation) { return !std::isfinite(separation); });
  if (wall == h.end()) return beyond.back();
  const std::size_t first = wall - h.begin();
  double inside = beyond[first > 0 ? first - 1 : 0], outside = beyond[first];
  for (int bisection = 0; bisection < 100; ++bisection) {
    const double middle = 0.5 * (inside + outside);
    (std::isfinite(model.separation(middle)) ? inside : outside) = middle;
  }
  return outside;
}

/// The interval around y = 0 on which the separation is finite, as if the bodies ended there.
Pair finite_part(const Model& model, const Numbers& edges) {
  Numbers below, above;
  for (double edge : edges) {
    if (edge <= 0.0) below.insert(below.begin(), edge);
    if (edge >= 0.0) above.push_back(edge);
  }
  return {finite_up_to(model, below), finite_up_to(model, above)};
}

}  // namespace

Pair bound_contact(const Model& model, const Prescription& prescribed) {
  double low = model.low(), high = model.high();
  if (std::isfinite(low) && std::isfinite(high)) return {low, high};
  Numbers edges = clip(growing_edges(model), low, high);
  if (prescribed.both()) {
    const Numbers h = model.separation(edges);
    if (!std::all_of(h.begin(), h.end(), [](double separation) { return std::isfinite(separation); })) {
      const auto [from, to] = finite_part(model, edges);
      if (from > edges.front()) low = from;
      if (to < edges.back()) high = to;
      edges = clip(std::move(edges), low, high);
      refuse_arm_outside(prescribed, low, high);
    }
  }
  const auto contact = spring_contact(springs(model, prescribed, edges));
  if (!contact && !prescribed.by_force[0]) refuse_no_contact(model, edges, prescribed, false);
  if (!contact) return finite_part(model, edges);
  const auto& [first, last] = *contact;
  if ((first == edges.front() && !std::isfinite(low)) || (last == edges.back() && !std::isfinite(high)))
    throw Refused(Refusal::no_end);
  const double reach = 0.5 * (last - first);
  return {std::max(low, first - reach), std::min(high, last + reach)};
}

std::shared_ptr<const Region> region_of(const Model& model, const Prescription& prescribed) {
  if (model.region()) return model.region();
  const auto [low, high] = bound_contact(model, prescribed);
  return model.region(low, high);
}

}  // namespace nonhertz
