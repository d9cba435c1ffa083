// The physical size of a PNG image.
#pragma once

#include <string>

namespace blocks::draw {

/// Returns a PNG file with its resolution [dots per inch], so that programs show it in
/// its physical size.
std::string with_resolution(std::string image, double resolution);

}  // namespace blocks::draw
