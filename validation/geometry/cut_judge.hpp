// An independent judge of cut domains. It computes with whole numbers and rationals of
// boost, and uses no predicate of the library.
#pragma once

#include <string>

#include "geometry/cut.hpp"

namespace blocks::validation {

/// Returns what is wrong with a result, or an empty string. It tests that the cells
/// tile their outline corner to corner (exact_judge), that this outline has all corners
/// of the request, that each block is a part of its cell, and that each side with a
/// joint id is on a joint with this id. The last test is left out if cleaning has moved
/// vertices.
std::string judge_cut(const geometry::CutRequest& request,
                      const geometry::CutResult& result);

}  // namespace blocks::validation
