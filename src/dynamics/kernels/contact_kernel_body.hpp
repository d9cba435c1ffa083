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

/// Steps b. to e. for row s of a batch without laws of joints.
template <bool rigid, bool readings, class Sums>
BLOCKS_INLINE void act_row(const BatchArrays& batches, int s, const Pairs<rigid>& two,
                           const Frame& at, Pack damping, const ContactLaw& law, int i,
                           Sums& sums, Most& most, WorkSums<rigid>& works) {
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
  if (batches.has_account)
    works.add(
        acts, law.dt, at, v,
        {closing, sliding, at.overlap, damping, where(choice_of(starts), all_of(1.0))},
        usual_state(law, load(springs.normal_elastic, i),
                    load(springs.shear_elastic, i)),
        usual_state(law, normal_elastic, shear_elastic), {normal, shear}, Pack{},
        [](const ContactState<Pack>& state)
            __attribute__((always_inline)) { return coulomb_energy(state); });
  normal_elastic = where(acts, normal_elastic);
  SpringRow& advanced = batches.advanced[s];
  store(advanced.normal_elastic, i, normal_elastic);
  store(advanced.shear_elastic, i, where(acts, shear_elastic));
  const Pack reached = where(acts, at.overlap);
  most.include(reached, normal_elastic);

  add_forces<rigid, readings>(batches, s, two, at, acts, normal, shear, i, sums);
}

/// Returns whether contacts in some lanes of rows [first, last), `count` of them from
/// lane i on, have yet to be settled (BatchMarks::unsettled).
template <bool has_laws>
BLOCKS_INLINE bool is_unsettled(const BatchArrays& batches, int first, int last, int i,
                                int count) {
  unsigned open = 0;
  for (int s = first; s < last; ++s) {
    const ContactStates& states = batches.states[s];
    open |= states.in_doubt;
    if constexpr (has_laws)
      open |= states.starts | states.ends;
  }
  return (open >> i & ((1U << count) - 1)) != 0;
}

/// The kind of batches without laws of joints, beside LawBits and 0 for several laws.
constexpr LawBits usual_kind = ~LawBits{};

/// Computes the contacts in the lanes of a pack. The length of a contact with a law
/// depends on which others act, so no forces are computed after a row with laws that
/// has yet to be settled.
template <LawBits kind, bool find, bool rigid, bool readings>
Most act_batch(const BatchArrays& batches, int batch, const BlockState& blocks,
               const ContactLaw& law, int i) {
  constexpr bool has_laws = kind != usual_kind, stresses = readings || !rigid;
  const BatchPairs& pairs = batches.pairs[batch];
  const Pairs<rigid> two(pairs, blocks, law.dt, i);
  const Pack damping = load(pairs.damping, i);
  Sums<stresses> sums;
  Most most;
  WorkSums<rigid> works(batches.has_account, pairs, blocks, i);
  // The frames of some rows are computed before the forces of these rows. Roots and
  // divisions have a long latency, and those of several rows overlap.
  constexpr int at_once = 4;
  Frame frames[at_once];
  EdgeLine edges[has_laws ? at_once : 1];
  bool settled = true;
  const int end = pairs.first_row + pairs.rows;
  for (int first = pairs.first_row; first < end; first += at_once) {
    const int last = first + at_once < end ? first + at_once : end;
    for (int s = first; s < last; ++s) {
      const Sides sides(batches.contacts[s], blocks, i);
      if constexpr (find && has_laws)
        find_acting_or_held(batches, s, sides, i);
      else if constexpr (find)
        find_acting(batches.tests[s], batches.states[s], sides, i);
      frames[s - first] = frame_of(sides, batches.tests[s], i);
      if constexpr (has_laws)
        edges[s - first] = EdgeLine(sides);
    }
    if constexpr (find && has_laws) {
      settled = settled && !is_unsettled<true>(batches, first, last, i, width);
      if (!settled)
        continue;
    }
    for (int s = first; s < last; ++s) {
      const Frame& frame = frames[s - first];
      if constexpr (has_laws)
        act_joint_row<kind, rigid, readings>(batches, batch, s, edges[s - first], frame,
                                             blocks, two, damping, law, i, sums, most,
                                             works);
      else
        act_row<rigid, readings>(batches, s, two, frame, damping, law, i, sums, most,
                                 works);
    }
  }
  store_sums(batches, batch, sums, i);
  if (batches.has_account)
    works.store_in(batches.works + batch * lane_count + i);
  return most;
}

template <bool find, bool rigid, bool readings>
Most act_any_batch(const BatchArrays& batches, int batch, const BlockState& blocks,
                   const ContactLaw& law, int i) {
  const BatchPairs& pairs = batches.pairs[batch];
  const auto act = [&]<LawBits kind>(std::integral_constant<LawBits, kind>)
      __attribute__((always_inline)) {
    return act_batch<kind, find, rigid, readings>(batches, batch, blocks, law, i);
  };
  if (!pairs.has_laws)
    return act(std::integral_constant<LawBits, usual_kind>());
  switch (pairs.laws) {
  case coulomb_bit:
    return act(std::integral_constant<LawBits, coulomb_bit>());
  case walton_bit:
    return act(std::integral_constant<LawBits, walton_bit>());
  case barton_bit:
    return act(std::integral_constant<LawBits, barton_bit>());
  default:
    return act(std::integral_constant<LawBits, 0>());
  }
}

template <bool find, bool rigid, bool readings>
Extremes act_batches(const BatchArrays& batches, const BlockState& blocks,
                     const ContactLaw& law, int first, int last) {
  Most all;
  for (int batch = first; batch < last; ++batch) {
    const BatchPairs& pairs = batches.pairs[batch];
    BatchMarks& marks = batches.marks[batch];
    if constexpr (find)
      marks = {};
    marks.breaks = false;
    Most most;
    for (int i = 0; i < lane_count; i += width) {
      const Most part =
          act_any_batch<find, rigid, readings>(batches, batch, blocks, law, i);
      most.include(part.overlap, part.spring);
    }
    if constexpr (find) {
      const int begin = pairs.first_row, end = begin + pairs.rows;
      for (int s = begin; s < end; ++s)
        marks.ends = marks.ends || batches.states[s].ends != 0;
      marks.unsettled = pairs.has_laws
                            ? is_unsettled<true>(batches, begin, end, 0, lane_count)
                            : is_unsettled<false>(batches, begin, end, 0, lane_count);
      if (marks.unsettled)
        continue;
    }
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
