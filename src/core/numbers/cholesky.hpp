// Elimination of some unknowns of a symmetric system, leaving the Schur complement: the repeated step of direct element
// solvers.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

/// A symmetric matrix of which only the lower triangle is used, with room for whole tiles.
class Front {
 public:
  Front() = default;
  /// All zero.
  explicit Front(Index size) { reset(size); }
  void reset(Index size);
  Index size() const { return size_; }
  double& operator()(Index i, Index j) { return values_(i, j); }
  double operator()(Index i, Index j) const { return values_(i, j); }

  /// Eliminate the first `count` unknowns by Cholesky's method: their rows and columns become the factor L, and the
  /// other numbers the Schur complement. Not finite where the matrix is not positive definite.
  void eliminate(Index count);
  /// Fix an unknown at zero.
  void hold(Index unknown);

 private:
  void factor(Index first, Index count);

  Index size_ = 0;
  Matrix values_, panel_;  // the panel holds columns of L as rows
};

}  // namespace nonhertz
