#include "judging/corners.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nonhertz {
namespace {

constexpr double PI = std::numbers::pi;
// A contact that extends past a corner by less than this, in half-widths, ends there: fine strips extend round it.
constexpr double PAST_CORNER = 0.1;
// The pressure at a corner of angle theta grows by theta / (2 pi^2 K) each time the distance falls by a factor e. If
// that is less than this fraction of it, refinement makes no significant difference.
constexpr double COUNTS = 0.02;
constexpr double LEFT_AT_CORNER = 0.5;  // of the squared pressure in the strip next to it: less is a run-out
constexpr double RUNS_OUT = 0.05;       // of the largest pressure: below this at a corner, the contact runs out there
constexpr double STEP = 1e-5;           // of the length: for differences that distinguish a corner from a curve

/// Finds the corners of the profile at which a contact ends under pressure.
class Corners {
 public:
  Corners(const Bends& bends, View edges, View pressure, View half_width)
      : bends_(bends), edges_(edges), pressure_(pressure), half_width_(half_width), y_(pressure.size()) {
    for (std::size_t i = 0; i < y_.size(); ++i) y_[i] = 0.5 * (edges[i + 1] + edges[i]);
    largest_ = *std::max_element(pressure.begin(), pressure.end());
  }

  Numbers find() {
    const Index n = count_of(y_);
    for (Index first = 0; first < n; ++first) {
      if (!(pressure_[first] > 0.0)) continue;
      Index last = first;
      while (last + 1 < n && pressure_[last + 1] > 0.0) ++last;
      const double widest = *std::max_element(half_width_.begin() + first, half_width_.begin() + last + 1);
      // Outermost strip first; positions times the side increase outwards.
      look_at(first, last, -1, PAST_CORNER * widest);
      look_at(last, first, 1, PAST_CORNER * widest);
      first = last;
    }
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    return std::move(found_);
  }

 private:
  void look_at(Index outer, Index inner_end, int side, double room) {
    const Index beyond = outer + side;
    const bool is_strip = 0 <= beyond && beyond < count_of(y_);
    const double outermost = is_strip ? y_[beyond] : edges_[outer + (side > 0)],
                 inner_edge = edges_[outer + (side < 0)];
    const double inner = std::min(side * inner_edge, side * y_[outer] - room);
    for (double bend : bends_.places)
      if (inner < side * bend && side * bend < side * outermost && presses(bend, side, outer, inner_end))
        found_.push_back(bend);
  }

  /// Whether a bend is a corner at which a contact ends under pressure.
  bool presses(double bend, int side, Index outer, Index inner_end) const {
    Index at = outer;  // becomes the outermost strip within
    for (; !(side * y_[at] < side * bend); at -= side)
      if (at == inner_end) return false;
    const double step = y_.size() > 1 ? STEP * (y_.back() - y_.front()) : STEP;
    const double turn = std::min(turn_at(bend, step), 2.0 * turn_at(bend, 0.1 * step)), beside = pressure_[at];
    if (turn < COUNTS * 2.0 * PI * PI * bends_.compliance * beside || beside < RUNS_OUT * largest_) return false;
    const Index within = std::abs(inner_end - at) + 1;
    if (within == 1) return true;
    if (at != outer && beside < pressure_[at - side]) return false;
    // The square of the pressure falls linearly to zero where a contact runs out. If there are three strips the
    // outermost is left out, because it may also carry the load beyond it.
    const Index last = within > 2 ? at - side : at, next_in = last - side;
    const double square = pressure_[last] * pressure_[last];
    const double fall = (pressure_[next_in] * pressure_[next_in] - square) / std::fabs(y_[next_in] - y_[last]);
    return square - fall * std::fabs(bend - y_[last]) > LEFT_AT_CORNER * square;
  }

  double turn_at(double place, double step) const {
    const Numbers h = bends_.separation(Numbers{place - step, place, place + step});
    return std::isfinite(h[1]) ? (h[2] - h[1]) / step + (h[0] - h[1]) / step : 0.0;
  }

  const Bends& bends_;
  View edges_, pressure_, half_width_;
  Numbers y_, found_;
  double largest_;
};

}  // namespace

Numbers corner_ends(const Bends& bends, View edges, View pressure, View half_width) {
  return Corners(bends, edges, pressure, half_width).find();
}

}  // namespace nonhertz
