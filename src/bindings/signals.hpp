// What stops a loop that Python waits for.
#pragma once

#include <nanobind/nanobind.h>

#include <chrono>
#include <exception>

#include "numbers/stop.hpp"

namespace nonhertz {

namespace nb = nanobind;

/// Looks for signals while the interpreter's lock is released. Ctrl-C is noticed by the main thread alone.
class Signals {
 public:
  void look() {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + EVERY;
    const nb::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() == 0) return;
    raised_ = std::make_exception_ptr(nb::python_error());
    throw Stopped{};
  }
  /// Raise what the signal's handler raised.
  void raise() const {
    if (raised_) std::rethrow_exception(raised_);
  }

 private:
  static constexpr auto EVERY =
      std::chrono::milliseconds(20);  // a loop of microseconds must not wait for the lock at every step
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + EVERY;
  std::exception_ptr raised_;
};

/// What a loop looks at: a stop that any thread of Python may set, if there is one, and signals.
inline Stop watched(const std::stop_source* source, Signals& signals) {
  return {source != nullptr ? source->get_token() : std::stop_token(), [&signals] { signals.look(); }};
}

}  // namespace nonhertz
