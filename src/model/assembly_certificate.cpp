#include "model/assembly_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace blocks {
namespace {

/// What rounding of corners alone can make of an overlap, [L^2].
double rounding_area(const geometry::Polygon& p, const geometry::Polygon& q) {
  double largest = 0.0;
  const auto outline_length = [&](const geometry::Polygon& outline) {
    double length = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      largest = std::max(largest, outline[i].cwiseAbs().maxCoeff());
      length += (outline[(i + 1) % outline.size()] - outline[i]).norm();
    }
    return length;
  };
  const double length = std::min(outline_length(p), outline_length(q));
  const double unit =
      std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
  // a square of this outline is `length / 4` wide
  return (rounding_units * unit + rounding_part * 0.25 * length) * length;
}

}  // namespace

AssemblyCertificate certify_assembly(const Blocks& blocks, int first_new) {
  AssemblyCertificate certificate;
  certificate.blocks = blocks.size();
  std::vector<geometry::Polygon> outlines;
  outlines.reserve(static_cast<std::size_t>(blocks.size()));
  for (int b = 0; b < blocks.size(); ++b)
    outlines.push_back(blocks.outline(b));
  for (const auto& pair : geometry::overlapping_pairs(outlines, blocks.layer)) {
    if (pair.second < first_new)
      continue;
    const double part =
        pair.area / std::min(blocks.area[pair.first], blocks.area[pair.second]);
    if (pair.area > rounding_area(outlines[pair.first], outlines[pair.second])) {
      certificate.overlaps.push_back(pair);
    } else {
      certificate.roundings.push_back(pair);
      certificate.largest_rounding = std::max(certificate.largest_rounding, part);
    }
  }
  return certificate;
}

std::string verdict(const AssemblyCertificate& certificate) {
  std::string text;
  if (certificate.holds()) {
    text = fmt::format("no two of {} blocks overlap{}", certificate.blocks,
                       certificate.roundings.empty() ? "" : " beyond rounding");
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
  if (!certificate.roundings.empty())
    text += fmt::format("; {} pair{} by the rounding of corners, the largest by {:.2g} "
                        "of the smaller block",
                        certificate.roundings.size(),
                        certificate.roundings.size() == 1 ? "" : "s",
                        certificate.largest_rounding);
  return text;
}

}  // namespace blocks
