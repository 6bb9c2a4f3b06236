#include "subsurface/load.hpp"

namespace nonhertz {
namespace {

void below(const Lamination& strips, double poisson, bool displaced, View points, Row out) {
  below_strips(strips, poisson, displaced, points, out);
}
void below(const Panels& panels, double poisson, bool displaced, View points, Row out) {
  below_rectangles(panels, poisson, displaced, points, out);
}

}  // namespace

void below_load(const Load& load, const std::vector<Term>& terms, double poisson, bool displaced, View points,
                Row out) {
  Numbers seen(points.size()), part(out.size());
  std::ranges::fill(out, 0.0);
  for (const auto& [sign, offset, weight] : terms) {
    // Points mapped from the image to the pressure itself.
    for (std::size_t i = 0; i < seen.size(); i += 3)
      seen[i] = points[i], seen[i + 1] = sign * (points[i + 1] - offset), seen[i + 2] = points[i + 2];
    std::visit([&](const auto& of) { below(of, poisson, displaced, seen, part); }, load.of);
    for (std::size_t i = 0; i < part.size(); i += 6)
      for (std::size_t c : {0, 1, 2, 3, 4, 5})
        out[i + c] += weight * (c == 3 || c == 5 ? sign * part[i + c] : part[i + c]);
  }
}

}  // namespace nonhertz
