// Says in words why MERGE absorbed a block.
#include <fmt/format.h>

#include "model/model.hpp"

namespace blocks {

std::string MergeRecord::why() const {
  if (!(width_to_height < limit))
    return fmt::format("just below {:g}, by less than doubles resolve", limit);
  for (int digits = 6; digits < 17; ++digits) {
    const std::string ratio = fmt::format("{:.{}g}", width_to_height, digits);
    const std::string min = fmt::format("{:.{}g}", limit, digits);
    if (ratio != min)
      return ratio + " < " + min;
  }
  return fmt::format("{:.17g} < {:.17g}", width_to_height, limit);
}

}  // namespace blocks
