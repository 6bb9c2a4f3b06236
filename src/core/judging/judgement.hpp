// What follows from the strips of a solution: its ends, the largest pressure, estimated errors, and how it stands
// against each condition of the model. Numbers only; Python puts into words what exceeds its limit.
#pragma once

#include "grids/levels.hpp"
#include "strips/acceptance.hpp"

namespace nonhertz {

enum class EndKind { run_out, finite, singular, corner, cut_off };

/// How a contact ends.
struct End {
  EndKind kind = EndKind::run_out;
  double y = 0.0, width = 0.0;  ///< where, and the width of the last strip [mm]
  double image_weight = 0.0, exponent = 0.0, correction_exponent = 0.0;
};

struct Ends {
  std::array<End, 2> ends;
  Numbers singular;  ///< all places at which the pressure has no limit [mm]: sharp ends, then corners
};

struct Largest {
  double pressure = 0.0, y = 0.0;  ///< as K q / a, and where [mm]
};

/// Relative errors.
struct Errors {
  double approach, load, max_pressure, moment, tilt;
};

/// How a solution stands against each condition of the model.
struct Checks {
  double length_ratio;               ///< width / length
  double radius_ratio;               ///< half-width over the smaller radius of curvature
  double unevenness;                 ///< departure from parabolas within a half-width [mm]
  double deepest;                    ///< largest interference at a strip's centre [mm]
  double mean_pressure;              ///< [MPa]
  double depth_ratio;                ///< least depth in half-widths, infinite where no depth is given
  double missed, missed_y, pressed;  ///< largest overlap out of contact [mm], where, and the deepest in contact
};

struct Judgement {
  std::vector<Pair> contact;  ///< intervals in contact [mm]
  Ends ends;
  Largest largest;
  bool peaks_at_corner = false;
  double penetration = 0.0;
  Errors errors{};
  Checks checks{};
};

/// Judge a converged solution.
Judgement judge(const Model& model, const Prescription& given, const Levels& levels);

// Its parts, each in a file of its own.
Ends ends_of(const Model& model, const Level& level);
Largest largest_pressure(const Level& level, double hertz_ratio, View singular);
struct Estimate {
  Errors errors;
  double penetration;
};
Estimate estimate(const Model& model, const Prescription& given, const Levels& levels, const Ends& ends,
                  const Largest& largest, bool at_corner);
Checks check(const Model& model, const Level& level, const std::vector<Pair>& contact);

/// The departure of the separation at nine places within a strip from a parabola, root mean square [mm].
double departure(View separation);
inline constexpr int WITHIN = 9;
/// The k-th of these places, from -1/2 to 1/2.
inline constexpr double within(int k) { return (k + 0.5) / WITHIN - 0.5; }

}  // namespace nonhertz
