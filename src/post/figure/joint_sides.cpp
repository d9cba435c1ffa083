#include "post/figure/joint_sides.hpp"

#include <algorithm>
#include <utility>

#include "draw/joint_colours.hpp"
#include "post/figure/half.hpp"

namespace blocks::post {

using namespace draw;

namespace {

class JointSides {
 public:
  JointSides(Pen& pen, const Axes& axes, const Frame& frame,
             const std::optional<double>& mirror_x)
      : pen_(pen), cairo_(pen.cairo()), frame_(frame), half_{axes, mirror_x} {}

  /// Draws the sides with this joint id. A path of many lines is slow, so it is
  /// stroked in parts.
  void draw(int id, double width, const Colour& colour) {
    constexpr int most = 64;
    int count = 0;
    for (std::size_t b = 0; b < frame_.outlines.size(); ++b) {
      const auto& outline = frame_.outlines[b];
      for (std::size_t k = 0; k < outline.size(); ++k) {
        if ((frame_.joints.empty() ? 0 : frame_.joints[b][k]) != id)
          continue;
        if (trace(outline[k], outline[(k + 1) % outline.size()]) && ++count % most == 0)
          pen_.stroke(width, colour);
      }
    }
    pen_.stroke(width, colour);
  }

 private:
  /// Adds a side to the path unless it is outside of the plot.
  bool trace(Eigen::Vector2d from, Eigen::Vector2d to) {
    // Two blocks share a side, so its dashes must begin at the same end.
    if (to.x() < from.x() || (to.x() == from.x() && to.y() < from.y()))
      std::swap(from, to);
    return half_.trace(cairo_, from, to);
  }

  Pen& pen_;
  cairo_t* cairo_;
  const Frame& frame_;
  Half half_;
};

}  // namespace

void draw_joint_sides(Pen& pen, const Axes& axes, const Frame& frame,
                      const FigureScales& scales,
                      const std::optional<double>& mirror_x) {
  constexpr double share_of_block = 0.055, thinnest = 0.7, widest = 2.6;
  const double width =
      std::clamp(share_of_block * scales.block_size * axes.scale(), thinnest, widest);
  JointSides sides(pen, axes, frame, mirror_x);
  sides.draw(0, std::min(0.4 * width, 0.8), no_joint_colour);
  for (const int id : scales.joints) {
    set_joint_dashes(pen, id);
    sides.draw(id, width, joint_colour(id));
  }
  pen.dashes({});
}

}  // namespace blocks::post
