#include "grids/levels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "grids/overlaps.hpp"
#include "strips/acceptance.hpp"
#include "strips/start.hpp"
#include "strips/summit.hpp"

namespace nonhertz {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();

constexpr double STRIP_LIMIT = 40.0;  // of an automatic grid of coarseness 1 on one interval of contact
constexpr Index COARSE_STRIPS = 24, COARSEST_LEVEL = 5, FINE_STRIPS = 2000;
constexpr Index MORE_STRIPS[] = {1, 5, 25};                       // to begin with, in case fewer miss the contact
constexpr double FEWER_STRIPS[] = {1.0, 0.94, 0.88, 0.82, 0.76};  // tried in turn where a grid has no solution
// Fractions of the strips: a rough grid that grades the final one, then half of the final one before all of it; and so
// often again, if the solution shows that another contact was missed or strips are too wide.
constexpr double ROUGH = 0.4, HALF = 0.5;
constexpr int REPEATS = 2;
constexpr double WELL_FILLED = 0.4;  // fraction of the region that the contact must fill before a grid is graded
// Measured on 300 random contacts: at this coarseness the error of the approach is below ACCURACY; it falls with about
// the power ORDER of the width, on coarser grids faster and less regularly.
constexpr double COARSENESS = 0.28, ORDER = 2.2, ORDER_COARSER = 3.0;
constexpr double LEAST_FINER = 0.4, MARGIN = 0.95, FULL = 0.97;
// At the largest pressure: its sagitta in a strip over the accuracy, how much narrower strips may become at once, below
// which share of their width they are solved again, by what share another may be less and yet count as the largest.
constexpr double POINTED = 5.0, LEAST_AT_PEAK = 0.2, TOO_WIDE = 0.7, ALIKE = 0.01, AT_KINK = 3.0;

/// Where the largest pressure is too pointed for its strips, the width wanted there, and what they have.
struct Peak {
  double place, wanted, width;
};

/// Find them on either side of y = 0, where pressures are equal that mirror each other.
std::vector<Peak> peaks_of(const Level& level, const Numbers& kinks, double accuracy) {
  const Grid& grid = *level.grid;
  const Index n = grid.count();
  Numbers pressure(n);
  for (Index i = 0; i < n; ++i) pressure[i] = level.state.r[i] * std::sqrt(level.state.m[i]);
  const double highest = *std::max_element(pressure.begin(), pressure.end());
  std::vector<Peak> found;
  for (const bool high_side : {false, true}) {
    Index at = -1;
    double reached = (1.0 - ALIKE) * highest;
    for (Index i = 1; i + 1 < n; ++i) {
      // A lower summit may be the largest pressure, if it is more pointed than its strips can tell.
      if ((grid.edges[i] + grid.edges[i + 1] >= 0.0) != high_side) continue;
      const double sagittas = is_cusp(pressure, i) ? CUSP : 1.0;
      const double reach = pressure[i] * (1.0 + sagittas * std::max(0.0, sagitta(pressure, i)));
      if (reach > reached && is_summit(pressure, i)) at = i, reached = reach;
    }
    if (at <= 0) continue;
    const double bend = sagitta(pressure, at), width = grid.width(at);
    bool pointed = bend > POINTED * accuracy;
    for (double kink : kinks) pointed = pointed && !(std::fabs(grid.y[at] - kink) < AT_KINK * width);  // no limit there
    if (pointed)
      found.push_back({grid.y[at], width * std::max(std::sqrt(POINTED * accuracy / bend), LEAST_AT_PEAK), width});
  }
  return found;
}

double load_of(const Level& level) {
  double load = 0.0;
  for (Index i = 0; i < level.grid->count(); ++i) load += level.state.r[i] * level.state.m[i] * level.grid->width(i);
  return load;
}

double arm_of(const Prescription& given) { return given.target[1] / given.target[0]; }

void refuse_arm_outside(const Prescription& given, double low, double high) {
  if (given.both() && !(low <= arm_of(given) && arm_of(given) <= high))
    throw Refused(Refused::Why::arm_outside, arm_of(given), low, high);
}

void refuse_endless_relief(View y, View separation) {
  bool any = false;
  for (Index i = 0; i < count_of(y); ++i) {
    if (std::isnan(separation[i])) throw Refused(Refused::Why::nan_relief, y[i]);
    any = any || std::isfinite(separation[i]);
  }
  if (!any) throw Refused(Refused::Why::endless_relief);
}

/// The response of independent springs, which is not a solution.
Level springs(const Model& model, const Prescription& given, Numbers edges) {
  Level found{model.springs(std::move(edges)), State(0)};
  found.state = State(found.grid->count());
  start_from_springs(*found.grid, given, model.kernel(), found.state);
  return found;
}

bool touches_anywhere(View m) {
  return std::any_of(m.begin(), m.end(), [](double each) { return each > 0.0; });
}

bool feasible(const Model& model, const Grid& grid, const Prescription& given) {
  try {
    refuse_infeasible(model, grid, given);
  } catch (const Refused&) {
    return false;
  }
  return true;
}

/// Return the interval in which springs find contact, with a margin.
Pair neighbourhood(const Model& model, const Prescription& given) {
  double low = model.low(), high = model.high();
  for (int k = 0; k < 3; ++k) {
    const Level fine = springs(model, given, uniform(low, high, FINE_STRIPS));
    const Numbers& m = fine.state.m;
    const auto touching = [](double each) { return each > 0.0; };
    const auto first = std::find_if(m.begin(), m.end(), touching);
    double margin = (high - low) / FINE_STRIPS;
    if (first != m.end()) {
      const double from = fine.grid->low(first - m.begin());
      const double to = fine.grid->high(m.rend() - std::find_if(m.rbegin(), m.rend(), touching) - 1);
      margin += 0.3 * (to - from);
      return {std::max(low, from - margin), std::min(high, to + margin)};
    }
    Index nearest = 0;
    for (Index i = 0; i < fine.grid->count(); ++i)
      if (fine.state.interference(*fine.grid, i) > fine.state.interference(*fine.grid, nearest)) nearest = i;
    low = std::max(low, fine.grid->y[nearest] - 2.0 * margin),
    high = std::min(high, fine.grid->y[nearest] + 2.0 * margin);
  }
  return {low, high};
}

/// Return equal strips that can meet what is prescribed: all along the bodies, or near where they touch.
std::shared_ptr<const Grid> first_strips(const Model& model, const Prescription& given) {
  auto grid = model.springs(uniform(model.low(), model.high(), COARSE_STRIPS));
  refuse_endless_relief(grid->y, grid->separation);
  // Where the load is given and the moment is not, any strips will do. A prescribed approach may bring only a tiny spot
  // into contact, a moment only the very end.
  if (given.by_force[0] && (!given.by_force[1] || feasible(model, *grid, given))) return grid;
  refuse_arm_outside(given, model.low(), model.high());
  std::vector<Pair> regions{neighbourhood(model, given)};
  if (given.both()) {  // at one end of the bodies, centred on the resultant of load and moment
    const double arm = arm_of(given), low = model.low(), high = model.high();
    const bool at_high = high - arm < arm - low;
    regions.push_back(at_high ? Pair{std::max(low, 2.0 * arm - high), high}
                              : Pair{low, std::min(high, 2.0 * arm - low)});
  }
  for (const auto& [low, high] : regions)
    for (Index more : MORE_STRIPS) {
      grid = model.springs(uniform(low, high, more * COARSE_STRIPS));
      if (feasible(model, *grid, given)) return grid;
    }
  refuse_infeasible(model, *grid, given);
  return grid;
}

/// Leave out coarser levels that have no solution.
void drop_unsolved(std::vector<Level>& levels) {
  const auto unsolved = [](const Level& each) { return !each.state.converged(); };
  levels.erase(std::remove_if(levels.begin() + 1, levels.end(), unsolved), levels.end());
}

/// Solves one case on ever better grids.
class Search {
 public:
  Search(const Model& model, const Prescription& given, double accuracy, const Stop* stop)
      : model_(model), given_(given), accuracy_(accuracy), stop_(stop) {
    const double order = accuracy > ACCURACY ? ORDER_COARSER : ORDER;
    coarseness_ = COARSENESS * std::pow(accuracy / ACCURACY, 1.0 / order);
  }

