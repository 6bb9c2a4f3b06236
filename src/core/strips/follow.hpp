// A solved contact that follows its bodies to another approach and tilt on its strips, as bearings need thousands of
// times: faster than solving it again, accurate in load, moment and stiffness, and not checked.
#pragma once

#include <memory>
#include <optional>

#include "strips/newton.hpp"

namespace nonhertz {

/// Strips on which contacts follow, one after the other, with the far field of the strips, which serves all of them.
class Following {
 public:
  Following(std::shared_ptr<const Grid> grid, std::shared_ptr<const Kernel> kernel);

  /// Let a solved contact follow to another approach and tilt; return K Q and K T.
  ///
  /// If that fails, nothing is returned and the state is unchanged. The stiffness is that of the state.
  std::optional<Pair> follow(const Pair& motion, State& state);

  const Grid& grid() const { return *grid_; }

 private:
  std::shared_ptr<const Grid> grid_;
  std::shared_ptr<const Kernel> kernel_;
  Newton loop_;
  State trial_;
};

}  // namespace nonhertz
