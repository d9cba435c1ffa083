// The size of a figure on the screen or in print.
#pragma once

#include <string>

namespace blocks::draw {

/// The size of a page in units of its layout, in which usual text is 14 high.
struct PageSize {
  double width = 1200;
  double height = 0;        ///< 0: as high as the content needs
  double unit = 1;          ///< length of a unit: pixels or points (PNG, SVG, PDF)
  bool printed = false;     ///< a unit is a number of points, in a PNG too
  double min_text = 0;      ///< smallest letters
  double max_text = 10000;  ///< largest letters

  /// Returns a page whose text grows with its width [pixels or points].
  static PageSize on_screen(double width);

  /// Reads "85mm", "3.5in", "85mmx60mm", "single" or "double". The text of such a page
  /// has 7 to 9 points, whatever the width. Throws std::runtime_error for another text.
  static PageSize in_print(const std::string& text);

  /// Returns the description of the option --size.
  static const char* help();

  /// Returns the resolution of a PNG [dots per inch]; 0 if a unit is in pixels.
  double resolution() const { return printed ? 300.0 : 0.0; }
};

}  // namespace blocks::draw
