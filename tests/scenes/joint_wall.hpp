// A wall of bricks whose contacts have the law of a joint, filled in by hand: the tests
// of files and figures need no run.
#pragma once

#include <cmath>

#include "model/model.hpp"

namespace blocks::scenes {

/// Adds a contact for every corner that lies on an edge of another block and ends a
/// face there, all with law 1, bonded, with 10 units of normal and 2 of shear force for
/// each unit of length.
inline void touch_with_law(Model& model) {
  const Blocks& blocks = model.blocks;
  for (int c = 0; c < blocks.corners(); ++c)
    for (int e = 0; e < blocks.corners(); ++e) {
      if (blocks.corner_block[c] == blocks.corner_block[e])
        continue;
      const Vec2 start = blocks.corner.col(e),
                 edge = blocks.corner.col(blocks.next[e]) - start,
                 along = edge.normalized(), arm = blocks.corner.col(c) - start;
      const double foot = arm.dot(along);
      if (std::abs(geometry::cross(arm, along)) > 1e-9 || foot < -1e-9 ||
          foot > edge.norm() + 1e-9)
        continue;
      for (const int next : {blocks.previous[c], blocks.next[c]}) {
        const Vec2 to = blocks.corner.col(next) - blocks.corner.col(c);
        const double end = std::clamp(foot + to.dot(along), 0.0, edge.norm());
        const bool runs_against =
            next == blocks.next[c] ? to.dot(along) < 0 : to.dot(along) > 0;
        if (std::abs(geometry::cross(to, along)) > 1e-9 || !runs_against ||
            std::abs(end - foot) < 1e-9)
          continue;
        const double length = 0.5 * std::abs(end - foot);
        model.contacts.push_back(
            {c, e, 10.0 * length, 2.0 * length, 10.0 * length, 2.0 * length, 1e-6});
        LawState state;
        state.law = 1, state.bonded = true, state.length = length;
        state.stiffness = 1e9 * length, state.shear_stiffness = 5e8 * length;
        model.law_states.push_back(state);
      }
    }
}

/// Returns a wall of `courses` courses of bricks 2 wide and 1 high, on a fixed base.
inline Model joint_wall(int courses, int bricks) {
  Model model;
  model.settings.title = "Bonded wall";
  model.settings.materials[1] = {1e10, 4e9, 2000.0, ""};
  model.settings.materials[2] = {1e10, 4e9, 2000.0, ""};
  model.settings.joint_laws[1] = {};
  const auto add = [&](double x, double y, double w, double h, int material,
                       Fixity fixity) {
    NewBlock block{
        {{x, y}, {x, y + h}, {x + w, y + h}, {x + w, y}}, material, 2000.0, fixity, 0};
    model.blocks.append({block});
  };
  add(-1, -1, 2.0 * bricks + 2, 1, 2, Fixity::by_user);
  for (int row = 0; row < courses; ++row)
    for (int i = 0; i < bricks; ++i)
      add(2.0 * i + (row % 2 == 0 ? 0.0 : 0.5), row, 2, 1, 1, Fixity::free);
  touch_with_law(model);
  return model;
}

/// Fails the contacts left of a line that rises to the right, the more slip the lower.
inline void crack(Model& model, double at) {
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const Vec2 p = model.blocks.corner.col(model.contacts[i].corner);
    LawState& state = model.law_states[i];
    const double depth = at - std::abs(p.x() - p.y() - 2.0);
    if (depth <= 0.0)
      continue;
    state.failed = true, state.bonded = depth < 0.5 * at && p.y() > 3.0;
    state.slip = -1e-3 * depth * (1.0 + 0.3 * p.y());
    state.offset = 0.1 * std::abs(state.slip);
  }
}

}  // namespace blocks::scenes
