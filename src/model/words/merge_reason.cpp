#include "model/words/merge_reason.hpp"

#include <fmt/format.h>

namespace blocks {

std::string merge_reason(const MergeRecord& merge) {
  if (!(merge.width_to_height < merge.limit))
    return fmt::format("just below {:g}, by less than doubles resolve", merge.limit);
  for (int digits = 6; digits < 17; ++digits) {
    const std::string ratio = fmt::format("{:.{}g}", merge.width_to_height, digits);
    const std::string min = fmt::format("{:.{}g}", merge.limit, digits);
    if (ratio != min)
      return ratio + " < " + min;
  }
  return fmt::format("{:.17g} < {:.17g}", merge.width_to_height, merge.limit);
}

}  // namespace blocks
