#include "dynamics/contact_forces.hpp"

#include <bit>
#include <utility>

#include "dynamics/contacts/contact_list.hpp"
#include "dynamics/face_ends.hpp"
#include "dynamics/kernels/kernels.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

ContactLaw law_of(const Settings& settings, double dt) {
  return {settings.normal_stiffness, settings.shear_stiffness, settings.friction, dt};
}

/// Calls visit(slot) for each slot of a batch whose bit in `marks` is set.
template <class Visit>
void each_marked(const ContactBatches& batches, int batch,
                 LaneBits ContactStates::*marks, const Visit& visit) {
  const BatchPairs& pairs = batches.pairs[batch];
  for (int row = pairs.first_row; row < pairs.first_row + pairs.rows; ++row)
    for (unsigned bits = batches.states[row].*marks; bits != 0; bits &= bits - 1)
      visit(row * lane_count + std::countr_zero(bits));
}

/// Decides exactly whether the contacts of a batch act for which the kernel was in
/// doubt.
void settle_doubts(const Blocks& blocks, ContactBatches& batches, int batch) {
  each_marked(batches, batch, &ContactStates::in_doubt, [&](int slot) {
    const auto at = [&](PerLane<int> ContactRow::*which) {
      return Vec2(blocks.corner.col(batches.at(slot, which)));
    };
    const Vec2 c = at(&ContactRow::corner), p1 = at(&ContactRow::edge),
               p2 = at(&ContactRow::edge_end);
    if (geometry::overlap_sign(c, p1, p2) > 0 && geometry::between(c, p1, p2))
      return;
    batches.set(slot, &ContactStates::acts, false);
    if (!batches.is(slot, &ContactStates::starts))
      batches.set(slot, &ContactStates::ends, true), batches.marks[batch].ends = true;
  });
}

/// Collects the springs of contacts of a batch that have ceased to act.
void release_springs(const ContactArrays& arrays, int batch,
                     std::vector<ReleasedSpring>& released) {
  const ContactBatches& batches = arrays.batches;
  each_marked(batches, batch, &ContactStates::ends, [&](int slot) {
    const double normal = batches.at(slot, &SpringRow::normal_elastic);
    if (!(normal > 0.0))
      return;
    released.push_back({arrays.pair_of_lane[batch * lane_count + slot % lane_count],
                        arrays.at(slot), normal,
                        batches.at(slot, &SpringRow::shear_elastic)});
    if (!arrays.laws.none())
      released.back().joint = arrays.joint_at(slot);
  });
}

/// Collects the pairs of a batch that have lost a bond in this step.
void find_broken(const ContactArrays& arrays, int batch, std::vector<int>& broken) {
  const ContactBatches& batches = arrays.batches;
  const BatchPairs& pairs = batches.pairs[batch];
  for (int k = 0; k < lane_count; ++k)
    for (int row = pairs.first_row; row < pairs.first_row + pairs.rows; ++row)
      if (batches.joints[row].bonded[k] > batches.advanced_joints[row].bonded[k]) {
        broken.push_back(arrays.pair_of_lane[batch * lane_count + k]);
        break;
      }
}

}  // namespace

Extremes find_contact_forces(const Blocks& blocks, const Settings& settings, double dt,
                             ContactArrays& arrays, bool transfers_springs,
                             const WorkSplit& split, Workers& workers,
                             ForceMemory& memory) {
  const ContactLaw law = law_of(settings, dt);
  const BlockState state = state_of(blocks);
  ContactBatches& batches = arrays.batches;
  const auto act = [&](int batch) {
    return kernels().compute_forces(batches, state, law, settings.rigid, false, batch,
                                    batch + 1);
  };
  workers.each(split.batches, [&](int k, int begin, int end) {
    ForceThread& thread = memory.threads[k];
    thread.extremes.include(kernels().test_and_compute_forces(
        batches, state, law, settings.rigid, begin, end));
    for (int batch = begin; batch < end; ++batch) {
      if (batches.marks[batch].unsettled) {
        settle_doubts(blocks, batches, batch);
        if (batches.pairs[batch].has_laws)
          share_ends(blocks, arrays, batch);
        thread.extremes.include(act(batch));
      }
      if (batches.marks[batch].ends)
        release_springs(arrays, batch, thread.released);
      if (batches.marks[batch].breaks)
        find_broken(arrays, batch, thread.broken);
    }
  });
  std::vector<ReleasedSpring>& released = memory.transfer.released;
  for (ForceThread& thread : memory.threads) {
    released.insert(released.end(), thread.released.begin(), thread.released.end());
    thread.released.clear();
  }
  if (!transfers_springs)
    released.clear();
  transfer_springs(blocks, arrays, settings, split, workers, memory.transfer,
                   memory.receivers);
  constexpr int batches_per_thread = 128;
  split.split_evenly(static_cast<int>(memory.receivers.size()), batches_per_thread,
                     memory.shares);
  workers.each(memory.shares, [&](int k, int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const int batch = memory.receivers[i];
      memory.threads[k].extremes.include(act(batch));
      if (batches.marks[batch].breaks)
        find_broken(arrays, batch, memory.threads[k].broken);
    }
  });
  Extremes extremes;
  memory.broken.clear();
  for (ForceThread& thread : memory.threads) {
    extremes.include(std::exchange(thread.extremes, {}));
    memory.broken.insert(memory.broken.end(), thread.broken.begin(),
                         thread.broken.end());
    thread.broken.clear();
  }
  return extremes;
}

void read_contacts(Blocks& blocks, std::vector<Contact>& list,
                   std::vector<JointState>& states, const Settings& settings, double dt,
                   ContactArrays& arrays, const WorkSplit& split, Workers& workers,
                   ForceMemory& memory) {
  ContactBatches& batches = arrays.batches;
  const ContactLaw law = law_of(settings, dt);
  workers.each(split.batches, [&](int, int begin, int end) {
    kernels().compute_forces(batches, state_of(blocks), law, settings.rigid, true,
                             begin, end);
  });
  list_acting(
      arrays, split, workers, memory.first_contact, list, states,
      [&](int slot, Contact& contact) {
        const int row = slot / lane_count, k = slot % lane_count;
        const ReadingRow& reading = batches.readings[row];
        contact.normal_elastic = batches.advanced[row].normal_elastic[k];
        contact.shear_elastic = batches.advanced[row].shear_elastic[k];
        contact.normal_force = reading.normal_force[k];
        contact.shear_force = reading.shear_force[k];
        contact.overlap = reading.overlap[k];
      },
      [&](int slot, JointState& state) { state = arrays.advanced_joint_at(slot); });
  if (!settings.rigid)
    return;
  workers.each(split.blocks, [&](int, int begin, int end) {
    for (int b = begin; b < end; ++b) {
      Eigen::Vector4d sum = Eigen::Vector4d::Zero();
      arrays.each_lane_of(b, [&](unsigned lane, bool is_low) {
        const PairStress& of = batches.stresses[lane];
        for (int i = 0; i < 4; ++i)
          sum[i] += is_low ? of.low[i] : of.high[i];
      });
      blocks.applied.col(b) = sum;
    }
  });
}

}  // namespace blocks::dynamics
