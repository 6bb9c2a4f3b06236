// The discretisation errors of a solution, estimated from coarser grids and from relief that strips do not resolve.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "judging/judgement.hpp"
#include "judging/resolution.hpp"
#include "strips/summit.hpp"

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity(), PI = std::numbers::pi;

constexpr int FEW_AT_END = 4;       // fewer strips within a half-width of an end do not resolve how the contact ends
constexpr double FALLS_AWAY = 0.1;  // of the interference: it is smaller at an end than inside by at least this
// Relative to the target accuracy: a change of the largest pressure may be small by chance. And on a rounded corner, on
// any grid: the position of strips on the step of its curvature changes the peak by that much.
constexpr double PRESSURE_LEFT = 1.0, LEFT_ON_CORNER = 6e-4;
constexpr double COARSE = 2.0;  // times the usual estimate of the largest pressure, on coarser grids
// Times the exponent: largest excess of the pressure a half-width from a sharp end over that of strips too wide to show
// it. Measured on straight rollers: 0.19 on half-spaces, 0.10 with mirrored, 0.02 with free ends.
constexpr double RAISED = 0.38;
constexpr double HIDDEN = 4.0;  // times the last strip's excess over the maximum: its mean is lower than the peak in it
// Error of approach and largest pressure by the modes and polynomials of a whole roller, from twice as many on random
// rollers. A load at one end only has 8e-5 of the approach, one at a sharp end 5e-4 of the pressure beside it.
constexpr double LEFT_BY_MODES = 2e-5, PRESSURE_LEFT_BY_MODES = 1e-4;
constexpr double SHARP_END_ERROR = 0.12, LEFT_AT_END = 0.016;  // see `at_ends`
constexpr double USUALLY_LEFT = 0.9;  // of the target accuracy: 6 of 750 errors are larger where the change is small
constexpr double WIDER_THAN_LONG = 1.02;
constexpr std::size_t LEVELS = 3;

/// Relief that strips do not resolve.
struct Unresolved {
  double penetration = -INFINITE, mean = 0.0;  ///< the mean departure from parabolas, by the loads of the strips [mm]
  Numbers ripples;                             ///< of pressure, as K q / a, that flatten each strip
};

Unresolved find_unresolved(const Model& model, const Level& level, const Pressures& strips, double load) {
  const Grid& grid = strips.grid;
  const Index n = grid.count();
  Numbers places(n * WITHIN);
  for (Index i = 0; i < n; ++i)
    for (int k = 0; k < WITHIN; ++k) places[i * WITHIN + k] = grid.y[i] + grid.width(i) * within(k);
  const Numbers h = model.separation(places);
  const double least = *std::min_element(h.begin(), h.end());
  Unresolved result;
  for (Index i = 0; i < n; ++i) {
    std::array<double, WITHIN> near;
    for (int k = 0; k < WITHIN; ++k) {
      const Index at = i * WITHIN + k;
      const double depth = level.state.rigid[0] + level.state.rigid[1] * places[at];
      result.penetration = std::max(result.penetration, depth - h[at]);
      // Relief deeper than the approach is out of contact, however deep it is.
      near[k] = std::min(h[at], std::max(depth, least));
    }
    const double off = departure(near);
    result.mean += strips.load[i] * off;
    result.ripples.push_back(RIPPLE * off / grid.width(i));
  }
  result.mean /= load;
  return result;
}

/// Errors due to ends of the contact: of approach or load on these strips, and on any; and of the pressure.
struct AtEnds {
  double floor = 0.0, remainder = 0.0, raised = 0.0;
};

/// The first is proportional to the width of the last strip: measured on straight rollers, a tenth of both end strips'
/// widths over the length, on equal and graded grids; 0.4 of that at kappa = 1/4, 0.2 at 1/2, 0.06 at 3/4 and zero
/// at 1. Ends that are free of normal stress count as ends of images with the same exponent.
///
/// The second remains for any number of strips. Within a half-width of a sharp end the pressure across is not a
/// semi-ellipse; the effect is proportional to the load on a length of one half-width there: for kappa = 0, 0.0150 of
/// its share of the load on a straight roller and 0.0103 on a crowned one, against three-dimensional solutions;
/// LEFT_AT_END is above both.
///
/// The third is the error of the largest pressure if that lies a half-width from a sharp end, in wide strips.
AtEnds at_ends(const Pressures& strips, const Ends& ends, double length, double highest, double load) {
  const Grid& grid = strips.grid;
  AtEnds errors;
  for (const End& end : ends.ends) {
    const double base = 1.0 - std::cos(PI * end.exponent), sharpness = std::pow(base, 1.5);
    errors.floor += SHARP_END_ERROR * end.width * sharpness / length;
    int near = 0;
    double nearest = INFINITE, beyond = highest;
    for (Index i = 0; i < grid.count(); ++i) {
      const double past = std::fabs(grid.y[i] - end.y) - strips.half_width[i];
      if (!(strips.half_width[i] > 0.0)) continue;
      near += past <= 0.0;
      if (0.0 < past && past < nearest) nearest = past, beyond = strips.pressure[i];
    }
    if (end.kind == EndKind::singular) {
      // The strip a half-width away from the end, by the half-width there.
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
      errors.remainder += LEFT_AT_END * borne * sharpness / load;
    }
    if (near < FEW_AT_END)
      errors.raised = std::max(errors.raised, (1.0 + RAISED * end.exponent) * beyond / highest - 1.0);
  }
  return errors;
}

