#include "grids/laying.hpp"

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
// Up to the second from sharp ends, in half-widths: there the strength of the singularity is fitted.
constexpr double GROWTH_AT_SHARP_ENDS = 0.2, NEAR_SHARP_ENDS = 1.5;
constexpr double SAG = 0.016;  // of the interference: the largest sagitta of the profile over one strip
constexpr double KINK_SHARE = 0.15, LOOSEST = 64.0;
constexpr double LEAST_STRIP = 0.4;  // of the target width, for a strip between two corners
// No width is below this fraction of the region, or this many times the spacing of floating-point numbers there.
constexpr double NARROWEST_EVER = 1e-9, ROUNDINGS = 1e4;
constexpr double EXTENSION = 0.3;  // of the contact's length, added where the strips end before the contact does
constexpr int NEAREST = 3;         // strips whose largest half-width is taken as the local one
constexpr double STEPS_PER_STRIP = 3.0;
constexpr Index MOST_STEPS = 6000;

/// Where strips are narrow: up to the distance `slow` widths grow slowly; an edge lies there if it is `marked`.
struct Feature {
  double place, width, slow;
  bool marked;
};

/// Positions, and how many strips lie between the first and each.
struct Path {
  Numbers place, count;
};

/// The narrowest strip width that floating-point numbers between low and high resolve.
double resolved(double low, double high) {
  return std::max(NARROWEST_EVER * (high - low), ROUNDINGS * 2.3e-16 * std::max(std::fabs(low), std::fabs(high)));
}

/// The largest half-width of the few strips in contact nearest to a place.
double width_near(const Grid& grid, View m, double place) {
  double widest = 0.0, beyond = -1.0;
  for (int k = 0; k < NEAREST; ++k) {
    Index at = -1;
    double closest = INFINITE;
    for (Index i = 0; i < count_of(m); ++i) {
      const double distance = std::fabs(grid.y[i] - place);
      if (m[i] > 0.0 && beyond < distance && distance < closest) at = i, closest = distance;
    }
    if (at < 0) break;
    widest = std::max(widest, m[at]), beyond = closest;
  }
  return std::sqrt(widest);
}

/// The distance from one end of a contact at which m is half its value at the nearest peak.
double fall(const Grid& grid, View m, double low, double high, int side) {
  const Index n = count_of(m);
  const double end = side > 0 ? high : low;
  double summit = 0.0;
  Index at_summit = -1, first = -1;
  for (Index k = 0; k < n; ++k) {
    const Index i = side > 0 ? n - 1 - k : k;
    if (!(m[i] > 0.0 && low <= grid.y[i] && grid.y[i] <= high)) continue;
    first = first < 0 ? i : first;
    if (m[i] < summit) break;
    summit = m[i], at_summit = i;
  }
  if (at_summit < 0) return high - low;
  Index i = first;
  while (m[i] < 0.5 * summit) i -= side;
  const double distance = std::fabs(grid.y[i] - end);
  if (i == first) return distance;
  const Index out = i + side;
  const double before = std::fabs(grid.y[out] - end), share = (0.5 * summit - m[out]) / (m[i] - m[out]);
  return before + share * (distance - before);
}

/// The value at `at` on the line through points with ascending x.
double read(View x, View values, double at) {
  Index low = 0, high = count_of(x) - 1;
  if (at <= x[low]) return values[low];
  if (at >= x[high]) return values[high];
  while (high - low > 1) {
    const Index middle = (low + high) / 2;
    (x[middle] <= at ? low : high) = middle;
  }
  return values[low] + (at - x[low]) / (x[high] - x[low]) * (values[high] - values[low]);
}

/// The size function that a coarse solution calls for.
class Sizes {
 public:
  Sizes(const Level& from, const Model& model, const std::vector<Extra>& extras, double coarseness);

  /// The target strip width at y; away from the features `by` times as wide.
  double operator()(double y, double by) const;
  Path walk(double start, double stop, double by) const;
  double centre() const;
  Numbers marks() const;
  Index pieces() const { return static_cast<Index>(contact_.size()); }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  void add_ends(const Level& from, const Model& model, double coarseness);
  void add_kinks(const Level& from, const Model& model, double depth);
  void add_extras(const Model& model, const std::vector<Extra>& extras);
  void bound_by_sag(const Samples& samples, const State& state, double deepest, double coarseness, double narrowest);

