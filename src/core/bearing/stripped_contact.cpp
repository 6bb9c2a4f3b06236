#include "bearing/stripped_contact.hpp"

#include <algorithm>
#include <limits>

#include "grids/levels.hpp"
#include "numbers/sums.hpp"

namespace nonhertz {
namespace {

constexpr Index PLACES = 256, LOOKS = 33;  // intervals along the contact, and points between two of them
constexpr int CLOSER_LOOKS = 4;
constexpr std::size_t KEPT_LOOPS = 32;  // each takes about half a megabyte
constexpr Prescription MOVED{{false, false}, {0.0, 0.0}};

Prescription displaced_to(const Pose& pose) { return {{false, false}, {pose.approach, pose.tilt}}; }

/// Ascending and without repeats.
Numbers unique(Numbers places) {
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

Numbers even_places(double low, double high, Index intervals) {
  const double step = (high - low) / static_cast<double>(intervals);
  Numbers places;
  for (Index i = 0; i < intervals; ++i) places.push_back(static_cast<double>(i) * step + low);
  places.push_back(high);
  return places;
}

}  // namespace

StrippedContact::StrippedContact(std::shared_ptr<const Model> model)
    : model_(std::move(model)), kernel_(model_, &model_->kernel()) {
  const Pair interval = bound_contact(*model_, MOVED);
  low_ = interval[0], high_ = interval[1];
  samples_.y = even_places(low_, high_, PLACES);
  for (const double crest : model_->contact().crests)
    if (low_ < crest && crest < high_) samples_.y.push_back(crest);
  samples_.y = unique(std::move(samples_.y));
  samples_.h = model_->separation(samples_.y);
}

Numbers StrippedContact::penetration(std::span<const Pose> poses) const {
  Numbers most(poses.size(), -std::numeric_limits<double>::infinity());
  if (poses.empty()) return most;
  View y = samples_.y, h = samples_.h;
  std::size_t count = y.size(), apart = 0;  // distance between the places of two poses: zero at first
  Numbers closer_y, closer_h;
  // A law that missed an overlap between two places would jump from zero load: search closer and closer.
  for (int look = 0;; ++look) {
    Numbers nearer;
    for (std::size_t n = 0; n < poses.size(); ++n) {
      const View places = y.subspan(n * apart, count), separation = h.subspan(n * apart, count);
      const auto overlap = [&](std::size_t k) { return poses[n].approach + poses[n].tilt * places[k] - separation[k]; };
      std::size_t deepest = 0;
      double deep = overlap(0);
      for (std::size_t k = 1; k < count; ++k)
        if (const double here = overlap(k); here > deep) deep = here, deepest = k;
      most[n] = std::max(most[n], deep);
      const Numbers between =
          even_places(places[deepest > 0 ? deepest - 1 : 0], places[std::min(deepest + 1, count - 1)], LOOKS - 1);
      nearer.insert(nearer.end(), between.begin(), between.end());
    }
    if (look == CLOSER_LOOKS - 1) return most;
    closer_y = std::move(nearer), closer_h = model_->separation(closer_y);
    y = closer_y, h = closer_h;
    count = apart = LOOKS;
  }
}

std::shared_ptr<const Grid> StrippedContact::lay_evenly(Index strips) const {
  Numbers edges = even_places(low_, high_, strips);
  // Where corners begin, or else at the ends, in parts: a roller that tips over may carry its load close to there.
  double low = low_, high = high_;
  bool bends_low = false, bends_high = false;
  for (const double bend : model_->contact().bends) {
    if (!(low_ < bend && bend < high_)) continue;
    if (bend < edges[1]) low = bends_low ? std::max(low, bend) : bend, bends_low = true;
    if (bend > edges[edges.size() - 2]) high = bends_high ? std::min(high, bend) : bend, bends_high = true;
  }
  const double width = edges[1] - edges[0];
  for (const double part : {0.0, 1.0 / 16.0, 1.0 / 4.0}) edges.push_back(low + width * part);
  for (const double part : {0.0, 1.0 / 16.0, 1.0 / 4.0}) edges.push_back(high - width * part);
  return model_->grid(unique(std::move(edges)));
}

SharedContact StrippedContact::lay(const Pose& pose, double depth, const Stop& stop) const {
  Levels levels = solve_automatically(*model_, displaced_to(pose), Accuracy{}, &stop);
  Level& finest = levels.levels[0];
  if (!finest.state.converged()) throw Unsolved{pose};
  return with_answer({std::move(finest), pose, depth, pose, {}});
}

SharedContact StrippedContact::solve(std::shared_ptr<const Grid> strips, const Pose& pose, double depth,
                                     const Stop& stop) const {
  Attempt attempt;
  attempt.patient = false, attempt.stop = &stop;
  State state = solve_on(*strips, displaced_to(pose), *kernel_, attempt);
  if (!state.converged()) return {};
  return with_answer({{std::move(strips), std::move(state)}, pose, depth, pose, {}});
}

SharedContact StrippedContact::solve(const LaidContact& before, const Pose& pose, const Stop& stop) const {
  Attempt attempt;
  attempt.near = &before.level, attempt.patient = false, attempt.stop = &stop;
  State state = solve_on(*before.level.grid, displaced_to(pose), *kernel_, attempt);
  if (!state.converged()) return {};
  return with_answer({{before.level.grid, std::move(state)}, before.laid_for, before.depth, pose, {}});
}

SharedContact StrippedContact::follow(const LaidContact& before, const Pose& pose) {
  const Grid* strips = before.level.grid.get();
  auto loop = loops_.find(strips);
  if (loop == loops_.end()) {
    if (loops_.size() >= KEPT_LOOPS) loops_.clear();
    loop = loops_.try_emplace(strips, before.level.grid, kernel_).first;
  }
  State state = before.level.state;
  const auto resultant = loop->second.follow({pose.approach, pose.tilt}, state);
  if (!resultant) return {};
  const auto& stiff = state.stiffness;
  const Answer answer{(*resultant)[0], (*resultant)[1], stiff[0][0], stiff[0][1], stiff[1][0], stiff[1][1]};
  return std::make_shared<const LaidContact>(
      LaidContact{{before.level.grid, std::move(state)}, before.laid_for, before.depth, pose, answer});
}

LaidContact StrippedContact::on_strips_of(const LaidContact& other) const {
  LaidContact guess = other;
  const Grid& strips = *other.level.grid;
  guess.level.grid = model_->grid(strips.edges);
  // Under equal load half-widths are proportional to the roots of the radii, and r to the curvature.
  for (Index i = 0; i < strips.count(); ++i) {
    const double sharper = guess.level.grid->curvature[i] / strips.curvature[i];
    guess.level.state.r[i] *= sharper, guess.level.state.m[i] /= sharper;
  }
  return guess;
}

/// The same with its results.
SharedContact StrippedContact::with_answer(LaidContact contact) const {
  const auto& [grid, state] = contact.level;
  Numbers loads, moments;
  for (Index i = 0; i < grid->count(); ++i) {
    loads.push_back(state.r[i] * state.m[i] * grid->width(i));
    moments.push_back(loads.back() * grid->y[i]);
  }
  const auto& stiff = state.stiffness;
  contact.answer = {sum_of(loads), sum_of(moments), stiff[0][0], stiff[0][1], stiff[1][0], stiff[1][1]};
  return std::make_shared<const LaidContact>(std::move(contact));
}

}  // namespace nonhertz