/// Ends resolved by few strips at which the bodies overlap less than a half-width inside.
std::vector<bool> falls_away(const Model& model, const Level& level, const Pressures& strips, View singular) {
  std::vector<bool> falls(singular.size());
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
    falls[k] = depth(singular[k]) < (1.0 - FALLS_AWAY) * depth(inside);
  }
  return falls;
}

/// Possible height of summits narrower than their strips, zero for all other strips.
///
/// A summit rises by no more than twice its last increase on halving the strips.
Numbers reaches_of(const Pressures& strips, const Pressures* coarse) {
  const Index n = strips.grid.count();
  Numbers heights(n);
  Index at = 0;
  for (Index i = 1; i + 1 < n; ++i) {
    heights[i] = cusp(strips.pressure, i);
    if (coarse == nullptr) continue;
    const Index last = coarse->grid.count() - 1;
    while (at < last && coarse->grid.high(at) < strips.grid.y[i]) ++at;
    double height = 0.0;
    for (Index j = std::max(at - 1, Index{0}); j <= std::min(at + 1, last); ++j)
      height = std::max(height, coarse->pressure[j]);
    heights[i] = std::min(heights[i], strips.pressure[i] + SAFETY * std::fabs(strips.pressure[i] - height));
  }
  return heights;
}

/// The relative error of the largest pressure, at a place, caused by unresolved relief and peaks.
///
/// Flattening the departure from a parabola within a strip takes a ripple of pressure: the largest pressure may be
/// higher by that, as may another one, which then becomes the largest. A summit may be narrower than its strips, and
/// higher than one that they resolve. And on strips as wide as the contact, a contact that runs out shortly before the
/// end of the bodies looks like one that reaches it: if the profile falls away there, the last strip may have the
/// largest pressure.
double beside_strips(const Pressures& strips, View singular, const std::vector<bool>& falls, View reaches, View ripples,
                     const Largest& largest) {
  const Grid& grid = strips.grid;
  const double highest = largest.value;
  double hidden = 0.0, reached = 0.0, own = 0.0;
  for (Index i = 0; i < grid.count(); ++i) {
    bool counts = strips.half_width[i] > 0.0;
    for (std::size_t k = 0; k < singular.size(); ++k) {
      if (!(std::fabs(grid.y[i] - singular[k]) <= strips.half_width[i])) continue;
      if (falls[k])
        hidden = std::max(hidden, HIDDEN * (strips.pressure[i] / highest - 1.0));
      else
        counts = false;
    }
    const bool is_there = grid.low(i) <= largest.y && largest.y <= grid.high(i);
    if (is_there) own = std::max(own, ripples[i]);
    if (counts) reached = std::max(reached, std::max(reaches[i], strips.pressure[i]) + (is_there ? 0.0 : ripples[i]));
  }
  return std::max(hidden, reached / highest - 1.0) + own / highest;
}

/// Estimate the error of a quantity from its values on successively coarser grids, finest first.
///
/// An error that halves when the strips are halved is as large as the last change. At sharp ends it falls slightly
/// less, and a contact whose end happens to suit the strips can hide it in one change, but hardly in two: the estimate
/// is twice the larger of the last change and half the change before it. If strips follow the ends of the contact,
/// errors fall to a quarter or less, and at most LEFT_OF_CHANGE of the last change remains; but a change may be small
/// by chance: USUALLY_LEFT is the least error of such grids.
double left_of_change(View values, double whole, bool regular) {
  if (values.size() < 2 || !(whole > 0.0)) return INFINITE;
  const double last = std::fabs(values[0] - values[1]) / whole;
  const double before = std::fabs(values[values.size() - 2] - values.back()) / whole;
  if (regular) return LEFT_OF_CHANGE * last;
  return std::isfinite(last + before) ? SAFETY * std::max(last, 0.5 * before) : INFINITE;
}

double relative(double part, double whole) { return whole != 0.0 ? part / std::fabs(whole) : INFINITE; }

bool has_whole_roller(const Model& model) {
  const auto& all = model.contact().references;
  return std::any_of(all.begin(), all.end(),
                     [](const Reference& reference) { return std::holds_alternative<AxisOfRoller>(reference); });
}

/// K Q and K T.
Pair resultant(const Pressures& strips) {
  Pair total{};
  for (Index i = 0; i < strips.grid.count(); ++i)
    total[0] += strips.load[i], total[1] += strips.grid.y[i] * strips.load[i];
  return total;
}

}  // namespace

