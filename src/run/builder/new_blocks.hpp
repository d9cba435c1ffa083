// What the cards that make blocks have in common: CREATE, READ9, LAYER and CUT. The
// limits of START are not tested if it is missing.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/polygon.hpp"
#include "run/builder/context.hpp"

namespace blocks::run {

/// The density of a defined material. If it is undefined, reports an error at `where`
/// and returns 0.
double density(const Context& context, long material, deck::SourceLocation where);

/// Whether `more` blocks still fit under START's maximum. Reports an error at `where`
/// if not.
bool have_space(const Context& context, long more, deck::SourceLocation where);

/// Whether START allows a block with so many corners. Reports an error if not. `what`
/// names the block in messages, here and below.
bool may_have_corners(const Context& context, std::size_t corners,
                      const std::string& what);

/// Whether area and second moment are finite and positive. Reports an error if not.
/// hint_if_thin: what to do if the block is not small, but thin.
bool has_weight(const Context& context, const geometry::Polygon& clockwise,
                const std::string& what,
                const std::string& hint_if_thin = "move its sides apart");

/// Checks an outline exactly and makes it clockwise. Each side keeps its joint id in
/// `joints`, which may be null. `warned` is set once a warning was given, which is then
/// not repeated. Returns false after an error.
bool accept(const Context& context, geometry::Polygon& outline, const std::string& what,
            bool& warned, std::vector<int>* joints = nullptr);

void append(const Context& context, const std::vector<NewBlock>& blocks);

/// Returns the nearest doubles of a corner, moved to the side of another outline of
/// this section of the deck if it lies on one.
Vec2 place_corner(const Context& context, const Vec2& nearest);

}  // namespace blocks::run
