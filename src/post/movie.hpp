// Frames as a movie, through the program ffmpeg where it is installed.
#pragma once

#include <string>
#include <vector>

#include "post/figure.hpp"

namespace blocks::post {

/// Whether the path ends in .mp4 or .gif.
bool is_movie(const std::string& path);

/// Draws the frames one after the other with common scales, `rate` pictures a second
/// (0.1 to 100). Each is drawn once and handed on, so memory is that of one. The file
/// appears whole or not at all, an older one is kept as .bak. Throws
/// output::FileError: no ffmpeg, or it fails; std::runtime_error as draw_figure.
void draw_movie(const std::string& path, const ResultsReader& results,
                const std::vector<long>& frames, double rate,
                const FigureOptions& options);

}  // namespace blocks::post
