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

void end_drive(Model& model, int block) {
  std::erase_if(model.drives, [&](const Drive& drive) { return drive.block == block; });
  if (model.blocks.is_driven(block))
    model.blocks.fixity[block] = Fixity::by_user;
}

}  // namespace blocks
