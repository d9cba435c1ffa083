#include "model/assembly_certificate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "geometry/block_shape.hpp"
#include "geometry/rounding.hpp"
#include "text/counted.hpp"

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

std::string at(const Vec2& place) {
  return fmt::format("({:.12g}, {:.12g})", place.x(), place.y());
}

/// Returns one line for each of the first items, and the number of further ones.
template <typename List, typename Line>
std::string named(const std::string& title, const List& list, std::size_t count,
                  Line line) {
  if (count == 0)
    return {};
  std::string text = "\n  " + title + "\n";
  for (std::size_t i = 0; i < std::min(count, max_pairs_named); ++i)
    text += "    " + line(list[i]) + "\n";
  if (count > max_pairs_named)
    text += fmt::format("    and {} more\n", count - max_pairs_named);
  text.pop_back();
  return text;
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

std::string verdict(const AssemblyCertificate& certificate) {
  std::string text;
  const int present = certificate.blocks - certificate.removed;
  if (present == 1) {
    text = "1 block, so none overlap";
  } else if (certificate.holds()) {
    text = fmt::format("no two of {} blocks overlap{}", present,
                       certificate.roundings.empty() ? "" : " beyond rounding");
  } else {
    const auto worst =
        std::max_element(certificate.overlaps.begin(), certificate.overlaps.end(),
                         [](const auto& a, const auto& b) { return a.area < b.area; });
    text = fmt::format("{} of {} blocks overlap{}, most of all {} and {} by an area "
                       "of {}",
                       counted(certificate.overlaps.size(), "pair"), present,
                       certificate.overlaps.size() == 1 ? "s" : "", worst->first + 1,
                       worst->second + 1, geometry::positive_text(worst->area, 3));
  }
  if (!certificate.roundings.empty())
    text += fmt::format("; {} by the rounding of corners, the largest by {} of the "
                        "smaller block",
                        counted(certificate.roundings.size(), "pair"),
                        geometry::positive_text(certificate.largest_rounding, 2));
  if (certificate.moved > 0) {
    text += certificate.moved == certificate.blocks
                ? "; all blocks have moved"
                : fmt::format("; blocks 1 to {} have moved", certificate.moved);
    text += certificate.contacts.empty()
                ? std::string(", none overlap in contact")
                : ", overlaps between them are contacts: " +
                      counted(certificate.contacts.size(), "pair");
  }
  return text;
}

std::string joints_line(const AssemblyCertificate& certificate) {
  const std::vector<geometry::Slit>& slits = certificate.joints.slits;
  if (certificate.moved == certificate.blocks)
    return "gaps: not searched between blocks that have moved";
  std::string text = "no gaps";
  if (certificate.gaps() > 0)
    text = fmt::format("{}, the widest {:.3g} between blocks {} and {} at {}",
                       counted(certificate.gaps(), "gap"), slits.front().width,
                       slits.front().first + 1, slits.front().second + 1,
                       at(slits.front().place));
  if (certificate.rounding_slits > 0)
    text += fmt::format("; {} made by rounding, the widest {:.2g}",
                        counted(certificate.rounding_slits, "slit"),
                        slits[certificate.gaps()].width);
  return text + "; " + counted(certificate.t_junctions, "T-junction");
}

std::string full_text(const AssemblyCertificate& certificate) {
  const auto pair_line = [](const geometry::BlockOverlap& pair) {
    return fmt::format("blocks {} and {}: area {} near {}", pair.first + 1,
                       pair.second + 1, geometry::positive_text(pair.area, 6),
                       at(pair.place));
  };
  return verdict(certificate) + "\n  " + joints_line(certificate) +
         named("overlaps", certificate.overlaps, certificate.overlaps.size(),
               pair_line) +
         named("overlaps by the rounding of corners", certificate.roundings,
               certificate.roundings.size(), pair_line) +
         named("overlaps of blocks that have moved: contacts", certificate.contacts,
               certificate.contacts.size(), pair_line) +
         named("gaps, the widest first", certificate.joints.slits, certificate.gaps(),
               [](const geometry::Slit& slit) {
                 return fmt::format("blocks {} and {}: width {:.6g} at {}",
                                    slit.first + 1, slit.second + 1, slit.width,
                                    at(slit.place));
               });
}

}  // namespace blocks
