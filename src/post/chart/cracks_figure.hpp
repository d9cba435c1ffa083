// The figure of `blocks cracks`: a rose of the directions of cracks, and histograms of
// their lengths and of the blocks that split off.
#pragma once

#include <string>
#include <vector>

#include "post/figure/figure.hpp"
#include "post/read/results_cracks.hpp"

namespace blocks::post {

/// Draws the figure to a PNG, SVG or PDF file, depending on the extension. The rose is
/// weighted by length and tells cracks by stress from those by point loads. Of the
/// options it uses page, title, subtitle and units. Throws std::runtime_error if there
/// is no crack, the page is too small or the extension is unknown, and
/// files::FileError if the file cannot be written.
void draw_cracks_figure(const std::string& path, const std::vector<Crack>& cracks,
                        const std::string& title, const FigureOptions& options);

}  // namespace blocks::post