  std::vector<Pair> contact_;
  std::vector<Feature> features_;
  double low_, high_, length_;
  double sample_low_, sample_step_;
  Numbers sample_width_;
  double largest_, largest_outside_, growth_;
};

Sizes::Sizes(const Level& from, const Model& model, const std::vector<Extra>& extras, double coarseness)
    : contact_(intervals(*from.grid, from.state.m)),
      low_(from.grid->edges.front()),
      high_(from.grid->edges.back()),
      length_(contact_.back()[1] - contact_.front()[0]) {
  const State& state = from.state;
  const bool whole = low_ == model.low() && high_ == model.high();
  const Samples of_part = whole ? Samples{} : model.sampled(low_, high_);
  const Samples& samples = whole ? model.region()->sampled : of_part;
  const double first = low_, step = (high_ - low_) / SAMPLES;
  add_ends(from, model, coarseness);
  double deepest = -INFINITE;
  for (Index i = 0; i < count_of(samples.h); ++i)
    deepest =
        std::max(deepest, state.rigid[0] + state.rigid[1] * (first + static_cast<double>(i) * step) - samples.h[i]);
  add_kinks(from, model, coarseness * deepest);
  add_extras(model, extras);
  const double finest = resolved(low_, high_);
  for (Feature& each : features_) each.width = std::max(std::min(each.width, length_ / 8.0), finest);
  const double widest = *std::max_element(state.m.begin(), state.m.end());
  const double narrowest =
      std::max(NARROWEST * std::sqrt(widest), resolved(first, first + step * static_cast<double>(samples.h.size())));
  sample_low_ = first + step, sample_step_ = step;
  bound_by_sag(samples, state, deepest, coarseness, narrowest);
  largest_ = coarseness * length_ / STRIPS_PER_CONTACT;
  largest_outside_ = (high_ - low_) / 8.0;
  growth_ = std::min(GROWTH * coarseness, 1.0);
}

void Sizes::add_ends(const Level& from, const Model& model, double coarseness) {
  const Grid& grid = *from.grid;
  const View m = from.state.m;
  for (const Pair& interval : contact_)
    for (int end = 0; end < 2; ++end) {
      const double place = interval[end], local = width_near(grid, m, place);
      const int side = 2 * end - 1;
      const bool reached = place == (end == 0 ? low_ : high_) && reaches(grid, m, side);
      const bool cut = reached && (end == 0 ? low_ > model.low() : high_ < model.high());
      double width = NARROWEST * local, slow = NEAR_SHARP_ENDS * local;
      if (!reached || cut) {
        const double falls = fall(grid, m, interval[0], interval[1], side);
        width = std::max(width, END_SHARE * coarseness * falls), slow = 0.0;
      }
      features_.push_back({place, width, slow, !reached});
      if (cut && end == 0)
        low_ = std::max(low_ - EXTENSION * length_, model.low());
      else if (cut)
        high_ = std::min(high_ + EXTENSION * length_, model.high());
    }
}

/// Add kinks in or beside contact, unless they are too many for any to stand out.
void Sizes::add_kinks(const Level& from, const Model& model, double depth) {
  const Grid& grid = *from.grid;
  const View m = from.state.m;
  const Kinks& kinks = model.region()->kinks;
  int beside = 0;
  for (double place : kinks.place) beside += nearly_touching(grid, m, place);
  if (beside > MOST_BENDS) return;
  for (std::size_t k = 0; k < kinks.place.size(); ++k) {
    const double place = kinks.place[k];
    if (!(grid.edges.front() < place && place < grid.edges.back() && nearly_touching(grid, m, place))) continue;
    const double width = std::max(KINK_SHARE * depth / kinks.turn[k], NARROWEST * width_near(grid, m, place));
    features_.push_back({place, width, 0.0, true});
  }
}

void Sizes::add_extras(const Model& model, const std::vector<Extra>& extras) {
  for (const auto& [place, width] : extras) {
    low_ = std::min(low_, std::max(place - 5.0 * width, model.low()));
    high_ = std::max(high_, std::min(place + 5.0 * width, model.high()));
    features_.push_back({place, width, 0.0, false});
  }
}

