#include "dynamics/decisions/decisions.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

#include "geometry/contact_constants.hpp"

namespace blocks::dynamics {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using geometry::Certainty;

/// No path grows by more than MotionBounds::longest_path.
constexpr double motion_per_growth = 2.0 * Certainty::motion_per_path;

/// Returns which blocks have a neighbour that is new or has changed, (blocks).
std::vector<char> with_new_neighbours(const Groups& now, const Groups& old,
                                      const std::vector<char>& changed) {
  std::vector<char> found(static_cast<std::size_t>(now.groups()), 0);
  for (int b = 0; b < now.groups(); ++b) {
    const bool existed = b < old.groups();
    int k = existed ? old.first[b] : 0;
    const int end = existed ? old.first[b + 1] : 0;
    now.each(b, [&](int other) {
      while (k < end && old.item[k] < other)
        ++k;
      const bool is_new = k == end || old.item[k] != other;
      if (is_new || (!changed.empty() && changed[other] != 0))
        found[b] = 1;
    });
  }
  return found;
}

/// Returns whether the corners of a block are those of a pose. Before its first step
/// they are those of the deck, which may be rounded otherwise.
bool has_corners_of(const Blocks& blocks, const KeptPose& pose) {
  for (int c = blocks.first_corner[pose.block]; c < blocks.first_corner[pose.block + 1];
       ++c)
    if (blocks.corner.col(c) != pose.corner(blocks.arm.col(c)))
      return false;
  return true;
}

}  // namespace

void Decisions::keep_in(const PairIndex& now, const PairIndex& old,
                        const std::vector<char>& changed) {
  const std::vector<char> touched =
      with_new_neighbours(now.neighbours, old.neighbours, changed);
  std::vector<PairDecision> old_pairs(now.pairs.size());
  std::vector<double> old_checks(now.pairs.size(), 0.0);
  pairs.swap(old_pairs), next_check.swap(old_checks);
  std::size_t k = 0;
  for (std::size_t p = 0; p < now.pairs.size(); ++p) {
    const auto [low, high] = now.pairs[p];
    while (k < old.pairs.size() && old.pairs[k] < now.pairs[p])
      ++k;
    if (k == old.pairs.size() || !(old.pairs[k] == now.pairs[p]))
      continue;
    const bool needs_neighbours =
        old_pairs[k].is_exact() || old_pairs[k].validity.until < infinite;
    const bool is_piece = !changed.empty() && (changed[low] != 0 || changed[high] != 0);
    if (is_piece || (needs_neighbours && (touched[low] != 0 || touched[high] != 0)))
      continue;
    pairs[p] = std::move(old_pairs[k]);
    next_check[p] = old_checks[k];
  }
}

void Decisions::keep_certain(const Blocks& blocks, const NearPair& pair, int p,
                             double validity, double growth) {
  const auto [low, high] = pair;
  pairs[p].end_renewal();
  pairs[p].validity = {validity,
                       bounds.longest_path + growth,
                       {blocks.centroid.col(high) - blocks.centroid.col(low),
                        blocks.gradient.col(low), blocks.gradient.col(high)}};
  postpone(pair, p, validity, pairs[p].validity.until);
}

void Decisions::keep_exact(const Blocks& blocks, const BlockParts& parts,
                           const PairIndex& index, int p,
                           const std::vector<KeptDepth>& depths, bool asked_of_third) {
  const auto [low, high] = index.pairs[p];
  pairs[p].validity = {};
  if (pairs[p].renewal == nullptr)
    pairs[p].renewal = std::make_unique<Renewal>();
  Renewal& renewal = *pairs[p].renewal;
  renewal.depths = depths;
  renewal.poses.clear();
  const auto add = [&](int block) {
    renewal.poses.push_back(
        {block, blocks.centroid.col(block), blocks.gradient.col(block)});
  };
  add(low), add(high);
  index.each_beside(index.pairs[p], asked_of_third, add);
  // The audit rebuilds the corners of blocks that move from these poses.
  for (const KeptPose& pose : renewal.poses)
    if ((blocks.is_free(pose.block) || blocks.is_driven(pose.block)) &&
        !has_corners_of(blocks, pose))
      return expire(p);
  pairs[p].examined_at_pair_path = 0.0;
  pairs[p].examined_at_longest_path =
      bounds.longest_path + renewal_motion(low, high) / motion_per_growth;
  holds(blocks, parts, index.pairs[p], p);
}

