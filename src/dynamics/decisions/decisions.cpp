#include "dynamics/decisions/decisions.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "geometry/contact_constants.hpp"

namespace blocks::dynamics {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Returns by how much MotionBounds::most may grow before the motion of a pair can grow
/// by `left`. While `most` grows by d, shift and turn of one block together grow by at
/// most 2 d. The reason is that `turn` is at most four times the motion of an arm,
/// which `most` counts twice. So the motion of two blocks grows by at most 4 d. The
/// motion of a neighbour against one of them adds at most 4 d.
double growth_until(const PairMotion& left) {
  return std::max(0.0, std::min(0.25 * left.two, 0.125 * left.neighbours));
}

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

/// Returns whether the corners of a block are those of its pose. Before its first step
/// they are those of the deck, which may be rounded otherwise.
bool has_corners_of_pose(const Blocks& blocks, int b) {
  const Eigen::Vector4d& g = blocks.gradient.col(b);
  for (int c = blocks.first_corner[b]; c < blocks.first_corner[b + 1]; ++c) {
    const Vec2 arm = blocks.arm.col(c);
    const Vec2 turned(g[0] * arm.x() + g[1] * arm.y(), g[3] * arm.y() + g[2] * arm.x());
    if (blocks.corner.col(c) != blocks.centroid.col(b) + turned)
      return false;
  }
  return true;
}

}  // namespace

void Decisions::begin_phase(const Blocks& blocks) {
  bounds.begin_phase(blocks);
  spoiled = 0;
}

void Decisions::reset(const Blocks& blocks, int pairs) {
  begin_phase(blocks);
  limits.assign(static_cast<std::size_t>(pairs), {});
  next_check.assign(static_cast<std::size_t>(pairs), 0.0);
  renewals.assign(static_cast<std::size_t>(pairs), {});
}

void Decisions::keep_in(const PairIndex& now, const PairIndex& old,
                        const std::vector<char>& changed) {
  const std::vector<char> touched =
      with_new_neighbours(now.neighbours, old.neighbours, changed);
  std::vector<PairMotion> old_limits(now.pairs.size());
  std::vector<double> old_checks(now.pairs.size(), 0.0);
  limits.swap(old_limits);
  next_check.swap(old_checks);
  std::vector<Renewal> old_renewals(now.pairs.size());
  renewals.swap(old_renewals);
  std::size_t k = 0;
  for (std::size_t p = 0; p < now.pairs.size(); ++p) {
    const auto [low, high] = now.pairs[p];
    while (k < old.pairs.size() && old.pairs[k] < now.pairs[p])
      ++k;
    if (k == old.pairs.size() || !(old.pairs[k] == now.pairs[p]))
      continue;
    const bool needs_neighbours = old_limits[k].neighbours < infinite;
    const bool is_piece = !changed.empty() && (changed[low] != 0 || changed[high] != 0);
    if (is_piece || (needs_neighbours && (touched[low] != 0 || touched[high] != 0)))
      continue;
    limits[p] = old_limits[k], next_check[p] = old_checks[k];
    std::swap(renewals[p], old_renewals[k]);
  }
}

PairMotion Decisions::motion_of(const Blocks& blocks, const PairIndex& index, int p,
                                bool neighbours) const {
  const auto [low, high] = index.pairs[p];
  const Vec2 low_shift = bounds.shift(blocks, low),
             high_shift = bounds.shift(blocks, high);
  const double turns = bounds.turn(blocks, low) + bounds.turn(blocks, high);
  const double two = 1.0000001 * (low_shift - high_shift).norm() + turns;
  double farthest = 0.0;
  const auto include = [&](int block, const Vec2& shift) {
    index.neighbours.each(block, [&](int other) {
      const double apart = (bounds.shift(blocks, other) - shift).lpNorm<1>();
      farthest = std::max(farthest, 1.0000001 * apart + bounds.turn(blocks, other));
    });
  };
  if (neighbours)
    include(low, low_shift), include(high, high_shift);
  return {two, two + farthest};
}

