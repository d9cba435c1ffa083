// The geometry report for a terminal.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/words/certificate_text.hpp"
#include "model/words/cut_report.hpp"
#include "model/words/merge_reason.hpp"
#include "run/reports/geometry_report.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

constexpr std::size_t max_listed = 10;

/// A bar drawn in eighths of a character, at most `full` characters long.
std::string bar(long count, long largest, int full) {
  static const char* const eighths[] = {"", "▏", "▎", "▍", "▌", "▋", "▊", "▉"};
  const long parts = std::max(count > 0 ? 1L : 0L, count * full * 8 / largest);
  std::string text;
  for (long i = 0; i < parts / 8; ++i)
    text += "█";
  return text + eighths[parts % 8];
}

std::string at(const Vec2& place) {
  return fmt::format("({:.6g}, {:.6g})", place.x(), place.y());
}

std::string row(const char* name, const Measure& m) {
  return fmt::format("  {:<22}{:>13.6g}{:>13.6g}{:>13.6g}\n", name, m.smallest,
                     m.median, m.largest);
}

std::string histogram(const char* name, const Measure& m) {
  std::string text = fmt::format("\n{}\n", name);
  const long largest = *std::max_element(m.counts.begin(), m.counts.end());
  for (std::size_t i = 0; i < m.counts.size(); ++i)
    text += fmt::format("  {:>10.4g} to {:<10.4g} {:>8}  {}\n", m.edges[i],
                        m.edges[i + 1], m.counts[i], bar(m.counts[i], largest, 36));
  return text;
}

std::string sides(const GeometryReport& report) {
  if (report.sides.empty())
    return {};
  std::string text = "\nSides of blocks\n";
  long largest = 0;
  for (const auto& [sides, blocks] : report.sides)
    largest = std::max(largest, blocks);
  for (const auto& [sides, blocks] : report.sides)
    text += fmt::format("  {:>10}{:<14} {:>8}  {}\n", sides, "", blocks,
                        bar(blocks, largest, 36));
  return text;
}

/// `where` is "side" or "corner", or empty for a measure of the whole block.
std::string worst(const char* name, const Measure& m, const std::string& where) {
  if (m.worst.empty())
    return {};
  std::string text = fmt::format("\n{}\n", name);
  for (const auto& place : m.worst)
    text += fmt::format("  {:>12.6g}  block {}{} at {}\n", place.value, place.block + 1,
                        where.empty() ? where
                                      : fmt::format(", {} {}", where, place.corner + 1),
                        at(place.at));
  return text;
}

template <typename List, typename Line>
std::string first_of(const List& list, Line line) {
  std::string text;
  for (std::size_t i = 0; i < std::min(list.size(), max_listed); ++i)
    text += "  " + line(list[i]) + "\n";
  if (list.size() > max_listed)
    text += fmt::format("  and {} more\n", list.size() - max_listed);
  return text;
}

/// Returns the lines with two more blanks before all but the first.
std::string indented(std::string lines) {
  for (std::size_t at = 0; (at = lines.find('\n', at)) + 1 < lines.size(); at += 3)
    lines.insert(at + 1, "  ");
  return lines;
}

std::string layers(const GeometryReport& report) {
  std::string text;
  for (const LayerRecord& layer : report.layers) {
    text += fmt::format(
        "  layer {}: blocks {} to {} tile it: {} cells, {} shared and {} "
        "outline sides",
        layer.number, layer.first_block + 1, layer.first_block + layer.blocks,
        layer.cells, layer.interior_edges, layer.outline_edges);
    if (layer.redrawn > 0 || layer.ruled > 0)
      text += fmt::format("; ORIENT: {} angles of {} sides redrawn, {} sides ruled",
                          layer.redrawn, layer.redrawn_sides, layer.ruled);
    text += "\n";
  }
  for (const MergeRecord& merge : report.merges)
    text += fmt::format("  layer {}: MERGE: block {} absorbed by {} (counted within "
                        "the layer before MERGE), width/height {}\n",
                        merge.layer, merge.absorbed, merge.into, merge_reason(merge));
  for (const CutRecord& cut : report.cuts)
    text += "  " + indented(cut_report(cut, report.joint_lengths));
  return text;
}

