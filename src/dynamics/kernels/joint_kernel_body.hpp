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

/// The edge of a contact and where its corner is along it.
struct EdgeLine {
  Pack ex, ey, square;  ///< [L], [L], [L^2] the edge and the square of its length
  Pack at;              ///< [L^2] position of the corner, times the length
  BLOCKS_INLINE EdgeLine() = default;
  BLOCKS_INLINE explicit EdgeLine(const Sides& of)
      : ex(of.ex), ey(of.ey), square(of.square), at(of.cx * of.ex + of.cy * of.ey) {}
};

/// The part of the faces that each contact of a row stands for.
struct FaceLength {
  Pack length;  ///< L, [L]
  Pack alone;   ///< [L] L if no other contact acts at the same ends
};

/// Returns the lengths of row s. The side before the corner and the side after it form
/// a face with the edge if they run in the opposite direction and overlap it in
/// projection.
BLOCKS_INLINE FaceLength length_of(const FaceRow& faces, const EdgeLine& edge,
                                   const Frame& corner, const BlockState& blocks,
                                   int i) {
  constexpr double square_of_cosine = geometry::face_cosine * geometry::face_cosine;
  const Point before = gather_point<2>(blocks.corner, faces.before + i);
  const Point after = gather_point<2>(blocks.corner, faces.after + i);
  const Pack from_x = before[0] - corner.x, from_y = before[1] - corner.y;
  const Pack to_x = corner.x - after[0], to_y = corner.y - after[1];
  // Positions along the edge, from its start, times its length.
  const Pack from = from_x * edge.ex + from_y * edge.ey;
  const Pack to = to_x * edge.ex + to_y * edge.ey;
  const Pack none = {};
  const auto length = [&](Pack along, Pack x, Pack y, Pack low, Pack high)
      __attribute__((always_inline)) {
    const Pack start = low > 0.0 ? low : none;
    const Pack end = high < edge.square ? high : edge.square;
    const Pack square = x * x + y * y;
    const Pack common = end > start ? end - start : none;
    const Pack faced =
        along * along >= square_of_cosine * square * edge.square ? common : none;
    return along > 0.0 ? faced : none;
  };
  const auto share = [&](LaneBits shared) __attribute__((always_inline)) {
    return where(choice_of(load(shared, i)), all_of(0.5), all_of(1.0));
  };
  const Pack length_before = length(from, from_x, from_y, edge.at, edge.at + from);
  const Pack length_after = length(to, to_x, to_y, edge.at - to, edge.at);
  const Pack both = length_before * share(faces.shared_before) +
                    length_after * share(faces.shared_after);
  return {0.5 * both * corner.per_length,
          0.5 * (length_before + length_after) * corner.per_length};
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
BLOCKS_INLINE void store_state(const BatchArrays& batches, int batch, int s, int i,
                               Choice acts, const ContactState<Pack>& state) {
  if (less(where(acts, state.bonded), load(batches.joints[s].bonded, i)) != 0)
    batches.marks[batch].breaks = true;
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

/// Returns the energy of the normal springs. kind: the only kind of law; 0: `kinds`.
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
template <LawBits kind, bool rigid>
BLOCKS_INLINE void
add_joint_work(WorkSums<rigid>& works, const BatchArrays& batches, int s, int i,
               Choice acts, double dt, const Frame& at, const Point& v,
               const ContactMotion<Pack>& motion, const LawValues<Pack>& values,
               const ContactState<Pack>& after, const ContactForce<Pack>& force) {
  ContactState<Pack> before = load_state(batches, s, i);
  before.stiffness = after.stiffness, before.shear_stiffness = after.shear_stiffness;
  before.length = after.length;
  const Pack kinds =
      kind != 0 ? all_of(kind) : gather(batches.laws.bit, batches.faces[s].law + i);
  works.add(
      acts, dt, at, v, motion, before, after, force,
      kinds == static_cast<double>(walton_bit) ? all_of(1.0) : Pack{},
      [&](const ContactState<Pack>& state) __attribute__((always_inline)) {
        return energy_of<kind>(kinds, values, state);
      });
}

/// Steps a. to e. for row s. kind: the only kind of law in the batch; 0: several.
template <LawBits kind, bool rigid, bool readings, class Sums>
BLOCKS_INLINE void act_joint_row(const BatchArrays& batches, int batch, int s,
                                 const EdgeLine& edge, const Frame& at,
                                 const BlockState& blocks, const Pairs<rigid>& two,
                                 Pack damping, const ContactLaw& usual, int i,
                                 Sums& sums, Most& most, WorkSums<rigid>& works) {
  const BatchPairs& pairs = batches.pairs[batch];
  const Bits acting = load(batches.states[s].acts, i);
  const Choice acts = choice_of(acting);
  const Bits starts = load(batches.states[s].starts, i);
  if (!readings && acting == 0) {
    store_state(batches, batch, s, i, acts, ContactState<Pack>{});
    return;
  }
  const Point v = two.velocity(at.x - two.low_x, at.y - two.low_y);

  ContactState<Pack> state = load_state(batches, s, i);
  const FaceLength face = length_of(batches.faces[s], edge, at, blocks, i);
  state.length = where(acts, face.length);
  const int* const law = batches.faces[s].law + i;

  const LawColumns& laws = batches.laws;
  const Pack per_area = law_value(laws.normal_stiffness, law, pairs.only_law);
  state.stiffness =
      stiffness_of(state.stiffness, per_area, state.length, usual.normal_stiffness);
  state.shear_stiffness = stiffness_of(
      state.shear_stiffness, law_value(laws.shear_stiffness, law, pairs.only_law),
      state.length, usual.shear_stiffness);

  // Idle lanes have no motion, so that their numbers need no rare paths.
  const ContactMotion<Pack> motion = {
      where(acts, -(v[0] * -at.ty + v[1] * at.tx)),
      where(acts, v[0] * at.tx + v[1] * at.ty), at.overlap,
      damping * dashpot_share(per_area, face, acting) *
          root_of_stiffness(batches.dashpots[s], state.stiffness,
                            usual.normal_stiffness, acting, i),
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
  store_state(batches, batch, s, i, acts, state);
  if (batches.has_account)
    add_joint_work<kind>(works, batches, s, i, acts, usual.dt, at, v, motion, values,
                         state, force);
  // The run judges springs by the stiffness of STIFF, so it gets the force that would
  // press in a contact of STIFF as far. FN / k would say too much: a contact that
  // received a spring has more force than its overlap.
  const Pack overlap = where(acts, at.overlap);
  most.include(overlap, overlap * usual.normal_stiffness);
  add_forces<rigid, readings>(batches, s, two, at, acts, force.normal, force.shear, i,
                              sums);
}

}  // namespace
}  // namespace blocks::dynamics::BLOCKS_INSTRUCTION_SET
