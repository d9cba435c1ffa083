// A page with pictures of one or several times: heading, axes and legend.
#pragma once

#include <vector>

#include "draw/axes.hpp"
#include "draw/pen.hpp"
#include "post/figure/figure_scales.hpp"

namespace blocks::post {

/// The space around the pictures, and the bottoms of the lines above them [units].
struct FigureMargins {
  double left = 84, right = 150, title = 34, subtitle = 62, top = 78, foot = 64;
};

class FigurePage {
 public:
  /// Lays out `count` pictures with these scales. Throws std::runtime_error if the page
  /// is too small for them.
  FigurePage(std::size_t count, std::string title, const FigureScales& scales,
             const FigureOptions& options);

  double height() const { return height_; }  ///< [units]

  /// Draws the page; call it once, before the pictures.
  void begin(draw::Pen& pen) const;
  /// Draws picture i, 0 <= i < count.
  void picture(draw::Pen& pen, std::size_t i, const Picture& picture) const;
  /// Draws the legend; call it once, with the last picture.
  void end(draw::Pen& pen, const Picture& picture) const;

 private:
  /// Chooses the columns and the size of the pictures within the margins.
  void lay_out();
  draw::Axes axes(std::size_t i) const;
  void rulers(draw::Pen& pen, const draw::Axes& axes, bool along_x, bool along_y) const;

  std::size_t count_, columns_ = 1;
  std::string title_;
  const FigureScales& scales_;
  const FigureOptions& options_;
  FigureMargins margins_;
  double numbers_ = 46;                ///< space for those of the y axis [units]
  bool below_;                         ///< the legend is below the pictures
  double width_ = 0.0, height_ = 0.0;  ///< of a plot, of the page
};

}  // namespace blocks::post
