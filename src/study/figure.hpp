// A study as a figure: for each scene and variant, how often it fails.
#pragma once

#include <string>
#include <vector>

#include "study/study.hpp"

namespace blocks::study {

/// A panel for each scene, a line for each variant: hang-ups and fall-throughs in per
/// cent of the frames with their confidence intervals, phantom contacts as a pale bar.
/// PNG, SVG or PDF by the ending. Throws std::runtime_error.
void draw_studies(const std::string& path, const std::vector<Study>& studies);

}  // namespace blocks::study
