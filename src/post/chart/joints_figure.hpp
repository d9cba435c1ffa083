// The figure of `blocks plot --joints`: a rose of joint directions, and histograms of
// the blocks between the joints.
#pragma once

#include <string>

#include "post/figure/figure.hpp"

namespace blocks::post {

/// Draws the figure of one frame to a PNG, SVG or PDF file, depending on the extension.
/// Of the options it uses page, title, subtitle and units. Throws std::runtime_error if
/// no side has a joint id, the page is too small or the extension is unknown, and
/// files::FileError if the file cannot be written.
void draw_joints_figure(const std::string& path, const Frame& frame,
                        const std::string& title, const FigureOptions& options);

}  // namespace blocks::post
