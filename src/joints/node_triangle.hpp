// The triangle of nodes I, Y and X (Manzocchi 2002; Sanderson and Nixon 2015).
#pragma once

#include <vector>

#include "joints/network.hpp"
#include "post/joint_histograms.hpp"
#include "post/pen.hpp"

namespace blocks::joints {

/// Draws the triangle in the place of a histogram, with lines of equal connections per
/// branch and one point for each network; `own` is the one that is filled. Networks
/// without nodes have no point.
void draw_node_triangle(post::Pen& pen, const post::HistogramPlace& place,
                        const std::vector<NodeCounts>& networks, std::size_t own);

}  // namespace blocks::joints
