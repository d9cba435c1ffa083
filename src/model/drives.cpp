#include "model/drives.hpp"

#include <algorithm>

namespace blocks {

void drive_block(Model& model, const Drive& drive) {
  end_drive(model, drive.block);
  model.blocks.velocity.col(drive.block) = drive.velocity;
  model.blocks.spin[drive.block] = drive.spin;
  model.blocks.fixity[drive.block] = Fixity::driven;
  model.search.invalidate();
  const auto next =
      std::find_if(model.drives.begin(), model.drives.end(),
                   [&](const Drive& other) { return other.block > drive.block; });
  model.drives.insert(next, drive);
}

void start_servo(Model& model, const Servo& servo) {
  drive_block(model, {servo.block});
  const auto next =
      std::find_if(model.servos.begin(), model.servos.end(),
                   [&](const Servo& other) { return other.block > servo.block; });
  model.servos.insert(next, servo);
}

ServoSide side_of(const Blocks& blocks, const Servo& servo) {
  const int corner = blocks.first_corner[servo.block] + servo.side;
  const Vec2 side = blocks.corner.col(blocks.next[corner]) - blocks.corner.col(corner);
  const double length = side.norm();
  return {Vec2(-side.y(), side.x()) / length, length};
}

double stress_on(const Model& model, const Servo& servo) {
  const Blocks& blocks = model.blocks;
  const ServoSide side = side_of(blocks, servo);
  double force = 0.0;
  for (const Contact& contact : model.contacts) {
    const bool has_corner = blocks.corner_block[contact.corner] == servo.block;
    if (!has_corner && blocks.corner_block[contact.edge] != servo.block)
      continue;
    const Vec2 along =
        (blocks.corner.col(blocks.next[contact.edge]) - blocks.corner.col(contact.edge))
            .normalized();
    const Vec2 on_corner = contact.normal_elastic * Vec2(-along.y(), along.x()) -
                           contact.shear_elastic * along;
    force += (has_corner ? 1.0 : -1.0) * side.outwards.dot(on_corner);
  }
  return force / side.length;
}

void end_drive(Model& model, int block) {
  const auto is_of = [&](const auto& item) { return item.block == block; };
  std::erase_if(model.drives, is_of);
  std::erase_if(model.servos, is_of);
  if (model.blocks.is_driven(block))
    model.blocks.fixity[block] = Fixity::by_user;
}

}  // namespace blocks
