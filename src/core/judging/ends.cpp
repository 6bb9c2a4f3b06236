// How a contact ends on either side: it runs out, or reaches the end of the bodies, a corner, or the end of the strips.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "judging/judgement.hpp"

namespace nonhertz {
namespace {

constexpr double PI = std::numbers::pi;
constexpr double AT_ONE_PLACE = 0.01;  // of the last strip
// kappa at and above which the pressure counts as finite up to an end.
constexpr double FINITE_FROM = 0.999;
// A contact that extends past a corner by less than this, in half-widths, ends there: fine strips reach round it.
constexpr double PAST_CORNER = 0.1;
// The pressure at a corner that turns by theta grows by theta / (2 pi^2 K) each time the distance falls by a factor e.
// Where that is less than this fraction of it, refinement makes no significant difference.
constexpr double COUNTS = 0.02;
constexpr double LEFT_AT_CORNER = 0.5;  // of the squared pressure in the strip next to it: less is a run-out
constexpr double RUNS_OUT = 0.05;       // of the largest pressure: where less is left at a corner, it runs out there
constexpr double STEP = 1e-5;           // of the length: of differences that distinguish a corner from a curve

/// The slope that a pressure s^-alpha leaves on the surfaces of two wedges: zero for that of an end.
double wedge_slope(double alpha, double kappa, double free) {
  const double cosine = std::cos(PI * alpha), brought = (1.0 - alpha) / std::cos(0.5 * PI * alpha);
  const double square = brought * brought;
  return cosine - kappa - free * (1.0 - cosine) * square / (1.0 - square);
}

double zero_between(double positive, double negative, double kappa, double free) {
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (positive + negative);
    (wedge_slope(middle, kappa, free) > 0.0 ? positive : negative) = middle;
  }
  return 0.5 * (positive + negative);
}

/// alpha of a pressure that varies with the distance from an end as s^-alpha, and the exponent of its correction.
Pair edge_exponents(double kappa, double free) {
  const double mirrored = std::acos(std::min(kappa, 1.0)) / PI;
  const double alpha = free > 0.0 && kappa < 1.0 ? zero_between(0.0, mirrored, kappa, free) : mirrored;
  const double second = free > 0.0 ? -zero_between(0.0, -1.0, kappa, free) : alpha;
  return {alpha, second + alpha};
}

/// How a contact ends that extends to the end of its strips.
End body_end(const Model& model, const Grid& grid, int side) {
  const Index last = side > 0 ? grid.count() - 1 : 0;
  End end;
  end.y = side > 0 ? grid.edges.back() : grid.edges.front(), end.width = grid.width(last);
  if (end.y != model.low() && end.y != model.high()) {
    end.kind = EndKind::cut_off;
    return end;
  }
  double free = 0.0;
  for (const FreedFace& face : model.contact().freed)
    if (face.side == side && std::fabs(face.y - end.y) <= AT_ONE_PLACE * end.width)
      end.image_weight += face.image_weight, free += face.free;
  end.image_weight = std::min(end.image_weight, 1.0);
  end.kind = end.image_weight >= FINITE_FROM ? EndKind::finite : EndKind::singular;
  if (end.kind == EndKind::singular) {
    const auto [first, second] = edge_exponents(end.image_weight, std::min(free, 1.0));
    end.exponent = first, end.correction_exponent = second;
  }
  return end;
}

/// Finds the corners of the profile at which a contact ends under pressure.
class Corners {
 public:
  Corners(const Model& model, const Level& level) : model_(model), grid_(*level.grid), pressure_(level.state.r.size()) {
    const double per = 2.0 / (PI * model.hertz_ratio() * model.contact().compliance);
    for (Index i = 0; i < grid_.count(); ++i) pressure_[i] = per * level.state.r[i] * std::sqrt(level.state.m[i]);
    largest_ = *std::max_element(pressure_.begin(), pressure_.end());
    find(level.state);
  }
  const Numbers& found() const { return found_; }

 private:
  void find(const State& state) {
    const Index n = grid_.count();
    for (Index first = 0; first < n; ++first) {
      if (!(pressure_[first] > 0.0)) continue;
      Index last = first;
      while (last + 1 < n && pressure_[last + 1] > 0.0) ++last;
      double widest = 0.0;
      for (Index i = first; i <= last; ++i) widest = std::max(widest, model_.hertz_ratio() * std::sqrt(state.m[i]));
      // Outermost strip first; multiplied by the side, positions increase outwards.
      look_at(first, last, -1, PAST_CORNER * widest);
      look_at(last, first, 1, PAST_CORNER * widest);
      first = last;
    }
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
  }

