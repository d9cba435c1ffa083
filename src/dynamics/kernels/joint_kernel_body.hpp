// The forces of batches with laws of joints (docs/laws.md). Included once for each
// instruction set, in a namespace of its own.
#include "dynamics/kernels/barton_law.hpp"
#include "dynamics/kernels/contact_frame_body.hpp"
#include "dynamics/kernels/contact_law.hpp"
#include "dynamics/kernels/coulomb_law.hpp"
#include "dynamics/kernels/walton_law.hpp"

namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET {
namespace {

/// Finds which lanes of row s act. In addition to the contacts of the contact rule,
/// these are intact ones, and those that acted in the step before, are between the ends
/// of their edge, and are still bonded or have an offset larger than their gap.
BLOCKS_INLINE void find_acting_or_held(const BatchArrays& batches, int s,
                                       const Sides& sides, int i) {
  ContactStates& states = batches.states[s];
  const JointRow& joints = batches.joints[s];
  const Bits before = load(states.acts, i);
  find_acting(batches.tests[s], states, sides, i);
  const Pack offset = load(joints.offset, i);
  const Bits bonded = less(Pack{}, load(joints.bonded, i));
  const Bits failed = less(Pack{}, load(joints.failed, i));
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

/// The shares of the contacts of a row in the two ends of their faces: 1/2 in the lanes
/// where the record beside the contact acts too, otherwise 1.
struct Shares {
  Pack before, after;
};
BLOCKS_INLINE Shares shares_of_ends(const BatchArrays& batches, const BatchPairs& pairs,
                                    const FaceRow& faces, int i) {
  const Pack before = load(faces.beside_before, i), after = load(faces.beside_after, i);
  const Pack whole = all_of(1.0), half = all_of(0.5);
  Shares shares = {whole, whole};
  for (int row = 0; row < pairs.rows; ++row) {
    const Bits acts = load(batches.states[pairs.first_row + row].acts, i);
    const Pack share = where(choice_of(acts), half, whole);
    shares.before = before == static_cast<double>(row) ? share : shares.before;
    shares.after = after == static_cast<double>(row) ? share : shares.after;
  }
  return shares;
}

/// The part of the faces that each contact of a row stands for.
struct FaceLength {
  Pack length;  ///< L, [L]
  Pack alone;   ///< [L] L if no other contact acts at the same ends
};

/// Returns the lengths of row s. The side before the corner and the side after it form
/// a face with the edge if they run in the opposite direction and overlap it in
/// projection.
BLOCKS_INLINE FaceLength length_of(const BatchArrays& batches, const BatchPairs& pairs,
                                   int s, const Sides& sides, Pack per_length,
                                   const BlockState& blocks, int i) {
  constexpr double square_of_cosine = geometry::face_cosine * geometry::face_cosine;
  const FaceRow& faces = batches.faces[s];
  const Point before = gather_point<2>(blocks.corner, faces.before + i);
  const Point after = gather_point<2>(blocks.corner, faces.after + i);
  const Pack from_x = before[0] - sides.xc, from_y = before[1] - sides.yc;
  const Pack to_x = sides.xc - after[0], to_y = sides.yc - after[1];
  // Positions along the edge, from its start, times its length.
  const Pack at = sides.cx * sides.ex + sides.cy * sides.ey;
  const Pack from = from_x * sides.ex + from_y * sides.ey;
  const Pack to = to_x * sides.ex + to_y * sides.ey;
  const Pack none = {};
  const auto length = [&](Pack along, Pack x, Pack y, Pack low, Pack high)
      __attribute__((always_inline)) {
    const Pack start = low > 0.0 ? low : none;
    const Pack end = high < sides.square ? high : sides.square;
    const Pack square = x * x + y * y;
    const Pack common = end > start ? end - start : none;
    const Pack faced =
        along * along >= square_of_cosine * square * sides.square ? common : none;
    return along > 0.0 ? faced : none;
  };
  const Pack length_before = length(from, from_x, from_y, at, at + from);
  const Pack length_after = length(to, to_x, to_y, at - to, at);
  const Shares shares = shares_of_ends(batches, pairs, faces, i);
  const Pack both = length_before * shares.before + length_after * shares.after;
  return {0.5 * both * per_length, 0.5 * (length_before + length_after) * per_length};
}

/// Returns the values of a column for the laws of a row. only: the law of all lanes;
/// -1: several.
BLOCKS_INLINE Pack law_value(const double* column, const int* law, int only) {
  return only >= 0 ? all_of(column[only]) : gather(column, law);
}
BLOCKS_INLINE LawValues<Pack> values_of(const LawColumns& laws, const int* law,
                                        int only) {
  const auto at = [&](const double* column) __attribute__((always_inline)) {
    return law_value(column, law, only);
  };
  const LawValues<const double*>& of = laws.values;
  return {at(of.friction),          at(of.cohesion),          at(of.tension),
          at(of.residual_friction), at(of.residual_cohesion), at(of.residual_tension),
          at(of.dilation),          at(of.dilation_limit),    at(of.unloading_ratio),
          at(of.roughness),         at(of.wall_strength),     at(of.residual_angle),
          at(of.peak_slip),         at(of.largest_closure),   at(of.linear_from),
          at(of.strength_share)};
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
  each_state(get, state, batches.joints[s]);
  const Pack born_failed = state.bonded > 0.0 ? state.failed : all_of(1.0);
  state.failed = state.stiffness > 0.0 ? state.failed : born_failed;
  return state;
}
/// Stores the states of the lanes that act, and zeros for the others.
BLOCKS_INLINE void store_state(const BatchArrays& batches, int s, int i, Choice acts,
                               const ContactState<Pack>& state) {
  const auto put = [&](double* row, const Pack& x) __attribute__((always_inline)) {
    store(row, i, where(acts, x));
  };
  put(batches.advanced[s].normal_elastic, state.normal);
  put(batches.advanced[s].shear_elastic, state.shear);
  each_state(put, batches.advanced_joints[s], state);
}

/// Returns the stiffness of a contact, [F/L]. It grows with the length, but does not
/// shrink. per_length: [F/L^3], 0 for `usual`, the stiffness of STIFF.
BLOCKS_INLINE Pack stiffness_of(Pack old, Pack per_length, Pack length, double usual) {
  const Pack wanted = per_length * length;
  const Pack fresh = wanted > 0.0 ? wanted : all_of(usual);
  const Pack kept = old > 0.0 ? old : fresh;
  return wanted > kept ? wanted : kept;
}

/// Returns by how much the dashpot of a contact is weaker because another contact acts
/// at the same end. Its constant goes with the root of its stiffness, so two halves of
/// an end would have stronger dashpots than the whole.
BLOCKS_INLINE Pack dashpot_share(Pack per_area, const FaceLength& face) {
  const Pack shared = root(face.length / face.alone);
  return ((per_area > 0.0) & (face.alone > 0.0)) ? shared : all_of(1.0);
}

/// Applies one kind of law. may_start: false if motion.starting is known to be 0.
template <LawBits kind, bool may_start>
BLOCKS_INLINE void apply_law(const LawValues<Pack>& values, double dt,
                             const ContactMotion<Pack>& motion,
                             ContactState<Pack>& state, ContactForce<Pack>& force) {
  if constexpr (kind == coulomb_bit)
    apply_coulomb<may_start>(values, dt, motion, state, force);
  else if constexpr (kind == walton_bit)
    apply_walton<may_start>(values, dt, motion, state, force);
  else
    apply_barton<may_start>(values, dt, motion, state, force);
}

/// Applies one kind of law in its lanes of a batch with several kinds.
template <LawBits kind>
BLOCKS_INLINE void
apply_in_lanes(LawBits laws, Pack kind_of_lane, const LawValues<Pack>& values,
               double dt, const ContactMotion<Pack>& motion,
               const ContactState<Pack>& start, ContactState<Pack>& state,
               ContactForce<Pack>& force) {
  if ((laws & kind) == 0)
    return;
  ContactState<Pack> own = start;
  ContactForce<Pack> of = {};
  apply_law<kind, true>(values, dt, motion, own, of);
  const auto put = [&](Pack & to, const Pack& x) __attribute__((always_inline)) {
    to = kind_of_lane == static_cast<double>(kind) ? x : to;
  };
  put(force.normal, of.normal), put(force.shear, of.shear);
  put(state.normal, own.normal), put(state.shear, own.shear);
  each_state(put, state, own);
}

/// Returns the energy of the springs. kind: the only kind of law; 0: `kinds`.
template <LawBits kind>
BLOCKS_INLINE Pack energy_of(Pack kinds, const LawValues<Pack>& values,
                             const ContactState<Pack>& state) {
  if constexpr (kind == coulomb_bit)
    return coulomb_energy(state);
  else if constexpr (kind == walton_bit)
    return walton_energy(values, state);
  else if constexpr (kind == barton_bit)
    return barton_energy(values, state);
  else
    return kinds == static_cast<double>(barton_bit)   ? barton_energy(values, state)
           : kinds == static_cast<double>(walton_bit) ? walton_energy(values, state)
                                                      : coulomb_energy(state);
}
/// Adds what the contacts of row s do with their work.
template <LawBits kind>
BLOCKS_INLINE void
add_joint_work(const BatchArrays& batches, int batch, int s, int i, Choice acts,
               double dt, const ContactMotion<Pack>& motion,
               const LawValues<Pack>& values, const ContactState<Pack>& after,
               const ContactForce<Pack>& force) {
  ContactState<Pack> before = load_state(batches, s, i);
  before.stiffness = after.stiffness, before.shear_stiffness = after.shear_stiffness;
  before.length = after.length;
  const Pack kinds =
      kind != 0 ? all_of(kind) : gather(batches.laws.bit, batches.faces[s].law + i);
  add_work(
      batches.works[batch], i, acts, dt, motion, before, after, force,
      kinds == static_cast<double>(walton_bit) ? all_of(1.0) : Pack{},
      [&](const ContactState<Pack>& state) __attribute__((always_inline)) {
        return energy_of<kind>(kinds, values, state);
      });
}

/// Steps a. to e. for row s. kind: the only kind of law in the batch; 0: several.
template <LawBits kind, bool rigid, bool readings, class Sums>
BLOCKS_INLINE void
act_joint_row(const BatchArrays& batches, int batch, int s, const Sides& sides,
              const BlockState& blocks, const Pairs<rigid>& two, Pack damping,
              const ContactLaw& usual, int i, Sums& sums, Most& most) {
  const BatchPairs& pairs = batches.pairs[batch];
  const Frame at = frame_of(sides, batches.tests[s], i);
  const ContactStates& row = batches.states[s];
  const Choice acts = choice_of(load(row.acts, i));
  const Bits starts = load(row.starts, i);
  const Point v = two.velocity(at.x - two.low_x, at.y - two.low_y);
  ContactState<Pack> state = load_state(batches, s, i);
  const FaceLength face = length_of(batches, pairs, s, sides, at.per_length, blocks, i);
  state.length = face.length;
  const int* const law = batches.faces[s].law + i;

  const LawColumns& laws = batches.laws;
  const Pack per_area = law_value(laws.normal_stiffness, law, pairs.only_law);
  state.stiffness =
      stiffness_of(state.stiffness, per_area, state.length, usual.normal_stiffness);
  state.shear_stiffness = stiffness_of(
      state.shear_stiffness, law_value(laws.shear_stiffness, law, pairs.only_law),
      state.length, usual.shear_stiffness);

  const ContactMotion<Pack> motion = {
      -(v[0] * -at.ty + v[1] * at.tx), v[0] * at.tx + v[1] * at.ty, at.overlap,
      damping * dashpot_share(per_area, face) *
          root(state.stiffness / usual.normal_stiffness),
      where(choice_of(starts), all_of(1.0))};
  const LawValues<Pack> values = values_of(laws, law, pairs.only_law);
  ContactForce<Pack> force = {};
  if constexpr (kind != 0) {
    if (starts != 0)
      apply_law<kind, true>(values, usual.dt, motion, state, force);
    else
      apply_law<kind, false>(values, usual.dt, motion, state, force);
  } else {
    const ContactState<Pack> start = state;
    const Pack kinds = gather(laws.bit, law);
    apply_in_lanes<coulomb_bit>(pairs.laws, kinds, values, usual.dt, motion, start,
                                state, force);
    apply_in_lanes<walton_bit>(pairs.laws, kinds, values, usual.dt, motion, start,
                               state, force);
    apply_in_lanes<barton_bit>(pairs.laws, kinds, values, usual.dt, motion, start,
                               state, force);
  }
  store_state(batches, s, i, acts, state);
  if (batches.has_account) {
    add_joint_work<kind>(batches, batch, s, i, acts, usual.dt, motion, values, state,
                         force);
    add_work_of_lag(batches.works[batch], i, acts, usual.dt,
                    Pairs<rigid>(pairs, blocks, 0.0, i), at, v, force.normal,
                    force.shear);
  }
  // The run judges springs by the stiffness of STIFF, so it gets the force that would
  // press in a contact of STIFF as far. FN / k would say too much: a contact that
  // received a spring has more force than its overlap.
  const Pack overlap = where(acts, at.overlap);
  most.include(overlap, overlap * usual.normal_stiffness);
  add_forces<rigid, readings>(batches, s, two, at, acts, force.normal, force.shear, i,
                              sums);
}

/// Returns whether contacts in some lanes, `count` of them from lane i on, have yet to
/// be settled (BatchMarks::unsettled).
inline bool is_unsettled(const BatchArrays& batches, const BatchPairs& pairs, int i,
                         int count) {
  unsigned open = 0;
  for (int s = pairs.first_row; s < pairs.first_row + pairs.rows; ++s) {
    const ContactStates& states = batches.states[s];
    open |= states.in_doubt;
    if (pairs.has_laws)
      open |= states.starts | states.ends;
  }
  return (open >> i & ((1U << count) - 1)) != 0;
}

/// The same as act_batch for batches with laws of joints. The length of a contact
/// depends on which other contacts act, so these are found first. If contacts have yet
/// to be settled, no forces are computed.
template <LawBits kind, bool find, bool rigid, bool readings>
Most act_joint_batch(const BatchArrays& batches, int batch, const BlockState& blocks,
                     const ContactLaw& usual, int i) {
  const BatchPairs& pairs = batches.pairs[batch];
  constexpr int kept = 8;  // rows whose sides are kept; the others compute them twice
  Sides all[kept];
  for (int k = 0; k < pairs.rows; ++k) {
    const int s = pairs.first_row + k;
    const Sides sides(batches.contacts[s], blocks, i);
    if constexpr (find)
      find_acting_or_held(batches, s, sides, i);
    if (k < kept)
      all[k] = sides;
  }
  if constexpr (find)
    if (is_unsettled(batches, pairs, i, width))
      return {};
  const Pairs<rigid> two(pairs, blocks, usual.dt, i);
  const Pack damping = load(pairs.damping, i);
  Sums<readings || !rigid> sums;
  Most most;
  if (batches.has_account)
    clear_work(batches.works[batch], i);
  for (int k = 0; k < pairs.rows; ++k) {
    const int s = pairs.first_row + k;
    const Sides& sides =
        k < kept ? all[k] : all[0] = Sides(batches.contacts[s], blocks, i);
    act_joint_row<kind, rigid, readings>(batches, batch, s, sides, blocks, two, damping,
                                         usual, i, sums, most);
  }
  store_sums(batches, batch, sums, i);
  return most;
}
template <bool find, bool rigid, bool readings>
BLOCKS_INLINE Most act_joint_batch(const BatchArrays& batches, int batch,
                                   const BlockState& blocks, const ContactLaw& usual,
                                   int i) {
  switch (batches.pairs[batch].laws) {
  case coulomb_bit:
    return act_joint_batch<coulomb_bit, find, rigid, readings>(batches, batch, blocks,
                                                               usual, i);
  case walton_bit:
    return act_joint_batch<walton_bit, find, rigid, readings>(batches, batch, blocks,
                                                              usual, i);
  case barton_bit:
    return act_joint_batch<barton_bit, find, rigid, readings>(batches, batch, blocks,
                                                              usual, i);
  default:
    return act_joint_batch<0, find, rigid, readings>(batches, batch, blocks, usual, i);
  }
}

/// Returns whether a contact of a batch has lost its bond in this step.
inline bool breaks(const BatchArrays& batches, const BatchPairs& pairs) {
  for (int s = pairs.first_row; s < pairs.first_row + pairs.rows; ++s)
    for (int k = 0; k < lane_count; ++k)
      if (batches.joints[s].bonded[k] > batches.advanced_joints[s].bonded[k])
        return true;
  return false;
}

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
