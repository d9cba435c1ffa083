#include "output/checkpoint_kept_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "output/checkpoint_expectations.hpp"

namespace blocks::output {

using namespace expectations;

namespace {

void expect_poses(const char* name, const std::vector<KeptPose>& poses, int blocks) {
  for (const KeptPose& pose : poses) {
    expect_index(name, pose.block, blocks);
    expect(name, pose.centroid);
    for (const double value : pose.gradient)
      expect(name, value, finite);
  }
}

void expect_room(const Room& room) {
  expect("kept/pairs/motion", room.motion, not_negative);
  expect("kept/pairs/until", room.until, not_negative);
  expect("kept/pairs/apart", room.then.apart);
  for (const Eigen::Vector4d& gradient : {room.then.low, room.then.high})
    for (const double value : gradient)
      expect("kept/pairs/gradient", value, finite);
}

/// Expects depths below sides that exist.
void expect_depths(const std::vector<KeptDepth>& depths, const Blocks& blocks) {
  std::vector<std::vector<int>> parts(static_cast<std::size_t>(blocks.size()));
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.convex[b])
      parts[b] = {blocks.corners_of(b)};
  blocks.each_cut([&](int b, const auto& corners) {
    parts[b].push_back(static_cast<int>(corners.size()));
  });
  for (const KeptDepth& depth : depths) {
    expect_index("kept/depths/own_block", depth.own_block, blocks.size());
    expect_index("kept/depths/other_block", depth.other_block, blocks.size());
    const std::vector<int>& own = parts[depth.own_block];
    expect_index("kept/depths/own_part", depth.own_part, std::ssize(own));
    expect_index("kept/depths/other_part", depth.other_part,
                 std::ssize(parts[depth.other_block]));
    expect_index("kept/depths/side", depth.side, own[depth.own_part]);
    expect("kept/depths/least", depth.least, finite);
    expect("kept/depths/most", depth.most, finite);
  }
}

void expect_counts(const char* name, long counted, std::size_t rows) {
  if (counted != static_cast<long>(rows))
    reject_checkpoint(fmt::format("{} has {} rows, expected {}", name, rows, counted));
}

}  // namespace

void expect_kept(const Model& model) {
  const KeptDecisions& kept = model.kept;
  expect("kept/blocks", kept.blocks,
         {0.0, static_cast<double>(model.blocks.size()), "at most the number of blocks"});
  expect("kept/most", kept.most, not_negative);
  expect_poses("kept/poses", kept.poses, model.blocks.size());
  std::pair last(-1, -1);
  long contacts = 0, poses = 0, depths = 0;
  for (const KeptPair& pair : kept.pairs) {
    expect_index("kept/pairs/low", pair.low, kept.blocks);
    expect_index("kept/pairs/high", pair.high, kept.blocks);
    if (pair.low >= pair.high || std::pair(pair.low, pair.high) <= last)
      reject_checkpoint("kept/pairs is out of order");
    last = {pair.low, pair.high};
    expect_room(pair.room);
    expect("kept/pairs/contacts", pair.contacts, count_from_0);
    expect("kept/pairs/poses", pair.poses, count_from_0);
    expect("kept/pairs/depths", pair.depths, count_from_0);
    contacts += pair.contacts, poses += pair.poses, depths += pair.depths;
  }
  expect_counts("kept/contacts", contacts, kept.contacts.size());
  expect_counts("kept/poses", poses, kept.poses.size());
  expect_counts("kept/depths", depths, kept.depths.size());
  expect_depths(kept.depths, model.blocks);
  for (const KeptContact& contact : kept.contacts) {
    expect_index("kept/contacts/corner", contact.corner, model.blocks.corners());
    expect_index("kept/contacts/edge", contact.edge, model.blocks.corners());
    if (contact.corner == contact.edge)
      reject_checkpoint("kept/contacts has a corner on its own edge");
  }
  for (const int block : kept.pieces)
    expect_index("kept/pieces", block, model.blocks.size());
}

}  // namespace blocks::output