  void look_at(Index outer, Index inner_end, int side, double room) {
    const Index beyond = outer + side;
    const bool is_strip = 0 <= beyond && beyond < grid_.count();
    const double outermost = is_strip ? grid_.y[beyond] : side > 0 ? grid_.high(outer) : grid_.low(outer);
    const double inner_edge = side > 0 ? grid_.low(outer) : grid_.high(outer);
    const double inner = std::min(side * inner_edge, side * grid_.y[outer] - room);
    for (double bend : model_.contact().bends)
      if (inner < side * bend && side * bend < side * outermost && presses(bend, side, outer, inner_end))
        found_.push_back(bend);
  }

  /// Whether a bend is a corner that a contact presses against.
  bool presses(double bend, int side, Index outer, Index inner_end) const {
    Index at = outer;  // becomes the outermost strip within
    for (; !(side * grid_.y[at] < side * bend); at -= side)
      if (at == inner_end) return false;
    const double length = grid_.count() > 1 ? grid_.y.back() - grid_.y.front() : 1.0, step = STEP * length;
    const double turn = std::min(turn_at(bend, step), 2.0 * turn_at(bend, 0.1 * step)), beside = pressure_[at];
    if (turn < COUNTS * 2.0 * PI * PI * model_.contact().compliance * beside || beside < RUNS_OUT * largest_)
      return false;
    const Index within = std::abs(inner_end - at) + 1;
    if (within == 1) return true;
    if (at != outer && beside < pressure_[at - side]) return false;
    // The square of the pressure falls linearly to zero where a contact runs out. Given three strips the outermost is
    // left out, because it may carry load for what lies beyond it.
    const Index last = within > 2 ? at - side : at, next_in = last - side;
    const double square = pressure_[last] * pressure_[last];
    const double fall =
        (pressure_[next_in] * pressure_[next_in] - square) / std::fabs(grid_.y[next_in] - grid_.y[last]);
    return square - fall * std::fabs(bend - grid_.y[last]) > LEFT_AT_CORNER * square;
  }

  double turn_at(double place, double step) const {
    const Numbers h = model_.separation(Numbers{place - step, place, place + step});
    return std::isfinite(h[1]) ? (h[2] - h[1]) / step + (h[0] - h[1]) / step : 0.0;
  }

  const Model& model_;
  const Grid& grid_;
  Numbers pressure_, found_;
  double largest_;
};

}  // namespace

Ends ends_of(const Model& model, const Level& level) {
  const Grid& grid = *level.grid;
  const State& state = level.state;
  const auto contact = intervals(grid, state.m);
  Ends found;
  for (int column = 0; column < 2; ++column) {
    const int side = 2 * column - 1;
    End& end = found.ends[column];
    end.y = contact.empty() ? (column ? grid.edges.back() : grid.edges.front())
            : column        ? contact.back()[1]
                            : contact[0][0];
    // Where undeformed bodies do not overlap at the end of the strips, they cannot touch there: the last strip may be
    // wider than the remainder of a contact that runs out close to the end.
    const double last = column ? grid.edges.back() : grid.edges.front();
    const bool touching =
        reaches(grid, state.m, side) && state.rigid[0] + state.rigid[1] * last > model.separation(last);
    if (touching) end = body_end(model, grid, side);
    if (end.kind == EndKind::singular) found.singular.push_back(end.y);
  }
  if (model.contact().bends.empty()) return found;
  const Corners corners(model, level);
  const auto bears = [](double m) { return m > 0.0; };
  const Index first = std::find_if(state.m.begin(), state.m.end(), bears) - state.m.begin();
  const Index last = state.m.rend() - std::find_if(state.m.rbegin(), state.m.rend(), bears) - 1;
  for (double corner : corners.found()) {
    for (int column = 0; column < 2; ++column) {
      const int side = 2 * column - 1;
      const Index at = column ? last : first;
      End& end = found.ends[column];
      if (end.kind == EndKind::run_out && side * corner > side * grid.y[at] - grid.width(at))
        end.kind = EndKind::corner, end.y = corner, end.width = grid.width(at);
    }
    found.singular.push_back(corner);
  }
  return found;
}

}  // namespace nonhertz