std::string joints(const GeometryReport& report) {
  const auto& found = report.certificate.joints;
  std::string text =
      fmt::format("  {}: a corner inside a side of another block (legal)\n",
                  counted(found.t_junctions.size(), "T-junction"));
  text += first_of(found.t_junctions, [](const geometry::TJunction& junction) {
    return fmt::format("  corner {} of block {} in a side of block {} at {}",
                       junction.corner + 1, junction.block + 1, junction.other + 1,
                       at(junction.place));
  });
  if (report.certificate.gaps() == 0)
    text +=
        fmt::format("  no gaps up to {:g} of a block's size\n", geometry::widest_slit);
  else
    text += fmt::format("  {} up to {:g} of a block's size, the widest {:.3g}\n",
                        counted(report.certificate.gaps(), "gap"),
                        geometry::widest_slit, found.slits.front().width);
  const std::vector<geometry::Slit> gaps(
      found.slits.begin(),
      found.slits.begin() + static_cast<std::ptrdiff_t>(report.certificate.gaps()));
  text += first_of(gaps, [](const geometry::Slit& slit) {
    return fmt::format("  blocks {} and {}: {:.3g} at {}", slit.first + 1,
                       slit.second + 1, slit.width, at(slit.place));
  });
  if (report.certificate.rounding_slits > 0)
    text += fmt::format("  {} made by rounding, the widest {:.2g}\n",
                        counted(report.certificate.rounding_slits, "slit"),
                        found.slits[report.certificate.gaps()].width);
  return text;
}

std::string resolution(const GeometryReport& report) {
  const double part = report.resolution();
  std::string text = fmt::format(
      "  doubles lie {:.2g} apart at the largest coordinate: {} the shortest side\n",
      report.certificate.ulp,
      std::isfinite(part) ? fmt::format("{:.2g} of", part) : "more than 1e308 times");
  if (!report.resolved())
    text += fmt::format("  warning: above {:g} contacts are poorly resolved; move the "
                        "origin of the deck near the blocks\n",
                        coarsest_resolution);
  return text;
}

}  // namespace

std::string text(const GeometryReport& report) {
  std::string text = fmt::format("{}: {}, {} corners\n", report.file,
                                 counted(report.blocks, "block"), report.corners);
  if (report.blocks == 0)
    return text;
  text += fmt::format("\n  {:<22}{:>13}{:>13}{:>13}\n", "of each block", "smallest",
                      "median", "largest");
  text += row("area", report.area) + row("aspect ratio", report.aspect) +
          row("shortest side", report.edge) + row("smallest angle, deg", report.angle);
  text += histogram("Areas", report.area) + histogram("Aspect ratios", report.aspect) +
          histogram("Shortest sides", report.edge) +
          histogram("Smallest angles, degrees", report.angle) + sides(report);
  text += worst("Most slender blocks", report.aspect, "") +
          worst("Shortest sides", report.edge, "side") +
          worst("Smallest angles, degrees", report.angle, "corner");
  text += "\nCertificate\n" + layers(report);
  text += fmt::format("  {}: {}\n", report.certificate.holds() ? "proved" : "FAILS",
                      verdict(report.certificate));
  const auto pair_text = [](const geometry::BlockOverlap& pair) {
    return fmt::format("  blocks {} and {}: area {} near {}", pair.first + 1,
                       pair.second + 1, geometry::positive_text(pair.area, 6),
                       at(pair.place));
  };
  text += first_of(report.certificate.overlaps, pair_text);
  if (!report.certificate.contacts.empty())
    text += "  in contact after motion:\n" +
            first_of(report.certificate.contacts, pair_text);
  if (!report.certificate.roundings.empty())
    text += "  by the rounding of corners:\n" +
            first_of(report.certificate.roundings, pair_text);
  text += "\nJoints\n" + joints(report);
  text += "\nResolution\n" + resolution(report);
  return text;
}

}  // namespace blocks::run
