#include "audit/pair_audit.hpp"

#include <algorithm>
#include <map>

#include "audit/neighbours.hpp"
#include "geometry/convex_parts.hpp"
#include "model/contact_blocks.hpp"

namespace blocks::audit {
namespace {

using Pair = std::pair<int, int>;

}  // namespace

std::vector<ConvexPart> cut_into_parts(const Blocks& blocks) {
  std::vector<ConvexPart> parts;
  for (int b = 0; b < blocks.size(); ++b) {
    const int first = blocks.first_corner[b];
    if (blocks.convex[b]) {
      parts.push_back({b, {}});
      for (int c = first; c < blocks.first_corner[b + 1]; ++c)
        parts.back().corners.push_back(c);
      continue;
    }
    for (const std::vector<int>& cut : geometry::convex_parts(blocks.outline(b))) {
      parts.push_back({b, {}});
      for (const int c : cut)
        parts.back().corners.push_back(first + c);
    }
  }
  return parts;
}

ExactPairRule exact_rule(const Blocks& blocks, std::vector<ConvexPart> parts,
                         double reach) {
  return {blocks, std::move(parts), blocks_near_blocks(blocks, reach)};
}

PairFindings audit_pairs(const Moment& moment, std::vector<ConvexPart> parts,
                         const std::vector<Pair>& listed) {
  const Blocks& blocks = moment.blocks;
  const Contacts& contacts = moment.contacts;
  PairFindings found;
  std::map<Pair, std::vector<Pair>> acting;
  for (int i = 0; i < contacts.size(); ++i)
    if (contacts.active[i]) {
      ++found.acting;
      acting[pair_of(blocks, contacts, i)].emplace_back(contacts.corner[i],
                                                        contacts.edge[i]);
    }
  // Both blocks of a pair may move that far.
  const ExactPairRule rule = exact_rule(blocks, std::move(parts), 2.0 * moment.left);
  for (int a = 0; a < blocks.size(); ++a)
    for (const int b : rule.neighbours(a)) {
      if (b < a)
        continue;
      ++found.pairs;
      if (!std::binary_search(listed.begin(), listed.end(), Pair(a, b)))
        found.missed.emplace_back(a, b);
      const std::vector<Pair> exact = rule.decide(a, b).contacts;
      std::vector<Pair> by_program = std::move(acting[{a, b}]);
      acting.erase({a, b});
      std::sort(by_program.begin(), by_program.end());
      if (by_program != exact)
        found.wrong.push_back({a, b, std::move(by_program), exact});
    }
  for (auto& [pair, records] : acting)  // They are not near each other.
    if (blocks.is_free(pair.first) || blocks.is_free(pair.second))
      found.wrong.push_back({pair.first, pair.second, std::move(records), {}});
  return found;
}

}  // namespace blocks::audit
