// `blocks plot`: the blocks at one time (heir of DBLOCK, report Appendix E).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "post/colour_map.hpp"
#include "post/marks.hpp"
#include "post/results_reader.hpp"

namespace blocks::post {

struct FigureOptions {
  double width = 1200;                  ///< pixels (PNG) or points (SVG, PDF)
  std::string colour = "material";      ///< or a name of quantity.hpp
  std::optional<Eigen::Vector4d> zoom;  ///< xmin, xmax, ymin, ymax [L]
  bool numbers = false;                 ///< block numbers
  bool original = false;                ///< outlines of the first frame underneath
  bool mirror = false;               ///< the other half of a half model, about mirror_x
  double mirror_x = 0.0;             ///< [L]
  std::vector<Mark> marks;           ///< those drawn last lie on top
  std::vector<MarkName> mark_names;  ///< legend of the marks
  std::string subtitle;              ///< instead of time and step
  std::map<int, Colour> material_colours;  ///< instead of the usual ones
};

/// Draws one frame to a PNG, SVG or PDF file chosen by the ending; the file appears
/// whole or not at all, an older one is kept as .bak. Throws std::runtime_error:
/// unknown ending or quantity, file not writable.
void draw_figure(const std::string& path, const ResultsReader& results, long frame,
                 const FigureOptions& options);

/// The same for frames at hand.
void draw_frame(const std::string& path, const Frame& now, const Frame& first,
                const std::string& title, const FigureOptions& options);

}  // namespace blocks::post
