#include "solve/batch.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace nonhertz {
namespace {

constexpr std::size_t PART = 50;  // cases in a row, each of which may start from the one before

/// The grids that cases share; none if each has its own: where endless bodies touch depends on what is prescribed.
Grids shared_grids(const Model& model, const Strips& strips) {
  const auto* count = std::get_if<Index>(&strips);
  if (count != nullptr && model.region()) return equal_grids(model, {}, *count);
  if (const auto* edges = std::get_if<Numbers>(&strips)) return given_grids(model, *edges);
  return {};
}

Result judged(const Model& model, const Prescription& given, Levels levels) {
  Result result;
  result.levels = std::move(levels);
  const auto& [grid, state] = result.finest();
  if (!state.converged()) return result;
  result.is_steady = steady(*grid, state);
  result.shortfall = first_unmet(*grid, given, model.kernel(), state);
  result.judgement = judge(model, given, result.levels);
  return result;
}

Result solve_in_turn(const Model& model, const Prescription& given, const Strips& strips, const Grids& grids,
                     const State* before, const Prescription& of_before) {
  if (const auto* automatic = std::get_if<Automatic>(&strips))
    return judged(model, given, solve_automatically(model, given, {automatic->accuracy}));
  if (grids.empty())
    return solve_in_turn(model, given, strips, equal_grids(model, given, std::get<Index>(strips)), before, of_before);
  refuse_infeasible(model, *grids[0], given);
  return judged(model, given, solve_on_grids(model, grids, given, before, of_before));
}

}  // namespace

Result solve(const Model& model, const Prescription& given, const Strips& strips) {
  return solve_in_turn(model, given, strips, shared_grids(model, strips), nullptr, {});
}

std::vector<Result> solve_many(const Model& model, std::array<bool, 2> by_force, const std::vector<Pair>& targets,
                               const Strips& strips, int threads) {
  const Grids grids = shared_grids(model, strips);
  std::vector<Result> results(targets.size());
  const auto solve_part = [&](std::size_t first) {
    const State* before = nullptr;
    Prescription of_before{};
    for (std::size_t k = first; k < std::min(first + PART, targets.size()); ++k) {
      const Prescription given{by_force, targets[k]};
      try {
        results[k] = solve_in_turn(model, given, strips, grids, before, of_before);
        before = &results[k].finest().state, of_before = given;
      } catch (const Refused& refused) {
        results[k].refused = refused, before = nullptr;
      }
    }
  };
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failed;
  const auto work = [&] {
    try {
      for (std::size_t first; (first = next.fetch_add(PART)) < targets.size();) solve_part(first);
    } catch (...) {  // of a profile in Python, say
      const std::lock_guard lock(failed);
      failure = failure ? failure : std::current_exception();
      next = targets.size();
    }
  };
  {
    std::vector<std::jthread> others;
    for (int k = 1; k < threads; ++k) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return results;
}

}  // namespace nonhertz
