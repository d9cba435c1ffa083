#include "dynamics/spring_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// Finds the contact that can take most of one released spring.
class Successor {
 public:
  Successor(const Blocks& blocks, const PairIndex& index, const ContactArrays& arrays,
            const ReleasedSpring& released, double stiffness)
      : blocks_(blocks), index_(index), arrays_(arrays), released_(released),
        stiffness_(stiffness), block_(blocks.corner_block[released.at.corner]),
        along_(along(released.at.edge)) {}

  void find() {
    for (int k = index_.first_of_block[block_]; k < index_.first_of_block[block_ + 1];
         ++k)
      each_touching(index_.pairs_of_blocks[k], [&](int row, int lane) {
        const ContactRow& contacts = arrays_.batches.contacts[row];
        if (contacts.corner[lane % lane_count] == released_.at.corner)
          consider(row, lane, 0.0);
      });
    each_touching(released_.pair,
                  [&](int row, int lane) { consider(row, lane, 0.95); });
  }

  /// The slot, or -1 if no contact can take anything, and its batch.
  int slot() const { return slot_; }
  int batch() const { return batch_; }
  double normal() const { return normal_; }
  double shear() const { return shear_; }

 private:
  /// Calls visit(row, lane of the pair) for the contacts of a pair that act.
  template <class Visit> void each_touching(int p, const Visit& visit) const {
    const int lane = arrays_.lane_of_pair[p];
    if (lane < 0)
      return;
    const BatchPairs& batch = arrays_.batches.pairs[lane / lane_count];
    for (int row = batch.first_row; row < batch.first_row + batch.rows; ++row)
      if ((arrays_.batches.bits[row].touches >> lane % lane_count & 1U) != 0)
        visit(row, lane);
  }
  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  /// Unit vector along an edge.
  Vec2 along(int edge) const {
    return (at(blocks_.next[edge]) - at(edge)).normalized();
  }
  /// Takes a contact if its spring would be strengthened most. The cosine is that of
  /// the angle between the old edge and its own; the edges of two blocks run in
  /// opposite senses.
  void consider(int row, int lane_of_pair, double least_cosine) {
    const int lane = lane_of_pair % lane_count;
    const ContactRow& contacts = arrays_.batches.contacts[row];
    const int corner = contacts.corner[lane];
    const Vec2 edge = along(contacts.edge[lane]);
    const double sense = blocks_.corner_block[corner] == block_ ? 1.0 : -1.0;
    const double cosine = sense * along_.dot(edge);
    if (cosine <= least_cosine)
      return;
    const double own = arrays_.batches.springs[row].normal_elastic[lane];
    const double received = cosine * released_.normal;
    const double overlap =
        std::max(0.0, geometry::cross(at(corner) - at(contacts.edge[lane]), edge));
    const double both =
        std::min(std::sqrt(received * received + own * own), stiffness_ * overlap);
    if (both - own > gain_) {
      slot_ = row * lane_count + lane, batch_ = lane_of_pair / lane_count;
      gain_ = both - own;
      normal_ = both, shear_ = cosine * released_.shear;
    }
  }

  const Blocks& blocks_;
  const PairIndex& index_;
  const ContactArrays& arrays_;
  const ReleasedSpring& released_;
  double stiffness_;
  int block_;  ///< of the corner
  Vec2 along_;
  int slot_ = -1, batch_ = -1;
  double normal_ = 0.0, shear_ = 0.0, gain_ = 0.0;
};

}  // namespace

void transfer_springs(const Blocks& blocks, const PairIndex& index,
                      ContactArrays& arrays, double normal_stiffness,
                      std::vector<ReleasedSpring>& released,
                      std::vector<int>& successors) {
  ContactBatches& batches = arrays.batches;
  successors.clear();
  const auto order = [](const ReleasedSpring& spring) {
    return std::tuple(spring.pair, spring.at.corner, spring.at.edge);
  };
  std::sort(released.begin(), released.end(),
            [&](const ReleasedSpring& l, const ReleasedSpring& r) {
              return order(l) < order(r);
            });
  for (const ReleasedSpring& spring : released) {
    Successor successor(blocks, index, arrays, spring, normal_stiffness);
    successor.find();
    const int slot = successor.slot();
    if (slot < 0)
      continue;
    batches.set(slot, &ContactBits::starts, true);
    batches.at(slot, &SpringRow::normal_elastic) = successor.normal();
    if (batches.at(slot, &SpringRow::shear_elastic) == 0.0)
      batches.at(slot, &SpringRow::shear_elastic) = successor.shear();
    successors.push_back(successor.batch());
  }
  released.clear();
  std::sort(successors.begin(), successors.end());
  successors.erase(std::unique(successors.begin(), successors.end()), successors.end());
}

}  // namespace blocks::dynamics
