// Products and systems of full matrices, whose last digits depend on no library and no number of threads.
#pragma once

#include "numbers/array.hpp"

namespace nonhertz {

/// a b; every sum goes along a row of `a` from its beginning.
Matrix product(const Matrix& a, const Matrix& b);

/// a^-1 b, by elimination with the largest pivot of each column.
Matrix solved(Matrix a, Matrix b);

}  // namespace nonhertz
