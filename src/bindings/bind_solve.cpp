// A solve, many solves, and what they return: arrays are views of the result's own memory.
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include "bindings/arrays.hpp"
#include "bindings/rooms.hpp"
#include "bindings/signals.hpp"
#include "solve/cases.hpp"

namespace nonhertz {
namespace {

/// Why a case has no result, as an exception of Python.
nb::object reason(const std::exception_ptr& why, const nb::object& refused_type) {
  try {
    std::rethrow_exception(why);
  } catch (const Refused& refused) {
    return refused_type(refused.why, refused.value, refused.low, refused.high, refused.strips);
  } catch (nb::python_error& error) {
    return nb::borrow(error.value());
  } catch (const std::exception& error) {
    return nb::steal(PyObject_CallFunction(PyExc_RuntimeError, "s", error.what()));
  }
}

std::optional<Result> solved(const Model& model, Flags by_force, Pair target, const Strips& strips,
                             const std::stop_source* source) {
  Signals signals;
  const Stop stop = watched(source, signals);
  try {
    const nb::gil_scoped_release unlocked;
    return solve(model, {by_force, target}, strips, &stop);
  } catch (const Stopped&) {
    signals.raise();
    return {};
  }
}

nb::list solved_in_turn(const Model& model, Flags by_force, const std::vector<Pair>& targets, const Strips& strips,
                        const std::stop_source* source, const nb::object& refused_type) {
  Signals signals;
  const Stop stop = watched(source, signals);
  std::vector<Ended> cases;
  {
    const nb::gil_scoped_release unlocked;
    cases = solve_in_turn(model, by_force, targets, strips, &stop);
  }
  signals.raise();
  nb::list ended;
  for (Ended& ended_case : cases) {
    if (auto* result = std::get_if<Result>(&ended_case))
      ended.append(nb::cast(std::move(*result)));
    else
      ended.append(reason(std::get<std::exception_ptr>(ended_case), refused_type));
  }
  return ended;
}

Result remade(const Model& model, Flags by_force, Pair target, const std::vector<std::pair<Numbers, State>>& levels,
              double accuracy, bool accepted) {
  Levels remade{{}, accuracy};
  for (const auto& [edges, state] : levels) {
    const bool is_checked = !accepted && remade.levels.empty();
    remade.levels.push_back({is_checked ? model.grid(edges) : model.springs(edges), state});
  }
  return accepted ? judge_levels(model, {by_force, target}, std::move(remade))
                  : check_and_judge(model, {by_force, target}, std::move(remade));
}

/// The sum of lengths, the error of each addition added at last.
double total(const std::vector<Pair>& intervals) {
  double sum = 0.0, lost = 0.0;
  for (const auto& [low, high] : intervals) {
    const double length = high - low, next = sum + length;
    lost += sum >= length ? (sum - next) + length : (length - next) + sum;
    sum = next;
  }
  return sum + lost;
}

/// Numbers of a row for each result.
Matrix columns(const std::vector<const Result*>& results, double compliance) {
  Matrix rows(static_cast<Index>(results.size()), 14);
  for (Index k = 0; k < rows.rows(); ++k) {
    const Judgement& j = results[k]->judgement;
    const State& state = results[k]->finest().state;
    const auto& s = state.stiffness;
    const double row[] = {state.rigid[0],
                          state.rigid[1],
                          results[k]->resultant[0] / compliance,
                          results[k]->resultant[1] / compliance,
                          j.pressure.value,
                          j.pressure.y,
                          j.half_width,
                          total(j.contact),
                          j.penetration,
                          s[0][0] / compliance,
                          s[0][1] / compliance,
                          s[1][0] / compliance,
                          s[1][1] / compliance,
                          j.ends.singular.empty() ? 0.0 : 1.0};
    std::copy(std::begin(row), std::end(row), rows[k].begin());
  }
  return rows;
}

}  // namespace

void bind_solve(nb::module_& m) {
  const auto per_strip = [](auto value) {
    return [value](const Result& self, double compliance) {
      const State& state = self.finest().state;
      Numbers values(state.r.size());
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(state, i, compliance);
      return values;
    };
  };
  nb::enum_<Unmet>(m, "Unmet")
      .value("NONE", Unmet::none)
      .value("NOT_FINITE", Unmet::not_finite)
      .value("FIRST", Unmet::first)
      .value("SECOND", Unmet::second)
      .value("TENSION", Unmet::tension)
      .value("UNCLOSED", Unmet::unclosed)
      .value("OVERLAP", Unmet::overlap)
      .value("BENT", Unmet::bent)
      .value("HIDDEN", Unmet::hidden);
  nb::class_<Shortfall>(m, "Shortfall")
      .def_ro("condition", &Shortfall::condition)
      .def_ro("value", &Shortfall::value)
      .def_ro("at", &Shortfall::at);
  nb::class_<Result> result(m, "Result", "A case as it ended, judged.");
  view_property(result, "edges", [](const Result& self) -> const Numbers& { return self.finest().grid->edges; });
  view_property(result, "gap", [](const Result& self) -> const Numbers& { return self.finest().state.gap; });
  result.def_prop_ro("status", [](const Result& self) { return self.finest().state.status; })
      .def_prop_ro(
          "rigid", [](const Result& self) { return self.finest().state.rigid; }, "Approach and tilt.")
      .def_prop_ro(
          "stiffness", [](const Result& self) { return self.finest().state.stiffness; }, "Scaled.")
      .def_ro("resultant", &Result::resultant, "K Q and K T.")
      .def_prop_ro("steps", [](const Result& self) { return self.finest().state.steps; })
      .def("line_load", per_strip([](const State& s, std::size_t i, double k) { return s.r[i] * s.m[i] / k; }),
           "compliance"_a)
      .def("half_width", per_strip([](const State& s, std::size_t i, double) { return std::sqrt(s.m[i]); }),
           "compliance"_a = 1.0, "Of the element's own pressure.")
      .def_prop_ro(
          "levels",
          [](nb::handle self) {
            nb::list levels;
            for (const Level& level : nb::cast<const Result&>(self).levels.levels)
              levels.append(nb::make_tuple(nb::cast(view_of(level.grid->edges, self), nb::rv_policy::reference),
                                           nb::cast(level.state)));
            return levels;
          },
          nb::sig("def levels(self) -> list[tuple[NDArray[numpy.float64], State]]"), "Edges and states, finest first.")
      .def_prop_ro("accuracy", [](const Result& self) { return self.levels.accuracy; })
      .def_ro("is_steady", &Result::is_steady)
      .def_prop_ro("holds", &Result::holds)
      .def_ro("shortfall", &Result::shortfall)
      .def_ro("judgement", &Result::judgement);
  nb::class_<std::stop_source>(m, "Stop", "Stops the solves that look at it within a Newton step.")
      .def(nb::init<>())
      .def("set", &std::stop_source::request_stop)
      .def_prop_ro("is_set", &std::stop_source::stop_requested);
  m.def("solve", &solved, "model"_a, "by_force"_a, "target"_a, "strips"_a, "stop"_a.none() = nb::none(),
        nb::sig("def solve(model: Model, by_force: Sequence[bool], target: Sequence[float], "
                "strips: Accuracy | int | NDArray[numpy.float64], stop: Stop | None = None) -> Result | None"),
        "Solve a case; None once stopped.");
  m.def(
      "solve_in_turn",
      [type = nb::object(m.attr("Refused"))](const Model& model, Flags by_force, const std::vector<Pair>& targets,
                                             const Strips& strips, const std::stop_source* stop) {
        return solved_in_turn(model, by_force, targets, strips, stop, type);
      },
      "model"_a, "by_force"_a, "targets"_a, "strips"_a, "stop"_a.none() = nb::none(),
      nb::sig("def solve_in_turn(model: Model, by_force: Sequence[bool], targets: Sequence[Sequence[float]], "
              "strips: Accuracy | int | NDArray[numpy.float64], stop: Stop | None = None) -> list[Result | Exception]"),
      "Solve similar cases; less of them once stopped.");
  m.def("restored", &remade, "model"_a, "by_force"_a, "target"_a, "levels"_a, "accuracy"_a, "accepted"_a, Released(),
        "A result from states that were kept, checked again unless they are known to be accepted.");
  m.def("columns", &columns, "results"_a, "compliance"_a);
}

}  // namespace nonhertz