/// Find the width, at every sample but the outermost, at which the profile sags by no more than its share.
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
  for (const Feature& each : features_) {
    const double away = std::fabs(y - each.place), near = std::min(away, each.slow);
    width = std::min(width, each.width + std::min(GROWTH_AT_SHARP_ENDS, rate) * near + rate * (away - near));
  }
  if (!inside) return width;
  // The narrower of the two samples around y, so that a symmetric profile has a symmetric grid. But a kink shows at one
  // sample only, however far away the next is, so its width grows with the distance. At a sample itself only that one,
  // whichever way its place is rounded.
  const double place = (y - sample_low_) / sample_step_;
  for (const double nearest : {std::floor(place + 1e-9), std::ceil(place - 1e-9)}) {
    const Index sample = std::clamp(static_cast<Index>(nearest), Index{0}, count_of(sample_width_) - 1);
    const double away = std::fabs(y - sample_low_ - static_cast<double>(sample) * sample_step_);
    width = std::min(width, std::max(std::sqrt(by) * sample_width_[sample], growth_ * away));
  }
  return width;
}

Path Sizes::walk(double start, double stop, double by) const {
  const double outward = stop > start ? 1.0 : -1.0;
  Path path{{start}, {0.0}};
  for (Index used = 1; used < MOST_STEPS; ++used) {
    const double here = path.place.back();
    double step = (*this)(here, by);
    if (used > MOST_STEPS / 2)  // more strips than any grid has: cover the rest in even steps
      step = std::max(step, STEPS_PER_STRIP * std::fabs(stop - here) / static_cast<double>(MOST_STEPS - used));
    double there = here + outward * step / STEPS_PER_STRIP;
    const bool last = outward * (there - stop) >= 0.0 || used == MOST_STEPS - 1;
    if (last) there = stop;
    path.place.push_back(there);
    path.count.push_back(path.count.back() + std::fabs(there - here) / (*this)(0.5 * (here + there), by));
    if (last) break;
  }
  return path;
}

/// y = 0 where it is in contact, else the middle of the longest interval in contact.
double Sizes::centre() const {
  double longest = -1.0, middle = 0.0;
  for (const auto& [low, high] : contact_) {
    if (low < 0.0 && 0.0 < high && low_ < 0.0 && 0.0 < high_) return 0.0;
    if (high - low > longest) longest = high - low, middle = 0.5 * (low + high);
  }
  return middle;
}

Numbers Sizes::marks() const {
  Numbers found;
  for (const Feature& each : features_)
    if (each.marked) found.push_back(each.place);
  std::sort(found.begin(), found.end());
  return found;
}

/// Return edges from `start` outward, a whole number of strips to every mark and to the end.
Numbers cut(const Path& path, double start, const Numbers& marks, double share) {
  const Index n = count_of(path.place);
  const double outward = path.place[n - 1] > path.place[0] ? 1.0 : -1.0, whole = path.count[n - 1];
  Numbers along(n), edges{start};
  for (Index i = 0; i < n; ++i) along[i] = outward * path.place[i];
  double begin = read(along, path.count, outward * start);
  for (Index k = 0; k <= count_of(marks); ++k) {
    const bool last = k == count_of(marks);
    const double mark = last ? along[n - 1] : outward * marks[outward > 0.0 ? k : count_of(marks) - 1 - k];
    if (!last && mark <= outward * start) continue;
    const double reached = read(along, path.count, mark);
    // A mark close to another edge would cut off a sliver.
    if (!last && std::min(share * (reached - begin), share * (whole - reached)) < LEAST_STRIP) continue;
    const Index strips = std::max(Index{1}, static_cast<Index>(std::nearbyint(share * (reached - begin))));
    for (Index strip = 1; strip < strips; ++strip)
      edges.push_back(read(path.count, path.place,
                           begin + (reached - begin) / static_cast<double>(strips) * static_cast<double>(strip)));
    edges.push_back(outward * mark);
    begin = reached;
  }
  return edges;
}