void Decisions::keep_exact(const Blocks& blocks, const BlockParts& parts,
                           const PairIndex& index, int p,
                           const std::vector<KeptDepth>& depths) {
  const auto [low, high] = index.pairs[p];
  const double limit =
      geometry::renewal_of_arm * std::min(bounds.longest[low], bounds.longest[high]);
  limits[p] = {limit, limit};
  Renewal& renewal = renewals[p];
  renewal.depths = depths;
  renewal.poses.clear();
  const auto add = [&](int block) {
    if (std::none_of(renewal.poses.begin(), renewal.poses.end(),
                     [&](const KeptPose& pose) { return pose.block == block; }))
      renewal.poses.push_back(
          {block, blocks.centroid.col(block), blocks.gradient.col(block)});
  };
  add(low);
  index.neighbours.each(low, add);
  index.neighbours.each(high, add);
  // The audit rebuilds the corners of blocks that move from these poses.
  for (const KeptPose& pose : renewal.poses)
    if ((blocks.is_free(pose.block) || blocks.is_driven(pose.block)) &&
        !has_corners_of_pose(blocks, pose.block))
      return expire(p);
  renewal.next_check = 0.0;
  next_check[p] = bounds.most + growth_left(blocks, parts, index, p);
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
        bounds.longest[kept.other_block];
    const double hold = (bounds.rigid ? 1.0 : 0.25) *
                        std::min(1.0, 2.0 * bounds.longest[kept.own_block] / away);
    least = std::min(least, hold * std::min(depth - kept.least, kept.most - depth));
  }
  return least;
}

double Decisions::growth_left(const Blocks& blocks, const BlockParts& parts,
                              const PairIndex& index, int p) {
  if (!renewals[p].empty()) {
    Renewal& renewal = renewals[p];
    const double to_limits = motion_to_limits(blocks, parts, renewal.depths);
    if (!(to_limits > 0.0))
      return 0.0;
    if (!(bounds.most < renewal.next_check)) {
      const double left = limits[p].two - motion_since(blocks, renewal.poses);
      renewal.next_check = bounds.most + growth_until({left, left});
    }
    // Corners are rounded in each step. At a distance below that, every step checks.
    const auto [low, high] = index.pairs[p];
    const double rounding =
        0x1p-50 * (blocks.centroid.col(low).lpNorm<1>() + bounds.longest[low] +
                   blocks.centroid.col(high).lpNorm<1>() + bounds.longest[high]);
    return std::min(std::max(growth_until({to_limits - rounding, infinite}),
                             std::numeric_limits<double>::min()),
                    renewal.next_check - bounds.most);
  }
  const bool neighbours = limits[p].neighbours < infinite;
  const PairMotion now = motion_of(blocks, index, p, neighbours);
  return growth_until({limits[p].two - now.two, limits[p].neighbours - now.neighbours});
}

bool Decisions::keep(const Blocks& blocks, const PairIndex& index, int p,
                     const PairMotion& room) {
  renewals[p].clear();
  // A motion from now on is at most the sum of the motions of the phase until now and
  // until then. So the limits are the rooms less the motions until now.
  const PairMotion now = motion_of(blocks, index, p, room.neighbours < infinite);
  limits[p] = {room.two - now.two, room.neighbours - now.neighbours};
  next_check[p] = bounds.most + growth_until({limits[p].two - now.two,
                                              limits[p].neighbours - now.neighbours});
  return limits[p].two < 0.5 * room.two || limits[p].neighbours < 0.5 * room.neighbours;
}

void Decisions::carry_over(const Blocks& blocks, const BlockParts& parts,
                           const PairIndex& index, int begin, int end) {
  for (int p = begin; p < end; ++p) {
    if (!renewals[p].empty()) {
      next_check[p] = growth_left(blocks, parts, index, p);
      renewals[p].next_check -= bounds.most;
      continue;
    }
    PairMotion& limit = limits[p];
    const PairMotion now = motion_of(blocks, index, p, limit.neighbours < infinite);
    limit.two -= now.two, limit.neighbours -= now.neighbours;
    next_check[p] = growth_until(limit);
  }
}

}  // namespace blocks::dynamics
