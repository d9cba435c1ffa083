#include "scene_table.hpp"

#include <fmt/format.h>

#include "compare_codes.hpp"

namespace blocks::bench {
namespace {

std::string ratio_of(const Report& report, const Row& own, const char* code,
                     int threads = 1) {
  const Row* row = report.find(own.scene, own.state, code, threads);
  return row != nullptr ? in_words(row->ratio) : "";
}

}  // namespace

std::string heading_of_scenes() {
  return "\n## Scenes and states\n\n"
         "Nanoseconds of a step of a rigid block on one thread, and of its phases by "
         "a separate profile. Ratios (range) are costs over that one, with two threads "
         "over one thread of the same blocks by the clock.\n\n"
         "| scene | state | blocks, ns | decisions | forces | motion | search | "
         "deformable | two threads | deformable, two threads | linked lists | Box2D |\n"
         "|---|---|---|---|---|---|---|---|---|---|---|---|\n";
}

std::string rows_of_scenes(const Report& report, const std::string& part) {
  std::string text;
  for (const Row& row : report.rows)
    if (row.part == part && row.phases) {
      const Phases& ns = *row.phases;
      text += fmt::format(
          "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", row.scene,
          row.state, short_number(row.cost), short_number(ns.decisions),
          short_number(ns.forces), short_number(ns.motion), short_number(ns.search),
          ratio_of(report, row, deformable_blocks),
          ratio_of(report, row, rigid_blocks, 2),
          ratio_of(report, row, deformable_blocks, 2),
          ratio_of(report, row, linked_lists), ratio_of(report, row, box2d_name));
    }
  return text;
}

}  // namespace blocks::bench
