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
  Samples even = sample(low, high);
  const auto is_within = [low, high](double y) { return low < y && y < high; };
  const bool has_crests = std::any_of(contact_.crests.begin(), contact_.crests.end(), is_within);
  Samples all = has_crests ? sample_with_crests(low, high) : even;
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
  std::array values{Numbers(y.size()), Numbers(y.size())};
  for (int k = 0; k < 2; ++k) fill(contact_.bodies[k].curvature, y, values[k]);
  return values;
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
  Matrix sum;
  for (const Reference& reference : contact_.references) {
    Matrix of_body = displacement(reference, y, edges);
    if (sum.empty()) {
      sum = std::move(of_body);
    } else {
      for (std::size_t i = 0; i < sum.all().size(); ++i) sum.all()[i] += of_body.all()[i];
    }
  }
  return sum;
}

Matrix Model::by_width(View y) const {
  Matrix sum;
  for (const Reference& reference : contact_.references) {
    const auto* roller = std::get_if<AxisOfRoller>(&reference);
    if (!roller) continue;
    if (sum.empty()) {
      sum.resize(4, count_of(y));
      std::fill(sum.all().begin(), sum.all().end(), 0.0);
    }
    add_by_width(*roller, y, hertz_ratio(), sum);
  }
  return sum;
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

Samples Model::sample(double low, double high) const {
  Samples samples{uniform(low, high, SAMPLES), {}};
  samples.h = separation(samples.y);
  return samples;
}

Samples Model::sample_with_crests(double low, double high) const {
  Samples samples{uniform(low, high, SAMPLES), {}};
  for (double crest : contact_.crests)
    if (low < crest && crest < high) samples.y.push_back(crest);
  std::sort(samples.y.begin(), samples.y.end());
  samples.y.erase(std::unique(samples.y.begin(), samples.y.end()), samples.y.end());
  samples.h = separation(samples.y);
  return samples;
}

Kinks Model::kinks_among(View bends, double length) const {
  Kinks kinks;
  const auto turn = [this](double place, double step) {
    const Numbers h = separation(Numbers{place - step, place, place + step});
    return std::fabs(h[2] - 2.0 * h[1] + h[0]) / step;
  };
  // If only the curvature jumps, the change of slope shrinks in proportion to the step; at a kink it does not.
  const double step = 1e-5 * length;
  for (double place : bends) {
    const double wide = turn(place, step), narrow = turn(place, 0.1 * step);
    if (!(narrow > 0.5 * wide && narrow > LEAST_KINK)) continue;
    kinks.place.push_back(place);
    kinks.turn.push_back(narrow);
  }
  return kinks;
}

}  // namespace nonhertz
