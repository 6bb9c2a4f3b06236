// Many states of one bearing.
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "bearing/balance.hpp"

namespace nonhertz {
namespace {

constexpr std::size_t PART = 64;  // states, below which a separate thread does not pay

}  // namespace

std::vector<Equilibrium> equilibria(const Assembly& assembly, const Conditions& conditions,
                                    const std::vector<Beginning>& beginnings, int threads, const Stop& stop) {
  std::vector<Equilibrium> states(beginnings.size());
  const auto solve_part = [&](std::size_t first, const Stop& stop) {
    for (std::size_t k = first; k < std::min(first + PART, states.size()); ++k)
      states[k] = Balance(assembly, conditions, beginnings[k], static_cast<Index>(k)).solve(stop);
  };
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failed;
  const auto work = [&](const Stop& stop) {
    try {
      for (std::size_t first; (first = next.fetch_add(PART)) < states.size();) solve_part(first, stop);
    } catch (...) {
      const std::lock_guard lock(failed);
      failure = failure ? failure : std::current_exception();
      next = states.size();
    }
  };
  {
    // Contacts that are solved may start from the previous state.
    const auto parts = (states.size() + PART - 1) / PART;
    const auto most = assembly.groups().empty() ? std::min(static_cast<std::size_t>(threads), parts) : 1;
    std::vector<std::jthread> others;
    // Signals are handled only in the calling thread.
    for (std::size_t k = 1; k < most; ++k) others.emplace_back([&] { work({stop.token, {}}); });
    work(stop);
  }
  if (failure) std::rethrow_exception(failure);
  return states;
}

}  // namespace nonhertz
