// The discretisation errors of a solution, estimated from coarser grids and from relief that strips do not resolve.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "judging/judgement.hpp"
#include "strips/summit.hpp"

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity(), PI = std::numbers::pi;

constexpr int FEW_AT_END = 4;          // fewer strips within a half-width of an end do not resolve how the contact ends
constexpr double FALLS_AWAY = 0.1;     // of the interference: by this much at least it is less at an end than inside
constexpr double PRESSURE_LEFT = 2.0;  // of the accuracy aimed for: a change may be small by chance
constexpr double COARSE = 2.0;         // times the usual estimate of the largest pressure, on coarser grids
// Times the exponent: by this much at most a sharp end raises the pressure a half-width from it above that of strips
// too wide to show it.
constexpr double RAISED = 0.38;
constexpr double HIDDEN = 4.0;  // times the last strip's excess over the maximum: its mean is lower than the peak in it
// What the modes and polynomials of a whole roller leave of approach and largest pressure.
constexpr double LEFT_BY_MODES = 2e-5, PRESSURE_LEFT_BY_MODES = 1e-4;
constexpr double SHARP_END_ERROR = 0.12, LEFT_AT_END = 0.016;  // see `at_ends`
constexpr double USUALLY_LEFT = 0.6;  // of the accuracy aimed for: about the largest error where the change was small
constexpr double WIDER_THAN_LONG = 1.02;
// K q / a that flattens a departure, over departure / width.
constexpr double RIPPLE = 0.5 * PI * std::numbers::sqrt2;
constexpr std::size_t LEVELS = 3;

/// The strips of a solution: half-widths [mm], K q / a, and K times the load of each.
struct Carried {
  const Grid& grid;
  Numbers half_width, pressure, load;
  double total = 0.0, moment = 0.0;

  Carried(const Level& level, double hertz_ratio) : grid(*level.grid) {
    const State& state = level.state;
    for (Index i = 0; i < grid.count(); ++i) {
      const double root = std::sqrt(state.m[i]);
      half_width.push_back(hertz_ratio * root);
      pressure.push_back(state.r[i] * root);
      load.push_back(state.r[i] * state.m[i] * grid.width(i));
      total += load[i];
      moment += grid.y[i] * load[i];
    }
  }
};

/// What of the relief strips do not resolve.
struct Unresolved {
  double penetration = -INFINITE, mean = 0.0;
  Numbers ripples;
};

Unresolved unresolved(const Model& model, const Level& level, const Carried& strips) {
  const Grid& grid = strips.grid;
  const Index n = grid.count();
  Numbers places(n * WITHIN);
  for (Index i = 0; i < n; ++i)
    for (int k = 0; k < WITHIN; ++k) places[i * WITHIN + k] = grid.y[i] + grid.width(i) * within(k);
  const Numbers h = model.separation(places);
  const double least = *std::min_element(h.begin(), h.end());
  Unresolved found;
  for (Index i = 0; i < n; ++i) {
    std::array<double, WITHIN> near;
    for (int k = 0; k < WITHIN; ++k) {
      const Index at = i * WITHIN + k;
      const double depth = level.state.rigid[0] + level.state.rigid[1] * places[at];
      found.penetration = std::max(found.penetration, depth - h[at]);
      // Relief deeper than the bodies approach is out of contact, however deep it is.
      near[k] = std::min(h[at], std::max(depth, least));
    }
    const double off = departure(near);
    found.mean += strips.load[i] * off;
    found.ripples.push_back(RIPPLE * off / grid.width(i));
  }
  found.mean /= strips.total;
  return found;
}

/// What ends of the contact leave of approach or load on these strips, and on any; and of the pressure.
struct AtEnds {
  double floor = 0.0, left = 0.0, raised = 0.0;
};

