// Maps: at many points for Python, and at one for C, by the address of a function.
#include <nanobind/stl/array.h>

#include <array>
#include <cstdint>

#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"
#include "maps/contact_map.hpp"

namespace nonhertz {
namespace {

constexpr std::size_t STATE = 8;

void write(const MapState& state, double* to) {
  to[0] = state.approach, to[1] = state.tilt, to[2] = state.load, to[3] = state.moment;
  to[4] = state.load_by_approach, to[5] = state.load_by_tilt, to[6] = state.moment_by_tilt;
  to[7] = state.inside ? 1.0 : 0.0;
}

// What any program calls that knows the C convention.
extern "C" {
void at_approach(const double* table, double approach, double tilt, double* state) {
  write(ContactMap(table).at_approach(approach, tilt), state);
}
void at_load(const double* table, double load, double tilt, double* state) {
  write(ContactMap(table).at_load(load, tilt), state);
}
void pressures(const double* table, double load, double tilt, double* pressure_and_width) {
  const auto [pressure, width] = ContactMap(table).pressures(load, tilt);
  pressure_and_width[0] = pressure, pressure_and_width[1] = width;
}
void share(const double* table, double load, double tilt, std::int64_t strips, const double* stations,
           double* strip_loads) {
  const auto count = static_cast<std::size_t>(strips);
  ContactMap(table).share(load, tilt, {stations, count + 1}, {strip_loads, count});
}
}

std::uintptr_t address(auto* function) { return reinterpret_cast<std::uintptr_t>(function); }

const MapHead& head(View numbers) {
  if (numbers.size() * sizeof(double) < sizeof(MapHead)) throw std::invalid_argument("table must begin with a head");
  return *reinterpret_cast<const MapHead*>(numbers.data());
}

ContactMap map_of(View table) {
  if (count_of(table) != ContactMap::size(head(table)))
    throw std::invalid_argument("table must have as many numbers as its cells need");
  return ContactMap(table.data());
}

void check_alike(View one, View other) {
  if (one.size() != other.size()) throw std::invalid_argument("arrays must have the same size");
}

/// The states of a map at many points, a row each: those of `pressed` or `loaded`, and largest pressure and half-width.
Matrix states(View table, bool by_load, View values, View tilts) {
  const ContactMap map = map_of(table);
  check_alike(values, tilts);
  Matrix rows(count_of(values), STATE + 2);
  for (Index k = 0; k < count_of(values); ++k) {
    const MapState state = by_load ? map.at_load(values[k], tilts[k]) : map.at_approach(values[k], tilts[k]);
    write(state, rows[k].data());
    const auto [pressure, width] = map.pressures(state.load, tilts[k]);
    rows(k, STATE) = pressure, rows(k, STATE + 1) = width;
  }
  return rows;
}

/// How loads are shared by the strips between stations, a row for each load.
Matrix shares(View table, View loads, View tilts, View stations) {
  const ContactMap map = map_of(table);
  check_alike(loads, tilts);
  if (stations.size() < 2) throw std::invalid_argument("stations must be two or more");
  Matrix rows(count_of(loads), count_of(stations) - 1);
  for (Index k = 0; k < count_of(loads); ++k) map.share(loads[k], tilts[k], stations, rows[k]);
  return rows;
}

/// z and its five derivatives at x and tilts, a row each; of the numbers of a map only the head is read.
Matrix tilt_coordinates(View numbers, View x, View tilts) {
  check_alike(x, tilts);
  Matrix rows(count_of(x), 6);
  for (Index k = 0; k < count_of(x); ++k) {
    const TiltCoordinate z = head(numbers).tilt_coordinate(x[k], tilts[k]);
    const double row[] = {z.z, z.by_x, z.by_tilt, z.by_x_twice, z.by_x_and_tilt, z.by_tilt_twice};
    std::copy_n(row, 6, rows[k].begin());
  }
  return rows;
}

}  // namespace

void bind_maps(nb::module_& m) {
  m.def("map_states", &states, "table"_a, "by_load"_a, "values"_a, "tilts"_a, Released());
  m.def("map_shares", &shares, "table"_a, "loads"_a, "tilts"_a, "stations"_a, Released());
  m.def("map_tilt_coordinates", &tilt_coordinates, "numbers"_a, "x"_a, "tilts"_a);
  m.def("map_functions", [] {
    return std::array{address(&at_approach), address(&at_load), address(&pressures), address(&share)};
  });
}

}  // namespace nonhertz
