// The automatic grid: equal strips find the contact, a rough graded grid locates its ends and bends, and the final grid
// is solved with half its strips and with all; and again, if that shows that strips are too wide or too few.
#pragma once

#include "grids/levels.hpp"

namespace nonhertz {

/// Solves one case on a sequence of better grids.
class Search {
 public:
  Search(const Model& model, const Prescription& prescribed, const Accuracy& accuracy, const Stop* stop);

  /// Return the levels, finest first, those without a solution among them.
  std::vector<Level> run();

 private:
  Level locate() const;
  std::optional<Pair> narrower(const Level& level) const;
  void add_halves(std::vector<Level>& levels) const;
  Plan plan(const Level& from) const;
  Level finer(const Plan& plan, const Level& near, double share) const;
  std::vector<Extra> extras(const Level& level) const;
  Level solve_level(std::shared_ptr<const Grid> grid, const Level* near, double tolerance, bool patient) const;
  double finer_wanted(const Level& finest, const Level& half) const;
  double error_over_accuracy(const Level& finest, const Level& half) const;
  bool is_incomplete(const Level& level) const;
  bool is_pointed(const Level& level) const;

  const Model& model_;
  const Prescription& prescribed_;
  Accuracy accuracy_;
  const Stop* stop_;
  std::shared_ptr<const Region> region_;
  double coarseness_, sagitta_;  // the latter: permitted sagitta of the largest pressure within a strip, relative
};

}  // namespace nonhertz
