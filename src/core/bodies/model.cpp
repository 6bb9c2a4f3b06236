#include "bodies/model.hpp"

#include <algorithm>
#include <cmath>

namespace nonhertz {
namespace {

constexpr double LEAST_KINK = 1e-7;  // rad

}  // namespace

Numbers uniform(double low, double high, Index count) {
  Numbers edges(count + 1);
  const double step = (high - low) / static_cast<double>(count);
  for (Index i = 0; i < count; ++i) edges[i] = static_cast<double>(i) * step + low;
  edges[count] = high;
  return edges;
}

Model::Model(Contact contact) : contact_(std::move(contact)) {
  if (std::isfinite(low()) && std::isfinite(high())) region_ = region(low(), high());
}

std::shared_ptr<const Region> Model::region(double low, double high) const {
  Numbers bends;
  for (double bend : contact_.bends)
    if (low < bend && bend < high) bends.push_back(bend);
  Samples even = sampled(low, high);
  const auto is_within = [low, high](double y) { return low < y && y < high; };
  const bool has_crests = std::any_of(contact_.crests.begin(), contact_.crests.end(), is_within);
  Samples all = has_crests ? surveyed(low, high) : even;
  return std::make_shared<const Region>(
      Region{low, high, std::move(even), std::move(all), kinks_among(bends, high - low)});
}

Numbers Model::separation(View y) const {
  Numbers h(y.size());
  for (const Body& body : contact_.bodies) body.relief.add_to(y, h);
  return h;
}

double Model::separation(double y) const { return separation(View(&y, 1))[0]; }

double Model::min_depth() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Reference& reference : contact_.references) least = std::min(least, depth_of(reference));
  return least;
}

Matrix Model::at_depth(View y, View edges) const {
  Matrix found;
  if (contact_.references.empty()) return found;
  found.resize(count_of(y), count_of(edges) - 1);
  std::fill(found.all().begin(), found.all().end(), 0.0);
  for (const Reference& reference : contact_.references) add_displacement(reference, y, edges, found);
  return found;
}

std::shared_ptr<const Grid> Model::grid(Numbers edges) const {
  auto grid = springs(std::move(edges));
  grid->at_depth = at_depth(grid->y, grid->edges);
  return grid;
}

std::shared_ptr<Grid> Model::springs(Numbers edges) const {
  auto grid = std::make_shared<Grid>();
  const Index n = count_of(edges) - 1;
  grid->y.resize(n);
  for (Index i = 0; i < n; ++i) grid->y[i] = 0.5 * (edges[i + 1] + edges[i]);
  grid->separation = separation(grid->y);
  const auto& [a, b] = contact_.bodies;
  grid->curvature.assign(n, a.curvature + b.curvature);
  grid->sharper.assign(n, std::max(std::fabs(a.curvature), std::fabs(b.curvature)));
  grid->min_depth.assign(n, min_depth());
  grid->edges = std::move(edges);
  return grid;
}

Samples Model::sampled(double low, double high) const {
  Samples found{uniform(low, high, SAMPLES), {}};
  found.h = separation(found.y);
  return found;
}

Samples Model::surveyed(double low, double high) const {
  Samples found{uniform(low, high, SAMPLES), {}};
  for (double crest : contact_.crests)
    if (low < crest && crest < high) found.y.push_back(crest);
  std::sort(found.y.begin(), found.y.end());
  found.y.erase(std::unique(found.y.begin(), found.y.end()), found.y.end());
  found.h = separation(found.y);
  return found;
}

Kinks Model::kinks_among(View bends, double length) const {
  Kinks found;
  const auto turn = [this](double place, double step) {
    const Numbers h = separation(Numbers{place - step, place, place + step});
    return std::fabs(h[2] - 2.0 * h[1] + h[0]) / step;
  };
  // Where only the curvature jumps, the slope change shrinks in proportion to the step; at a kink it does not.
  const double step = 1e-5 * length;
  for (double place : bends) {
    const double wide = turn(place, step), narrow = turn(place, 0.1 * step);
    if (!(narrow > 0.5 * wide && narrow > LEAST_KINK)) continue;
    found.place.push_back(place);
    found.turn.push_back(narrow);
  }
  return found;
}

}  // namespace nonhertz