/// The first is in proportion to the width of the last strip: a tenth of both end strips' widths over the length.
/// The second no number of strips removes: within a half-width of a sharp end the pressure across is no semi-ellipse.
/// The third is that of the largest pressure if it is that a half-width from a sharp end, in wide strips.
AtEnds at_ends(const Carried& strips, const Ends& ends, double length, double highest) {
  const Grid& grid = strips.grid;
  AtEnds found;
  for (const End& end : ends.ends) {
    const double base = 1.0 - std::cos(PI * end.exponent), sharpness = std::pow(base, 1.5);
    found.floor += SHARP_END_ERROR * end.width * sharpness / length;
    int near = 0;
    double nearest = INFINITE, beyond = highest;
    for (Index i = 0; i < grid.count(); ++i) {
      const double past = std::fabs(grid.y[i] - end.y) - strips.half_width[i];
      if (!(strips.half_width[i] > 0.0)) continue;
      near += past <= 0.0;
      if (0.0 < past && past < nearest) nearest = past, beyond = strips.pressure[i];
    }
    if (end.kind == EndKind::singular) {
      // The strip a half-width from the end, by the half-width there.
      const auto nearest_to = [&](auto distance) {
        Index at = 0;
        for (Index i = 1; i < grid.count(); ++i)
          if (std::fabs(distance(i)) < std::fabs(distance(at))) at = i;
        return at;
      };
      const auto from_end = [&](Index i) { return std::fabs(grid.y[i] - end.y); };
      const Index border = nearest_to([&](Index i) { return from_end(i) - strips.half_width[i]; });
      const Index at = nearest_to([&](Index i) { return from_end(i) - strips.half_width[border]; });
      const double borne = strips.load[at] / grid.width(at) * strips.half_width[at];
      found.left += LEFT_AT_END * borne * sharpness / strips.total;
    }
    if (near < FEW_AT_END)
      found.raised = std::max(found.raised, (1.0 + RAISED * end.exponent) * beyond / highest - 1.0);
  }
  return found;
}

/// Beside which ends that few strips resolve the bodies overlap less than a half-width inside.
std::vector<bool> falls_away(const Model& model, const Level& level, const Carried& strips, View singular) {
  std::vector<bool> found(singular.size());
  double middle = 0.0;
  for (double edge : strips.grid.edges) middle += edge / static_cast<double>(strips.grid.edges.size());
  for (std::size_t k = 0; k < singular.size(); ++k) {
    int count = 0;
    double widest = 0.0;
    for (Index i = 0; i < strips.grid.count(); ++i)
      if (strips.half_width[i] > 0.0 && std::fabs(strips.grid.y[i] - singular[k]) <= strips.half_width[i])
        ++count, widest = std::max(widest, strips.half_width[i]);
    if (!(0 < count && count < FEW_AT_END)) continue;
    const double inside = singular[k] + std::copysign(widest, middle - singular[k]);
    const auto depth = [&](double y) { return level.state.rigid[0] + level.state.rigid[1] * y - model.separation(y); };
    found[k] = depth(singular[k]) < (1.0 - FALLS_AWAY) * depth(inside);
  }
  return found;
}

/// How high summits may reach that are narrower than their strips, zero for all other strips.
///
/// A summit stands out no further than by twice what halving the strips has just raised it by.
Numbers reaches_of(const Carried& strips, const Carried* coarse) {
  const Index n = strips.grid.count();
  Numbers found(n);
  Index at = 0;
  for (Index i = 1; i + 1 < n; ++i) {
    found[i] = cusp(strips.pressure, i);
    if (coarse == nullptr) continue;
    const Index last = coarse->grid.count() - 1;
    while (at < last && coarse->grid.high(at) < strips.grid.y[i]) ++at;
    double height = 0.0;
    for (Index j = std::max(at - 1, Index{0}); j <= std::min(at + 1, last); ++j)
      height = std::max(height, coarse->pressure[j]);
    found[i] = std::min(found[i], strips.pressure[i] + SAFETY * std::fabs(strips.pressure[i] - height));
  }
  return found;
}

/// The relative error of the largest pressure caused by what strips do not resolve.
///
/// On strips as wide as the contact, one that runs out shortly before the end of the bodies looks like one that reaches
/// it: where the profile falls away there, the last strip may well have the largest pressure.
double beside_strips(const Carried& strips, View singular, const std::vector<bool>& falls, View reaches, View ripples,
                     double highest) {
  double hidden = 0.0, summit = 0.0, ripple = 0.0;
  for (Index i = 0; i < strips.grid.count(); ++i) {
    bool counted = strips.half_width[i] > 0.0;
    for (std::size_t k = 0; k < singular.size(); ++k) {
      if (!(std::fabs(strips.grid.y[i] - singular[k]) <= strips.half_width[i])) continue;
      if (falls[k])
        hidden = std::max(hidden, HIDDEN * (strips.pressure[i] / highest - 1.0));
      else
        counted = false;
    }
    if (counted) summit = std::max(summit, reaches[i]), ripple = std::max(ripple, ripples[i]);
  }
  return std::max(hidden, summit / highest - 1.0) + ripple / highest;
}

/// Estimate the error of a quantity from its values on successively coarser grids, finest first.
///
/// Twice the larger of the last change and half the change before it; where strips follow the ends of the contact,
/// LEFT_OF_CHANGE of the last change, but never less than what such grids usually leave.
double left_of_change(View values, double whole, double accuracy) {
  if (values.size() < 2 || !(whole > 0.0)) return INFINITE;
  const double last = std::fabs(values[0] - values[1]) / whole;
  const double before = std::fabs(values[values.size() - 2] - values.back()) / whole;
  if (accuracy > 0.0) return std::max(LEFT_OF_CHANGE * last, USUALLY_LEFT * accuracy);
  return std::isfinite(last + before) ? SAFETY * std::max(last, 0.5 * before) : INFINITE;
}

