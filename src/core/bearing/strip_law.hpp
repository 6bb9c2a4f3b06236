// Contact law of rollers by strips: contacts are moved on their present strips as long as these suit them.
#pragma once

#include <optional>
#include <unordered_map>

#include "bearing/stripped_contact.hpp"

namespace nonhertz {

/// Cost of the evaluations of a law.
struct StripWork {
  std::unordered_map<Index, Index> evaluations;  ///< number of evaluations of the contacts of each roller
  std::vector<Pose> laid_for;                    ///< poses for which automatic strips were laid
  Index followed = 0, solved = 0;                ///< numbers of contacts moved to other poses, and solved on strips
};

class StripLaw : public GroupLaw {
 public:
  /// Contacts of a roller, with both rings or one of them; and an approximate number of strips, nearly equal and laid
  /// once, which is fast. Without a number, strips of the automatic grid are laid when a contact is first evaluated,
  /// and again when its penetration has changed. If both contacts have the same separation, both use the same strips.
  StripLaw(std::vector<std::shared_ptr<StrippedContact>> contacts, std::optional<Index> strips);
  StripLaw(const StripLaw&) = delete;

  void answer(std::span<const Index> rollers, std::span<const Pose> poses, std::span<Answer> answers,
              const Stop& stop) override;

  /// From now on, lay new strips for contacts that differ from those for which the strips were laid.
  void lay_anew() { near_ = true; }
  /// The strips on which a contact was solved last.
  const Grid& strips(Index roller, Index contact) const;
  const StripWork& work() const { return work_; }

 private:
  /// Contacts of rollers with one ring.
  struct Side {
    std::shared_ptr<StrippedContact> contact;
    std::shared_ptr<const Grid> few;
    std::unordered_map<Index, SharedContact> laid;
    std::unordered_map<Index, double> depths;

    double deepest() const;
  };
  /// A contact of one roller to be moved.
  struct Question {
    Index roller;
    Pose pose;
    double depth;
  };

  void answer_side(std::size_t side, std::span<const Index> rollers, std::span<const Pose> poses,
                   std::span<Answer> answers, const Stop& stop);
  void lay_deeper(std::size_t side, const std::vector<Question>& missing, std::span<const Index> rollers,
                  std::span<const Pose> poses, const Stop& stop);
  void lay(Side& side, const std::vector<Question>& contacts, const Stop& stop);
  bool try_move(Side& side, const Question& to, const Stop& stop);
  bool try_solve(std::size_t side, const Question& to, const Stop& stop);
  bool suits(const Side& side, const LaidContact& laid, const Question& to, bool near) const;

  std::vector<Side> sides_;
  bool few_, alike_, near_ = false;
  StripWork work_;
};

}  // namespace nonhertz
