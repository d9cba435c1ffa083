#include "audit/kept_pairs.hpp"

#include <algorithm>

#include "audit/held_contacts.hpp"
#include "audit/make_exact_rule.hpp"
#include "model/numbering.hpp"

namespace blocks::audit {
KeptPairs::KeptPairs(const Moment& moment)
    : blocks_(moment.blocks), order_(moment.order) {
  const auto outside = [&](int b) { return number_in_deck(order_, b); };
  auto pose = moment.kept.poses.begin();
  for (const KeptPair& pair : moment.kept.pairs) {
    std::vector<KeptPose> poses(pose, pose + pair.poses);
    pose += pair.poses;
    if (poses.empty())
      continue;
    for (KeptPose& one : poses)
      one.block = outside(one.block);
    poses_.emplace(std::minmax(outside(pair.low), outside(pair.high)),
                   std::move(poses));
  }
}

Blocks KeptPairs::blocks_at(const std::vector<KeptPose>& poses) const {
  Blocks then = blocks_;
  for (const KeptPose& pose : poses) {
    const int b = pose.block;
    if (then.centroid.col(b) == pose.centroid && then.gradient.col(b) == pose.gradient)
      continue;  // corners that have never moved are not sums of centroid and arm
    then.centroid.col(b) = pose.centroid, then.gradient.col(b) = pose.gradient;
    for (int c = then.first_corner[b]; c < then.first_corner[b + 1]; ++c)
      then.corner.col(c) = pose.corner(then.arm.col(c));
  }
  return then;
}

std::optional<std::vector<std::pair<int, int>>>
KeptPairs::contacts(const BlockPair& pair,
                    const std::vector<std::pair<int, int>>& acting,
                    const ExactPairRule& now) const {
  const auto found = poses_.find(pair);
  if (found == poses_.end())
    return std::nullopt;
  const Blocks then = blocks_at(found->second);
  const ExactPairRule rule = make_exact_rule(then, 0.0, order_);
  std::vector<std::pair<int, int>> all;
  for (const PartDecision& parts : rule.decide(pair.first, pair.second).parts)
    for (const Candidate& candidate : parts.candidates) {
      const CornerEdge contact(candidate.corner, candidate.side.start);
      if (candidate.side.inner || candidate.far)
        continue;
      const int on =
          is_on_edge(blocks_, contact, now.overlap(contact.first, contact.second));
      if (on > 0 ||
          (on < 0 && std::binary_search(acting.begin(), acting.end(), contact)))
        all.push_back(contact);
    }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace blocks::audit
