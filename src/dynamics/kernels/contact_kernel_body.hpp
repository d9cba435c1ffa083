// The forces of batches of contacts (kernels.hpp), in the order a. to e. of
// docs/theory.md#the-force-in-its-order. Included once for each instruction set, in a
// namespace of its own.
#include "dynamics/kernels/contact_law.hpp"
#include "dynamics/kernels/joint_kernel_body.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// Steps b. to e. for row s of a batch without laws of joints.
template <bool rigid, bool readings, class Sums>
BLOCKS_INLINE void act_row(const BatchArrays& batches, int s, const Pairs<rigid>& pair,
                           const Frame& at, Pack damping, const ContactLaw& law, int i,
                           Sums& sums, Maxima& maxima, WorkSums<rigid>& works) {
  const ContactStates& row = batches.states[s];
  const Choice acts = choice_of(load(row.acts, i));
  const Bits starts = load(row.starts, i);
  const Pack nx = -at.ty, ny = at.tx;
  const Pack x = at.x - pair.low_x, y = at.y - pair.low_y;
  const Point v = pair.velocity(x, y);
  const Pack vx = v[0], vy = v[1];

  // Steps b. to d.
  const SpringRow& springs = batches.springs[s];
  const ContactState<Pack> before =
      usual_state(law, load(springs.normal_elastic, i), load(springs.shear_elastic, i));
  const ContactMotion<Pack> motion = {-(vx * nx + vy * ny), vx * at.tx + vy * at.ty,
                                      at.overlap, damping,
                                      where(choice_of(starts), all_of(1.0))};
  ContactState<Pack> state = before;
  ContactForce<Pack> force;
  if (starts != 0)
    apply_usual<true>(law, motion, state, force);
  else
    apply_usual<false>(law, motion, state, force);
  if (batches.has_account)
    works.add(
        acts, law.dt, at, v, motion, before, state, force, Pack{},
        [](const ContactState<Pack>& contact)
            __attribute__((always_inline)) { return coulomb_energy(contact); });
  const Pack normal_elastic = where(acts, state.normal);
  SpringRow& advanced = batches.advanced[s];
  store(advanced.normal_elastic, i, normal_elastic);
  store(advanced.shear_elastic, i, where(acts, state.shear));
  const Pack reached = where(acts, at.overlap);
  maxima.include(reached, normal_elastic);

  add_forces<rigid, readings>(batches, s, pair, at, acts, force.normal, force.shear, i,
                              sums);
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

/// Computes the contacts in the lanes of a pack. The length of a contact with a law
/// depends on which others act, so no forces are computed after a row with laws that
/// has yet to be settled.
template <LawBits laws, bool find, bool rigid, bool readings>
Maxima act_batch(const BatchArrays& batches, int batch, const BlockState& blocks,
                 const ContactLaw& law, int i) {
  constexpr bool has_laws = laws != no_law, stresses = readings || !rigid;
  const BatchPairs& pairs = batches.pairs[batch];
  const Pairs<rigid> pair(pairs, blocks, law.dt, i);
  const Pack damping = load(pairs.damping, i);
  Sums<stresses> sums;
  Maxima maxima;
  WorkSums<rigid> works(batches.has_account, pairs, blocks, i);
  // The frames of some rows are computed before the forces of these rows. Roots and
  // divisions have a long latency, and those of several rows overlap.
  constexpr int at_once = 4;
  Frame frames[at_once];
  EdgeLine<Pack> edges[has_laws ? at_once : 1];
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
        edges[s - first] = edge_line(sides);
    }
    if constexpr (find && has_laws) {
      settled = settled && !is_unsettled<true>(batches, first, last, i, width);
      if (!settled)
        continue;
    }
    for (int s = first; s < last; ++s) {
      const Frame& frame = frames[s - first];
      if constexpr (has_laws)
        act_joint_row<laws, rigid, readings>(batches, batch, s, edges[s - first], frame,
                                             blocks, pair, damping, law, i, sums,
                                             maxima, works);
      else
        act_row<rigid, readings>(batches, s, pair, frame, damping, law, i, sums, maxima,
                                 works);
    }
  }
  store_sums(batches, batch, sums, i);
  if (batches.has_account)
    works.store_in(batches.works + batch * lane_count + i);
  return maxima;
}

template <bool find, bool rigid, bool readings>
Maxima act_any_batch(const BatchArrays& batches, int batch, const BlockState& blocks,
                     const ContactLaw& law, int i) {
  const BatchPairs& pairs = batches.pairs[batch];
  const auto act = [&]<LawBits laws>(std::integral_constant<LawBits, laws>)
      __attribute__((always_inline)) {
    return act_batch<laws, find, rigid, readings>(batches, batch, blocks, law, i);
  };
  if (!pairs.has_laws)
    return act(std::integral_constant<LawBits, no_law>());
  if (!is_one_law(pairs.laws))
    return act(std::integral_constant<LawBits, all_laws>());
  Maxima maxima;
  each_law(pairs.laws, [&](auto one) { maxima = act(one); });
  return maxima;
}

template <bool find, bool rigid, bool readings>
Extremes act_batches(const BatchArrays& batches, const BlockState& blocks,
                     const ContactLaw& law, int first, int last) {
  Maxima all;
  for (int batch = first; batch < last; ++batch) {
    const BatchPairs& pairs = batches.pairs[batch];
    BatchMarks& marks = batches.marks[batch];
    if constexpr (find)
      marks = {};
    marks.breaks = false;
    Maxima maxima;
    for (int i = 0; i < lane_count; i += width) {
      const Maxima part =
          act_any_batch<find, rigid, readings>(batches, batch, blocks, law, i);
      maxima.include(part.overlap, part.spring);
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
    all.include(maxima.overlap, maxima.spring);
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
