#include "dynamics/spring_transfer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

/// A linear spring.
struct Spring {
  double force, stiffness;  ///< [F], [F/L]
  double energy() const {
    return stiffness > 0.0 ? force * force / (2.0 * stiffness) : 0.0;
  }
};

/// Returns the spring `own` after it has received a part of `other`. Forces and the
/// stiffness `more` are added. The stiffness becomes no larger than `limit`, unless
/// `own` has more, and the force not so large that energy would be created.
Spring joined(const Spring& own, const Spring& other, double cosine, double more,
              double limit) {
  const double stiffness =
      std::min(own.stiffness + more, std::max(limit, own.stiffness));
  const double energy = own.energy() + cosine * cosine * other.energy();
  const double max = std::sqrt(2.0 * stiffness * energy);
  return {std::clamp(own.force + cosine * other.force, -max, max), stiffness};
}

/// Chooses the contact that takes one released spring, by one of two rules.
class Choice {
 public:
  Choice(const Blocks& blocks, const ContactArrays& arrays,
         const ReleasedSpring& released, const Settings& settings)
      : blocks_(blocks), arrays_(arrays), released_(released), settings_(settings),
        block_(blocks.corner_block[released.at.corner]),
        along_(along(released.at.edge)),
        has_stiffness_(!arrays.laws.none() &&
                       arrays.laws.has_stiffness(arrays.laws.law_of(
                           blocks, released.at.corner, released.at.edge))),
        is_held_(arrays.laws.in_situ() && released.law_state.offset > 0.0),
        adds_(has_stiffness_ || is_held_) {}

  /// Returns the best of the contacts of the same corner and of those of the pair.
  Successor best() {
    // Springs per length of a face keep to it, or to a face that continues it.
    const double min_cosine = adds_ ? geometry::successor_cosine : 0.0;
    // Few contacts have the same corner, so this is tested first.
    arrays_.each_lane_of(block_, [&](unsigned lane, bool) {
      each_acting(static_cast<int>(lane), [&](int slot) {
        if (arrays_.at(slot).corner == released_.at.corner)
          consider(slot, static_cast<int>(lane), min_cosine);
      });
    });
    if (const int own = arrays_.lane_of_pair[released_.pair]; own >= 0)
      each_acting(own,
                  [&](int slot) { consider(slot, own, geometry::successor_cosine); });
    return best_;
  }

 private:
  /// Calls visit(slot) for each slot of a lane whose contact acts.
  template <class Visit> void each_acting(int lane, const Visit& visit) const {
    const BatchPairs& batch = arrays_.batches.pairs[lane / lane_count];
    for (int row = batch.first_row; row < batch.first_row + batch.rows; ++row)
      if ((arrays_.batches.states[row].acts >> lane % lane_count & 1U) != 0)
        visit(row * lane_count + lane % lane_count);
  }
  Vec2 at(int corner) const { return blocks_.corner.col(corner); }
  /// Returns the unit vector along an edge.
  Vec2 along(int edge) const {
    return (at(blocks_.next[edge]) - at(edge)).normalized();
  }
  /// Returns the depth of a corner below an edge, [L]; negative: a gap.
  double depth(const CornerOnEdge& place) const {
    return geometry::cross(at(place.corner) - at(place.edge), along(place.edge));
  }
  /// Returns a number of a slot.
  template <class Row> double of(int slot, PerLane<double> Row::*column) const {
    return arrays_.batches.at(slot, column);
  }

  /// Compares a contact with the best one so far. Its law has a stiffness of its own if
  /// and only if the released one has. The cosine of the angle between the two edges
  /// must be above `min_cosine`; if its corner belongs to the other block, its edge
  /// runs in the opposite direction, so the sign of the cosine is changed.
  void consider(int slot, int lane, double min_cosine) {
    const bool has_stiffness =
        !arrays_.laws.none() &&
        arrays_.laws.has_stiffness(arrays_.batches.at(slot, &FaceRow::law));
    const auto [corner, edge] = arrays_.at(slot);
    const double sense = blocks_.corner_block[corner] == block_ ? 1.0 : -1.0;
    const double cosine = sense * along_.dot(along(edge));
    if (has_stiffness != has_stiffness_ || cosine <= min_cosine)
      return;
    if (adds_)
      add_to_nearest(slot, lane, cosine);
    else
      strengthen_most(slot, lane, cosine);
  }

  /// Springs per length, and those that an offset holds: the nearest contact adds them
  /// to its own.
  void add_to_nearest(int slot, int lane, double cosine) {
    const CornerOnEdge place = arrays_.at(slot);
    const double distance = (at(place.corner) - at(released_.at.corner)).norm();
    if (!(distance < nearest_))
      return;
    nearest_ = distance;
    // The time step is chosen for these stiffnesses. With STIFF an end of a face has
    // two contacts at most.
    const double half = 0.5 * (at(blocks_.next[place.edge]) - at(place.edge)).norm();
    const LawValues<double>& values =
        arrays_.laws.values(arrays_.batches.at(slot, &FaceRow::law));
    const auto limit = [&](double per_length, double usual) {
      return has_stiffness_ ? half * per_length : 2.0 * usual;
    };
    const LawState& state = released_.law_state;
    // An end of a face that has opened has no stiffness to pass on.
    const bool opened = !(depth(released_.at) + state.offset > 0.0);
    const auto more = [&](double stiffness) {
      return opened ? 0.0 : cosine * cosine * stiffness;
    };
    const Spring normal =
        joined({of(slot, &SpringRow::normal_elastic), of(slot, &LawRow::stiffness)},
               {released_.normal, state.stiffness}, cosine, more(state.stiffness),
               limit(values.normal_stiffness, settings_.normal_stiffness));
    const Spring shear = joined(
        {of(slot, &SpringRow::shear_elastic), of(slot, &LawRow::shear_stiffness)},
        {released_.shear, state.shear_stiffness}, cosine, more(state.shear_stiffness),
        limit(values.shear_stiffness, settings_.shear_stiffness));
    // With this offset the successor is as deep as its force needs.
    const double needed =
        normal.stiffness > 0.0 ? normal.force / normal.stiffness - depth(place) : 0.0;
    best_ = {.slot = slot,
             .batch = lane / lane_count,
             .before = of(slot, &SpringRow::normal_elastic),
             .normal = normal.force,
             .shear = shear.force,
             .stiffness = normal.stiffness,
             .shear_stiffness = shear.stiffness,
             .offset = is_held_ ? std::max(of(slot, &LawRow::offset), needed) : 0.0};
  }

