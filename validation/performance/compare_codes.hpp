// Times every code that can step a scene.
#pragma once

#include "parts.hpp"
#include "report.hpp"
#include "scenes.hpp"

namespace blocks::bench {

/// The names of codes in the rows.
constexpr const char* rigid_blocks = "blocks";
constexpr const char* deformable_blocks = "blocks, deformable";
constexpr const char* linked_lists = "linked lists of 1982";
constexpr const char* box2d_name = "Box2D 2.4.1";

/// A profile of fewer steps depends on whether it includes a search.
constexpr long min_profiled = 30;

/// Adds a row for each code: the program with rigid and deformable blocks and with one
/// and two threads, the linked lists, and Box2D. Adds a note for each code that cannot
/// step the scene.
void compare_codes(const Plan& plan, const Scene& scene, Report& report);

}  // namespace blocks::bench
