// Results derived from the strips of a solution: its ends, the largest pressure, estimated errors, and the numbers for
// each condition of the model. Numbers only; Python words the findings that exceed their limits.
#pragma once

#include "grids/levels.hpp"
#include "judging/maximum.hpp"

namespace nonhertz {

enum class EndKind { run_out, finite, singular, corner, cut_off };

/// The end of a contact.
struct End {
  EndKind kind = EndKind::run_out;
  double y = 0.0, width = 0.0;  ///< position, and the width of the last strip [mm]
  double pressure = 0.0;        ///< of the last strip in contact [MPa], zero where the contact runs out
  double image_weight = 0.0, exponent = 0.0, correction_exponent = 0.0;
};

/// A place at which the pressure is singular: a sharp end, or a corner of the profile.
struct SingularEnd {
  double y;
  bool is_corner;
  double width;  ///< of the nearest strip in contact [mm]
};

struct Ends {
  std::array<End, 2> ends;
  std::vector<SingularEnd> singular;  ///< ascending

  Numbers singular_places() const;
};

/// Relative errors, and the parts of those of approach or load and of the pressure that remain for any number of
/// strips, due to the modes and polynomials of a whole roller.
struct Errors {
  double approach, load, max_pressure, moment, tilt;
  double left_by_modes, pressure_left_by_modes;
};

/// The numbers of a solution for each condition of the model.
struct Checks {
  double length_ratio = 0.0;            ///< width / length
  double radius_ratio = 0.0;            ///< half-width over the smaller radius of curvature, the largest
  double depth_ratio = 0.0;             ///< depth in half-widths, the least; infinite where no depth is given
  double half_width = 0.0;              ///< the largest of any strip [mm]
  double unevenness = 0.0;              ///< departure from parabolas within a half-width [mm]
  double deepest = 0.0, pressed = 0.0;  ///< largest interference at a strip's centre, and at one in contact [mm]
  double mean_pressure = 0.0;           ///< [MPa]
  double missed = 0.0, missed_y = 0.0;  ///< largest overlap out of contact [mm], and its position
};

struct Judgement {
  std::vector<Pair> contact;  ///< intervals in contact [mm]
  Ends ends;
  Largest pressure;         ///< the largest that is independent of refinement [MPa], and its position [mm]
  double half_width = 0.0;  ///< the largest one, likewise [mm]
  bool peaks_at_corner = false;
  double penetration = 0.0;  ///< largest interference of the undeformed bodies [mm]
  Errors errors{};
  Checks checks{};
};

/// Judge a solution, or the state of a failed loop, without corners and known errors.
Judgement judge(const Model& model, const Prescription& prescribed, const Levels& levels);

// Its parts, each in a file of its own.
Ends ends_of(const Model& model, const Level& level);
Errors estimate(const Model& model, const Prescription& prescribed, const Levels& levels, const Ends& ends,
                bool at_corner);
Checks check(const Model& model, const Level& level, const Judgement& known);
double penetration_of(const Model& model, View edges, const Pair& rigid);

}  // namespace nonhertz
