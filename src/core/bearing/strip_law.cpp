#include "bearing/strip_law.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <map>

namespace nonhertz {
namespace {

constexpr int SAME =
    12;  // digits, relative to the largest, to which contacts count as equal, as on both sides of a load
// Factor by which the penetration may differ from that for which strips were laid, on the way to the balance.
constexpr double ON_THE_WAY = 3.0;
// Near it: permitted increase and decrease of the penetration anywhere, over the deepest. Measured on crowned rollers:
// with the second the error of the load stays below the accuracy of the strips; contacts that outgrow their strips by a
// tenth have three times that error.
constexpr double DEEPER = 0.02, SHALLOWER = 0.12;
constexpr double LIGHT =
    0.1;  // of the deepest contact of all rollers: shallower ones carry too little load to be judged separately
constexpr double UNRESOLVED = 1e-10;  // of it: an overlap whose load the balance does not resolve

/// A number rounded in decimal to so many digits.
double round_to(double value, int places) {
  char text[400];
  std::snprintf(text, sizeof text, "%.*f", std::clamp(places, 0, 330), value);
  return std::strtod(text, nullptr);
}

bool close(View one, View other) {
  return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](double a, double b) {
    return a == b || (std::isfinite(b) && std::abs(a - b) <= 1e-9 * std::abs(b));
  });
}

bool same(const Pose& one, const Pose& other) { return one.approach == other.approach && one.tilt == other.tilt; }

}  // namespace

StripLaw::StripLaw(std::vector<std::shared_ptr<StrippedContact>> contacts, std::optional<Index> strips)
    : few_(strips.has_value()) {
  for (auto& contact : contacts) {
    auto few = few_ ? contact->lay_evenly(*strips) : nullptr;
    sides_.push_back({std::move(contact), std::move(few), {}, {}});
  }
  const Samples &one = sides_.front().contact->samples(), &other = sides_.back().contact->samples();
  alike_ = !few_ && sides_.size() == 2 && one.y == other.y && close(one.h, other.h);
}

void StripLaw::answer(std::span<const Index> rollers, std::span<const Pose> poses, std::span<Answer> answers,
                      const Stop& stop) {
  for (const Index roller : rollers) ++work_.evaluations[roller];
  for (std::size_t side = 0; side < sides_.size(); ++side) answer_side(side, rollers, poses, answers, stop);
}

void StripLaw::answer_side(std::size_t number, std::span<const Index> rollers, std::span<const Pose> poses,
                           std::span<Answer> answers, const Stop& stop) {
  Side& side = sides_[number];
  std::vector<Pose> own;
  double farthest = 1e-300;
  for (std::size_t n = 0; n < rollers.size(); ++n) {
    own.push_back(poses[n * sides_.size() + number]);
    farthest = std::max(farthest, std::abs(own[n].approach));
  }
  const Numbers depth = side.contact->penetration(own);
  for (std::size_t n = 0; n < rollers.size(); ++n) side.depths[rollers[n]] = depth[n];
  const int places = SAME - static_cast<int>(std::floor(std::log10(farthest)));
  const double least = UNRESOLVED * side.deepest();
  // Only the first of equal contacts is evaluated.
  std::map<std::pair<double, double>, std::size_t> first;
  std::vector<std::size_t> like(rollers.size());
  std::vector<Question> missing;
  for (std::size_t n = 0; n < rollers.size(); ++n) {
    if (!(depth[n] > least)) continue;
    const auto key = std::pair(round_to(own[n].approach, places), round_to(own[n].tilt, places));
    like[n] = first.try_emplace(key, n).first->second;
    if (like[n] != n) continue;
    const Question to{rollers[n], own[n], depth[n]};
    if (!try_move(side, to, stop)) missing.push_back(to);
  }
  if (alike_) lay_deeper(number, missing, rollers, poses, stop);
  std::erase_if(missing, [&](const Question& to) { return try_solve(number, to, stop); });
  lay(side, missing, stop);
  for (std::size_t n = 0; n < rollers.size(); ++n) {
    Answer& answer = answers[n * sides_.size() + number];
    answer = {};
    if (depth[n] > least) {
      const SharedContact laid = side.laid.at(rollers[like[n]]);
      side.laid[rollers[n]] = laid;
      const double by = side.contact->compliance();
      const Answer& of = laid->answer;
      answer = {of.load / by,
                of.moment / by,
                of.load_by_approach / by,
                of.load_by_tilt / by,
                of.moment_by_approach / by,
                of.moment_by_tilt / by};
    }
    answer.overlap = depth[n];
  }
}