/// Return the edges of a grid without a centred strip, cut from the end nearest to the centre.
Numbers from_end(const Path& left, const Path& right, const Numbers& marks, double share) {
  const bool left_is_near = left.count.back() <= right.count.back();
  const Path &near = left_is_near ? left : right, &far = left_is_near ? right : left;
  Path path;
  const Index n = count_of(near.place) - 1;
  for (Index i = 0; i < n; ++i) {
    path.place.push_back(near.place[n - i]);
    path.count.push_back(near.count[n] - near.count[n - i]);
  }
  for (Index i = 0; i < count_of(far.place); ++i) {
    path.place.push_back(far.place[i]);
    path.count.push_back(near.count[n] + far.count[i]);
  }
  Numbers edges = cut(path, path.place[0], marks, share);
  if (!(edges.front() < edges.back())) std::reverse(edges.begin(), edges.end());
  return edges;
}

/// Where the contact around strip `at` ends on the given side, at most one strip away.
double end_of(const Grid& grid, View m, Index at, Index other, int side) {
  const double edge = side > 0 ? grid.high(at) : grid.low(at);
  const Index next_in = at - side, next_out = at + side;
  if (at == other || m[next_in] <= m[at]) return edge;
  const double y = grid.y[at], limit = 0 <= next_out && next_out < count_of(m) ? grid.y[next_out] : edge;
  const double run = m[at] * std::fabs(y - grid.y[next_in]) / (m[next_in] - m[at]);
  return side * std::min(side * (y + side * run), side * limit);
}

}  // namespace

Numbers lay(const Level& from, const Model& model, const std::vector<Extra>& extras, const Fineness& fineness) {
  const Sizes sizes(from, model, extras, fineness.coarseness);
  const double pieces = static_cast<double>(std::min(sizes.pieces(), Index{2}));
  const double limit = fineness.limit / std::min(fineness.coarseness, 1.0) * pieces;
  const double centre = sizes.centre();
  double by = 1.0;
  Path right = sizes.walk(centre, sizes.high(), by), left = sizes.walk(centre, sizes.low(), by);
  double wanted = right.count.back() + left.count.back();
  // Where the sizes call for too many strips, those away from features are widened.
  while (wanted > limit && by < LOOSEST) {
    by *= std::max(1.03, std::pow(wanted / limit, 1.5));
    right = sizes.walk(centre, sizes.high(), by), left = sizes.walk(centre, sizes.low(), by);
    wanted = right.count.back() + left.count.back();
  }
  const double share = fineness.share * std::min(1.0, limit / wanted), half = 0.5 / share;
  const Numbers marks = sizes.marks();
  // Too close to an end for half a strip and another one beside it.
  if (std::min(right.count.back(), left.count.back()) < half + LEAST_STRIP / share)
    return from_end(left, right, marks, share);
  const double reach =
      std::min(read(right.count, right.place, half) - centre, centre - read(left.count, left.place, half));
  const Numbers after = cut(right, centre + reach, marks, share), before = cut(left, centre - reach, marks, share);
  Numbers edges(before.rbegin(), before.rend());
  edges.insert(edges.end(), after.begin(), after.end());
  return edges;
}

std::vector<Pair> intervals(const Grid& grid, View m) {
  std::vector<Pair> found;
  const Index n = count_of(m);
  Index first = -1;
  for (Index i = 0; i < n; ++i) {
    if (m[i] > 0.0 && first < 0) first = i;
    if (m[i] > 0.0 && (i + 1 == n || !(m[i + 1] > 0.0))) {
      found.push_back({end_of(grid, m, first, i, -1), end_of(grid, m, i, first, 1)});
      first = -1;
    }
  }
  return found;
}

bool reaches(const Grid& grid, View m, int side) {
  const Index n = count_of(m), at = side > 0 ? n - 1 : 0, next_in = side > 0 ? n - 2 : 1;
  if (!(m[at] > 0.0)) return false;
  if (n < 2) return true;
  const double distance =
      0.5 * std::fabs(grid.edges[at] + grid.edges[at + 1] - grid.edges[next_in] - grid.edges[next_in + 1]);
  return m[at] - 0.5 * (m[next_in] - m[at]) / distance * grid.width(at) > 0.0;
}

bool nearly_touching(const Grid& grid, View m, double place) {
  const Index n = count_of(m);
  for (Index i = 0; i < n; ++i)
    if (m[i] > 0.0 && grid.edges[std::max(i - 1, Index{0})] <= place && place <= grid.edges[std::min(i + 2, n)])
      return true;
  return false;
}

}  // namespace nonhertz