double Decisions::motion_since(const Blocks& blocks, const NearPair& pair,
                               const PairPose& pose) const {
  const auto [low, high] = pair;
  const Vec2 apart = blocks.centroid.col(high) - blocks.centroid.col(low);
  return Certainty::shift_factor * (apart - pose.apart).norm() +
         bounds.turn(blocks, low, pose.low.data()) +
         bounds.turn(blocks, high, pose.high.data());
}

double Decisions::motion_since(const Blocks& blocks,
                               const std::vector<KeptPose>& kept) const {
  const auto shift = [&](const KeptPose& pose) -> Vec2 {
    return blocks.centroid.col(pose.block) - pose.centroid;
  };
  const auto turn = [&](const KeptPose& pose) {
    return bounds.turn(blocks, pose.block, pose.gradient.data());
  };
  const Vec2 own = shift(kept.front());
  double max = 0.0;
  for (const KeptPose& pose : kept)
    max = std::max(max,
                   Certainty::shift_factor * (shift(pose) - own).norm() + turn(pose));
  return max + turn(kept.front());
}

double Decisions::renewal_motion(int low, int high) const {
  return geometry::renewal_of_arm * std::min(bounds.longest[low], bounds.longest[high]);
}

double Decisions::motion_to_limits(const Blocks& blocks, const BlockParts& parts,
                                   const std::vector<KeptDepth>& depths) const {
  double min = infinite;
  for (const KeptDepth& kept : depths) {
    const int own = parts.first_part(kept.own_block) + kept.own_part,
              other = parts.first_part(kept.other_block) + kept.other_part;
    const Side side = parts.side(own, kept.side);
    const Vec2 start = blocks.corner.col(side.start),
               along = blocks.corner.col(side.end) - start;
    double depth = -infinite;
    for (int k = 0; k < parts.corners(other); ++k)
      depth = std::max(
          depth,
          geometry::cross(blocks.corner.col(parts.corner(other, k)) - start, along));
    depth /= along.norm();
    // Seen from `own`, corners of `other` move faster than the pair if they are far.
    const double away =
        (blocks.centroid.col(kept.other_block) - blocks.centroid.col(kept.own_block))
            .norm() +
        bounds.stretch(blocks, kept.other_block) * bounds.longest[kept.other_block];
    const double slowness = (bounds.rigid ? 1.0 : Certainty::strain_share) *
                            std::min(1.0, 2.0 * bounds.longest[kept.own_block] / away);
    min = std::min(min, slowness * std::min(depth - kept.min, kept.max - depth));
  }
  return min;
}

void Decisions::postpone(const NearPair& pair, int p, double motion,
                         double longest_path) {
  pairs[p].examined_at_pair_path =
      bounds.path_of(pair.low, pair.high) + motion / Certainty::motion_per_path;
  pairs[p].examined_at_longest_path = longest_path;
  set_next_check(pair, p);
}

bool Decisions::set_next_check(const NearPair& pair, int p) {
  const double path_left =
      pairs[p].examined_at_pair_path - bounds.path_of(pair.low, pair.high);
  // Each of the two paths may grow as much as the longest path.
  const double growth = std::min(0.5 * path_left, pairs[p].examined_at_longest_path -
                                                      bounds.longest_path);
  next_check[p] = bounds.longest_path + growth;
  return growth > 0.0;
}

bool Decisions::holds(const Blocks& blocks, const BlockParts& parts,
                      const NearPair& pair, int p) {
  if (set_next_check(pair, p))
    return true;
  const auto [low, high] = pair;
  if (!pairs[p].is_exact()) {
    const Validity& validity = pairs[p].validity;
    const double left = validity.distance - motion_since(blocks, pair, validity.pose);
    postpone(pair, p, left, validity.until);
    return left > 0.0 && bounds.longest_path < validity.until;
  }
  const Renewal& renewal = *pairs[p].renewal;
  const double to_limits = motion_to_limits(blocks, parts, renewal.depths);
  if (!(to_limits > 0.0))
    return false;
  double end = pairs[p].examined_at_longest_path;
  if (!(bounds.longest_path < end)) {
    const double left = renewal_motion(low, high) - motion_since(blocks, renewal.poses);
    end = bounds.longest_path + left / motion_per_growth;
  }
  // Corners are rounded in each step. At a distance below that, every step checks.
  const double rounding =
      Certainty::corner_rounding *
      (blocks.centroid.col(low).lpNorm<1>() + bounds.longest[low] +
       blocks.centroid.col(high).lpNorm<1>() + bounds.longest[high]);
  postpone(pair, p, to_limits - rounding, end);
  return bounds.longest_path < end;
}

}  // namespace blocks::dynamics
