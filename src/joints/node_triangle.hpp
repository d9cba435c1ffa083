// The triangle of nodes I, Y and X (Manzocchi 2002; Sanderson and Nixon 2015).
#pragma once

#include <vector>

#include "draw/chart/histogram.hpp"
#include "draw/pen.hpp"
#include "joints/network.hpp"

namespace blocks::joints {

/// Draws the triangle in the place of a histogram, with lines of equal connections per
/// branch and one point for each network; `own` is the one that is filled. Networks
/// without nodes have no point.
void draw_node_triangle(draw::Pen& pen, const draw::HistogramPlace& place,
                        const std::vector<NodeCounts>& networks, std::size_t own);

}  // namespace blocks::joints
