#include "grids/springs.hpp"

#include <algorithm>

#include "strips/start.hpp"

namespace nonhertz {

Level springs(const Model& model, const Prescription& prescribed, Numbers edges) {
  Level level{model.springs(std::move(edges)), State(0)};
  level.state = State(level.grid->count());
  start_from_springs(*level.grid, prescribed, model.kernel(), level.state);
  return level;
}

bool is_touching(const Level& level) { return spring_contact(level).has_value(); }

std::optional<Pair> spring_contact(const Level& level) {
  const Numbers& m = level.state.m;
  const auto bears = [](double m) { return m > 0.0; };
  const auto first = std::find_if(m.begin(), m.end(), bears);
  if (first == m.end()) return std::nullopt;
  const Index last = m.rend() - std::find_if(m.rbegin(), m.rend(), bears) - 1;
  return Pair{level.grid->low(first - m.begin()), level.grid->high(last)};
}

Pair neighbourhood(const Model& model, const Prescription& prescribed, double low, double high) {
  constexpr int LOOKS = 3;
  for (int look = 0; look < LOOKS; ++look) {
    const Level fine = springs(model, prescribed, uniform(low, high, FINE_STRIPS));
    double margin = (high - low) / FINE_STRIPS;
    if (const auto contact = spring_contact(fine)) {
      const auto& [first, last] = *contact;
      margin += 0.3 * (last - first);
      return {std::max(low, first - margin), std::min(high, last + margin)};
    }
    Index nearest = 0;
    for (Index i = 0; i < fine.grid->count(); ++i)
      if (fine.state.interference(*fine.grid, i) > fine.state.interference(*fine.grid, nearest)) nearest = i;
    const double y = fine.grid->y[nearest];
    low = std::max(low, y - 2.0 * margin), high = std::min(high, y + 2.0 * margin);
  }
  return {low, high};
}

}  // namespace nonhertz
