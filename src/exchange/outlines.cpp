#include "exchange/outlines.hpp"

#include <algorithm>

namespace blocks::exchange {

void reverse(Outline& outline) {
  if (!outline.corners.empty())
    std::reverse(outline.corners.begin() + 1, outline.corners.end());
  if (!outline.written.empty())
    std::reverse(outline.written.begin() + 1, outline.written.end());
  std::reverse(outline.joints.begin(), outline.joints.end());
}

}  // namespace blocks::exchange
