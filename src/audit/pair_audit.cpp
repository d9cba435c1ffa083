#include "audit/pair_audit.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "audit/neighbours.hpp"
#include "geometry/convex_parts.hpp"
#include "model/contact_blocks.hpp"

namespace blocks::audit {
namespace {

using Pair = std::pair<int, int>;

/// The corner is this near to the edge's segment. The limit is lowered by rounding.
bool is_within(const Blocks& blocks, int corner, int edge, double distance) {
  constexpr double rounding = 1e-9;
  const Vec2 p = blocks.corner.col(edge);
  const Vec2 e = Vec2(blocks.corner.col(blocks.next[edge])) - p;
  const Vec2 from = Vec2(blocks.corner.col(corner)) - p;
  const double s = std::clamp(from.dot(e) / e.squaredNorm(), 0.0, 1.0);
  return (from - s * e).norm() <= distance * (1.0 - rounding);
}

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

PairFindings audit_pairs(const Moment& moment, std::vector<ConvexPart> parts) {
  const Blocks& blocks = moment.blocks;
  const Contacts& contacts = moment.contacts;
  const double promise = 2.0 * moment.left;
  PairFindings found;
  std::set<Pair> listed;
  std::map<Pair, std::vector<Pair>> acting;
  for (int i = 0; i < contacts.size(); ++i) {
    const Pair record(contacts.corner[i], contacts.edge[i]);
    listed.insert(record);
    if (!contacts.active[i])
      continue;
    ++found.acting;
    acting[pair_of(blocks, contacts, i)].push_back(record);
  }
  const ExactPairRule rule = exact_rule(blocks, std::move(parts), promise);
  const auto look_for_missed = [&](int a, int b, const std::vector<Pair>& exact) {
    for (int c = blocks.first_corner[a]; c < blocks.first_corner[a + 1]; ++c)
      for (int e = blocks.first_corner[b]; e < blocks.first_corner[b + 1]; ++e) {
        const bool acts = std::binary_search(exact.begin(), exact.end(), Pair(c, e));
        if (!acts && !is_within(blocks, c, e, promise))
          continue;
        ++found.records;
        if (!listed.contains({c, e}))
          found.missed.push_back({c, e, rule.overlap(c, e), acts});
      }
  };
  for (int a = 0; a < blocks.size(); ++a)
    for (const int b : rule.neighbours(a)) {
      if (b < a)
        continue;
      ++found.pairs;
      const std::vector<Pair> exact = rule.decide(a, b).contacts;
      look_for_missed(a, b, exact);
      look_for_missed(b, a, exact);
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
