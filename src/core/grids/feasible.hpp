// Prescriptions that no strip loads can meet, refused before a loop is started.
#pragma once

#include <exception>

#include "bodies/model.hpp"

namespace nonhertz {

/// Why no strips can meet a prescription; Python words the error. Comments explain the numbers.
enum class Refusal {
  nan_relief,      ///< value: y
  endless_relief,  ///< the separation is finite nowhere
  arm_outside,     ///< value: moment / load; low, high: pressure is possible between these
  arm_off_strips,  ///< value: moment / load; strips: whose centres all lie on one side of it
  tilted_apart,    ///< value: approach; at the tilt that the moment causes the bodies are apart
  between_strips,  ///< strips: the contact lies between the centres of so many
  unresolved,      ///< value: approach; strips cannot resolve the contact
  apart,           ///< value: approach at which the bodies begin to touch; low, high, strips: if the user gave them
  no_end,          ///< the contact reaches the end of the interval searched on infinite bodies
};

struct Refused : std::exception {
  Refusal why;
  double value, low, high;
  Index strips;

  explicit Refused(Refusal reason, double of = 0.0, double from = 0.0, double to = 0.0, Index count = 0)
      : why(reason), value(of), low(from), high(to), strips(count) {}
  const char* what() const noexcept override { return "no strips can meet what is prescribed"; }
};

/// Lever arm of the moment: moment / load [mm].
inline double arm_of(const Prescription& prescribed) { return prescribed.target[1] / prescribed.target[0]; }

/// Whether any loads on the strips of a grid can meet the prescribed values.
bool is_feasible(const Model& model, const Grid& grid, const Prescription& prescribed);

/// Refuse prescribed values that no loads on these strips can meet; `chosen` if the user gave the strips.
void refuse_infeasible(const Model& model, const Grid& grid, const Prescription& prescribed, bool chosen = true);

/// Refuse a load and moment whose resultant lies outside the interval where pressure is possible.
void refuse_arm_outside(const Prescription& prescribed, double low, double high);

/// Refuse bodies whose relief is NaN somewhere, or infinite everywhere.
void refuse_endless_relief(View y, View separation);

/// Return why no strip touches at the prescribed approach: too few strips, or bodies too far apart.
[[noreturn]] void refuse_no_contact(const Model& model, View edges, const Prescription& prescribed, bool chosen);

}  // namespace nonhertz
