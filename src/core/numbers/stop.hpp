// How a solve that is under way is stopped, at the latest after the Newton step that it is in.
#pragma once

#include <functional>
#include <stop_token>

namespace nonhertz {

/// Thrown by a loop that is asked to stop.
struct Stopped {};

/// What a loop looks at before every step.
struct Stop {
  std::stop_token token{};             ///< set by any thread
  std::function<void()> every_step{};  ///< may throw: of the program around, which has signals to look at

  void look() const {
    if (token.stop_requested()) throw Stopped{};
    if (every_step) every_step();
  }
};

}  // namespace nonhertz