/// If the other contact of a roller is deeper, lay strips for that one: they suit both.
void StripLaw::lay_deeper(std::size_t number, const std::vector<Question>& missing, std::span<const Index> rollers,
                          std::span<const Pose> poses, const Stop& stop) {
  Side& other = sides_[1 - number];
  std::vector<Pose> opposite;
  for (const Question& to : missing) {
    const auto n = static_cast<std::size_t>(std::find(rollers.begin(), rollers.end(), to.roller) - rollers.begin());
    opposite.push_back(poses[2 * n + 1 - number]);
  }
  const Numbers depth = other.contact->penetration(opposite);
  std::vector<Question> met;
  for (std::size_t k = 0; k < missing.size(); ++k) {
    const Question to{missing[k].roller, opposite[k], depth[k]};
    if (depth[k] > missing[k].depth && !try_move(other, to, stop)) met.push_back(to);
  }
  lay(other, met, stop);
}

void StripLaw::lay(Side& side, const std::vector<Question>& contacts, const Stop& stop) {
  for (const Question& to : contacts) {
    work_.laid_for.push_back(to.pose);
    side.laid[to.roller] = side.contact->lay(to.pose, to.depth, stop);
  }
}

/// Move a contact to the requested pose on its present strips; return whether that succeeds.
bool StripLaw::try_move(Side& side, const Question& to, const Stop& stop) {
  const auto known = side.laid.find(to.roller);
  if (known == side.laid.end() || !(few_ || suits(side, *known->second, to, near_))) return false;
  SharedContact laid = known->second;
  if (!same(laid->pose, to.pose)) {
    SharedContact moved = side.contact->follow(*laid, to.pose);
    ++(moved ? work_.followed : work_.solved);
    laid = moved ? moved : side.contact->solve(*laid, to.pose, stop);
  }
  if (!laid) return false;
  known->second = std::move(laid);
  return true;
}

/// Solve a contact on few strips, or on those of the same roller's other contact if they suit it.
bool StripLaw::try_solve(std::size_t number, const Question& to, const Stop& stop) {
  Side& side = sides_[number];
  SharedContact contact;
  if (few_) {
    ++work_.solved;
    contact = side.contact->solve(side.few, to.pose, to.depth, stop);
  } else if (alike_) {
    const auto other = sides_[1 - number].laid.find(to.roller);
    if (other != sides_[1 - number].laid.end() && suits(side, *other->second, to, true)) {
      contact = side.contact->follow(side.contact->on_strips_of(*other->second), to.pose);
      work_.followed += contact != nullptr;
    }
  }
  if (!contact) return false;
  side.laid[to.roller] = std::move(contact);
  return true;
}

/// Whether strips still suit a contact, on the way to the balance or near it.
bool StripLaw::suits(const Side& side, const LaidContact& laid, const Question& to, bool near) const {
  if (!near) return std::max(to.depth / laid.depth, laid.depth / to.depth) <= ON_THE_WAY;
  const double nearer = to.pose.approach - laid.laid_for.approach;
  const double turned = side.contact->half_length() * std::abs(to.pose.tilt - laid.laid_for.tilt);
  const double beside = std::max(laid.depth, LIGHT * side.deepest());
  return turned + nearer <= DEEPER * beside && turned - nearer <= SHALLOWER * beside;
}

double StripLaw::Side::deepest() const {
  double most = -std::numeric_limits<double>::infinity();
  for (const auto& [roller, depth] : depths) most = std::max(most, depth);
  return most;
}

const Grid& StripLaw::strips(Index roller, Index contact) const {
  return *sides_.at(static_cast<std::size_t>(contact)).laid.at(roller)->level.grid;
}

}  // namespace nonhertz
