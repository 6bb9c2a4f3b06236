#include "grids/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();

// At a coarseness of 1, tuned on random contacts of all profiles; docs/explain/grid.md has the figures.
constexpr double STRIPS_PER_CONTACT = 8.0;            // sets the widest strip in contact
constexpr double NARROWEST = 1.0 / 40.0;              // of the half-width, at sharp ends and kinks
constexpr double END_SHARE = 0.2;                     // of the distance over which m falls from half its peak to zero
constexpr double GROWTH = 0.6, GROWTH_OUTSIDE = 1.2;  // of the distance from a feature
// Up to the second from sharp ends, in half-widths, where the strength of the singularity is fitted.
constexpr double GROWTH_AT_SHARP_ENDS = 0.2, NEAR_SHARP_ENDS = 1.5;
constexpr double SAG = 0.016;        // of the interference: the largest sagitta of the profile over one strip
constexpr double KINK_SHARE = 0.15;  // of the interference over the change of slope: the strip at a kink
// No width is below this fraction of the region, or this many times the spacing of floating-point numbers there.
constexpr double NARROWEST_EVER = 1e-9, ROUNDINGS = 1e4;
constexpr double EXTENSION = 0.3;  // of the contact's length, added where the contact extends beyond the strips

/// The narrowest strip width that floating-point numbers between low and high resolve.
double narrowest_width(double low, double high) {
  return std::max(NARROWEST_EVER * (high - low), ROUNDINGS * 2.3e-16 * std::max(std::fabs(low), std::fabs(high)));
}

}  // namespace

Sizes::Sizes(const Level& from, const Model& model, const Region& region, const std::vector<Extra>& extras,
             double coarseness)
    : contact_(intervals(*from.grid, from.state.m)),
      low_(from.grid->edges.front()),
      high_(from.grid->edges.back()),
      length_(contact_.back()[1] - contact_.front()[0]) {
  const State& state = from.state;
  const bool whole = low_ == region.low && high_ == region.high;
  const Samples of_part = whole ? Samples{} : model.sample(low_, high_);
  const Samples& samples = whole ? region.samples : of_part;
  const double first = low_, step = (high_ - low_) / SAMPLES;
  add_ends(from, region, coarseness);
  double deepest = -INFINITE;
  for (Index i = 0; i < count_of(samples.h); ++i)
    deepest =
        std::max(deepest, state.rigid[0] + state.rigid[1] * (first + static_cast<double>(i) * step) - samples.h[i]);
  add_kinks(from, region.kinks, coarseness * deepest);
  add_extras(region, extras);
  const double finest = narrowest_width(low_, high_);
  for (Feature& feature : features_) feature.width = std::max(std::min(feature.width, length_ / 8.0), finest);
  const double widest = *std::max_element(state.m.begin(), state.m.end());
  const double narrowest = std::max(NARROWEST * std::sqrt(widest),
                                    narrowest_width(first, first + step * static_cast<double>(samples.h.size())));
  sample_low_ = first + step, sample_step_ = step;
  bound_by_sag(samples, state, deepest, coarseness, narrowest);
  largest_ = coarseness * length_ / STRIPS_PER_CONTACT;
  largest_outside_ = (high_ - low_) / 8.0;
  growth_ = std::min(GROWTH * coarseness, 1.0);
}

void Sizes::add_ends(const Level& from, const Region& region, double coarseness) {
  const Grid& grid = *from.grid;
  const View m = from.state.m;
  for (const Pair& interval : contact_)
    for (int end = 0; end < 2; ++end) {
      const double place = interval[end], local = width_near(grid, m, place);
      const int side = 2 * end - 1;
      const bool reached = place == (end == 0 ? low_ : high_) && reaches(grid, m, side);
      const bool cut = reached && (end == 0 ? low_ > region.low : high_ < region.high);
      double width = NARROWEST * local, slow = NEAR_SHARP_ENDS * local;
      if (!reached || cut) {
        const double falls = fall(grid, m, interval[0], interval[1], side);
        width = std::max(width, END_SHARE * coarseness * falls), slow = 0.0;
      }
      features_.push_back({place, width, slow, !reached});
      if (cut && end == 0)
        low_ = std::max(low_ - EXTENSION * length_, region.low);
      else if (cut)
        high_ = std::min(high_ + EXTENSION * length_, region.high);
    }
}

