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

void end_drive(Model& model, int block) {
  const auto is_of = [&](const auto& item) { return item.block == block; };
  std::erase_if(model.drives, is_of);
  std::erase_if(model.servos, is_of);
  if (model.blocks.is_driven(block))
    model.blocks.fixity[block] = Fixity::by_user;
}

}  // namespace blocks
