#include "bodies/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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
  const auto& [a, b] = contact_.bodies;
  Numbers h(y.size()), other(y.size());
  a.relief->fill(y, h);
  b.relief->fill(y, other);
  for (std::size_t i = 0; i < y.size(); ++i) h[i] += other[i];
  return h;
}

double Model::separation(double y) const { return separation(View(&y, 1))[0]; }

std::array<Numbers, 2> Model::curvatures(View y) const {
  std::array found{Numbers(y.size()), Numbers(y.size())};
  for (int k = 0; k < 2; ++k) fill(contact_.bodies[k].curvature, y, found[k]);
  return found;
}

Numbers Model::curvature(View y) const {
  auto [combined, other] = curvatures(y);
  for (std::size_t i = 0; i < y.size(); ++i) combined[i] += other[i];
  if (std::any_of(combined.begin(), combined.end(), [](double curvature) { return curvature <= 0.0; }))
    contact_.refuse(y, combined);
  return combined;
}

Numbers Model::sharper_curvature(View y) const {
  auto [sharper, other] = curvatures(y);
  for (std::size_t i = 0; i < y.size(); ++i) sharper[i] = std::max(std::fabs(sharper[i]), std::fabs(other[i]));
  return sharper;
}

Numbers Model::min_depth(View y) const {
  Numbers least(y.size(), std::numeric_limits<double>::infinity()), depth(y.size());
  for (const Reference& reference : contact_.references) {
    std::visit([&](const auto& of) { fill(of.depth, y, depth); }, reference);
    for (std::size_t i = 0; i < y.size(); ++i) least[i] = std::min(least[i], depth[i]);
  }
  return least;
}

Matrix Model::at_depth(View y, View edges) const {
  Matrix found;
  for (const Reference& reference : contact_.references) {
    Matrix of_body = displacement(reference, y, edges);
    if (found.empty()) {
      found = std::move(of_body);
    } else {
      for (std::size_t i = 0; i < found.all().size(); ++i) found.all()[i] += of_body.all()[i];
    }
  }
  return found;
}

Matrix Model::by_width(View y) const {
  Matrix found;
  for (const Reference& reference : contact_.references) {
    const auto* roller = std::get_if<AxisOfRoller>(&reference);
    if (!roller) continue;
    if (found.empty()) {
      found.resize(4, count_of(y));
      std::fill(found.all().begin(), found.all().end(), 0.0);
    }
    add_by_width(*roller, y, hertz_ratio(), found);
  }
  return found;
}

std::shared_ptr<const Grid> Model::grid(Numbers edges) const {
  auto grid = springs(std::move(edges));
  grid->at_depth = at_depth(grid->y, grid->edges);
  grid->by_width = by_width(grid->y);
  return grid;
}

std::shared_ptr<Grid> Model::springs(Numbers edges) const {
  auto grid = std::make_shared<Grid>();
  const Index n = count_of(edges) - 1;
  grid->y.resize(n);
  for (Index i = 0; i < n; ++i) grid->y[i] = 0.5 * (edges[i + 1] + edges[i]);
  grid->curvature = curvature(grid->y);
  grid->separation = separation(grid->y);
  grid->min_depth = min_depth(grid->y);
  grid->sharper = sharper_curvature(grid->y);
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
  // If only the curvature jumps, the change of slope shrinks in proportion to the step; at a kink it does not.
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
