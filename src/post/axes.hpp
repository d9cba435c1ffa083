// Where a figure's parts stand on the page, and the way from model to page.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace blocks::post {

/// Equal scales on both axes; the page is 1200 wide and its y runs downwards.
struct Axes {
  double xmin, xmax, ymin, ymax;    ///< [L] shown
  double left, top, width, height;  ///< of the plot on the page

  /// Shows at least xmin, xmax, ymin, ymax [L]; a flat or tall model still gets a plot
  /// one can look at.
  Axes(const Eigen::Vector4d& shown, double left, double top, double width);

  double scale() const { return width / (xmax - xmin); }
  double x(double model_x) const { return left + (model_x - xmin) * scale(); }
  double y(double model_y) const { return top + (ymax - model_y) * scale(); }
  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

/// Round numbers between lower and upper, about `count` of them; none where doubles are
/// too coarse for them.
std::vector<double> nice_ticks(double lower, double upper, int count);

/// Ticks with short labels that tell them apart.
struct TickLabels {
  std::vector<double> ticks;
  std::vector<std::string> labels;
  std::string offset;  ///< "+1000000000": to be added to every label; empty for none
  int power = 0;       ///< labels count powers of ten: a multiple of three

  /// The axis' name with that power: "kinetic energy [10⁶ J/m]", "contacts [10³]".
  std::string titled(const std::string& name) const;
};

/// About `count` ticks. What all of them share is taken off into the offset where the
/// labels would need more than five digits otherwise; without an offset, labels from
/// 100,000 or below a thousandth count powers of ten.
TickLabels label_ticks(double lower, double upper, int count);

}  // namespace blocks::post
