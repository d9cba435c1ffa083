// A cutter in plain doubles with a tolerance, as such codes are usually written. It is
// measured beside geometry::cut_outline.
#pragma once

#include "geometry/cut.hpp"

namespace blocks::validation {

/// Splits segments in pairs, merges nodes that are closer than the tolerance, removes
/// what dangles, and traces cells by angles. tolerance: in sizes of the domain. Throws
/// std::runtime_error if it does not end or finds no outline.
geometry::Mesh naive_cut(const geometry::CutRequest& request, double tolerance);

}  // namespace blocks::validation
