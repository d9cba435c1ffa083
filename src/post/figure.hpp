// `blocks plot`: the blocks at one time or several (heir of DBLOCK, report Appendix E).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "post/colour_map.hpp"
#include "post/marks.hpp"
#include "post/results_reader.hpp"
#include "post/units.hpp"

namespace blocks::post {

struct FigureOptions {
  double width = 1200;                   ///< pixels (PNG, movies) or points (SVG, PDF)
  std::string colour = "material";       ///< or a name of quantity.hpp
  std::optional<Eigen::Vector2d> range;  ///< of the colours; else of all values drawn
  std::optional<Eigen::Vector4d> zoom;   ///< xmin, xmax, ymin, ymax [L]
  bool numbers = false;                  ///< block numbers
  bool corners = false;                  ///< corner numbers
  bool original = false;                 ///< outlines of the first frame underneath
  bool forces = false;                   ///< the network of contact forces
  std::string arrows;                ///< velocity, displacement or force; empty: none
  bool mirror = false;               ///< the other half of a half model, about mirror_x
  double mirror_x = 0.0;             ///< [L]
  int columns = 0;                   ///< of a sheet of several times; 0: chosen
  std::optional<Units> units;        ///< else [L], [T]
  std::vector<Mark> marks;           ///< those drawn last lie on top
  std::vector<MarkName> mark_names;  ///< legend of the marks
  std::string subtitle;              ///< instead of time and step
  std::map<int, Colour> material_colours;  ///< instead of the usual ones
};

/// Draws frames to a PNG, SVG or PDF file chosen by the ending, several side by side on
/// one sheet with common scales; the file appears whole or not at all, an older one is
/// kept as .bak. Reads one frame at a time. Throws std::runtime_error: no frame,
/// unknown ending, quantity or arrows; output::FileError: file not writable.
void draw_figure(const std::string& path, const ResultsReader& results,
                 const std::vector<long>& frames, const FigureOptions& options);

/// The same for one frame at hand, without its contacts.
void draw_frame(const std::string& path, const Frame& now, const Frame& first,
                const std::string& title, const FigureOptions& options);

}  // namespace blocks::post
