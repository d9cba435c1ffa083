// The forces of batches with laws of joints (docs/laws.md). Included once for each
// instruction set, in a namespace of its own.
#include "dynamics/kernels/contact_frame_body.hpp"
#include "dynamics/kernels/contact_law.hpp"
#include "dynamics/kernels/face_length.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// Finds which lanes of row s act. In addition to the contacts of the contact rule,
/// these are intact ones, and those that acted in the step before, are between the ends
/// of their edge, and are still bonded or have an offset larger than their gap.
BLOCKS_INLINE void find_acting_or_held(const BatchArrays& batches, int s,
                                       const Sides& sides, int i) {
  ContactStates& states = batches.states[s];
  const LawRow& law_states = batches.law_states[s];
  const Bits before = load(states.acts, i);
  find_acting(batches.tests[s], states, sides, i);
  const Pack offset = load(law_states.offset, i);
  const Bits bonded = less(Pack{}, load(law_states.bonded, i));
  const Bits failed = less(Pack{}, load(law_states.failed, i));
  Bits holds = less(Pack{}, offset);
  Bits weakened = bonded & failed;
  if ((holds | weakened) != 0) {
    Pack error;
    const Bits between = less(Pack{}, sides.between(error));
    holds &= less(-offset * root(sides.square), sides.value) & between;
    weakened &= between;
  }
  const Bits held = before & ((bonded & ~failed) | weakened | holds);
  const Bits act = load(states.acts, i) | held;
  store(states.acts, i, act);
  store(states.starts, i, act & ~before);
  store(states.ends, i, before & ~act);
  store(states.in_doubt, i, load(states.in_doubt, i) & ~held);
}

BLOCKS_INLINE EdgeLine<Pack> edge_line(const Sides& sides) {
  return {sides.ex, sides.ey, sides.square, sides.cx * sides.ex + sides.cy * sides.ey};
}

/// The part of the faces that each contact of a row stands for.
struct FaceLength {
  Pack length;  ///< L, [L]
  Pack alone;   ///< [L] L if no other contact acts at the same ends
};

/// Returns the lengths of row s.
BLOCKS_INLINE FaceLength length_of(const FaceRow& faces, const EdgeLine<Pack>& edge,
                                   const Frame& corner, const BlockState& blocks,
                                   int i) {
  const Point before = gather_point<2>(blocks.corner, faces.before + i);
  const Point after = gather_point<2>(blocks.corner, faces.after + i);
  const Pack length_before =
      common_length(edge, Pack(before[0] - corner.x), Pack(before[1] - corner.y), true);
  const Pack length_after =
      common_length(edge, Pack(corner.x - after[0]), Pack(corner.y - after[1]), false);
  const auto share = [&](LaneBits shared) __attribute__((always_inline)) {
    return where(choice_of(load(shared, i)), all_of(0.5), all_of(1.0));
  };
  const Pack both = length_before * share(faces.shared_before) +
                    length_after * share(faces.shared_after);
  return {0.5 * both * corner.per_length,
          0.5 * (length_before + length_after) * corner.per_length};
}

/// Returns the values of the laws of a row. only: the law of all lanes; -1: several.
BLOCKS_INLINE LawValues<Pack> values_of(const LawColumns& laws, const int* law,
                                        int only) {
  LawValues<Pack> values;
  each_value(
      [&](Pack & value, const double* column) __attribute__((always_inline)) {
        value = only >= 0 ? all_of(column[only]) : gather(column, law);
      },
      values, laws.values);
  return values;
}

/// Returns the states at the start of the step. A contact without bond is born with the
/// residual strength.
BLOCKS_INLINE ContactState<Pack> load_state(const BatchArrays& batches, int s, int i) {
  ContactState<Pack> state;
  const auto get = [&](Pack & x, const double* row) __attribute__((always_inline)) {
    x = load(row, i);
  };
  get(state.normal, batches.springs[s].normal_elastic);
  get(state.shear, batches.springs[s].shear_elastic);
  each_state(get, state, batches.law_states[s]);
  const Pack born_failed = state.bonded > 0.0 ? state.failed : all_of(1.0);
  state.failed = state.stiffness > 0.0 ? state.failed : born_failed;
  return state;
}
/// Stores the states of the lanes that act, and zeros for the others.
BLOCKS_INLINE void store_state(const BatchArrays& batches, int batch, int s, int i,
                               Choice acts, const ContactState<Pack>& state) {
  if (less(where(acts, state.bonded), load(batches.law_states[s].bonded, i)) != 0)
    batches.marks[batch].breaks = true;
  const auto put = [&](double* row, const Pack& x) __attribute__((always_inline)) {
    store(row, i, where(acts, x));
  };
  put(batches.advanced[s].normal_elastic, state.normal);
  put(batches.advanced[s].shear_elastic, state.shear);
  each_state(put, batches.advanced_law_states[s], state);
}

/// Returns by how much the dashpot of a contact is weaker because another contact acts
/// at the same end. Its constant goes with the root of its stiffness, so two halves of
/// an end would have stronger dashpots than the whole.
BLOCKS_INLINE Pack dashpot_share(Pack per_area, const FaceLength& face, Bits acts) {
  constexpr double root_of_half = 0x1.6a09e667f3bcdp-1;
  const Pack whole = all_of(1.0);
  const Bits unshared = zero(face.length - face.alone);
  const Bits halved = zero(2.0 * face.length - face.alone);
  // The root is needed only where one of two ends is shared.
  const Pack share = (acts & ~(unshared | halved)) != 0
                         ? root(face.length / face.alone)
                         : where(choice_of(unshared), whole, all_of(root_of_half));
  return ((per_area > 0.0) & (face.alone > 0.0)) ? share : whole;
}

