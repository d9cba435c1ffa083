// An exact judge of split_outline by brute force, on rationals and whole numbers of
// boost. It shares nothing with split.cpp, with the certificate or with CGAL.
#pragma once

#include <string>

#include "geometry/split.hpp"

namespace blocks::validation {

/// The answer of judge_split if a piece is smaller than the least area.
inline constexpr const char* piece_too_small = "a piece is too small";

/// Judges a result by the rules of geometry/split.hpp: the chord, its ends, the fault,
/// and the pieces with all their fields. Returns what is wrong, or an empty string.
/// outline: simple and clockwise, finite.
std::string judge_split(const geometry::Polygon& outline,
                        const geometry::SplitLine& line, double min_area,
                        const geometry::Split& split);

}  // namespace blocks::validation
