#include "grids/search.hpp"

#include <algorithm>
#include <cmath>

#include "grids/first.hpp"
#include "grids/overlaps.hpp"
#include "grids/peaks.hpp"
#include "numbers/sums.hpp"
#include "strips/acceptance.hpp"
#include "strips/summit.hpp"

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();

constexpr double STRIP_LIMIT = 40.0;  // of an automatic grid of coarseness 1 on one interval of contact
constexpr double FEWER_STRIPS[] = {1.0, 0.94, 0.88, 0.82, 0.76};  // tried in turn if a grid has no solution
// Fractions of the strips: a rough grid that grades the final one, then half of the final one before all of it; and the
// number of repetitions if the solution shows that another contact was missed or strips are too wide.
constexpr double ROUGH = 0.4, HALF = 0.5;
constexpr int REPEATS = 2;
constexpr double WELL_FILLED = 0.4;  // fraction of the region that the contact must fill before a grid is graded
constexpr int NARROWINGS = 40;
// At this coarseness the error of the approach is below ACCURACY; it falls with about the power ORDER of the width, on
// coarser grids faster and less regularly.
constexpr double COARSENESS = 0.28, ORDER = 2.2, ORDER_COARSER = 3.0;
constexpr double LEAST_FINER = 0.4, MARGIN = 0.95, FULL = 0.97;
// Permitted change of the largest pressure over its accuracy, and permitted sagitta in a strip over the accuracy.
constexpr double OF_PRESSURE = 0.7, PER_SAGITTA = 8.0;
// At the largest pressure: its sagitta in a strip over the accuracy, and the fraction of their width below which strips
// are solved again.
constexpr double POINTED = 5.0, TOO_WIDE = 0.7;

double load_of(const Level& level) {
  Numbers loads(level.grid->y.size());
  for (Index i = 0; i < level.grid->count(); ++i) loads[i] = level.state.r[i] * level.state.m[i] * level.grid->width(i);
  return sum_of(loads);
}

}  // namespace

Search::Search(const Model& model, const Prescription& prescribed, const Accuracy& accuracy, const Stop* stop)
    : model_(model), prescribed_(prescribed), accuracy_(accuracy), stop_(stop), region_(region_of(model, prescribed)) {
  const double order = accuracy.of_motion > ACCURACY ? ORDER_COARSER : ORDER;
  coarseness_ = COARSENESS * std::pow(accuracy.of_motion / ACCURACY, 1.0 / order);
  sagitta_ = std::min(POINTED * accuracy.of_motion, accuracy.of_pressure / PER_SAGITTA);
}

std::vector<Level> Search::run() {
  // The equal strips that find the contact are too few for an error estimate.
  const Level located = locate();
  // A case without a solution ends here, on all levels.
  if (!located.state.converged()) return {located, located, located};
  std::vector<Level> levels{finer(plan(located), located, ROUGH)};
  add_halves(levels);
  for (int k = 0; k < REPEATS; ++k) {
    const Level& finest = levels[0];
    if (too_thin(*finest.grid, model_.kernel(), finest.state.m, 1.0)) break;  // no number of strips helps
    const double finer = finer_wanted(finest, levels[1]);
    const bool is_missing = finest.state.converged() && (is_incomplete(finest) || is_pointed(finest));
    if (!(finer < 1.0 || is_missing)) break;
    coarseness_ *= finer;
    add_halves(levels);
  }
  return levels;
}

/// Solve on equal strips of a region that the contact fills well, from the whole interval inwards.
Level Search::locate() const {
  Level level = solve_level(model_.grid(first_strips(model_, prescribed_, region_->low, region_->high)), nullptr,
                            ROUGH_TOLERANCE, true);
  for (int k = 0; k < NARROWINGS && level.state.converged(); ++k) {
    const auto part = narrower(level);
    if (!part) break;
    level = solve_level(model_.grid(uniform((*part)[0], (*part)[1], COARSE_STRIPS)), nullptr, ROUGH_TOLERANCE, true);
  }
  return level;
}

/// The next region for a contact that fills little of its strips or is cut off; nothing if not needed.
std::optional<Pair> Search::narrower(const Level& level) const {
  const Grid& grid = *level.grid;
  const Numbers& m = level.state.m;
  const auto contact = intervals(grid, m);
  const double first = contact.front()[0], last = contact.back()[1];
  const double low = grid.edges.front(), high = grid.edges.back();
  const bool is_cut = (m.front() > 0.0 && low > model_.low()) || (m.back() > 0.0 && high < model_.high());
  if (!is_cut && last - first > WELL_FILLED * (high - low)) return std::nullopt;
  double narrowest = INFINITE;
  for (Index i = 0; i < grid.count(); ++i) narrowest = std::min(narrowest, grid.width(i));
  const double margin = std::max(0.3 * (last - first), 2.0 * narrowest) * (is_cut ? 4.0 : 1.0);
  return Pair{std::max(first - margin, model_.low()), std::min(last + margin, model_.high())};
}

