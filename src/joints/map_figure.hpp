// The figure of `blocks joints statistics`: for each map a rose of its families, the
// triangle of its nodes, and histograms of lengths.
#pragma once

#include <string>
#include <vector>

#include "draw/page_size.hpp"
#include "joints/statistics.hpp"

namespace blocks::joints {

/// Draws the maps one below the other to a PNG, SVG or PDF file, depending on the
/// extension. Throws std::runtime_error if the page is too small or the extension is
/// unknown, and files::FileError if the file cannot be written.
void draw_map_figure(const std::string& path, const std::vector<MapStatistics>& maps,
                     const draw::PageSize& page);

}  // namespace blocks::joints
