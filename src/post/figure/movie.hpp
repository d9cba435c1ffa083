// Draws frames as a movie with the program ffmpeg, if it is installed.
#pragma once

#include <string>
#include <vector>

#include "post/figure/figure.hpp"

namespace blocks::post {

/// True if the path ends in .mp4 or .gif.
bool is_movie(const std::string& path);

/// Draws the frames with common scales, at `rate` pictures per second (0.1 to 100).
/// Only one frame is in memory at a time. The file appears only when it is complete; an
/// older one is kept as .bak. Throws files::FileError if ffmpeg is missing or fails,
/// and std::runtime_error as draw_figure does.
void draw_movie(const std::string& path, const ResultsReader& results,
                const std::vector<long>& frames, double rate,
                const FigureOptions& options);

}  // namespace blocks::post
