// Where contacts are looked for, where strips lie, and why a prescription is refused.
#include <nanobind/stl/array.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"
#include "grids/first.hpp"
#include "grids/levels.hpp"
#include "grids/overlaps.hpp"
#include "grids/peaks.hpp"
#include "grids/springs.hpp"

namespace nonhertz {
namespace {

/// Raise in Python what the core throws: an exception whose arguments are the fields of it.
void translate(const std::exception_ptr& thrown, void* type) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Refused& refused) {
    const nb::tuple fields = nb::make_tuple(refused.why, refused.value, refused.low, refused.high, refused.strips);
    PyErr_SetObject(static_cast<PyObject*>(type), fields.ptr());
  }
}

void bind_refusals(nb::module_& m) {
  nb::enum_<Refusal>(m, "Refusal", "Why no strips can meet a prescription.")
      .value("NAN_RELIEF", Refusal::nan_relief)
      .value("ENDLESS_RELIEF", Refusal::endless_relief)
      .value("ARM_OUTSIDE", Refusal::arm_outside)
      .value("ARM_OFF_STRIPS", Refusal::arm_off_strips)
      .value("TILTED_APART", Refusal::tilted_apart)
      .value("BETWEEN_STRIPS", Refusal::between_strips)
      .value("UNRESOLVED", Refusal::unresolved)
      .value("APART", Refusal::apart)
      .value("NO_END", Refusal::no_end);
  // Its arguments: a Refusal, value, low and high [mm], and strips; grids/feasible.hpp says what they are.
  const std::string name = nb::cast<std::string>(m.attr("__name__")) + ".Refused";
  nb::object type = nb::steal(PyErr_NewException(name.c_str(), PyExc_Exception, nullptr));
  m.attr("Refused") = type;
  nb::register_exception_translator(translate, type.ptr());
}

}  // namespace

void bind_grids(nb::module_& m) {
  bind_refusals(m);
  m.attr("ACCURACY") = ACCURACY;
  nb::class_<Accuracy>(m, "Accuracy", "The relative errors that an automatic grid aims for.")
      .def(nb::init<double, double>(), "of_motion"_a, "of_pressure"_a);
  m.def(
      "bound_contact",
      [](const Model& model, Flags by_force, Pair target) {
        return bound_contact(model, {by_force, target});
      },
      "model"_a, "by_force"_a, "target"_a, Released(),
      "The interval in which to look for the contact [mm]; finite even where the bodies are unbounded.");
  m.def(
      "is_feasible",
      [](const Model& model, const Numbers& edges, Flags by_force, Pair target) {
        return is_feasible(model, *model.springs(edges), {by_force, target});
      },
      "model"_a, "edges"_a, "by_force"_a, "target"_a, Released(),
      "Whether some loads on the strips between these edges can meet what is prescribed.");
  m.def(
      "refuse_infeasible",
      [](const Model& model, const Numbers& edges, Flags by_force, Pair target, bool chosen) {
        refuse_infeasible(model, *model.springs(edges), {by_force, target}, chosen);
      },
      "model"_a, "edges"_a, "by_force"_a, "target"_a, "chosen"_a = true, Released());
  m.def(
      "first_strips",
      [](const Model& model, Flags by_force, Pair target) {
        const Prescription prescribed{by_force, target};
        const auto [low, high] = bound_contact(model, prescribed);
        return first_strips(model, prescribed, low, high);
      },
      "model"_a, "by_force"_a, "target"_a, Released(),
      "The edges of the equal strips that an automatic grid begins with [mm].");
  m.def(
      "kinks_among",
      [](const Model& model, const Numbers& bends, double length) {
        Kinks kinks = model.kinks_among(bends, length);
        return std::pair(std::move(kinks.place), std::move(kinks.turn));
      },
      "model"_a, "bends"_a, "length"_a, Released(),
      "Those of the bends [mm] at which the slope of the separation jumps, and by how much [rad].");
  m.def(
      "springs",
      [](const Model& model, Flags by_force, Pair target, const Numbers& edges) {
        return springs(model, {by_force, target}, edges).state.m;
      },
      "model"_a, "by_force"_a, "target"_a, "edges"_a, "Squares of the half-widths of independent springs [mm^2].");
  m.def("intervals", &intervals, "grid"_a, "m"_a, "Both ends of every interval in contact [mm].");
  m.def("reaches", &reaches, "grid"_a, "m"_a, "side"_a,
        "Whether a contact extends to the outer edge of its strips on that side, -1 or 1.");
  m.def("is_nearly_touching", &is_nearly_touching, "grid"_a, "m"_a, "place"_a,
        "Whether the strip around a place or one of its neighbours is in contact.");
  m.def("width_near", &width_near, "grid"_a, "m"_a, "place"_a,
        "The largest half-width of the few strips in contact nearest to a place [mm].");
  m.def("fall", &fall, "grid"_a, "m"_a, "low"_a, "high"_a, "side"_a,
        "The distance from one end of a contact at which m is half its value at the nearest peak [mm].");
  m.def(
      "peaks",
      [](std::shared_ptr<Grid> grid, const State& state, const Numbers& kinks, double allowed) {
        std::vector<std::array<double, 3>> peaks;
        for (const Peak& peak : peaks_of({std::move(grid), state}, kinks, allowed))
          peaks.push_back({peak.place, peak.wanted, peak.width});
        return peaks;
      },
      "grid"_a, "state"_a, "kinks"_a, "allowed"_a,
      "Where the largest pressure is too pointed for its strips, the width wanted there and that of the strip [mm].");
  m.def("summits_of", &summits_of, "y"_a, "depth"_a,
        "The vertices of parabolas through three neighbouring places each, where they are deeper than zero.");
  m.def(
      "overlaps",
      [](const Model& model, std::shared_ptr<Grid> grid, const State& state, double low, double high) {
        const auto region = model.region(low, high);
        const Level level{std::move(grid), state};
        std::vector<Pair> places;
        if (!suspect(level, region->samples_with_crests)) return places;
        for (const Extra& extra : overlaps(model, *region, level)) places.push_back({extra.place, extra.width});
        return places;
      },
      "model"_a, "grid"_a, "state"_a, "low"_a, "high"_a, Released(),
      "Where another contact may have been missed, and widths for strips there [mm].");
  m.def(
      "lay",
      [](const Model& model, std::shared_ptr<Grid> grid, const State& state, double low, double high,
         const std::vector<Pair>& extras, double coarseness, double share, double limit) {
        std::vector<Extra> places;
        for (const auto& [place, width] : extras) places.push_back({place, width});
        return Plan({std::move(grid), state}, model, *model.region(low, high), places, coarseness, limit).lay(share);
      },
      "model"_a, "grid"_a, "state"_a, "low"_a, "high"_a, "extras"_a, "coarseness"_a, "share"_a, "limit"_a, Released(),
      "The edges of the strips [mm] that a coarser solution calls for, within an interval.");
}

}  // namespace nonhertz
