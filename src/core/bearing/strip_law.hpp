// How the contacts of rollers answer by strips: moved on those that they have as long as these suit them.
#pragma once

#include <optional>
#include <unordered_map>

#include "bearing/stripped_contact.hpp"

namespace nonhertz {

/// What the answers of a law took.
struct StripWork {
  std::unordered_map<Index, Index> asked;  ///< how often the contacts of each roller were
  std::vector<Pose> laid_for;              ///< poses for which automatic strips were laid
  Index followed = 0, solved = 0;          ///< contacts that were led to other poses, and that were solved on strips
};

class StripLaw : public GroupLaw {
 public:
  /// Contacts of a roller, with both rings, or one of them; and about how many strips, nearly equal and laid once,
  /// which is fast; without a number, those of the automatic grid, laid when a contact is first asked for, and again
  /// when its penetration has become another one. If the bodies are as far apart in both contacts, both use the same
  /// strips.
  StripLaw(std::vector<std::shared_ptr<StrippedContact>> contacts, std::optional<Index> strips);
  StripLaw(const StripLaw&) = delete;

  void answer(std::span<const Index> rollers, std::span<const Pose> poses, std::span<Answer> answers,
              const Stop& stop) override;

  /// From now on lay strips anew for contacts that are not nearly those which they were laid for.
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
  /// A contact of one roller that is to be moved.
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
  bool moves(Side& side, const Question& to, const Stop& stop);
  bool takes(std::size_t side, const Question& to, const Stop& stop);
  bool suits(const Side& side, const LaidContact& laid, const Question& to, bool near) const;

  std::vector<Side> sides_;
  bool few_, alike_, near_ = false;
  StripWork work_;
};

}  // namespace nonhertz
