#include "subsurface/rectangles.hpp"

#include <algorithm>

#include "subsurface/tails.hpp"

namespace nonhertz {
namespace {

// At a corner of a cell on the surface a shear stress is unbounded; it is evaluated at this distance, in cells.
constexpr double AT_A_CORNER = 1e-12;
constexpr Index EXACT = -1;

using Range = Panels::Range;

/// Rows of a panel handled by one rule, or by Love's form.
struct Piece {
  Index panel, rule;
  Range rows;
};

/// The rows that intersect the ellipse of a rule about the point.
Range rows_within(double x, double y, double z, const Panels& panels, Index panel, Index rule) {
  const double half = panels.half[panel], along = panels.ellipses(rule, 0), across = panels.ellipses(rule, 1);
  const double apart = x - panels.middle[panel];
  const double reach = across * (half * half - apart * apart / along) - z * z;
  if (reach < 0.0) return {0, 0};
  const double first_edge = panels.y_edges[0], side = panels.y_edges[1] - first_edge, root = std::sqrt(reach);
  const double low = (y - first_edge - root) / side, high = (y - first_edge + root) / side;
  return {static_cast<Index>(std::floor(low)), static_cast<Index>(std::ceil(high))};
}

/// Divide the load for one point. `left` is a buffer for the rows that each panel has to handle.
void divide(double x, double y, double z, const Panels& panels, std::vector<Range>& remaining,
            std::vector<Piece>& pieces) {
  const Index total = std::ssize(panels.half);
  remaining = panels.rows;
  pieces.clear();
  for (Index panel = 0; panel < total; ++panel) {
    auto [first, end] = remaining[panel];
    for (Index rule = 0; rule < panels.ellipses.rows() && first < end; ++rule) {
      auto [near, far] = rows_within(x, y, z, panels, panel, rule);
      near = std::max(near, first), far = std::min(far, end);
      if (near >= far) near = far = end;
      if (first < near) pieces.push_back({panel, rule, {first, near}});
      if (far < end) pieces.push_back({panel, rule, {far, end}});
      first = near, end = far;
    }
    if (2 * panel + 2 < total)
      for (Index below : {2 * panel + 1, 2 * panel + 2})
        remaining[below] = {std::max(remaining[below].first, first), std::min(remaining[below].end, end)};
    else if (first < end)
      pieces.push_back({panel, EXACT, {first, end}});
  }
}

/// The row above the point, -1 if there is none.
Index row_over(double y, const Numbers& y_edges, const Range& rows) {
  if (!(y_edges[rows.first] < y && y <= y_edges[rows.end])) return -1;
  Index row = rows.first;
  while (y_edges[row + 1] < y) ++row;
  return row;
}

/// The second difference of the pressure at the low corner of cell (i, j), within a block of cells only.
double step_at_corner(const Matrix& pressure, Index i, Index j, const Range& columns, const Range& rows) {
  double step = 0.0;
  if (i < columns.end && j < rows.end) step += pressure(i, j);
  if (i > columns.first && j > rows.first) step += pressure(i - 1, j - 1);
  if (i > columns.first && j < rows.end) step -= pressure(i - 1, j);
  if (i < columns.end && j > rows.first) step -= pressure(i, j - 1);
  return step;
}

struct Stress {
  static constexpr double SCALE = 1.0 / TWO_PI;

  static Six<Pack> tail(Pack X, Pack Y, Pack z, double poisson) { return stress_tail(X, Y, z, poisson); }
  /// 2 pi times the stress of an infinite line, in plane strain.
  static Six<double> line(double X, double z, double poisson) {
    const double squared = X * X + z * z, radial = -4.0 * z / squared;
    return {radial * X * X / squared, radial * poisson, radial * z * z / squared, 0.0, radial * X * z / squared, 0.0};
  }
  /// 2 pi times the stresses of Love's corner (X, Y) ahead of the point, in our order.
  static Six<double> corner(double X, double Y, double z, double poisson, double least) {
    const double R = std::max(std::sqrt(X * X + Y * Y + z * z), least);
    const double across = std::max(X * X + z * z, least * least), along = std::max(Y * Y + z * z, least * least);
    const double lateral = 1.0 - 2.0 * poisson;
    const double angle = std::atan2(X * Y, z * R), angle_x = std::atan2(X * Y, across + z * R);
    const double in_x = z * X * Y / (R * across), in_y = z * X * Y / (R * along);
    return {in_x - 2.0 * poisson * angle - lateral * angle_x,
            in_y - 2.0 * poisson * angle - lateral * (angle - angle_x),
            -angle - in_x - in_y,
            -z * z * X / (R * along),
            -z * z * Y / (R * across),
            -z / R - lateral * std::log(R + z)};
  }
};

struct Displacement {
  static constexpr double SCALE = 0.5 / TWO_PI;