  std::vector<Level> run() {
    // The equal strips that find the contact are too few to say anything about the error.
    const Level located = locate();
    std::vector<Level> levels{finer(located, located, ROUGH)};
    add_halves(levels);
    for (int k = 0; k < REPEATS; ++k) {
      const double finer = finer_wanted(levels);
      const bool again = finer < 1.0 || (levels[0].state.converged() && (incomplete(levels[0]) || pointed(levels[0])));
      if (too_thin(*levels[0].grid, model_.kernel(), levels[0].state.m, 1.0) || !again) break;
      coarseness_ *= finer;
      add_halves(levels);
    }
    return levels;
  }

 private:
  Level solved(std::shared_ptr<const Grid> grid, const Level* near, double tolerance, bool patient) const {
    Attempt attempt;
    attempt.near = near, attempt.tolerance = tolerance, attempt.patient = patient, attempt.stop = stop_;
    State state = solve_on(*grid, given_, model_.kernel(), attempt);
    return {std::move(grid), std::move(state)};
  }

  /// Solve on equal strips of a region that the contact fills well.
  Level locate() const {
    const auto first = first_strips(model_, given_);
    Level level = solved(model_.grid(first->edges), nullptr, ROUGH_TOLERANCE, true);
    for (int k = 0; k < 40 && level.state.converged(); ++k) {
      const auto [low, high] = narrower(level);
      if (!(low < high)) break;
      level = solved(model_.grid(uniform(low, high, COARSE_STRIPS)), nullptr, ROUGH_TOLERANCE, true);
    }
    return level;
  }

