#include "model/words/certificate_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "text/counted.hpp"

namespace blocks {
namespace {

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