/// Put solutions on a graded grid and on half of its strips in front; a failed one ends the search.
void Search::add_halves(std::vector<Level>& levels) const {
  if (!levels[0].state.converged()) {
    levels.insert(levels.begin(), 2, Level(levels[0]));
    return;
  }
  const Plan learnt = plan(levels[0]);
  levels.insert(levels.begin(), finer(learnt, levels[0], HALF));
  levels.insert(levels.begin(), finer(learnt, levels[0], 1.0));
}

Plan Search::plan(const Level& from) const {
  return Plan(from, model_, *region_, extras(from), coarseness_, STRIP_LIMIT);
}

/// Solve on a graded grid, or on a slightly coarser one if it has no solution.
///
/// Where a blunt contact ends just at the edge of a strip, that strip can be unable to carry load (its neighbours alone
/// curve the surface more than the bodies do) and yet overlap without it. The next grid has its edges elsewhere. It is
/// also tried when the solution found is unstable, as spurious ones are in contacts several times as wide as long.
Level Search::finer(const Plan& plan, const Level& near, double share) const {
  const double tolerance = share == 1.0 ? TOLERANCE : ROUGH_TOLERANCE;
  for (double fewer : FEWER_STRIPS) {
    const bool is_last = fewer == FEWER_STRIPS[4];
    Level level = solve_level(model_.grid(plan.lay(fewer * share)), &near, tolerance, is_last);
    if (is_last || (level.state.converged() && steady(*level.grid, level.state))) return level;
  }
  return near;
}

/// Places that need strips beside the ends and kinks of the contact.
std::vector<Extra> Search::extras(const Level& level) const {
  std::vector<Extra> places;
  for (const Peak& peak : peaks_of(level, region_->kinks.place, sagitta_)) places.push_back({peak.place, peak.wanted});
  if (suspect(level, region_->samples_with_crests))
    for (const Extra& overlap : overlaps(model_, *region_, level)) places.push_back(overlap);
  return places;
}

Level Search::solve_level(std::shared_ptr<const Grid> grid, const Level* near, double tolerance, bool patient) const {
  Attempt attempt;
  attempt.near = near, attempt.tolerance = tolerance, attempt.patient = patient, attempt.stop = stop_;
  State state = solve_on(*grid, prescribed_, model_.kernel(), attempt);
  return {std::move(grid), std::move(state)};
}

/// Fraction to which strips have to be narrowed for the accuracy; 1 if it is met or cannot be met.
double Search::finer_wanted(const Level& finest, const Level& half) const {
  const double missing = error_over_accuracy(finest, half);
  const bool is_met = !(missing > 1.0) || !(finest.state.converged() && half.state.converged());
  // More strips than the limit are never laid.
  const bool is_spent = static_cast<double>(finest.grid->count()) >= FULL * STRIP_LIMIT / std::min(coarseness_, 1.0);
  return is_met || is_spent ? 1.0 : std::max(LEAST_FINER, MARGIN * std::pow(missing, -1.0 / ORDER));
}

/// The larger of the estimated errors over the accuracy, of approach or load and of the largest pressure; NaN if either
/// is.
double Search::error_over_accuracy(const Level& finest, const Level& half) const {
  const Samples& along = region_->samples;
  double pressed = -INFINITE;
  for (Index i = 0; i < count_of(along.y); ++i)
    pressed = worse(pressed, finest.state.rigid[0] + finest.state.rigid[1] * along.y[i] - along.h[i]);
  const bool by_load = prescribed_.by_force[0];
  const double fine = by_load ? finest.state.rigid[0] : load_of(finest);
  const double coarse = by_load ? half.state.rigid[0] : load_of(half);
  const double error = LEFT_OF_CHANGE * std::fabs(fine - coarse) / (by_load ? std::fabs(pressed) : fine);
  const double missing = error / accuracy_.of_motion;
  if (!std::isfinite(accuracy_.of_pressure)) return missing;
  const double of_pressure = largest_summit_error(finest, half, model_.hertz_ratio());
  return worse(missing, of_pressure / (OF_PRESSURE * accuracy_.of_pressure));
}

/// Whether a contact ends where the bodies do not, or overlaps where no strip is in contact.
bool Search::is_incomplete(const Level& level) const {
  const Grid& grid = *level.grid;
  const View m = level.state.m;
  if (reaches(grid, m, -1) && grid.edges.front() > model_.low()) return true;
  if (reaches(grid, m, 1) && grid.edges.back() < model_.high()) return true;
  return suspect(level, region_->samples_with_crests) && !overlaps(model_, *region_, level).empty();
}

/// Whether the largest pressure is far too pointed for its strips.
bool Search::is_pointed(const Level& level) const {
  const auto peaks = peaks_of(level, region_->kinks.place, sagitta_);
  return std::any_of(peaks.begin(), peaks.end(), [](const Peak& peak) { return peak.wanted < TOO_WIDE * peak.width; });
}

}  // namespace nonhertz