  static Six<Pack> tail(Pack X, Pack Y, Pack z, double poisson) { return displacement_tail(X, Y, z, poisson); }
  /// 4 pi G times the displacement of an infinite line, up to the constant of two tails.
  static Six<double> line(double X, double z, double poisson) {
    const double squared = X * X + z * z;
    const double u_x = 2.0 * (z * X / squared - (1.0 - 2.0 * poisson) * std::atan2(X, z));
    return {u_x, 0.0, 2.0 * (z * z / squared - (1.0 - poisson) * std::log(squared)), 0.0, 0.0, 0.0};
  }
  /// 4 pi G times u_x, 0, u_z, u_y, 0, 0 of Love's corner (X, Y) ahead of the point.
  static Six<double> corner(double X, double Y, double z, double poisson, double least) {
    const double R = std::max(std::sqrt(X * X + Y * Y + z * z), least);
    const double across = std::max(X * X + z * z, least * least), along = std::max(Y * Y + z * z, least * least);
    const double lateral = 1.0 - 2.0 * poisson;
    const double angle = std::atan2(X * Y, z * R), angle_x = std::atan2(X * Y, across + z * R);
    const double of_y = std::copysign(std::log((std::abs(Y) + R) / std::sqrt(across)), Y);
    const double of_x = std::copysign(std::log((std::abs(X) + R) / std::sqrt(along)), X);
    const double depth = std::log(R + z);
    return {z * of_y + lateral * (Y * depth + z * of_y + X * angle_x),
            0.0,
            2.0 * (1.0 - poisson) * (X * of_y + Y * of_x) - lateral * z * angle,
            z * of_x + lateral * (X * depth + z * of_x + Y * (angle - angle_x)),
            0.0,
            0.0};
  }
};

/// Adds up the effect of tails in their order; many at a time, in packs.
template <class Kind>
class Sum {
 public:
  Sum(double z, double poisson) : z_(z), poisson_(poisson) {}

  /// `mirrored` is the sign for components even in y.
  void add(double X, double Y, double step, double mirrored) {
    X_[count_] = X, Y_[count_] = Y, step_[count_] = step, mirrored_[count_] = mirrored;
    if (++count_ == ROOM) add_waiting();
  }
  void add_line(double weight, const Six<double>& of) {
    add_waiting();
    for (int c : {0, 1, 2, 4}) total_[c] += weight * of[c];
  }
  const Six<double>& total() {
    add_waiting();
    return total_;
  }

 private:
  static constexpr int ROOM = 64;

  void add_waiting() {
    // The padding of the last pack is not added.
    for (int k = count_; k % WIDTH; ++k) X_[k] = 0.0, Y_[k] = 1.0, step_[k] = mirrored_[k] = 0.0;
    const Pack z = Pack{} + z_;
    double done[6][ROOM];
    for (int k = 0; k < count_; k += WIDTH) {
      const Six<Pack> of = Kind::tail(load(X_ + k), load(Y_ + k), z, poisson_);
      for (int c : {0, 1, 2, 4}) store(done[c] + k, load(mirrored_ + k) * of[c]);
      for (int c : {3, 5}) store(done[c] + k, load(step_ + k) * of[c]);
    }
    add_in_turn(done, count_, total_);
    count_ = 0;
  }

  double z_, poisson_;
  Six<double> total_{};
  int count_ = 0;
  double X_[ROOM], Y_[ROOM], step_[ROOM], mirrored_[ROOM];
};

/// Add the lines of a piece.
template <class Kind>
void add_lines(double x, double y, double z, double poisson, const Panels& panels, const Piece& piece, Row out) {
  const auto& [panel, rule, rows] = piece;
  const Index begin = panels.starts[rule], stop = panels.starts[rule + 1];
  const auto weight = [&, base = panel * panels.pressure.columns()](Index row, Index node) {
    return panels.weights(base + row, node);
  };
  Sum<Kind> sum(z, poisson);
  for (Index k = begin; k < stop; ++k) {
    const double X = x - panels.nodes(panel, k);
    double before = 0.0;
    for (Index edge = rows.first; edge <= rows.end; ++edge) {
      const double after = edge < rows.end ? weight(edge, k) : 0.0, Y = panels.y_edges[edge] - y;
      const double step = after - before;
      if (step == 0.0) continue;
      before = after;
      sum.add(X, std::abs(Y), step, Y >= 0.0 ? step : -step);
    }
  }
  if (const Index own = row_over(y, panels.y_edges, rows); own >= 0)
    for (Index k = begin; k < stop; ++k)
      sum.add_line(weight(own, k), Kind::line(x - panels.nodes(panel, k), z, poisson));
  for (int c = 0; c < 6; ++c) out[c] += Kind::SCALE * sum.total()[c];
}

/// Add the cells of a piece, by Love's corners.
template <class Kind>
void add_cells(double x, double y, double z, double poisson, const Panels& panels, const Piece& piece, Row out) {
  const Range columns = panels.columns[piece.panel], rows = piece.rows;
  const double least = AT_A_CORNER * (panels.x_edges[1] - panels.x_edges[0]);
  for (Index i = columns.first; i <= columns.end; ++i)
    for (Index j = rows.first; j <= rows.end; ++j) {
      const double step = Kind::SCALE * step_at_corner(panels.pressure, i, j, columns, rows);
      if (step == 0.0) continue;
      const Six<double> of = Kind::corner(panels.x_edges[i] - x, panels.y_edges[j] - y, z, poisson, least);
      for (int c = 0; c < 6; ++c) out[c] += step * of[c];
    }
}

template <class Kind>
void add_up(const Panels& panels, double poisson, View points, Row out) {
  std::vector<Range> remaining;
  std::vector<Piece> pieces;
  for (Index i = 0; i < count_of(points) / 3; ++i) {
    // A negative zero would put the arctangents on the other branch.
    const double x = points[3 * i], y = points[3 * i + 1], z = points[3 * i + 2] + 0.0;
    const Row at_point = out.subspan(6 * i, 6);
    std::ranges::fill(at_point, 0.0);
    divide(x, y, z, panels, remaining, pieces);
    for (const Piece& piece : pieces)
      (piece.rule == EXACT ? add_cells<Kind> : add_lines<Kind>)(x, y, z, poisson, panels, piece, at_point);
  }
}

}  // namespace

void below_rectangles(const Panels& panels, double poisson, bool displaced, View points, Row out) {
  (displaced ? add_up<Displacement> : add_up<Stress>)(panels, poisson, points, out);
}

}  // namespace nonhertz
