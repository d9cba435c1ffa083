#include "dynamics/servo.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/kernels/barton_law.hpp"

namespace blocks::dynamics {
namespace {

/// Calls visit(slot, lane) for each contact of block b that acts, in the order of the
/// pairs.
template <class Visit>
void each_acting(const ContactArrays& arrays, int b, const Visit& visit) {
  arrays.each_lane_of(b, [&](unsigned lane, bool) {
    const int number = static_cast<int>(lane);
    arrays.each_slot(arrays.pair_of_lane[number], [&](int slot) {
      if (arrays.batches.is(slot, &ContactStates::acts))
        visit(slot, number);
    });
  });
}

/// Returns the largest tangent of the closure of Bandis up to a force, [F/L].
double bandis_tangent(const LawValues<double>& law, double length, double stiffness,
                      double force) {
  const double rise = 1.0 + std::max(0.0, force) / (stiffness * law.largest_closure);
  const BandisClosure<double> bandis(law, length, stiffness);
  return std::min(stiffness * rise * rise, bandis.slope);
}

/// The direction of a contact seen from a side: that of the edge.
struct EdgeDirection {
  double cosine, sine;  ///< along the side, and along its outward normal

  EdgeDirection(const Blocks& blocks, const ContactBatches& batches, int slot,
                const Vec2& along) {
    const Vec2 from = blocks.corner.col(batches.at(slot, &ContactRow::edge));
    const Vec2 to = blocks.corner.col(batches.at(slot, &ContactRow::edge_end));
    const Vec2 edge = to - from;
    const double length = std::sqrt(edge.x() * edge.x() + edge.y() * edge.y());
    cosine = (edge.x() * along.x() + edge.y() * along.y()) / length;
    sine = (edge.y() * along.x() - edge.x() * along.y()) / length;
  }
};

/// The stiffnesses of contacts. They are never less than what a contact shows while its
/// force rises by `missing`: with less the servo would go too far.
class ServoStiffness {
 public:
  /// missing: [F] >= 0
  ServoStiffness(const Settings& settings, const ContactArrays& arrays, double missing)
      : settings_(settings), batches_(arrays.batches), laws_(arrays.laws),
        missing_(missing) {}

  /// Returns the stiffness of a contact in the direction of the normal, [F/L].
  double of(int slot, int lane, const EdgeDirection& edge) const {
    const bool has_laws = batches_.pairs[lane / lane_count].has_laws;
    double normal = settings_.normal_stiffness, shear = settings_.shear_stiffness;
    if (has_laws) {  // Contacts of STIFF may be stiffer too, after INSITU.
      const int law = batches_.at(slot, &FaceRow::law);
      const int row = slot / lane_count, k = slot % lane_count;
      const LawRow& row_state = batches_.law_states[row];
      normal = row_state.stiffness[k], shear = row_state.shear_stiffness[k];
      const LawBits bit = laws_.bit(law);
      if (bit == walton_bit)  // It may unload, along the steeper line.
        normal *= laws_.values(law).unloading_ratio;
      else if (bit == barton_bit && edge.cosine != 0.0)
        normal = bandis_tangent(laws_.values(law), row_state.length[k], normal,
                                batches_.springs[row].normal_elastic[k] +
                                    missing_ / std::abs(edge.cosine));
    }
    return normal * (edge.cosine * edge.cosine) + shear * (edge.sine * edge.sine);
  }

 private:
  const Settings& settings_;
  const ContactBatches& batches_;
  const LawTable& laws_;
  double missing_;
};

}  // namespace

ServoContacts read_servo_contacts(const Model& model, const ContactArrays& contacts,
                                  const Servo& servo, const Vec2& along,
                                  double length) {
  const Blocks& blocks = model.blocks;
  const ContactBatches& batches = contacts.batches;
  double force = 0.0;  // on the block, along the outward normal
  each_acting(contacts, servo.block, [&](int slot, int) {
    const EdgeDirection edge(blocks, batches, slot, along);
    const SpringRow& springs = batches.springs[slot / lane_count];
    const int k = slot % lane_count;
    // The normal spring pushes the block of the corner along the outward normal of the
    // edge. A positive shear spring pushes it against the direction of the edge.
    const double on_corner =
        springs.normal_elastic[k] * edge.cosine - springs.shear_elastic[k] * edge.sine;
    const int corner = batches.at(slot, &ContactRow::corner);
    force += blocks.corner_block[corner] == servo.block ? on_corner : -on_corner;
  });
  ServoContacts read;
  read.stress = force / length;
  const double missing = std::max(0.0, (read.stress - servo.target) * length);
  const ServoStiffness stiffness(model.settings, contacts, missing);
  each_acting(contacts, servo.block, [&](int slot, int lane) {
    read.stiffness +=
        stiffness.of(slot, lane, EdgeDirection(blocks, batches, slot, along));
  });
  return read;
}

void control_servos(Model& model, const ContactArrays& contacts) {
  Blocks& blocks = model.blocks;
  auto drive = model.drives.begin();
  for (const Servo& servo : model.servos) {
    while (drive->block != servo.block)  // Both are ascending in block.
      ++drive;
    const int corner = blocks.first_corner[servo.block] + servo.side;
    const Vec2 side =
        blocks.corner.col(blocks.next[corner]) - blocks.corner.col(corner);
    const double length = std::sqrt(side.x() * side.x() + side.y() * side.y());
    const Vec2 along(side.x() / length, side.y() / length);
    const ServoContacts read =
        read_servo_contacts(model, contacts, servo, along, length);
    // Without contacts the stress is 0. A side that is to press then moves on until it
    // touches. One that is to pull has nothing to pull, and waits.
    double speed = servo.target < 0.0 ? servo.max_speed : 0.0;
    if (read.stiffness > 0.0)
      speed = std::clamp(servo_gain * length * (read.stress - servo.target) /
                             (read.stiffness * model.time_step.dt),
                         -servo.max_speed, servo.max_speed);
    // Corners are clockwise, so the outward normal is the side turned to the left.
    const Vec2 velocity(-along.y() * speed, along.x() * speed);
    drive->velocity = velocity;
    blocks.velocity.col(servo.block) = velocity;
  }
}

}  // namespace blocks::dynamics
