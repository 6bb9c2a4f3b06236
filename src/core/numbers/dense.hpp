// Products and systems of full matrices, whose last digits do not depend on a library or the number of threads.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

/// a b; every sum runs along a row of `a` from its beginning.
Matrix product(const Matrix& a, const Matrix& b);

/// a^-1 b, by elimination with the largest pivot of each column.
Matrix solve_dense(Matrix a, Matrix b);

}  // namespace nonhertz