/// Add kinks in or beside contact, unless there are too many.
void Sizes::add_kinks(const Level& from, const Kinks& kinks, double depth) {
  const Grid& grid = *from.grid;
  const View m = from.state.m;
  int beside = 0;
  for (double place : kinks.place) beside += is_nearly_touching(grid, m, place);
  if (beside > MOST_BENDS) return;
  for (std::size_t k = 0; k < kinks.place.size(); ++k) {
    const double place = kinks.place[k];
    if (!(grid.edges.front() < place && place < grid.edges.back() && is_nearly_touching(grid, m, place))) continue;
    const double width = std::max(KINK_SHARE * depth / kinks.turn[k], NARROWEST * width_near(grid, m, place));
    features_.push_back({place, width, 0.0, true});
  }
}

void Sizes::add_extras(const Region& region, const std::vector<Extra>& extras) {
  for (const auto& [place, width] : extras) {
    low_ = std::min(low_, std::max(place - 5.0 * width, region.low));
    high_ = std::max(high_, std::min(place + 5.0 * width, region.high));
    features_.push_back({place, width, 0.0, false});
  }
}

/// Find the width at every sample except the outermost at which the sagitta of the profile is within its limit.
void Sizes::bound_by_sag(const Samples& samples, const State& state, double deepest, double coarseness,
                         double narrowest) {
  const Numbers& h = samples.h;
  const Index n = count_of(h) - 2;
  const double step = sample_step_;
  const double sag = 8.0 * SAG * coarseness * coarseness * std::max(deepest, 0.0);
  sample_width_.resize(n);
  for (Index i = 0; i < n; ++i) {
    const double bend = std::fabs(h[i + 2] - 2.0 * h[i + 1] + h[i]) / (step * step);
    const double y = samples.y.front() + static_cast<double>(i + 1) * step;
    const bool overlaps = state.rigid[0] + state.rigid[1] * y >= h[i + 1];
    double wanted = step * static_cast<double>(n + 1);
    if (std::isfinite(bend) && bend > 0.0 && overlaps) wanted = std::min(wanted, std::sqrt(sag / bend));
    sample_width_[i] = std::max(wanted, narrowest);
  }
  // Away from every sample it may grow no faster than from a feature.
  const double growth = GROWTH * coarseness * step;
  for (Index i = 1; i < n; ++i) sample_width_[i] = std::min(sample_width_[i], sample_width_[i - 1] + growth);
  for (Index i = n - 2; i >= 0; --i) sample_width_[i] = std::min(sample_width_[i], sample_width_[i + 1] + growth);
}

double Sizes::operator()(double y, double by) const {
  bool inside = false;
  for (const auto& [low, high] : contact_) inside = inside || (low <= y && y <= high);
  const double growth = std::min(growth_ * std::sqrt(by), 1.0), rate = inside ? growth : GROWTH_OUTSIDE;
  double width = by * (inside ? largest_ : largest_outside_);
  for (const Feature& feature : features_) {
    const double away = std::fabs(y - feature.place), near = std::min(away, feature.slow);
    width = std::min(width, feature.width + std::min(GROWTH_AT_SHARP_ENDS, rate) * near + rate * (away - near));
  }
  if (!inside) return width;
  // The narrower of the two samples around y, so that a symmetric profile has a symmetric grid. But a kink appears at
  // only one sample, however far away the next is, so its width grows with the distance. At a sample only that one is
  // used, however its place is rounded.
  const double place = (y - sample_low_) / sample_step_;
  for (const double nearest : {std::floor(place + 1e-9), std::ceil(place - 1e-9)}) {
    const double sample = std::clamp(nearest, 0.0, static_cast<double>(sample_width_.size() - 1));
    const double away = std::fabs(y - sample_low_ - sample * sample_step_);
    width = std::min(width, std::max(std::sqrt(by) * sample_width_[static_cast<Index>(sample)], growth_ * away));
  }
  return width;
}

double Sizes::centre() const {
  double longest = -1.0, middle = 0.0;
  for (const auto& [low, high] : contact_) {
    if (low < 0.0 && 0.0 < high && low_ < 0.0 && 0.0 < high_) return 0.0;
    if (high - low > longest) longest = high - low, middle = 0.5 * (low + high);
  }
  return middle;
}

Numbers Sizes::marks() const {
  Numbers places;
  for (const Feature& feature : features_)
    if (feature.marked) places.push_back(feature.place);
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace nonhertz