  /// Where to look again for a contact that fills little of its strips or is cut off; nothing if it need not.
  Pair narrower(const Level& level) const {
    const Grid& grid = *level.grid;
    const Numbers& m = level.state.m;
    const auto contact = intervals(grid, m);
    const double first = contact.front()[0], last = contact.back()[1];
    const double low = grid.edges.front(), high = grid.edges.back();
    const bool cut = (m.front() > 0.0 && low > model_.low()) || (m.back() > 0.0 && high < model_.high());
    if (!cut && last - first > WELL_FILLED * (high - low)) return {0.0, 0.0};
    double narrowest = INFINITE;
    for (Index i = 0; i < grid.count(); ++i) narrowest = std::min(narrowest, grid.width(i));
    const double margin = std::max(0.3 * (last - first), 2.0 * narrowest) * (cut ? 4.0 : 1.0);
    return {std::max(first - margin, model_.low()), std::min(last + margin, model_.high())};
  }

  /// Put solutions on a graded grid and on half of its strips in front.
  void add_halves(std::vector<Level>& levels) const {
    const Level learnt_from = levels[0];
    levels.insert(levels.begin(), finer(learnt_from, learnt_from, HALF));
    levels.insert(levels.begin(), finer(learnt_from, levels[0], 1.0));
  }

  /// Solve on a graded grid, or on a slightly coarser one where it has no solution.
  ///
  /// Where a blunt contact ends just at the edge of a strip, that strip can be unable to carry load and yet overlap
  /// without it. The next grid has its edges elsewhere. It is also tried when the solution found is unstable.
  Level finer(const Level& from, const Level& near, double share) const {
    if (!from.state.converged()) return from;
    std::vector<Extra> extras;
    for (const Peak& peak : peaks_of(from, model_.region()->kinks.place, accuracy_))
      extras.push_back({peak.place, peak.wanted});
    if (suspect(from, model_.region()->surveyed))
      for (const Extra& each : overlaps(model_, from)) extras.push_back(each);
    Level found = near;
    for (double fewer : FEWER_STRIPS) {
      auto grid = model_.grid(lay(from, model_, extras, {coarseness_, fewer * share, STRIP_LIMIT}));
      const bool last = fewer == FEWER_STRIPS[4];
      found = solved(std::move(grid), &near, share == 1.0 ? TOLERANCE : ROUGH_TOLERANCE, last);
      if (found.state.converged() && steady(*found.grid, found.state)) break;
    }
    return found;
  }

  /// By what share strips have to be narrower for the accuracy to be met; 1 where it is or cannot be.
  double finer_wanted(const std::vector<Level>& levels) const {
    const Level &finest = levels[0], &half = levels[1];
    const Samples& along = model_.region()->sampled;
    double pressed = -INFINITE;
    for (Index i = 0; i < count_of(along.y); ++i)
      pressed = std::max(pressed, finest.state.rigid[0] + finest.state.rigid[1] * along.y[i] - along.h[i]);
    const bool by_load = given_.by_force[0];
    const double fine = by_load ? finest.state.rigid[0] : load_of(finest);
    const double coarse = by_load ? half.state.rigid[0] : load_of(half);
    const double error = LEFT_OF_CHANGE * std::fabs(fine - coarse) / (by_load ? std::fabs(pressed) : fine);
    const bool met = !(error > accuracy_) || !(finest.state.converged() && half.state.converged());
    // More strips than the limit are not laid, whatever is asked for.
    const bool spent = static_cast<double>(finest.grid->count()) >= FULL * STRIP_LIMIT / std::min(coarseness_, 1.0);
    return met || spent ? 1.0 : std::max(LEAST_FINER, MARGIN * std::pow(accuracy_ / error, 1.0 / ORDER));
  }

