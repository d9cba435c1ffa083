// A scene is stepped by every code that can step it, and timed.
#pragma once

#include "parts.hpp"
#include "report.hpp"
#include "scenes.hpp"

namespace blocks::bench {

/// Rows have these names of codes.
constexpr const char* rigid_blocks = "blocks";
constexpr const char* deformable_blocks = "blocks, deformable";
constexpr const char* linked_lists = "linked lists of 1982";
constexpr const char* box2d_name = "Box2D 2.4.1";

/// Adds a row for each code: the program rigid and deformable, with one and two
/// threads, the linked lists, and Box2D. Notes which code cannot step the scene.
void compare_codes(const Plan& plan, const Scene& scene, Report& report);

}  // namespace blocks::bench
