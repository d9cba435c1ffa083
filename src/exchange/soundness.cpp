#include "exchange/soundness.hpp"

#include <algorithm>

#include "geometry/rounding.hpp"

namespace blocks::exchange {

Soundness examine(const std::vector<geometry::Polygon>& outlines) {
  Soundness result;
  std::vector<geometry::Polygon> good;
  std::vector<int> number;  // block numbers of the good outlines
  std::vector<double> area;
  for (int b = 0; b < static_cast<int>(outlines.size()); ++b) {
    const geometry::OutlineCheck check = geometry::check_outline(outlines[b]);
    if (check.fault != geometry::OutlineFault::none) {
      result.bad.push_back({b, check});
      continue;
    }
    if (check.anticlockwise)
      result.turned.push_back(b);
    if (!check.convex)
      result.concave.push_back(b);
    good.push_back(check.anticlockwise ? geometry::reversed(outlines[b]) : outlines[b]);
    area.push_back(geometry::section_properties(good.back()).area);
    number.push_back(b);
  }

  for (geometry::BlockOverlap pair : geometry::overlapping_pairs(good)) {
    const bool rounded =
        pair.area <= geometry::rounding_area(good[pair.first], good[pair.second]);
    pair.first = number[pair.first];
    pair.second = number[pair.second];
    (rounded ? result.roundings : result.overlaps).push_back(pair);
  }
  result.joints = geometry::find_joints(good);
  result.slits_by_rounding = std::erase_if(
      result.joints.slits, [](const geometry::Slit& slit) { return slit.by_rounding; });
  for (geometry::TJunction& junction : result.joints.t_junctions) {
    junction.block = number[junction.block];
    junction.other = number[junction.other];
  }
  for (geometry::Slit& slit : result.joints.slits) {
    slit.first = number[slit.first];
    slit.second = number[slit.second];
  }
  return result;
}

}  // namespace blocks::exchange
