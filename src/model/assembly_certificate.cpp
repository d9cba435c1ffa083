#include "model/assembly_certificate.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "geometry/block_shape.hpp"
#include "geometry/rounding.hpp"

namespace blocks {
namespace {

/// Finds joints, except those between two moved blocks, which the deck did not make.
void find_joints(const std::vector<geometry::Polygon>& outlines,
                 AssemblyCertificate& certificate, geometry::StepProgress progress) {
  if (certificate.moved == certificate.blocks)
    return;
  auto& [t_junctions, slits] = certificate.joints =
      geometry::find_joints(outlines, &progress);
  const int moved = certificate.moved;
  std::erase_if(t_junctions, [moved](const geometry::TJunction& junction) {
    return std::max(junction.block, junction.other) < moved;
  });
  std::erase_if(slits, [moved](const geometry::Slit& s) { return s.second < moved; });
  std::stable_sort(slits.begin(), slits.end(), [](const auto& a, const auto& b) {
    return a.by_rounding != b.by_rounding ? b.by_rounding : a.width > b.width;
  });
  certificate.t_junctions = t_junctions.size();
  certificate.rounding_slits = static_cast<std::size_t>(
      std::count_if(slits.begin(), slits.end(),
                    [](const geometry::Slit& s) { return s.by_rounding; }));
}

}  // namespace

AssemblyCertificate certify_assembly(const Blocks& blocks, int moved,
                                     const AssemblyCertificate& before,
                                     const geometry::ProgressFunction& progress) {
  AssemblyCertificate certificate;
  certificate.blocks = blocks.size();
  certificate.moved = moved;
  certificate.removed = blocks.size() - blocks.count_present();
  const std::vector<geometry::Polygon> outlines = blocks.present_outlines();
  for (const geometry::Polygon& outline : outlines)
    certificate.ulp = std::max(certificate.ulp, geometry::coarsest_ulp(outline));
  std::set<std::pair<int, int>> at_fault;
  for (const auto& pair : before.overlaps)
    at_fault.emplace(pair.first, pair.second);
  // Blocks of one layer are disjoint only until they move.
  const std::vector<int> apart = moved > 0 ? std::vector<int>{} : blocks.layer;
  geometry::StepProgress comparing(progress, "compare blocks", 0.0, 0.5);
  for (const auto& pair : geometry::overlapping_pairs(
           outlines, apart, geometry::Figures::exact, &comparing)) {
    if (pair.second < moved && !at_fault.contains({pair.first, pair.second})) {
      certificate.contacts.push_back(pair);
      continue;
    }
    const double part =
        pair.area / std::min(blocks.area[pair.first], blocks.area[pair.second]);
    if (pair.area >
        geometry::rounding_area(outlines[pair.first], outlines[pair.second])) {
      certificate.overlaps.push_back(pair);
    } else {
      certificate.roundings.push_back(pair);
      certificate.largest_rounding = std::max(certificate.largest_rounding, part);
    }
  }
  find_joints(outlines, certificate,
              geometry::StepProgress(progress, "find gaps between blocks", 0.5, 1.0));
  return certificate;
}

}  // namespace blocks