double relative(double part, double whole) { return whole != 0.0 ? part / std::fabs(whole) : INFINITE; }

bool has_whole_roller(const Model& model) {
  const auto& all = model.contact().references;
  return std::any_of(all.begin(), all.end(),
                     [](const Reference& each) { return std::holds_alternative<AxisOfRoller>(each); });
}

}  // namespace

Estimate estimate(const Model& model, const Prescription& given, const Levels& levels, const Ends& ends,
                  const Largest& largest, bool at_corner) {
  const double highest = largest.pressure, ratio = model.hertz_ratio(), modes = has_whole_roller(model);
  const Level& finest = levels.levels[0];
  std::vector<Carried> strips;
  for (std::size_t k = 0; k < std::min(LEVELS, levels.levels.size()); ++k) strips.emplace_back(levels.levels[k], ratio);
  const Unresolved missing = unresolved(model, finest, strips[0]);
  // Relative to the penetration: what is approached before the bodies touch has no error, and may be most of it.
  const double before_touch = finest.state.rigid[0] - missing.penetration;
  std::array<Numbers, 5> values;
  for (std::size_t k = 0; k < strips.size(); ++k) {
    const Level& level = levels.levels[k];
    const double pressure = k == 0 ? highest : largest_pressure(level, ratio, ends.singular).pressure;
    values[0].push_back(level.state.rigid[0] - before_touch);
    values[1].push_back(strips[k].total);
    values[2].push_back(pressure);
    values[3].push_back(strips[k].moment);
    values[4].push_back(level.state.rigid[1]);
  }
  double widest = 0.0, longest = 0.0, length = 0.0;
  for (double half : strips[0].half_width) widest = std::max(widest, 2.0 * half);
  for (const auto& [low, high] : intervals(*finest.grid, finest.state.m))
    longest = std::max(longest, high - low), length += high - low;
  const auto is_kind = [&ends](EndKind kind) { return ends.ends[0].kind == kind || ends.ends[1].kind == kind; };
  // Towards a corner errors fall in proportion to the strips only, and anyhow in contacts wider than long.
  const bool regular = !at_corner && !is_kind(EndKind::corner) && !(widest > WIDER_THAN_LONG * longest);
  const double accuracy = regular ? levels.accuracy : 0.0;
  auto [floor, left, raised] = at_ends(strips[0], ends, length, highest);
  left += LEFT_BY_MODES * modes;
  const double load = strips[0].total, reach = finest.grid->half_length();
  const double unseen = relative(missing.mean, missing.penetration);
  const double unborne = relative(missing.mean * finest.state.stiffness[0][0], load);
  const double wholes[5] = {std::fabs(values[0][0]), std::fabs(load), highest, load * reach,
                            missing.penetration / reach};
  std::array<double, 5> of_grids;
  for (int k = 0; k < 5; ++k) of_grids[k] = left_of_change(values[k], wholes[k], k == 2 ? 0.0 : accuracy);
  const auto of_motion = [&](double of_grid) { return std::max(floor, of_grid + unseen) + left; };
  const auto of_force = [&](double of_grid) { return std::max(floor, of_grid + unborne) + left; };
  Errors errors{};
  errors.approach = given.by_force[0] ? of_motion(of_grids[0]) : 0.0;
  errors.load = given.by_force[0] ? 0.0 : of_force(of_grids[1]);
  errors.tilt = given.by_force[1] ? of_motion(of_grids[4]) : 0.0;
  errors.moment = given.by_force[1] ? 0.0 : of_force(of_grids[3]);
  errors.max_pressure = INFINITE;
  if (!at_corner && !is_kind(EndKind::cut_off)) {
    const double coarseness = levels.accuracy > ACCURACY ? COARSE : 1.0;
    const double by_strips =
        std::max({floor, coarseness * std::max(PRESSURE_LEFT * levels.accuracy, of_grids[2]), raised});
    const Numbers reaches = reaches_of(strips[0], strips.size() > 1 ? &strips[1] : nullptr);
    const auto falls = falls_away(model, finest, strips[0], ends.singular);
    errors.max_pressure = by_strips + PRESSURE_LEFT_BY_MODES * modes +
                          beside_strips(strips[0], ends.singular, falls, reaches, missing.ripples, highest);
  }
  return {errors, missing.penetration};
}

}  // namespace nonhertz
