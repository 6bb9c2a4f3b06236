// Small dense linear equations, by Gaussian elimination with row pivoting, in a fixed order of operations.
//
// With a hundred unknowns, LAPACK's overhead of copies and threads exceeds its gain in arithmetic. Nearly all of the
// work is one matrix product, in tiles of 4 x 8 numbers that stay in registers. Systems are padded to whole tiles with
// equations x = 0, so that tiles hardly ever meet an edge.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

inline constexpr Index BLOCK = 8;  // rows and columns eliminated at a time, also the width of a tile
inline constexpr Index TALL = 4;   // the height of a tile, and the width of a last one

inline constexpr Index padded_size(Index count) { return (count + TALL - 1) / TALL * TALL; }

/// A system of equations: the matrix, and from column `sides()` on its right-hand sides, which become the solutions.
class System {
 public:
  /// Change its size; only the padding is filled in.
  void reset(Index unknowns, Index sides);
  /// Replace the right-hand sides by the solutions; not finite where the matrix, which is overwritten, is singular.
  void solve();
  /// Subtract the product of a padded square matrix and the right-hand sides of another system from the matrix.
  void subtract_product(const Matrix& left, const System& right);

  Index sides() const { return values_.rows(); }
  double& operator()(Index i, Index j) { return values_(i, j); }
  double operator()(Index i, Index j) const { return values_(i, j); }

 private:
  void pivot(Index first, Index width);

  Matrix values_, panel_;
};

}  // namespace nonhertz