Errors estimate(const Model& model, const Prescription& prescribed, const Levels& levels, const Ends& ends,
                bool at_corner) {
  const Level& finest = levels.levels[0];
  const double modes = has_whole_roller(model);
  Errors errors{
      INFINITE, INFINITE, INFINITE, INFINITE, INFINITE, LEFT_BY_MODES * modes, PRESSURE_LEFT_BY_MODES * modes};
  if (!finest.state.converged()) return errors;
  const double ratio = model.hertz_ratio();
  const Numbers singular = ends.singular_places();
  std::vector<Pressures> grids;
  for (std::size_t k = 0; k < std::min(LEVELS, levels.levels.size()); ++k) grids.emplace_back(levels.levels[k], ratio);
  const Pressures &strips = grids.front(), &coarse = grids[std::min<std::size_t>(1, grids.size() - 1)];
  const auto largest_of = [&singular](const Pressures& of) {
    return values_that_count(of.grid.y, of.pressure, of.half_width, singular).largest();
  };
  const Largest largest = largest_of(strips);
  const double highest = largest.value, load = resultant(strips)[0], reach = finest.grid->half_length();
  const Unresolved missing = find_unresolved(model, finest, strips, load);
  // Relative to the penetration: the approach before the bodies touch has no error, and may be most of it.
  const double before_touch = finest.state.rigid[0] - missing.penetration;
  std::array<Numbers, 5> values;
  for (std::size_t k = 0; k < grids.size(); ++k) {
    const auto [force, moment] = resultant(grids[k]);
    const auto [approach, tilt] = levels.levels[k].state.rigid;
    const double pressure = k == 0 ? highest : largest_of(grids[k]).value;
    const double of_grid[] = {approach - before_touch, force, pressure, moment, tilt};
    for (int column = 0; column < 5; ++column) values[column].push_back(of_grid[column]);
  }
  double widest = 0.0, longest = 0.0, length = 0.0;
  for (double half : strips.half_width) widest = std::max(widest, 2.0 * half);
  for (const auto& [low, high] : intervals(*finest.grid, finest.state.m))
    longest = std::max(longest, high - low), length += high - low;
  const auto is_kind = [&ends](EndKind kind) { return ends.ends[0].kind == kind || ends.ends[1].kind == kind; };
  // At a corner errors fall only in proportion to the strips, and erratically in contacts wider than long.
  const bool follows = !at_corner && !is_kind(EndKind::corner) && !(widest > WIDER_THAN_LONG * longest);
  const double accuracy = follows ? levels.accuracy : 0.0;
  const bool regular = accuracy > 0.0;
  auto [floor, remainder, raised] = at_ends(strips, ends, length, highest, load);
  remainder += errors.left_by_modes;
  const double usual = std::max(floor, USUALLY_LEFT * accuracy);
  const double wholes[] = {std::fabs(values[0][0]), std::fabs(load), highest, load * reach,
                           missing.penetration / reach};
  std::array<double, 5> of_grids;
  for (int k = 0; k < 5; ++k) of_grids[k] = left_of_change(values[k], wholes[k], k != 2 && regular);
  const auto summit = resolved_summit(strips, largest.y);
  if (summit && grids.size() > 1) of_grids[2] = error_at_summit(strips, *summit, coarse, grids.back(), regular);
  const double unseen = relative(missing.mean, missing.penetration);
  const double unborne = relative(missing.mean * finest.state.stiffness[0][0], load);
  const auto of_motion = [&](double of_grid) { return std::max(usual, of_grid + unseen) + remainder; };
  const auto of_force = [&](double of_grid) { return std::max(usual, of_grid + unborne) + remainder; };
  errors.approach = prescribed.by_force[0] ? of_motion(of_grids[0]) : 0.0;
  errors.load = prescribed.by_force[0] ? 0.0 : of_force(of_grids[1]);
  errors.tilt = prescribed.by_force[1] ? of_motion(of_grids[4]) : 0.0;
  errors.moment = prescribed.by_force[1] ? 0.0 : of_force(of_grids[3]);
  if (at_corner || is_kind(EndKind::cut_off)) return errors;
  const double least =
      std::max(PRESSURE_LEFT * levels.accuracy, summit && is_on_corner(strips, *summit) ? LEFT_ON_CORNER : 0.0);
  const double coarseness = levels.accuracy > ACCURACY ? COARSE : 1.0;
  const double by_strips = std::max({floor, coarseness * std::max(least, of_grids[2]), raised});
  const Numbers reaches = reaches_of(strips, grids.size() > 1 ? &coarse : nullptr);
  const auto falls = falls_away(model, finest, strips, singular);
  errors.max_pressure = by_strips + beside_strips(strips, singular, falls, reaches, missing.ripples, largest) +
                        errors.pressure_left_by_modes;
  return errors;
}

}  // namespace nonhertz
