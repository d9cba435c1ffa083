#include "dynamics/contact_forces.hpp"

#include <bit>
#include <utility>

#include "dynamics/contacts/contact_list.hpp"
#include "dynamics/face_ends.hpp"
#include "dynamics/kernels/kernels.hpp"
#include "dynamics/workspace.hpp"
#include "geometry/contact_predicates.hpp"

namespace blocks::dynamics {
namespace {

ContactLaw law_of(const Model& model) {
  const Settings& settings = model.settings;
  return {settings.normal_stiffness, settings.shear_stiffness, settings.friction,
          model.time_step.dt};
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
      released.back().law_state = arrays.law_state_at(slot);
  });
}

/// Collects the pairs of a batch that have lost a bond in this step.
void find_broken(const ContactArrays& arrays, int batch, std::vector<int>& broken) {
  const ContactBatches& batches = arrays.batches;
  const BatchPairs& pairs = batches.pairs[batch];
  for (int k = 0; k < lane_count; ++k)
    for (int row = pairs.first_row; row < pairs.first_row + pairs.rows; ++row)
      if (batches.law_states[row].bonded[k] >
          batches.advanced_law_states[row].bonded[k]) {
        broken.push_back(arrays.pair_of_lane[batch * lane_count + k]);
        break;
      }
}

/// Writes the sums f_i x_j of the contacts of each block.
void sum_stresses(Blocks& blocks, Workspace& work) {
  work.workers->each(work.split.blocks, [&](int, int begin, int end) {
    for (int b = begin; b < end; ++b) {
      Eigen::Vector4d sum = Eigen::Vector4d::Zero();
      work.contacts.each_lane_of(b, [&](unsigned lane, bool is_low) {
        const PairStress& stress = work.contacts.batches.stresses[lane];
        for (int i = 0; i < 4; ++i)
          sum[i] += is_low ? stress.low[i] : stress.high[i];
      });
      blocks.applied.col(b) = sum;
    }
  });
}

}  // namespace

Extremes find_contact_forces(const Model& model, Workspace& work) {
  const Blocks& blocks = model.blocks;
  const ContactLaw law = law_of(model);
  const BlockState state = state_of(blocks);
  ContactArrays& arrays = work.contacts;
  ContactBatches& batches = arrays.batches;
  ForceMemory& memory = work.forces;
  const bool rigid = model.settings.rigid;
  const auto compute = [&](ForceThread& thread, int batch) {
    thread.extremes.include(
        kernels().compute_forces(batches, state, law, rigid, false, batch, batch + 1));
  };
  work.workers->each(work.split.batches, [&](int k, int begin, int end) {
    ForceThread& thread = memory.threads[k];
    thread.extremes.include(
        kernels().test_and_compute_forces(batches, state, law, rigid, begin, end));
    for (int batch = begin; batch < end; ++batch) {
      if (batches.marks[batch].unsettled) {
        settle_doubts(blocks, batches, batch);
        if (batches.pairs[batch].has_laws)
          share_ends(blocks, arrays, batch);
        compute(thread, batch);
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
  if (!work.rule->options.transfers_springs)
    released.clear();
  transfer_springs(blocks, arrays, model.settings, *work.workers, memory.transfer,
                   memory.receivers);
  constexpr int batches_per_thread = 128;
  const auto receivers = static_cast<int>(memory.receivers.size());
  work.workers->each_evenly(receivers, batches_per_thread,
                            [&](int k, int begin, int end) {
                              for (int i = begin; i < end; ++i) {
                                const int batch = memory.receivers[i];
                                compute(memory.threads[k], batch);
                                if (batches.marks[batch].breaks)
                                  find_broken(arrays, batch, memory.threads[k].broken);
                              }
                            });
  Extremes extremes;
  for (ForceThread& thread : memory.threads) {
    extremes.include(std::exchange(thread.extremes, {}));
    for (const int pair : thread.broken)
      work.decisions.expire(pair);
    thread.broken.clear();
  }
  return extremes;
}

void take_readings(const Model& model, Workspace& work) {
  const ContactLaw law = law_of(model);
  work.workers->each(work.split.batches, [&](int, int begin, int end) {
    kernels().compute_forces(work.contacts.batches, state_of(model.blocks), law,
                             model.settings.rigid, true, begin, end);
  });
}

void list_contacts(Model& model, Workspace& work, bool read) {
  const ContactArrays& arrays = work.contacts;
  const ContactBatches& batches = arrays.batches;
  list_acting(arrays, work.split, *work.workers, work.forces.first_contact,
              model.contacts, model.law_states, [&](int slot, Contact& contact) {
                const int row = slot / lane_count, k = slot % lane_count;
                const ReadingRow& reading = batches.readings[row];
                contact.normal_elastic = batches.springs[row].normal_elastic[k];
                contact.shear_elastic = batches.springs[row].shear_elastic[k];
                contact.normal_force = read ? reading.normal_force[k] : 0.0;
                contact.shear_force = read ? reading.shear_force[k] : 0.0;
                contact.overlap = read ? reading.overlap[k] : 0.0;
              });
  work.springs.both_agree();
  if (!model.settings.rigid)
    return;
  if (read)
    sum_stresses(model.blocks, work);
  else
    model.blocks.applied.setZero();
}

}  // namespace blocks::dynamics
