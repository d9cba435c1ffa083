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

/// Neighbours in the form that the contact rule needs.
struct Listed {
  const Adjacency& lists;
  template <class Visit> void each(int block, const Visit& visit) const {
    for (const int other : lists[block])
      visit(other);
  }
  int count(int block) const { return static_cast<int>(lists[block].size()); }
};

/// The contact rule of the program.
template <class Neighbours>
using ProgramRule = dynamics::PairRule<dynamics::ExactPredicates, Neighbours>;

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
    const Listed listed{neighbours};
    dynamics::PairScratch scratch;
    ProgramRule<Listed> rule(blocks, cut, listed, scratch);
    std::set<std::pair<int, int>> found;
    for (const dynamics::CornerOnEdge& contact : rule.decide(a, b))
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
