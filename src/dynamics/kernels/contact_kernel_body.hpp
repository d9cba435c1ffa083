// The forces of batches of contacts (kernels.hpp), in the order a. to e. of
// docs/theory.md#the-force-in-its-order. Included once for each instruction set, in a
// namespace of its own.
#include "dynamics/kernels/contact_law.hpp"
#include "dynamics/kernels/joint_kernel_body.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// Returns the state of a contact without the law of a joint.
BLOCKS_INLINE ContactState<Pack> usual_state(const ContactLaw& law, Pack normal,
                                             Pack shear) {
  ContactState<Pack> state = {};
  state.normal = normal, state.shear = shear, state.failed = all_of(1.0);
  state.stiffness = all_of(law.normal_stiffness);
  state.shear_stiffness = all_of(law.shear_stiffness);
  return state;
}

/// Steps b. to e. for row s.
template <bool rigid, bool readings, class Sums>
BLOCKS_INLINE void act_row(const BatchArrays& batches, const BlockState& blocks,
                           int batch, int s, const Pairs<rigid>& two, const Frame& at,
                           Pack damping, const ContactLaw& law, int i, Sums& sums,
                           Most& most) {
  const ContactStates& row = batches.states[s];
  const Choice acts = choice_of(load(row.acts, i));
  const Bits starts = load(row.starts, i);
  const Pack nx = -at.ty, ny = at.tx;
  const Pack x = at.x - two.low_x, y = at.y - two.low_y;
  const Point v = two.velocity(x, y);
  const Pack vx = v[0], vy = v[1];

  // Steps b. to d.
  const SpringRow& springs = batches.springs[s];
  Pack normal_elastic = load(springs.normal_elastic, i);
  Pack shear_elastic = load(springs.shear_elastic, i);
  Pack normal, shear;
  const Pack closing = -(vx * nx + vy * ny), sliding = vx * at.tx + vy * at.ty;
  if (starts != 0)
    apply(law, normal_elastic, shear_elastic, closing, sliding, at.overlap, damping,
          where(choice_of(starts), all_of(1.0)), normal, shear);
  else
    apply<false>(law, normal_elastic, shear_elastic, closing, sliding, at.overlap,
                 damping, Pack{}, normal, shear);
  if (batches.has_account) {
    add_work(
        batches.works[batch], i, acts, law.dt,
        {closing, sliding, at.overlap, damping, where(choice_of(starts), all_of(1.0))},
        usual_state(law, load(springs.normal_elastic, i),
                    load(springs.shear_elastic, i)),
        usual_state(law, normal_elastic, shear_elastic), {normal, shear}, Pack{},
        [](const ContactState<Pack>& state)
            __attribute__((always_inline)) { return coulomb_energy(state); });
    add_work_of_lag(batches.works[batch], i, acts, law.dt,
                    Pairs<rigid>(batches.pairs[batch], blocks, 0.0, i), at, v, normal,
                    shear);
  }
  normal_elastic = where(acts, normal_elastic);
  SpringRow& advanced = batches.advanced[s];
  store(advanced.normal_elastic, i, normal_elastic);
  store(advanced.shear_elastic, i, where(acts, shear_elastic));
  const Pack reached = where(acts, at.overlap);
  most.include(reached, normal_elastic);

  add_forces<rigid, readings>(batches, s, two, at, acts, normal, shear, i, sums);
}

template <bool find, bool rigid, bool readings>
BLOCKS_INLINE Most act_batch(const BatchArrays& batches, int batch,
                             const BlockState& blocks, const ContactLaw& law, int i) {
  constexpr bool stresses = readings || !rigid;
  const BatchPairs& pairs = batches.pairs[batch];
  const Pairs<rigid> two(pairs, blocks, law.dt, i);
  const Pack damping = load(pairs.damping, i);
  Sums<stresses> sums;
  Most most;
  if (batches.has_account)
    clear_work(batches.works[batch], i);
  // The frames of some rows are computed before the forces of these rows. Roots and
  // divisions have a long latency, and those of several rows overlap.
  constexpr int at_once = 4;
  Frame frames[at_once];
  const int end = pairs.first_row + pairs.rows;
  for (int first = pairs.first_row; first < end; first += at_once) {
    const int last = first + at_once < end ? first + at_once : end;
    for (int s = first; s < last; ++s) {
      const Sides sides(batches.contacts[s], blocks, i);
      if constexpr (find)
        find_acting(batches.tests[s], batches.states[s], sides, i);
      frames[s - first] = frame_of(sides, batches.tests[s], i);
    }
    for (int s = first; s < last; ++s)
      act_row<rigid, readings>(batches, blocks, batch, s, two, frames[s - first],
                               damping, law, i, sums, most);
  }
  store_sums(batches, batch, sums, i);
  return most;
}

template <bool find, bool rigid, bool readings>
Extremes act_batches(const BatchArrays& batches, const BlockState& blocks,
                     const ContactLaw& law, int first, int last) {
  Most all;
  for (int batch = first; batch < last; ++batch) {
    const BatchPairs& pairs = batches.pairs[batch];
    Most most;
    for (int i = 0; i < lane_count; i += width) {
      const Most part =
          !pairs.has_laws
              ? act_batch<find, rigid, readings>(batches, batch, blocks, law, i)
              : act_joint_batch<find, rigid, readings>(batches, batch, blocks, law, i);
      most.include(part.overlap, part.spring);
    }
    if constexpr (find) {
      LaneBits ends = 0;
      for (int s = pairs.first_row; s < pairs.first_row + pairs.rows; ++s)
        ends |= batches.states[s].ends;
      const bool open = is_unsettled(batches, pairs, 0, lane_count);
      batches.marks[batch] = {ends != 0, open, false, false};
      if (open)
        continue;
    }
    if (pairs.has_laws)
      batches.marks[batch].breaks = breaks(batches, pairs);
    all.include(most.overlap, most.spring);
  }
  Extremes extremes = {0.0, 0.0};
  for (int k = 0; k < width; ++k) {
    extremes.overlap =
        all.overlap[k] > extremes.overlap ? all.overlap[k] : extremes.overlap;
    extremes.spring = all.spring[k] > extremes.spring ? all.spring[k] : extremes.spring;
  }
  return extremes;
}

}  // namespace

Extremes test_and_compute_forces(const BatchArrays& batches, const BlockState& blocks,
                                 const ContactLaw& law, bool rigid, int first,
                                 int last) {
  const auto all =
      rigid ? act_batches<true, true, false> : act_batches<true, false, false>;
  return all(batches, blocks, law, first, last);
}

Extremes compute_forces(const BatchArrays& batches, const BlockState& blocks,
                        const ContactLaw& law, bool rigid, bool readings, int first,
                        int last) {
  const auto all = rigid      ? readings ? act_batches<false, true, true>
                                         : act_batches<false, true, false>
                        : readings ? act_batches<false, false, true>
                              : act_batches<false, false, false>;
  return all(batches, blocks, law, first, last);
}

}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
