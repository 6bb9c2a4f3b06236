// The ends of a contact on either side: a run-out, the end of the bodies, a corner, or the end of the strips.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "judging/corners.hpp"
#include "judging/judgement.hpp"

namespace nonhertz {
namespace {

constexpr double PI = std::numbers::pi;
constexpr double AT_ONE_PLACE = 0.01;  // of the last strip
// kappa at and above which the pressure counts as finite up to an end.
constexpr double FINITE_FROM = 0.999;
constexpr double SAME_PLACE = 1e-9;  // of the length

/// The slope that a pressure s^-alpha leaves on the surfaces of two wedges: zero for the exponent of an end.
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

/// alpha of a pressure that varies as s^-alpha with the distance from an end, and the exponent of its correction.
Pair edge_exponents(double kappa, double free) {
  const double mirrored = std::acos(std::min(kappa, 1.0)) / PI;
  const double alpha = free > 0.0 && kappa < 1.0 ? zero_between(0.0, mirrored, kappa, free) : mirrored;
  const double second = free > 0.0 ? -zero_between(0.0, -1.0, kappa, free) : alpha;
  return {alpha, second + alpha};
}

/// The end of a contact that extends to the end of its strips.
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

/// The width of the strip in contact nearest to a place.
double step_at(const Level& level, double place) {
  const Grid& grid = *level.grid;
  Index nearest = -1;
  for (Index i = 0; i < grid.count(); ++i) {
    const bool bears = level.state.r[i] * level.state.m[i] > 0.0;
    if (bears && (nearest < 0 || std::fabs(grid.y[i] - place) < std::fabs(grid.y[nearest] - place))) nearest = i;
  }
  return nearest < 0 ? 0.0 : grid.width(nearest);
}

}  // namespace

Numbers Ends::singular_places() const {
  Numbers places;
  for (const SingularEnd& end_here : singular) places.push_back(end_here.y);
  return places;
}

Ends ends_of(const Model& model, const Level& level) {
  const Grid& grid = *level.grid;
  const State& state = level.state;
  const auto contact = intervals(grid, state.m);
  Ends result;
  for (int column = 0; column < 2; ++column) {
    const int side = 2 * column - 1;
    End& end = result.ends[column];
    const double last = column ? grid.edges.back() : grid.edges.front();
    end.y = contact.empty() ? last : column ? contact.back()[1] : contact[0][0];
    // Undeformed bodies that do not overlap at the end of the strips cannot touch there: the last strip may be wider
    // than the remainder of a contact that runs out close to the end.
    const bool touching =
        reaches(grid, state.m, side) && state.rigid[0] + state.rigid[1] * last > model.separation(last);
    if (touching) end = body_end(model, grid, side);
    if (end.kind == EndKind::singular) result.singular.push_back({end.y, false, step_at(level, end.y)});
  }
  const auto bears = [](double m) { return m > 0.0; };
  const Index first = std::find_if(state.m.begin(), state.m.end(), bears) - state.m.begin();
  if (first == grid.count()) return result;
  const Index last = state.m.rend() - std::find_if(state.m.rbegin(), state.m.rend(), bears) - 1;
  Numbers pressure(grid.y.size()), half_width(grid.y.size());
  for (Index i = 0; i < grid.count(); ++i) {
    const double root = std::sqrt(state.m[i]);
    pressure[i] = 2.0 * (state.r[i] * root) / (PI * model.hertz_ratio() * model.contact().compliance);
    half_width[i] = model.hertz_ratio() * root;
  }
  const auto separation = [&model](View y) { return model.separation(y); };
  const Bends bends{model.contact().bends, model.contact().compliance, separation};
  for (double corner : state.converged() ? corner_ends(bends, grid.edges, pressure, half_width) : Numbers{}) {
    for (int column = 0; column < 2; ++column) {
      const int side = 2 * column - 1;
      const Index at = column ? last : first;
      End& end = result.ends[column];
      if (end.kind == EndKind::run_out && side * corner > side * grid.y[at] - grid.width(at))
        end.kind = EndKind::corner, end.y = corner, end.width = grid.width(at);
    }
    const double room = SAME_PLACE * (grid.edges.back() - grid.edges.front());
    const auto is_apart = [&](const SingularEnd& end) { return std::fabs(corner - end.y) > room; };
    if (std::all_of(result.singular.begin(), result.singular.end(), is_apart))
      result.singular.push_back({corner, true, step_at(level, corner)});
  }
  std::sort(result.singular.begin(), result.singular.end(),
            [](const SingularEnd& one, const SingularEnd& other) { return one.y < other.y; });
  for (int column = 0; column < 2; ++column)
    if (result.ends[column].kind != EndKind::run_out) result.ends[column].pressure = pressure[column ? last : first];
  return result;
}

}  // namespace nonhertz
