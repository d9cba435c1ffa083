// Clusters of blocks whose contacts the program and the judge decide.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "audit/exact_pair_rule.hpp"
#include "dynamics/rules/pair_rule.hpp"

namespace blocks::testing {

using ContactSet = std::vector<std::pair<int, int>>;  ///< corners and edges
using Adjacency = std::vector<std::vector<int>>;

/// Returns the convex parts of all blocks.
inline std::vector<audit::ConvexPart> parts_of(const dynamics::BlockParts& cut,
                                               const Blocks& blocks) {
  std::vector<audit::ConvexPart> parts;
  for (int b = 0; b < blocks.size(); ++b)
    for (int part = cut.first_part(b); part < cut.end_part(b); ++part) {
      parts.push_back({b, {}});
      for (int i = 0; i < cut.corners(part); ++i)
        parts.back().corners.push_back(cut.corner(part, i));
    }
  return parts;
}

/// Blocks with the pairs of a contact list.
struct Cluster {
  Blocks before, blocks;  ///< when they were cut into parts, and now
  Adjacency neighbours;
  dynamics::BlockParts cut;

  /// All pairs are in the list. The seed selects their order. In some cases the blocks
  /// turn after they have been cut, so that their corners are rounded again.
  Cluster(const std::vector<NewBlock>& made, std::optional<std::uint64_t> seed) {
    blocks.append(made);
    cut.make(blocks);
    before = blocks;
    std::mt19937_64 random(seed.value_or(0));
    const auto one_in = [&](unsigned n) { return seed && random() % n == 0; };
    neighbours.resize(made.size());
    for (int a = 0; a < blocks.size(); ++a)
      for (int b = 0; b < a; ++b)
        if ((blocks.is_free(a) || blocks.is_free(b))) {
          neighbours[a].push_back(b);
          neighbours[b].push_back(a);
        }
    for (std::vector<int>& some : neighbours)
      std::shuffle(some.begin(), some.end(), random);
    if (one_in(3)) {
      const double angle = 1e-9 * static_cast<double>(random() % 6'000'000'000U);
      const double c = std::cos(angle), s = std::sin(angle);
      Eigen::Matrix2d turn;
      turn << c, -s, s, c;
      blocks.corner = (turn * blocks.corner).eval();
      blocks.centroid = (turn * blocks.centroid).eval();
    }
  }
  ContactSet by_program(int a, int b) const {
    dynamics::Groups listed;
    listed.sort(blocks.size(), [&](const auto& add) {
      for (int block = 0; block < blocks.size(); ++block)
        for (const int other : neighbours[block])
          add(block, other);
    });
    dynamics::PairScratch scratch;
    decide_pair(blocks, cut, listed, a, b, {}, scratch);
    std::set<std::pair<int, int>> found;
    for (const dynamics::CornerOnEdge& contact : scratch.found)
      found.emplace(contact.corner, contact.edge);
    return {found.begin(), found.end()};
  }
  audit::ExactPairRule judge() const {
    return {blocks, parts_of(cut, blocks), neighbours};
  }
  bool has_pair(int a, int b) const {
    return std::count(neighbours[a].begin(), neighbours[a].end(), b) > 0;
  }
};

}  // namespace blocks::testing
