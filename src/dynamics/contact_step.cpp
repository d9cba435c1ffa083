#include "dynamics/contact_step.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/kernels/barton_law.hpp"
#include "dynamics/kernels/contact_law.hpp"
#include "dynamics/kernels/coulomb_law.hpp"
#include "dynamics/kernels/walton_law.hpp"

namespace blocks::dynamics {

int ContactSteps::law(int slot, int lane) const {
  const bool has_laws = arrays_.batches.pairs[lane / lane_count].has_laws;
  return has_laws ? arrays_.batches.at(slot, &FaceRow::law) : 0;
}

ContactState<double> ContactSteps::state(const SpringRow* springs,
                                         const JointRow* joints, int slot,
                                         int lane) const {
  const int row = slot / lane_count, k = slot % lane_count;
  ContactState<double> state{};
  state.normal = springs[row].normal_elastic[k];
  state.shear = springs[row].shear_elastic[k];
  if (is_stateless(law(slot, lane))) {
    state.stiffness = settings_.normal_stiffness;
    state.shear_stiffness = settings_.shear_stiffness;
    state.failed = 1.0;
    return state;
  }
  each_state([k](double& to, const double* from) { to = from[k]; }, state, joints[row]);
  return state;
}

ContactMotion<double> ContactSteps::motion(int slot, int lane) const {
  const ContactBatches& batches = arrays_.batches;
  const BatchPairs& pairs = batches.pairs[lane / lane_count];
  const int low = pairs.low[lane % lane_count], high = pairs.high[lane % lane_count];
  const Vec2 c = blocks_.corner.col(batches.at(slot, &ContactRow::corner));
  const Vec2 from = blocks_.corner.col(batches.at(slot, &ContactRow::edge));
  const Vec2 to = blocks_.corner.col(batches.at(slot, &ContactRow::edge_end));
  const Vec2 edge = to - from, at = c - from;
  const double per_length = 1.0 / std::sqrt(edge.x() * edge.x() + edge.y() * edge.y());
  const double depth = (at.x() * edge.y() - at.y() * edge.x()) * per_length;
  const bool turned = batches.is(slot, &ContactTests::edge_is_low);
  const Vec2 t = edge * (turned ? -per_length : per_length);

  // The motion of the low block relative to the high one, in the order of the kernel.
  const Vec2 apart = blocks_.centroid.col(low) - blocks_.centroid.col(high);
  const Vec2 arm = c - blocks_.centroid.col(low);
  const Vec2 va = blocks_.velocity.col(low), vb = blocks_.velocity.col(high);
  const auto a = blocks_.strain_rate.col(low), b = blocks_.strain_rate.col(high);
  const double x = apart.x(), y = apart.y();
  const double vx = va.x() - (vb.x() - blocks_.spin[high] * y) - (b[0] * x + b[1] * y);
  const double vy = va.y() - (vb.y() + blocks_.spin[high] * x) - (b[2] * x + b[3] * y);
  const double turn = blocks_.spin[low] - blocks_.spin[high];
  const Vec2 v(vx + ((a[0] - b[0]) * arm.x() + (-turn + (a[1] - b[1])) * arm.y()),
               vy + ((turn + (a[2] - b[2])) * arm.x() + (a[3] - b[3]) * arm.y()));
  ContactMotion<double> motion{};
  motion.closing = -(v.x() * -t.y() + v.y() * t.x());
  motion.sliding = v.x() * t.x() + v.y() * t.y();
  motion.overlap = depth > 0.0 ? depth : 0.0;
  motion.damping = pairs.damping[lane % lane_count];
  motion.starting = batches.is(slot, &ContactStates::starts) ? 1.0 : 0.0;
  return motion;
}

ContactForce<double> ContactSteps::force_of(int law, const ContactMotion<double>& moves,
                                            ContactState<double> state) const {
  ContactForce<double> force{};
  if (is_stateless(law)) {
    const ContactLaw usual{settings_.normal_stiffness, settings_.shear_stiffness,
                           settings_.friction, dt_};
    if (moves.starting > 0.0)
      apply(usual, state.normal, state.shear, moves.closing, moves.sliding,
            moves.overlap, moves.damping, moves.starting, force.normal, force.shear);
    else
      apply<false>(usual, state.normal, state.shear, moves.closing, moves.sliding,
                   moves.overlap, moves.damping, 0.0, force.normal, force.shear);
    return force;
  }
  const LawValues<double> values = energies_.values_of(law);
  switch (energies_.bit_of(law)) {
  case walton_bit:
    apply_walton(values, dt_, moves, state, force);
    break;
  case barton_bit:
    apply_barton(values, dt_, moves, state, force);
    break;
  default:
    apply_coulomb(values, dt_, moves, state, force);
  }
  return force;
}

ContactStep ContactSteps::at(int slot, int lane) const {
  const ContactBatches& batches = arrays_.batches;
  const int number = law(slot, lane);
  const ContactState<double> after =
      state(batches.advanced, batches.advanced_joints, slot, lane);
  ContactState<double> before = state(batches.springs, batches.joints, slot, lane);
  // The kernel sets stiffness and length of the step, and the strength of a new
  // contact.
  if (!(before.stiffness > 0.0) && !(before.bonded > 0.0))
    before.failed = 1.0;
  before.stiffness = after.stiffness, before.shear_stiffness = after.shear_stiffness;
  before.length = after.length;
  ContactMotion<double> moves = motion(slot, lane);
  if (!is_stateless(number))
    moves.damping *= std::sqrt(after.stiffness / settings_.normal_stiffness);

  const LawBits bit = energies_.bit_of(number);
  const ContactForce<double> force = force_of(number, moves, before);

  ContactStep step{};
  step.closing = moves.closing * dt_, step.sliding = moves.sliding * dt_;
  step.share = moves.starting > 0.0 ? closing_of<true>(dt_, moves, before).share : 1.0;
  step.normal_before = before.normal;
  // Dilation changes the spring after it has acted.
  const double rise = after.offset - before.offset;
  const bool is_known = after.bonded > 0.0 || force.normal > 0.0;
  step.normal = rise == 0.0 ? after.normal
                : is_known  ? force.normal - moves.damping * moves.closing
                            : std::max(0.0, after.normal - after.stiffness * rise);
  step.shear_before = before.shear, step.shear = after.shear;
  step.normal_force = force.normal, step.shear_force = force.shear;
  step.shear_compliance =
      after.shear_stiffness > 0.0 ? 1.0 / after.shear_stiffness : 0.0;
  const SpringEnergy stored_before = energies_.of(number, before);
  const SpringEnergy stored = energies_.of(number, after);
  step.normal_energy_before = stored_before.normal;
  step.shear_energy_before = stored_before.shear;
  step.normal_energy = step.normal_energy_acting = stored.normal;
  step.shear_energy = stored.shear;
  if (rise != 0.0) {
    ContactState<double> acting = after;
    acting.normal = step.normal;
    step.normal_energy_acting = energies_.of(number, acting).normal;
  }
  step.fails = after.failed > before.failed;
  step.is_hysteretic = bit == walton_bit;
  return step;
}

double ContactSteps::stored(int slot, int lane) const {
  const ContactBatches& batches = arrays_.batches;
  return energies_
      .of(law(slot, lane), state(batches.springs, batches.joints, slot, lane))
      .both();
}

}  // namespace blocks::dynamics