  /// Springs of STIFF: the contact whose normal spring gains most takes them. It keeps
  /// the energy of both, within its overlap.
  void strengthen_most(int slot, int lane, double cosine) {
    const double own = of(slot, &SpringRow::normal_elastic);
    const double received = cosine * released_.normal;
    const double offset = arrays_.laws.in_situ() ? of(slot, &LawRow::offset) : 0.0;
    const double overlap = std::max(0.0, depth(arrays_.at(slot)) + offset);
    const double both = std::min(std::sqrt(received * received + own * own),
                                 settings_.normal_stiffness * overlap);
    if (!(both - own > gain_))
      return;
    gain_ = both - own;
    best_ = {.slot = slot,
             .batch = lane / lane_count,
             .before = own,
             .normal = both,
             .shear = cosine * released_.shear};
  }

  const Blocks& blocks_;
  const ContactArrays& arrays_;
  const ReleasedSpring& released_;
  const Settings& settings_;
  int block_;  ///< block of the released spring's corner
  Vec2 along_;
  bool has_stiffness_;  ///< the law of the released contact has its own stiffness
  bool is_held_;        ///< an offset held the released contact, after INSITU
  bool adds_;           ///< the springs are added to those of the successor
  Successor best_;
  double nearest_ = std::numeric_limits<double>::infinity();  ///< [L]
  double gain_ = 0.0;                                         ///< [F]
};

/// Stores the stiffnesses and the offset of a successor to whose springs those of
/// `from` were added. If it begins to act in this step, it takes over the state of the
/// law, too.
void take_over_state(ContactArrays& arrays, const Successor& successor,
                     const ReleasedSpring& from) {
  ContactBatches& batches = arrays.batches;
  const int slot = successor.slot;
  if (batches.at(slot, &LawRow::stiffness) == 0.0 &&
      batches.at(slot, &LawRow::bonded) == 0.0) {
    const int law = batches.at(slot, &FaceRow::law);
    if (arrays.laws.id(law) == from.law_state.law)
      arrays.put_law_state(slot, from.law_state);
    else
      batches.at(slot, &LawRow::failed) = 1.0;
  }
  batches.at(slot, &LawRow::stiffness) = successor.stiffness;
  batches.at(slot, &LawRow::shear_stiffness) = successor.shear_stiffness;
  if (successor.offset > 0.0)
    batches.at(slot, &LawRow::offset) = successor.offset;
}

}  // namespace

void transfer_springs(const Blocks& blocks, ContactArrays& arrays,
                      const Settings& settings, Workers& workers,
                      SpringTransfer& transfer, std::vector<int>& receivers) {
  ContactBatches& batches = arrays.batches;
  std::vector<ReleasedSpring>& released = transfer.released;
  const int count = static_cast<int>(released.size());
  receivers.clear();
  const auto order = [](const ReleasedSpring& spring) {
    return std::tuple(spring.pair, spring.at.corner, spring.at.edge);
  };
  std::sort(released.begin(), released.end(),
            [&](const ReleasedSpring& l, const ReleasedSpring& r) {
              return order(l) < order(r);
            });
  const auto choose = [&](int i) {
    return Choice(blocks, arrays, released[i], settings).best();
  };
  transfer.successors.resize(released.size());
  constexpr int springs_per_thread = 256;
  workers.each_evenly(count, springs_per_thread, [&](int, int begin, int end) {
    for (int i = begin; i < end; ++i)
      transfer.successors[i] = choose(i);
  });
  for (int i = 0; i < count; ++i) {
    Successor successor = transfer.successors[i];
    if (successor.slot >= 0 &&
        batches.at(successor.slot, &SpringRow::normal_elastic) != successor.before)
      successor = choose(i);
    if (successor.slot < 0)
      continue;
    // Added springs of contacts that act already are not limited by the overlap.
    if (successor.adds())
      take_over_state(arrays, successor, released[i]);
    else
      batches.set(successor.slot, &ContactStates::starts, true);
    batches.at(successor.slot, &SpringRow::normal_elastic) = successor.normal;
    if (double& shear = batches.at(successor.slot, &SpringRow::shear_elastic);
        shear == 0.0 || successor.adds())
      shear = successor.shear;
    if (!std::exchange(batches.marks[successor.batch].receives, true))
      receivers.push_back(successor.batch);
  }
  released.clear();
}

}  // namespace blocks::dynamics
