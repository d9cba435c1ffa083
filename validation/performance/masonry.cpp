#include "masonry.hpp"

#include <algorithm>

namespace blocks::bench {

NewBlock box(double left, double bottom, double right, double top, Fixity fixity) {
  return {{{left, bottom}, {left, top}, {right, top}, {right, bottom}},
          1,
          rock_density,
          fixity};
}

std::vector<NewBlock> trough(double width, double top) {
  return {box(-1, -1, width + 1, 0, Fixity::by_user),
          box(-1, 0, 0, top, Fixity::by_user),
          box(width, 0, width + 1, top, Fixity::by_user)};
}

Model masonry(const std::string& title, const std::vector<NewBlock>& blocks,
              double width, double height, int boxes_y, double stiffness) {
  Model model;
  Settings& s = model.settings;
  s.title = title;
  s.max_blocks = static_cast<int>(blocks.size());
  for (const NewBlock& block : blocks)
    s.max_corners = std::max(s.max_corners, static_cast<int>(block.outline.size()));
  s.lower = {-2, -2};
  s.upper = {width + 2, height + 2};
  s.boxes_x = static_cast<int>(width) + 4;
  s.boxes_y = boxes_y;
  s.contact_tolerance = 0.05;
  s.normal_stiffness = s.shear_stiffness = stiffness;
  s.fraction = 0.025;
  s.damping = 0.5;
  s.friction = 0.6;
  s.gravity = {0, -9.81};
  s.rigid = true;
  // So soft that contacts limit the time step of deformable blocks too.
  s.materials[1] = {4e9, 1.6e9, rock_density};
  model.blocks.append(blocks);
  return model;
}

}  // namespace blocks::bench
