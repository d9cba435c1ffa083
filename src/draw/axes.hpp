// The layout of a figure on the page, and the map from the model to the page.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace blocks::draw {

/// Axes with equal scales; the page is 1200 wide and its y axis points down.
struct Axes {
  double xmin, xmax, ymin, ymax;    ///< [L] shown
  double left, top, width, height;  ///< of the plot on the page

  /// Shows at least xmin, xmax, ymin, ymax [L]. The shape of the plot is limited, so
  /// that a flat or tall model remains readable.
  Axes(const Eigen::Vector4d& shown, double left, double top, double width);

  double scale() const { return width / (xmax - xmin); }
  double x(double model_x) const { return left + (model_x - xmin) * scale(); }
  double y(double model_y) const { return top + (ymax - model_y) * scale(); }
  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

/// Returns about `count` round numbers between lower and upper; none if doubles are too
/// coarse for them.
std::vector<double> nice_ticks(double lower, double upper, int count);

/// Ticks with short labels that all differ.
struct TickLabels {
  std::vector<double> ticks;
  std::vector<std::string> labels;
  std::string offset;  ///< "+1000000000": to be added to every label; empty for none
  int power = 0;       ///< labels are in units of 10^power; a multiple of three

  /// Returns the name of the axis with that power: "kinetic energy [10⁶ J/m]",
  /// "contacts [10³]".
  std::string titled(const std::string& name) const;
  /// Returns the name of the axis with the power or the offset: "x − 350000 [m]".
  std::string axis_title(const std::string& name) const;
};

/// Whether an offset is subtracted from the labels of an axis.
enum class Offset {
  of_long_labels,    ///< if they would need more than five digits
  of_large_numbers,  ///< also if they are from 10,000 and near each other
};

/// Returns about `count` ticks. A common offset is subtracted from the labels as
/// `offset` says. Without an offset, labels are in powers of ten if the values are from
/// 100,000 or below a thousandth, or if that makes labels of more than four characters
/// shorter.
TickLabels label_ticks(double lower, double upper, int count,
                       Offset offset = Offset::of_long_labels);

}  // namespace blocks::draw
