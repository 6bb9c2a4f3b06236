#include "bearing/assembly.hpp"

namespace nonhertz {

Assembly::Assembly(std::vector<Small<3, 5>> ring_of, const std::vector<Joint>& joints, std::vector<Vector<3>> load_of,
                   double lever, double stiffness_of)
    : ring(std::move(ring_of)),
      load(std::move(load_of)),
      columns(0),
      scale{1.0, 1.0, lever},
      reach{},
      stiffness(stiffness_of) {
  for (const Joint& joint : joints) columns = std::max(columns, joint.column + 1);
  contacts_.resize(ring.size() * static_cast<std::size_t>(columns));
  for (const Joint& joint : joints) join(joint, static_cast<Index>(laws_.size())), laws_.push_back(joint.law);
  for (const Small<3, 5>& at : ring)
    for (const Vector<5>& row : at)
      for (Index b = 0; b < 5; ++b) reach[b] = std::max(reach[b], std::abs(row[b]));
  // A single roller is not affected by motions across it.
  reach[1] = reach[2] = std::max(reach[1], reach[2]);
  reach[3] = reach[4] = std::max(reach[3], reach[4]);
}

void Assembly::join(const Joint& joint, Index law) {
  const auto count = static_cast<Index>(joint.gap.size());
  for (Index k = 0; k < count; ++k)
    contacts_[static_cast<std::size_t>((joint.first + k) * columns + joint.column)] = {
        joint.motion, joint.gap[static_cast<std::size_t>(k)], joint.inner, law};
  const auto* group_law = std::get_if<std::shared_ptr<GroupLaw>>(&joint.law);
  if (!group_law) return;
  for (Group& group : groups_)
    if (group.law == *group_law) return group.columns.push_back(joint.column);
  groups_.push_back({*group_law, joint.first, joint.first + count, {joint.column}});
}

}  // namespace nonhertz
