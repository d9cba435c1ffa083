// `blocks plot`: the blocks at one time, coloured by material (heir of DBLOCK).
#pragma once

#include <optional>
#include <string>

#include "post/results_reader.hpp"

namespace blocks::post {

struct FigureOptions {
  double width = 1200;                  ///< pixels (PNG) or points (SVG, PDF)
  std::optional<Eigen::Vector4d> zoom;  ///< xmin, xmax, ymin, ymax [L]
  bool numbers = false;                 ///< block numbers
  bool original = false;                ///< first frame's outline underneath
  bool mirror = false;  ///< mirrored about x = mirror_x beside the model
  double mirror_x = 0.0;
};

/// Draws one frame to a PNG, SVG or PDF file chosen by the ending. Throws
/// std::runtime_error.
void draw_figure(const std::string& path, const ResultsReader& results, long frame,
                 const FigureOptions& options);

}  // namespace blocks::post