  /// Whether a contact ends where the bodies do not, or overlaps where no strip is in contact.
  bool incomplete(const Level& level) const {
    const Grid& grid = *level.grid;
    const View m = level.state.m;
    if (reaches(grid, m, -1) && grid.edges.front() > model_.low()) return true;
    if (reaches(grid, m, 1) && grid.edges.back() < model_.high()) return true;
    return suspect(level, model_.region()->surveyed) && !overlaps(model_, level).empty();
  }

  /// Whether the largest pressure is far too pointed for its strips.
  bool pointed(const Level& level) const {
    const auto peaks = peaks_of(level, model_.region()->kinks.place, accuracy_);
    return std::any_of(peaks.begin(), peaks.end(),
                       [](const Peak& each) { return each.wanted < TOO_WIDE * each.width; });
  }

  const Model& model_;
  const Prescription& given_;
  double accuracy_, coarseness_;
  const Stop* stop_;
};

}  // namespace

void refuse_infeasible(const Model& model, const Grid& grid, const Prescription& given) {
  refuse_endless_relief(grid.y, grid.separation);
  const auto is_finite = [](double h) { return std::isfinite(h); };
  const Numbers& h = grid.separation;
  if (given.both()) {
    const double first = grid.y[std::find_if(h.begin(), h.end(), is_finite) - h.begin()];
    const double last = grid.y[h.rend() - std::find_if(h.rbegin(), h.rend(), is_finite) - 1];
    if (!(first <= arm_of(given) && arm_of(given) <= last))
      throw Refused(Refused::Why::no_strip_between, arm_of(given), first, last);
  } else if (given.by_force[1]) {
    if (!touches_anywhere(springs(model, given, grid.edges).state.m))
      throw Refused(Refused::Why::tilted_apart, given.target[0]);
  } else if (!given.by_force[0]) {
    for (Index i = 0; i < grid.count(); ++i)
      if (given.target[0] + given.target[1] * grid.y[i] - h[i] > 0.0) return;
    throw Refused(Refused::Why::no_contact, given.target[0], grid.edges.front(), grid.edges.back());
  }
}

Levels solve_automatically(const Model& model, const Prescription& given, double accuracy, const Stop* stop) {
  std::vector<Level> levels = Search(model, given, accuracy, stop).run();
  const bool regular = levels[1].state.converged();
  drop_unsolved(levels);
  return {std::move(levels), regular ? accuracy : 0.0};
}

std::vector<std::shared_ptr<const Grid>> equal_grids(const Model& model, Index count) {
  std::vector<std::shared_ptr<const Grid>> grids;
  for (Index level = count;; level /= 2) {
    grids.push_back(model.grid(uniform(model.low(), model.high(), level)));
    if (!(level / 2 >= COARSEST_LEVEL || (grids.size() == 1 && count > 1))) return grids;
  }
}

Levels solve_on_grids(const Model& model, const std::vector<std::shared_ptr<const Grid>>& grids,
                      const Prescription& given, const State* before, const Prescription& of_before, const Stop* stop) {
  Levels found;
  for (auto grid = grids.rbegin(); grid != grids.rend(); ++grid) {
    const bool last = *grid == grids.front();
    Attempt attempt;
    attempt.near = found.levels.empty() ? nullptr : &found.levels[0];
    attempt.tolerance = last ? TOLERANCE : ROUGH_TOLERANCE, attempt.patient = last, attempt.stop = stop;
    if (last) attempt.before = before, attempt.of_before = of_before;
    State state = solve_on(**grid, given, model.kernel(), attempt);
    found.levels.insert(found.levels.begin(), {*grid, std::move(state)});
  }
  drop_unsolved(found.levels);
  return found;
}

}  // namespace nonhertz
