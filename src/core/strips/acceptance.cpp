#include "strips/acceptance.hpp"

#include <algorithm>
#include <cmath>

#include "strips/influence.hpp"

namespace nonhertz {
namespace {

// A thousand times the loop's own tolerance: sums in another order differ by rounding, wrong answers by far more.
// Curvature rows are met only to the square of the last step.
constexpr double TOLERANCE = 1e-8, CURVATURE_TOLERANCE = 1e-6;
constexpr double ROUNDING = 1e-14;    // relative to the largest of the lengths whose difference is a gap
constexpr double MOST_HIDDEN = 1e-2;  // largest rounding as a fraction of the interference
constexpr double UNSTEADY = -1e-6;    // of the stiffness against approach times reach^2: smaller values are rounding

Shortfall check_values(const Grid& grid, const Answer& answer) {
  const auto& [q, half_width, gap, motion] = answer;
  for (Index i = 0; i < grid.count(); ++i) {
    const bool unknown = std::isnan(gap[i]) || std::isnan(grid.separation[i]);
    const bool known = std::isfinite(motion[0] + motion[1]) && std::isfinite(q[i]) && std::isfinite(half_width[i]);
    const bool has_pressure = half_width[i] > 0.0 && std::isfinite(q[i] / half_width[i]);
    if (unknown || !known || (q[i] > 0.0 && !has_pressure)) return {Unmet::not_finite, q[i], i};
    if (q[i] < 0.0) return {Unmet::tension, q[i], i};
  }
  return {};
}

Shortfall check_balance(const Grid& grid, const Answer& answer, const Prescription& prescribed) {
  double load = 0.0, moment = 0.0;
  for (Index i = 0; i < grid.count(); ++i) {
    const double carried = answer.q[i] * grid.width(i);
    load += carried;
    moment += carried * grid.y[i];
  }
  const Pair &target = prescribed.target, &rigid = answer.motion;
  const double first = prescribed.by_force[0] ? load : rigid[0], second = prescribed.by_force[1] ? moment : rigid[1];
  if (!(std::fabs(first - target[0]) <= TOLERANCE * std::fabs(target[0]))) return {Unmet::first, first, 0};
  // A moment is as accurate as the load at the longest lever arm.
  const double reach = std::max(std::fabs(grid.y.front()), std::fabs(grid.y.back()));
  const double scale = prescribed.by_force[1] ? load * reach : std::fabs(target[1]);
  if (!(std::fabs(second - target[1]) <= TOLERANCE * scale)) return {Unmet::second, second, 0};
  return {};
}

/// Add the correction for a free side face: by its table if place and source are close to it, else by its series.
void add_face(const Grid& grid, const Answer& answer, const Kernel& kernel, const Face& face, Row lift, Row bend) {
  const Numbers &q = answer.q, &half_width = answer.half_width;
  const Index n = grid.count();
  const double *powers = kernel.element->table.data() + POWERS_AT, *table = face.table->data();
  double unit = 0.0;
  for (Index j = 0; j < n; ++j)
    if (q[j] > 0.0) unit = std::max(unit, half_width[j]);
  const auto away_from_face = [&](double y) { return std::max(face.side * (face.place - y), 0.0) / unit; };
  Numbers u(n);
  for (Index i = 0; i < n; ++i) u[i] = away_from_face(grid.y[i]);
  Matrix of_edges[2] = {Matrix(1 + POWERS, n + TILE), Matrix(1 + POWERS, n + TILE)}, work(2, n + TILE);
  Squares cache;
  // The upper edge of a strip is the lower edge of the next.
  double at_low = away_from_face(grid.low(0));
  far_terms(u, at_low, table, of_edges[0], work);
  for (Index j = 0; j < n; ++j) {
    const double at_high = away_from_face(grid.high(j)), inner = std::min(at_low, at_high),
                 outer = std::max(at_low, at_high);
    const Matrix& of_low = of_edges[j % 2];
    Matrix& of_high = of_edges[1 - j % 2];
    far_terms(u, at_high, table, of_high, work);
    at_low = at_high;
    if (!(q[j] > 0.0)) continue;
    const double inverse = 1.0 / half_width[j], ratio = (half_width[j] / unit) * (half_width[j] / unit);
    const double by_bend = face.weight * q[j] * inverse * inverse;
    for (Index i = 0; i < n; ++i) {
      if ((u[i] + inner) * unit * inverse < AWAY) {
        const Four near = face_influence(grid.y[i], grid.low(j), grid.high(j), inverse, face, *kernel.element, cache);
        lift[i] += face.weight * q[j] * near.a();
        bend[i] += by_bend * near.b();
        continue;
      }
      const bool within = inner <= u[i] && u[i] < outer;
      double power = 1.0, risen = 0.0, curved = 0.0;
      for (int p = 0; p <= POWERS; ++p) {
        double part = face.side * (of_low(p, i) - of_high(p, i));
        if (within) part += far_whole(u[i], p, table);
        if (p == 0) {
          risen = part;
        } else {
          power *= ratio;
          risen += power * part * powers[2 * p - 2];
          curved += power * part * powers[2 * p - 1];
        }
      }
      lift[i] += face.weight * q[j] * risen;
      bend[i] += by_bend * curved;
    }
  }
}

/// Find displacement [mm] and curvature [1/mm] of both surfaces together at every strip, on the centre line.
std::array<Numbers, 2> lift_and_bend(const Grid& grid, const Answer& answer, const Kernel& kernel) {
  const Numbers& q = answer.q;
  const double* table = kernel.element->table.data();
  const Index n = grid.count();
  Numbers lift(n), bend(n);
  const auto looked_at = [&](Index i) { return q[i] > 0.0 || std::isfinite(grid.separation[i]); };
  for (Index j = 0; j < n; ++j) {
    if (!(q[j] > 0.0)) continue;
    const double inverse = 1.0 / answer.half_width[j], by_bend = q[j] * inverse * inverse;
    for (const Term& term : kernel.terms) {
      const double weight = term.sign * term.weight;
      const double high = term.sign * grid.high(j) + term.offset, low = term.sign * grid.low(j) + term.offset;
      for (Index i = 0; i < n; ++i) {
        if (!looked_at(i)) continue;
        const Four s = evaluate((high - grid.y[i]) * inverse, table) - evaluate((low - grid.y[i]) * inverse, table);
        lift[i] += q[j] * weight * s.a();
        bend[i] += by_bend * weight * s.b();
      }
    }
    lift[j] += q[j] * by_own_width(grid.by_width, j, answer.half_width[j])[0];
    if (!grid.at_depth.empty())
      for (Index i = 0; i < n; ++i)
        if (looked_at(i)) lift[i] -= q[j] * grid.at_depth(i, j);
  }
  for (const Face& face : kernel.faces) add_face(grid, answer, kernel, face, lift, bend);
  return {lift, bend};
}

}  // namespace

Shortfall first_unmet(const Grid& grid, const Prescription& prescribed, const Kernel& kernel, const State& state) {
  const Index n = grid.count();
  Answer answer{Numbers(n), Numbers(n), state.gap, state.rigid};
  for (Index i = 0; i < n; ++i) {
    answer.q[i] = state.r[i] * state.m[i];
    answer.half_width[i] = std::sqrt(state.m[i]);
  }
  return first_unmet(grid, prescribed, kernel, answer);
}

Shortfall first_unmet(const Grid& grid, const Prescription& prescribed, const Kernel& kernel, const Answer& answer) {
  if (const Shortfall shortfall = check_values(grid, answer); shortfall.condition != Unmet::none) return shortfall;
  if (const Shortfall shortfall = check_balance(grid, answer, prescribed); shortfall.condition != Unmet::none)
    return shortfall;
  const Pair& rigid = answer.motion;
  double deepest = 0.0;
  double longest =
      std::fabs(rigid[0]) + std::fabs(rigid[1]) * std::max(std::fabs(grid.y.front()), std::fabs(grid.y.back()));
  for (Index i = 0; i < grid.count(); ++i)
    if (answer.q[i] > 0.0) {
      deepest = std::max(deepest, answer.interference(grid, i));
      longest = std::max(longest, std::fabs(grid.separation[i]));
    }
  if (!(deepest > 0.0)) deepest = longest;
  if (ROUNDING * longest > MOST_HIDDEN * deepest) return {Unmet::hidden, deepest, 0};
  const double allowed = TOLERANCE * deepest + ROUNDING * longest;
  const auto [lift, bend] = lift_and_bend(grid, answer, kernel);
  for (Index i = 0; i < grid.count(); ++i) {
    const bool bears = answer.q[i] > 0.0;
    if (!std::isfinite(grid.separation[i]) && !bears) continue;
    const double opening = lift[i] - answer.interference(grid, i), curvature = grid.curvature[i];
    const bool as_said = std::fabs(opening - answer.gap[i]) <= allowed + TOLERANCE * std::fabs(opening);
    if (!as_said || (bears && std::fabs(opening) > allowed)) return {Unmet::unclosed, opening, i};
    if (opening < -allowed) return {Unmet::overlap, -opening, i};
    if (bears && !(std::fabs(bend[i] - curvature) <= CURVATURE_TOLERANCE * curvature))
      return {Unmet::bent, bend[i] / curvature - 1.0, i};
  }
  return {};
}

bool steady(const Grid& grid, const State& state) {
  return steady(state.stiffness, std::max(std::fabs(grid.edges.front()), std::fabs(grid.edges.back())));
}

bool steady(const std::array<Pair, 2>& k, double reach) {
  for (const Pair& row : k)
    for (double value : row)
      if (!std::isfinite(value)) return false;
  return k[0][0] > 0.0 && k[1][1] >= UNSTEADY * k[0][0] * reach * reach;
}

}  // namespace nonhertz
