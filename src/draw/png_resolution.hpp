// The physical size of a PNG file.
#pragma once

#include <string>

namespace blocks::draw {

/// Stores the resolution [dots per inch] in a PNG file, so that programs show it in its
/// physical size. Throws std::runtime_error if the file cannot be rewritten.
void set_png_resolution(const std::string& path, double resolution);

}  // namespace blocks::draw
