#include "bodies/section.hpp"

#include <algorithm>

namespace nonhertz {
namespace {

void fill_in(double value, View, Row out) { std::fill(out.begin(), out.end(), value); }

void fill_in(const TabulatedDiameter& of, View y, Row out) {
  for (std::size_t i = 0; i < y.size(); ++i) out[i] = 2.0 / of.diameter.at(y[i] - of.middle);
}

void fill_in(const Function& of, View y, Row out) { of(y, out); }

void fill_in(const DepthInDiameters& of, View y, Row out) {
  fill(of.curvature, y, out);
  if (std::any_of(out.begin(), out.end(), [](double curvature) { return curvature <= 0.0; })) return of.refuse(y, out);
  for (double& value : out) value = 2.0 * of.diameters / value;
}

}  // namespace

void fill(const Curvature& curvature, View y, Row out) {
  std::visit([&](const auto& of) { fill_in(of, y, out); }, curvature);
}

void fill(const Depth& depth, View y, Row out) {
  std::visit([&](const auto& of) { fill_in(of, y, out); }, depth);
}

}  // namespace nonhertz
