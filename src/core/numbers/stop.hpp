// Stopping a running solve, at the latest after the present Newton step.
#pragma once

#include <functional>
#include <stop_token>

namespace nonhertz {

/// Thrown by a loop that is stopped.
struct Stopped {};

/// Conditions that a loop checks before every step.
struct Stop {
  std::stop_token token{};             ///< set by any thread
  std::function<void()> every_step{};  ///< may throw: callback of the calling program, for signals

  void look() const {
    if (token.stop_requested()) throw Stopped{};
    if (every_step) every_step();
  }
};

}  // namespace nonhertz
