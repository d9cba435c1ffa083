// `blocks plot`: draws the blocks at one or several times (successor of DBLOCK, report
// Appendix E).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "draw/colour_map.hpp"
#include "draw/marks.hpp"
#include "draw/number_text.hpp"
#include "draw/page_size.hpp"
#include "post/read/results_reader.hpp"
#include "post/read/units.hpp"

namespace blocks::post {

/// The value of arrows that have the full length. Longer arrows are drawn at this
/// length.
struct ArrowScale {
  double value = 0.0;      ///< 0: the percentile
  double percent = 100.0;  ///< of the values of a picture that are not 0
};

struct FigureOptions {
  draw::PageSize page;
  /// "material", "family" (pieces by the block from which they come), "joint" (the
  /// sides of blocks by joint id), "bond" (the faces of blocks by the state of their
  /// bond), "opening" or "shear_displacement" (the faces by their motion),
  /// "water_pressure" (the sides that water presses), or a name of quantity.hpp
  std::string colour = "material";
  std::string colour_map;  ///< a name of colour_map.hpp; empty: automatic
  std::optional<Eigen::Vector2d>
      range;  ///< of the colours; empty: that of all values drawn
  std::optional<Eigen::Vector4d> zoom;  ///< xmin, xmax, ymin, ymax [L]
  bool numbers = false;                 ///< block numbers
  bool corners = false;                 ///< corner numbers
  bool original = false;  ///< draw the outlines of the first frame underneath
  bool forces = false;    ///< draw the network of contact forces
  bool cracks = true;     ///< draw the faces of cracks, if there are any
  std::string arrows;     ///< velocity, displacement or force; empty: none
  /// None: the largest value has the full length, and no arrow is shortened.
  std::optional<ArrowScale> arrow_scale;
  bool mirror = false;            ///< also draw the other half, mirrored about mirror_x
  double mirror_x = 0.0;          ///< [L]
  int columns = 0;                ///< of a sheet of several times; 0: automatic
  std::optional<Units> units;     ///< empty: [L], [T]
  std::vector<draw::Mark> marks;  ///< later marks are drawn on top
  std::vector<draw::MarkName> mark_names;  ///< legend of the marks
  std::vector<PlaneLine> planes;           ///< symmetry planes
  std::optional<std::string> title;        ///< empty text: no title; none: of the run
  std::vector<double> requested_times;     ///< of the pictures of a sheet; may be empty
  std::string subtitle;  ///< replaces time and step, or the counts of a sheet
  std::map<int, draw::Colour> material_colours;  ///< replace the default colours
  std::map<int, std::string> material_names;     ///< shown instead of the numbers

  /// Returns a label with its unit: "speed [m/s]", "speed [L T⁻¹]".
  std::string with_unit(const std::string& label, const Dimension& dimension) const {
    return draw::with_unit(label, unit_text(dimension, units));
  }
  bool shows_families() const { return colour == "family"; }
  bool shows_joints() const { return colour == "joint"; }
  bool shows_bonds() const { return colour == "bond"; }
  bool shows_faces() const {
    return colour == "opening" || colour == "shear_displacement" ||
           colour == "water_pressure";
  }
  /// True if the sides of blocks have colours, and blocks those of their materials.
  bool shows_sides() const { return shows_joints() || shows_bonds() || shows_faces(); }
  bool shows_cracks() const { return cracks && !shows_sides(); }
  /// True if the colours of blocks are those of a quantity, not of their materials.
  bool shows_quantity() const {
    return colour != "material" && !shows_sides() && !shows_families();
  }
  /// True if colours show the values of a quantity, of blocks or of faces.
  bool shows_values() const { return shows_quantity() || shows_faces(); }
};

/// Draws frames to a PNG, SVG or PDF file, depending on the extension. Several frames
/// are drawn side by side on one sheet with common scales. The file appears only when
/// it is complete; an older one is kept as .bak. Reads one frame at a time. Throws
/// std::runtime_error if there is no frame, or for an unknown extension, quantity or
/// arrow name. Throws files::FileError if the file cannot be written.
void draw_figure(const std::string& path, const ResultsReader& results,
                 const std::vector<long>& frames, const FigureOptions& options);

/// Returns the same sheet as SVG, or as PNG.
std::string figure_svg(const ResultsReader& results, const std::vector<long>& frames,
                       const FigureOptions& options);
std::string figure_png(const ResultsReader& results, const std::vector<long>& frames,
                       const FigureOptions& options);

/// Draws one frame that is already in memory, without contacts.
void draw_frame(const std::string& path, const Frame& now, const Frame& first,
                const std::string& title, const FigureOptions& options);

}  // namespace blocks::post
