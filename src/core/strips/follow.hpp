// A solved contact that follows its bodies to another approach and tilt on its strips, as bearings ask for thousands of
// times: quicker than solving it anew, accurate in load, moment and stiffness, and not checked.
#pragma once

#include <memory>
#include <optional>

#include "strips/newton.hpp"

namespace nonhertz {

/// Strips on which contacts follow, one after the other, with what the strips do far away, which serves them all.
class Following {
 public:
  Following(std::shared_ptr<const Grid> grid, std::shared_ptr<const Kernel> kernel);

  /// Let a solved contact follow to another approach and tilt; return K Q and K T.
  ///
  /// Nothing is returned, and the state is as it was, where the contact got lost. The stiffness is that of the state.
  std::optional<Pair> follow(const Pair& motion, State& state);

  const Grid& grid() const { return *grid_; }

 private:
  std::shared_ptr<const Grid> grid_;
  std::shared_ptr<const Kernel> kernel_;
  Newton loop_;
  State trial_;
};

}  // namespace nonhertz
