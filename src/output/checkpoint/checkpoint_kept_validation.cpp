#include <utility>

#include "model/numbering.hpp"
#include "output/checkpoint/checkpoint_expectations.hpp"

namespace blocks::output {
namespace {

/// Expects depths below sides that exist. Their blocks have the numbers of the steps.
void expect_depths(const Model& model) {
  const Blocks& blocks = model.blocks;
  std::vector<std::vector<int>> parts(static_cast<std::size_t>(blocks.size()));
  for (int b = 0; b < blocks.size(); ++b)
    if (blocks.convex[b])
      parts[b] = {blocks.corners_of(b)};
  blocks.each_cut([&](int b, const auto& corners) {
    parts[b].push_back(static_cast<int>(corners.size()));
  });
  const auto parts_of = [&](const char* name, int b) -> const std::vector<int>& {
    if (!model.order.empty())
      expect_index(name, b, std::ssize(model.order));
    const int block = number_in_deck(model.order, b);
    expect_index("order", block, blocks.size());
    return parts[block];
  };
  for (const KeptDepth& depth : model.kept.depths) {
    const std::vector<int>& own = parts_of("kept/depths/own_block", depth.own_block);
    const std::vector<int>& other =
        parts_of("kept/depths/other_block", depth.other_block);
    expect_index("kept/depths/own_part", depth.own_part, std::ssize(own));
    expect_index("kept/depths/other_part", depth.other_part, std::ssize(other));
    expect_index("kept/depths/side", depth.side, own[depth.own_part]);
  }
}

}  // namespace

void expect_kept(const Model& model) {
  const KeptDecisions& kept = model.kept;
  expect(
      "kept/blocks", kept.blocks,
      {0.0, static_cast<double>(model.blocks.size()), "at most the number of blocks"});
  expect_ascending("kept pair", kept.pairs,
                   [](const KeptPair& pair) { return std::pair(pair.low, pair.high); });
  long contacts = 0, poses = 0, depths = 0;
  for (const KeptPair& pair : kept.pairs) {
    expect_index("kept/pairs/high", pair.high, kept.blocks);
    expect_index("kept/pairs/low", pair.low, pair.high);
    contacts += pair.contacts, poses += pair.poses, depths += pair.depths;
  }
  expect_rows("kept/contacts", kept.contacts, contacts);
  expect_rows("kept/poses", kept.poses, poses);
  expect_rows("kept/depths", kept.depths, depths);
  expect_depths(model);
  for (const KeptContact& contact : kept.contacts)
    if (contact.corner == contact.edge)
      reject_checkpoint("kept/contacts has a corner on its own edge");
}

}  // namespace blocks::output
