#include "post/export/cracks_table.hpp"

#include <utility>

namespace blocks::post {

NumberTable cracks_table(const std::vector<Crack>& cracks,
                         const std::optional<Units>& units, bool all) {
  constexpr Dimension pure{}, time{0, 0, 1, "s", ""}, length{1, 0, 0, "m", ""},
      area{2, 0, 0, "m²", ""}, stress{-1, 1, -2, "Pa", ""}, energy{1, 1, -2, "J/m", ""},
      angle{0, 0, 0, "", "degrees"};
  NumberTable table;
  const auto add = [&](const char* name, const char* label, const Dimension& dimension,
                       auto value) {
    NumberColumn column{name, label, unit_text(dimension, units), {}};
    for (const Crack& crack : cracks)
      column.values.push_back(static_cast<double>(value(crack)));
    table.columns.push_back(std::move(column));
  };
  using C = const Crack&;
  add("step", "step", pure, [](C c) { return c.step; });
  add("time", "time", time, [](C c) { return c.time; });
  add("parent", "block that split", pure, [](C c) { return c.parent; });
  add("child", "new block", pure, [](C c) { return c.child; });
  NumberColumn cause{"cause", "cause", "", {}};
  for (const Crack& crack : cracks)
    cause.words.emplace_back(crack.cause());
  table.columns.push_back(std::move(cause));
  add("stress", "tension that reached the strength", stress,
      [](C c) { return c.stress; });
  add("angle", "direction of the cut, anticlockwise from x", angle,
      [](C c) { return c.angle(); });
  add("length", "length of the cut", length, [](C c) { return c.length(); });
  if (all) {
    add("from_x", "first end of the cut, x", length, [](C c) { return c.from.x(); });
    add("from_y", "first end of the cut, y", length, [](C c) { return c.from.y(); });
    add("to_x", "other end of the cut, x", length, [](C c) { return c.to.x(); });
    add("to_y", "other end of the cut, y", length, [](C c) { return c.to.y(); });
    add("moved", "distance from a crossing to its corner", length,
        [](C c) { return c.moved; });
  }
  add("parent_area", "area of the piece that keeps the number", area,
      [](C c) { return c.parent_area; });
  add("child_area", "area of the new block", area, [](C c) { return c.child_area; });
  if (all) {
    add("kinetic_before", "kinetic energy of the block", energy,
        [](C c) { return c.kinetic_before; });
    add("kinetic_after", "kinetic energy of both pieces", energy,
        [](C c) { return c.kinetic_after; });
    add("strain_before", "strain energy of the block", energy,
        [](C c) { return c.strain_before; });
    add("strain_after", "strain energy of both pieces", energy,
        [](C c) { return c.strain_after; });
  }
  add("released", "energy released", energy, [](C c) { return c.released(); });
  return table;
}

}  // namespace blocks::post
