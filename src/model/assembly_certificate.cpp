#include "model/assembly_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace blocks {

AssemblyCertificate certify_assembly(const Blocks& blocks, int first_new) {
  AssemblyCertificate certificate;
  certificate.blocks = blocks.size();
  std::vector<geometry::Polygon> outlines;
  outlines.reserve(static_cast<std::size_t>(blocks.size()));
  for (int b = 0; b < blocks.size(); ++b)
    outlines.push_back(blocks.outline(b));
  for (const auto& pair : geometry::overlapping_pairs(outlines)) {
    if (pair.second < first_new)
      continue;
    const double part =
        pair.area / std::min(blocks.area[pair.first], blocks.area[pair.second]);
    if (part > rounding_overlap) {
      certificate.overlaps.push_back(pair);
    } else {
      ++certificate.rounding_pairs;
      certificate.largest_rounding = std::max(certificate.largest_rounding, part);
    }
  }
  return certificate;
}

std::string verdict(const AssemblyCertificate& certificate) {
  std::string text;
  if (certificate.holds()) {
    text = fmt::format("no two of {} blocks overlap", certificate.blocks);
  } else {
    const auto worst =
        std::max_element(certificate.overlaps.begin(), certificate.overlaps.end(),
                         [](const auto& a, const auto& b) { return a.area < b.area; });
    text = fmt::format("{} pair{} of {} blocks overlap{}, most of all {} and {} by an "
                       "area of {:.3g}",
                       certificate.overlaps.size(),
                       certificate.overlaps.size() == 1 ? "" : "s", certificate.blocks,
                       certificate.overlaps.size() == 1 ? "s" : "", worst->first + 1,
                       worst->second + 1, worst->area);
  }
  if (certificate.rounding_pairs > 0)
    text += fmt::format(" ({} pair{} by rounding only, at most {:.2g} of the smaller "
                        "block)",
                        certificate.rounding_pairs,
                        certificate.rounding_pairs == 1 ? "" : "s",
                        certificate.largest_rounding);
  return text;
}

}  // namespace blocks
