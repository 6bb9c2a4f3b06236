// Rollers between rings, and the states in which they are in balance.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/unordered_map.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include <cstdint>

#include "bearing/balance.hpp"
#include "bearing/strip_law.hpp"
#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"
#include "bindings/signals.hpp"
#include "maps/contact_map.hpp"

namespace nonhertz {
namespace {

/// A law in Python: called with the interpreter's lock, with the rollers and the poses of their contacts.
class PythonLaw : public GroupLaw {
 public:
  explicit PythonLaw(nb::callable law) : law_(std::move(law)) {}

  void answer(std::span<const Index> rollers, std::span<const Pose> poses, std::span<Answer> answers,
              const Stop&) override {
    if (rollers.empty()) return;
    const nb::gil_scoped_acquire lock;
    const std::size_t count = rollers.size(), contacts = poses.size() / count;
    const auto numbers = nb::ndarray<nb::numpy, const Index>(rollers.data(), {count});
    const auto places = nb::ndarray<nb::numpy, const double>(&poses[0].approach, {count, contacts, 2});
    const auto values = nb::cast<nb::ndarray<const double, nb::ndim<3>, nb::c_contig, nb::device::cpu>>(
        law_(nb::cast(numbers, nb::rv_policy::copy), nb::cast(places, nb::rv_policy::copy)));
    if (values.size() * sizeof(double) != answers.size_bytes())
      throw std::invalid_argument("a law must answer for every contact that it is asked for");
    std::copy_n(values.data(), values.size(), &answers[0].load);
  }

 private:
  nb::callable law_;
};

MapLaw map_law(View table) {
  const MapHead& head = *reinterpret_cast<const MapHead*>(table.data());
  if (table.size() * sizeof(double) < sizeof(MapHead) || count_of(table) != ContactMap::size(head))
    throw std::invalid_argument("table must be that of a map");
  return {{table.data(), table.data() + ContactMap::size_of_mean_approach(head)}};
}

/// States as arrays: ring, force, stiffness, residual, steps, rollers' motions, poses and answers.
using States =
    std::tuple<Writable, Writable, Writable, Writable, WritableOf<std::int64_t>, Writable, Writable, Writable>;

States arrays(const Assembly& assembly, const std::vector<Equilibrium>& states) {
  const auto count = states.size(), rollers = assembly.ring.size(),
             columns = static_cast<std::size_t>(assembly.columns);
  Numbers ring, force, stiffness, residual, motion, pose, answer;
  std::vector<std::int64_t> steps;
  const auto append = [](Numbers& to, const auto& values) {
    const auto* first = reinterpret_cast<const double*>(values.data());
    to.insert(to.end(), first, first + sizeof(values[0]) / sizeof(double) * values.size());
  };
  for (const Equilibrium& state : states) {
    append(ring, state.ring), append(force, state.force), append(stiffness, state.stiffness);
    residual.push_back(state.residual), steps.push_back(state.steps);
    append(motion, state.rollers), append(pose, state.poses), append(answer, state.answers);
  }
  return {writable(std::move(ring), {count, 5}),
          writable(std::move(force), {count, 5}),
          writable(std::move(stiffness), {count, 5, 5}),
          writable(std::move(residual), {count}),
          writable(std::move(steps), {count}),
          writable(std::move(motion), {count, rollers, 3}),
          writable(std::move(pose), {count, rollers, columns, 2}),
          writable(std::move(answer), {count, rollers, columns, sizeof(Answer) / sizeof(double)})};
}

std::optional<States> balance(const Assembly& assembly, std::array<bool, 5> by_force, double depth, double tolerance,
                              int steps, const Matrix& target, const Matrix& start, const Matrix& motion, int threads,
                              const std::stop_source* source) {
  const auto targets = rows_of<Vector<5>>(target), starts = rows_of<Vector<5>>(start);
  const auto motions = rows_of<Vector<3>>(motion);
  const std::size_t rollers = assembly.ring.size();
  if (starts.size() != targets.size() || motions.size() != targets.size() * rollers)
    throw std::invalid_argument("target, start and motion must be of the same states");
  std::vector<Beginning> beginnings;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    const auto first = motions.begin() + static_cast<Index>(k * rollers);
    beginnings.push_back({targets[k], starts[k], {first, first + static_cast<Index>(rollers)}});
  }
  Signals signals;
  const Stop stop = watched(source, signals);
  std::vector<Equilibrium> states;
  try {
    const nb::gil_scoped_release released;
    states = equilibria(assembly, {by_force, depth, tolerance, steps}, beginnings, threads, stop);
  } catch (const Stopped&) {
    signals.raise();
    return {};
  }
  return arrays(assembly, states);
}

}  // namespace

