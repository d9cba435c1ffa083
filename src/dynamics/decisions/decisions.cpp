#include "dynamics/decisions/decisions.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "geometry/contact_constants.hpp"

namespace blocks::dynamics {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The motion of a pair grows by at most what the paths of its two blocks grow by. The
/// rest covers rounding.
constexpr double motion_per_path = 1.000001;
/// No path grows by more than MotionBounds::most.
constexpr double motion_per_growth = 2.0 * motion_per_path;

/// Returns which blocks have a new neighbour, (blocks).
std::vector<char> with_new_neighbours(const Groups& now, const Groups& old) {
  std::vector<char> found(static_cast<std::size_t>(now.groups()), 0);
  for (int b = 0; b < now.groups(); ++b) {
    int k = old.first[b];
    const int end = old.first[b + 1];
    now.each(b, [&](int other) {
      while (k < end && old.item[k] < other)
        ++k;
      if (k == end || old.item[k] != other)
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

void Decisions::reset(int pairs) {
  rooms.assign(static_cast<std::size_t>(pairs), {});
  next_examination.assign(static_cast<std::size_t>(pairs), {});
  next_check.assign(static_cast<std::size_t>(pairs), 0.0);
  renewals.assign(static_cast<std::size_t>(pairs), {});
}

void Decisions::keep_in(const PairIndex& now, const PairIndex& old) {
  const std::vector<char> touched =
      with_new_neighbours(now.neighbours, old.neighbours);
  std::vector<Room> old_rooms(now.pairs.size());
  std::vector<NextExamination> old_examination(now.pairs.size());
  std::vector<double> old_checks(now.pairs.size(), 0.0);
  std::vector<Renewal> old_renewals(now.pairs.size());
  rooms.swap(old_rooms), renewals.swap(old_renewals);
  next_examination.swap(old_examination), next_check.swap(old_checks);
  std::size_t k = 0;
  for (std::size_t p = 0; p < now.pairs.size(); ++p) {
    const auto [low, high] = now.pairs[p];
    while (k < old.pairs.size() && old.pairs[k] < now.pairs[p])
      ++k;
    if (k == old.pairs.size() || !(old.pairs[k] == now.pairs[p]))
      continue;
    const bool needs_neighbours =
        !old_renewals[k].empty() || old_rooms[k].until < infinite;
    if (needs_neighbours && (touched[low] != 0 || touched[high] != 0))
      continue;
    rooms[p] = old_rooms[k], next_examination[p] = old_examination[k];
    next_check[p] = old_checks[k];
    std::swap(renewals[p], old_renewals[k]);
  }
}

void Decisions::keep_certain(const Blocks& blocks, const NearPair& pair, int p,
                             double room, double growth) {
  const auto [low, high] = pair;
  renewals[p].clear();
  rooms[p] = {room,
              bounds.most + growth,
              {blocks.centroid.col(high) - blocks.centroid.col(low),
               blocks.gradient.col(low), blocks.gradient.col(high)}};
  postpone(pair, p, room, rooms[p].until);
}

void Decisions::keep_exact(const Blocks& blocks, const BlockParts& parts,
                           const PairIndex& index, int p,
                           const std::vector<KeptDepth>& depths, bool asked_of_third) {
  const auto [low, high] = index.pairs[p];
  rooms[p] = {};
  Renewal& renewal = renewals[p];
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
  next_examination[p] = {0.0,
                         bounds.most + renewal_motion(low, high) / motion_per_growth};
  holds(blocks, parts, index.pairs[p], p);
}

double Decisions::motion_since(const Blocks& blocks, const NearPair& pair,
                               const PairPose& then) const {
  const auto [low, high] = pair;
  const Vec2 apart = blocks.centroid.col(high) - blocks.centroid.col(low);
  return 1.0000001 * (apart - then.apart).norm() +
         bounds.turn(blocks, low, then.low.data()) +
         bounds.turn(blocks, high, then.high.data());
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
  double most = 0.0;
  for (const KeptPose& pose : kept)
    most = std::max(most, 1.0000001 * (shift(pose) - own).norm() + turn(pose));
  return most + turn(kept.front());
}

double Decisions::renewal_motion(int low, int high) const {
  return geometry::renewal_of_arm * std::min(bounds.longest[low], bounds.longest[high]);
}

double Decisions::motion_to_limits(const Blocks& blocks, const BlockParts& parts,
                                   const std::vector<KeptDepth>& depths) const {
  double least = infinite;
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
    const double hold = (bounds.rigid ? 1.0 : 0.25) *
                        std::min(1.0, 2.0 * bounds.longest[kept.own_block] / away);
    least = std::min(least, hold * std::min(depth - kept.least, kept.most - depth));
  }
  return least;
}

void Decisions::postpone(const NearPair& pair, int p, double motion, double all) {
  next_examination[p] = {bounds.path_of(pair.low, pair.high) + motion / motion_per_path,
                         all};
  is_postponed(pair, p);
}

bool Decisions::is_postponed(const NearPair& pair, int p) {
  const double own = next_examination[p].own - bounds.path_of(pair.low, pair.high),
               growth = std::min(0.5 * own, next_examination[p].all - bounds.most);
  next_check[p] = bounds.most + growth;
  return growth > 0.0;
}

bool Decisions::holds(const Blocks& blocks, const BlockParts& parts,
                      const NearPair& pair, int p) {
  if (is_postponed(pair, p))
    return true;
  const Renewal& renewal = renewals[p];
  const auto [low, high] = pair;
  if (renewal.empty()) {
    const Room& room = rooms[p];
    const double left = room.motion - motion_since(blocks, pair, room.then);
    postpone(pair, p, left, room.until);
    return left > 0.0 && bounds.most < room.until;
  }
  const double to_limits = motion_to_limits(blocks, parts, renewal.depths);
  if (!(to_limits > 0.0))
    return false;
  double all = next_examination[p].all;
  if (!(bounds.most < all)) {
    const double left = renewal_motion(low, high) - motion_since(blocks, renewal.poses);
    all = bounds.most + left / motion_per_growth;
  }
  // Corners are rounded in each step. At a distance below that, every step checks.
  const double rounding =
      0x1p-50 * (blocks.centroid.col(low).lpNorm<1>() + bounds.longest[low] +
                 blocks.centroid.col(high).lpNorm<1>() + bounds.longest[high]);
  postpone(pair, p, to_limits - rounding, all);
  return bounds.most < all;
}

}  // namespace blocks::dynamics
