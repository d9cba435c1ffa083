#include "run/watch/deep_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "dynamics/rules/block_parts.hpp"
#include "dynamics/rules/third_parts.hpp"
#include "dynamics/search/near_pairs.hpp"
#include "dynamics/search/pair_index.hpp"
#include "geometry/continuation.hpp"

namespace blocks::run {
namespace {

using dynamics::BlockParts;
using dynamics::ThirdParts;

class Search {
 public:
  explicit Search(const Model& model) : model_(model), blocks_(model.blocks) {}

  std::optional<Contact> deepest() {
    std::optional<Contact> found;
    for (std::size_t i = 0; i < model_.contacts.size(); ++i) {
      const Contact& contact = model_.contacts[i];
      if (contact.overlap > min_depth(contact) &&
          (!found || contact.overlap > found->overlap) && !is_held(i) &&
          is_unexplained(contact))
        found = contact;
    }
    return found;
  }

 private:
  int block_of(int corner) const { return blocks_.corner_block[corner]; }
  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  bool is_held(std::size_t i) const {
    return i < model_.law_states.size() &&
           (model_.law_states[i].bonded || model_.law_states[i].offset > 0.0);
  }
  double min_depth(const Contact& contact) const {
    constexpr double part_of_size = 1e-3;
    return part_of_size * std::sqrt(std::min(blocks_.area[block_of(contact.corner)],
                                             blocks_.area[block_of(contact.edge)]));
  }

  /// Most looks find no contact that needs the parts and neighbours of blocks.
  void find_near_blocks() {
    if (std::exchange(has_index_, true))
      return;
    parts_.make(blocks_);
    dynamics::NearSearch memory;
    std::vector<dynamics::NearPair> pairs;
    dynamics::find_near_pairs(blocks_, 0.0, memory, pairs);
    index_.take(pairs, blocks_.size());
  }

  /// Returns whether no overlap explains the depth, whichever parts the corner is in.
  bool is_unexplained(const Contact& contact) {
    find_near_blocks();
    const int a = block_of(contact.corner), b = block_of(contact.edge);
    for (int q = parts_.first_part(b); q < parts_.end_part(b); ++q)
      for (int p = parts_.first_part(a); p < parts_.end_part(a); ++p)
        if (has_edge(q, contact.edge) && has_corner(p, contact.corner) &&
            !is_unexplained(contact, p, q))
          return false;
    return true;
  }
  bool is_unexplained(const Contact& contact, int p, int q) {
    const auto exceeds = [&](const geometry::Polygon& one,
                             const geometry::Polygon& other) {
      return geometry::exceeds_separating_shift(at(contact.corner), at(contact.edge),
                                                at(blocks_.next[contact.edge]), one,
                                                other);
    };
    const geometry::Polygon of_p = outline(p), of_q = outline(q);
    if (!exceeds(of_p, of_q))
      return false;
    const auto explains = [&](int own, int other, const geometry::Polygon& shifted) {
      thirds_.collect(blocks_, parts_, index_.neighbours, own, other);
      return thirds_.any(
          [&](const geometry::Polygon& third) { return !exceeds(shifted, third); });
    };
    return !explains(p, q, of_q) && !explains(q, p, of_p);
  }
  bool has_corner(int part, int corner) const {
    for (int i = 0; i < parts_.corners(part); ++i)
      if (parts_.corner(part, i) == corner)
        return true;
    return false;
  }
  bool has_edge(int part, int edge) const {
    for (int i = 0; i < parts_.corners(part); ++i)
      if (const dynamics::Side side = parts_.side(part, i);
          side.start == edge && !parts_.is_inner(blocks_, side))
        return true;
    return false;
  }
  geometry::Polygon outline(int part) const {
    geometry::Polygon found;
    for (int i = 0; i < parts_.corners(part); ++i)
      found.push_back(at(parts_.corner(part, i)));
    return found;
  }

  const Model& model_;
  const Blocks& blocks_;
  BlockParts parts_;
  ThirdParts thirds_;
  dynamics::PairIndex index_;
  bool has_index_ = false;
};

}  // namespace

std::optional<Contact> find_deep_contact(const Model& model) {
  return Search(model).deepest();
}

}  // namespace blocks::run
