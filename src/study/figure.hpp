// Draws a study as a figure that shows how often each variant fails in each scene.
#pragma once

#include <string>
#include <vector>

#include "study/study.hpp"

namespace blocks::study {

/// Draws a panel for each scene, with a line for each variant. Hang-ups and
/// fall-throughs are in per cent of the frames, with confidence intervals; phantom
/// contacts are a pale bar. The ending of `path` selects PNG, SVG or PDF. Throws
/// std::runtime_error.
void draw_studies(const std::string& path, const std::vector<Study>& studies);

}  // namespace blocks::study