namespace {

/// Raise in Python what the core throws: an exception whose arguments are approach and tilt.
void translate(const std::exception_ptr& thrown, void* type) {
  try {
    std::rethrow_exception(thrown);
  } catch (const Unsolved& unsolved) {
    const nb::tuple fields = nb::make_tuple(unsolved.pose.approach, unsolved.pose.tilt);
    PyErr_SetObject(static_cast<PyObject*>(type), fields.ptr());
  }
}

Writable answers_of(GroupLaw& law, const std::vector<Index>& rollers,
                    const nb::ndarray<const double, nb::ndim<3>, nb::c_contig, nb::device::cpu>& poses) {
  const std::size_t count = rollers.size(), contacts = poses.shape(1), size = sizeof(Answer) / sizeof(double);
  if (poses.shape(0) != count || poses.shape(2) != 2) throw std::invalid_argument("poses must be of the rollers");
  std::vector<Pose> at(count * contacts);
  std::copy_n(poses.data(), poses.size(), &at[0].approach);
  std::vector<Answer> answers(at.size());
  {
    const nb::gil_scoped_release released;
    law.answer(rollers, at, answers, Stop{});
  }
  const double* first = &answers[0].load;
  return writable(Numbers(first, first + size * answers.size()), {count, contacts, size});
}

void bind_strips_of_rollers(nb::module_& m) {
  const std::string name = nb::cast<std::string>(m.attr("__name__")) + ".Unsolved";
  nb::object type = nb::steal(PyErr_NewException(name.c_str(), PyExc_Exception, nullptr));
  m.attr("Unsolved") = type;
  nb::register_exception_translator(translate, type.ptr());
  nb::class_<StrippedContact>(m, "StrippedContact", "A contact between roller and ring, to be solved on strips.")
      .def(nb::init<std::shared_ptr<const Model>>(), "model"_a)
      .def_prop_ro("loops", &StrippedContact::loops, "How many loops are kept for strips.")
      .def(
          "penetration",
          [](const StrippedContact& self, const Matrix& poses) { return self.penetration(rows_of<Pose>(poses)); },
          "poses"_a, "How deep the undeformed bodies overlap where they do most [mm], at poses of the shape (n, 2).");
  nb::class_<StripLaw, GroupLaw>(m, "StripLaw", "How the contacts of rollers answer by strips.")
      .def(nb::init<std::vector<std::shared_ptr<StrippedContact>>, std::optional<Index>>(), "contacts"_a,
           "strips"_a.none() = nb::none())
      .def("lay_anew", &StripLaw::lay_anew,
           "From now on lay strips anew for contacts that are not nearly those which they were laid for.")
      .def(
          "edges", [](const StripLaw& self, Index roller, Index contact) { return self.strips(roller, contact).edges; },
          "roller"_a, "contact"_a = 0, "Of the strips on which a contact was solved last [mm].")
      .def_prop_ro(
          "laid_for",
          [](const StripLaw& self) {
            std::vector<std::pair<double, double>> poses;
            for (const Pose& pose : self.work().laid_for) poses.emplace_back(pose.approach, pose.tilt);
            return poses;
          },
          "The poses for which strips of the automatic grid were laid.")
      .def_prop_ro(
          "evaluations", [](const StripLaw& self) { return self.work().evaluations; },
          "How often the contacts of each roller were evaluated.")
      .def_prop_ro(
          "followed", [](const StripLaw& self) { return self.work().followed; }, "How many contacts were led on.")
      .def_prop_ro(
          "solved", [](const StripLaw& self) { return self.work().solved; }, "How many were solved on strips.");
}

}  // namespace

void bind_bearing(nb::module_& m) {
  nb::class_<Slices>(m, "Slices")
      .def(
          "__init__",
          [](Slices* self, Numbers y, Numbers relief, double stiffness, double exponent) {
            if (y.size() != relief.size()) throw std::invalid_argument("y and relief must have the same size");
            new (self) Slices{std::move(y), std::move(relief), stiffness, exponent};
          },
          "y"_a, "relief"_a, "stiffness"_a, "exponent"_a);
  nb::class_<MapLaw>(m, "MapLaw")
      .def(
          "__init__", [](MapLaw* self, View table) { new (self) MapLaw(map_law(table)); }, "table"_a);
  nb::class_<GroupLaw>(m, "GroupLaw", "A law that is asked for the contacts of many rollers at once.")
      .def("answer", &answers_of, "rollers"_a, "poses"_a,
           "Answers of contacts, shape (n, contacts, 7), at poses of the shape (n, contacts, 2).");
  nb::class_<PythonLaw, GroupLaw>(m, "PythonLaw")
      .def(
          "__init__",
          [](PythonLaw* self, nb::typed<nb::callable, nb::object(nb::object, nb::object)> law) {
            new (self) PythonLaw(std::move(law));
          },
          "law"_a);
  bind_strips_of_rollers(m);
  nb::class_<Joint>(m, "Joint")
      .def(
          "__init__",
          [](Joint* self, bool inner, const Matrix& motion, Numbers gap, Law law, Index column, Index first) {
            const auto rows = rows_of<Vector<3>>(motion);
            if (rows.size() != 2) throw std::invalid_argument("motion must have a row for approach and one for tilt");
            new (self) Joint{inner, {rows[0], rows[1]}, std::move(gap), std::move(law), column, first};
          },
          "inner"_a, "motion"_a, "gap"_a, "law"_a, "column"_a, "first"_a);
  nb::class_<Assembly>(m, "Assembly")
      .def(
          "__init__",
          [](Assembly* self, const Matrix& ring, const std::vector<Joint>& joints, const Matrix& load, double lever,
             double stiffness) {
            new (self) Assembly(rows_of<Small<3, 5>>(ring), joints, rows_of<Vector<3>>(load), lever, stiffness);
          },
          "ring"_a, "joints"_a, "load"_a, "lever"_a, "stiffness"_a);
  m.def("balance", &balance, "assembly"_a, "by_force"_a, "depth"_a, "tolerance"_a, "steps"_a, "target"_a, "start"_a,
        "motion"_a, "threads"_a, "stop"_a.none() = nb::none(), "States of a bearing in balance; None once stopped.");
}

}  // namespace nonhertz