/// Returns the root of the stiffness of contacts over `usual`, that of STIFF.
BLOCKS_INLINE Pack root_of_stiffness(DashpotRow& row, Pack stiffness, double usual,
                                     Bits acts, int i) {
  if ((acts & ~zero(stiffness - load(row.stiffness, i))) != 0) {
    store(row.stiffness, i, stiffness);
    store(row.root, i, root(stiffness / usual));
  }
  return load(row.root, i);
}

/// Applies the laws of a row. laws: the kinds that may occur; kinds: that of each lane.
template <LawBits laws>
BLOCKS_INLINE void apply_laws(LawBits present, Pack kinds,
                              const LawValues<Pack>& values, double dt,
                              const ContactMotion<Pack>& motion, bool starts,
                              ContactState<Pack>& state, ContactForce<Pack>& force) {
  if constexpr (is_one_law(laws)) {
    if (starts)
      apply_law<laws, true>(values, dt, motion, state, force);
    else
      apply_law<laws, false>(values, dt, motion, state, force);
  } else {
    const ContactState<Pack> start = state;
    each_law(
        present, [&]<LawBits law>(std::integral_constant<LawBits, law>)
                     __attribute__((always_inline)) {
                       ContactState<Pack> own = start;
                       ContactForce<Pack> one = {};
                       apply_law<law, true>(values, dt, motion, own, one);
                       const auto put = [&](Pack & to, const Pack& x)
                           __attribute__((always_inline)) {
                         to = kinds == static_cast<double>(law) ? x : to;
                       };
                       put(force.normal, one.normal), put(force.shear, one.shear);
                       put(state.normal, own.normal), put(state.shear, own.shear);
                       each_state(put, state, own);
                     });
  }
}

/// Returns the energy of the normal springs of a row.
template <LawBits laws>
BLOCKS_INLINE Pack energy_of(Pack kinds, const LawValues<Pack>& values,
                             const ContactState<Pack>& state) {
  if constexpr (is_one_law(laws)) {
    return normal_energy<laws>(values, state);
  } else {
    Pack energy = {};
    each_law(
        laws, [&]<LawBits law>(std::integral_constant<LawBits, law>)
                  __attribute__((always_inline)) {
                    const Pack of_law = normal_energy<law>(values, state);
                    energy = kinds == static_cast<double>(law) ? of_law : energy;
                  });
    return energy;
  }
}

/// Steps a. to e. for row s. laws: the kinds that may occur.
template <LawBits laws, bool rigid, bool readings, class Sums>
BLOCKS_INLINE void act_joint_row(const BatchArrays& batches, int batch, int s,
                                 const EdgeLine<Pack>& edge, const Frame& at,
                                 const BlockState& blocks, const Pairs<rigid>& pair,
                                 Pack damping, const ContactLaw& usual, int i,
                                 Sums& sums, Maxima& maxima, WorkSums<rigid>& works) {
  const BatchPairs& pairs = batches.pairs[batch];
  const Bits acting = load(batches.states[s].acts, i);
  const Choice acts = choice_of(acting);
  const Bits starts = load(batches.states[s].starts, i);
  if (!readings && acting == 0) {
    store_state(batches, batch, s, i, acts, ContactState<Pack>{});
    return;
  }
  const Point v = pair.velocity(at.x - pair.low_x, at.y - pair.low_y);

  ContactState<Pack> state = load_state(batches, s, i);
  const FaceLength face = length_of(batches.faces[s], edge, at, blocks, i);
  state.length = where(acts, face.length);
  const int* const law = batches.faces[s].law + i;
  const LawValues<Pack> values = values_of(batches.laws, law, pairs.only_law);
  state.stiffness = stiffness_of(state.stiffness, values.normal_stiffness, state.length,
                                 all_of(usual.normal_stiffness));
  state.shear_stiffness = stiffness_of(state.shear_stiffness, values.shear_stiffness,
                                       state.length, all_of(usual.shear_stiffness));

  // Idle lanes have no motion, so that their numbers need no rare paths.
  const ContactMotion<Pack> motion = {
      where(acts, -(v[0] * -at.ty + v[1] * at.tx)),
      where(acts, v[0] * at.tx + v[1] * at.ty), at.overlap,
      damping * dashpot_share(values.normal_stiffness, face, acting) *
          root_of_stiffness(batches.dashpots[s], state.stiffness,
                            usual.normal_stiffness, acting, i),
      where(choice_of(starts), all_of(1.0))};
  const Pack kinds = is_one_law(laws) ? all_of(laws) : gather(batches.laws.kind, law);
  ContactForce<Pack> force = {};
  apply_laws<laws>(pairs.laws, kinds, values, usual.dt, motion, starts != 0, state,
                   force);
  store_state(batches, batch, s, i, acts, state);
  if (batches.has_account) {
    ContactState<Pack> before = load_state(batches, s, i);
    before.stiffness = state.stiffness, before.shear_stiffness = state.shear_stiffness;
    before.length = state.length;
    works.add(
        acts, usual.dt, at, v, motion, before, state, force,
        kinds == static_cast<double>(walton_bit) ? all_of(1.0) : Pack{},
        [&](const ContactState<Pack>& contact) __attribute__((always_inline)) {
          return energy_of<laws>(kinds, values, contact);
        });
  }
  // The run judges springs by the stiffness of STIFF, so it gets the force that would
  // press in a contact of STIFF as far. FN / k would say too much: a contact that
  // received a spring has more force than its overlap.
  const Pack overlap = where(acts, at.overlap);
  maxima.include(overlap, overlap * usual.normal_stiffness);
  add_forces<rigid, readings>(batches, s, pair, at, acts, force.normal, force.shear, i,
                              sums);
}

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
