#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exchange/block_record.hpp"
#include "exchange/joint_lines.hpp"
#include "text/escaped.hpp"

namespace blocks::exchange {
namespace {

using geometry::Vec2;

constexpr double margin_mm = 8.0, bar_space_mm = 10.0;
constexpr double page_width_mm = 281.0, page_height_mm = 194.0;  // A4 across

struct Frame {
  Vec2 low = Vec2::Constant(HUGE_VAL), high = -low;
  Vec2 size() const { return high - low; }
};

Frame frame_of(const std::vector<BlockRecord>& blocks) {
  Frame frame;
  for (const BlockRecord& block : blocks)
    for (const Vec2& corner : block.outline) {
      frame.low = frame.low.cwiseMin(corner);
      frame.high = frame.high.cwiseMax(corner);
    }
  return frame;
}

/// The largest of 1, 2, 5, 10, ... at most x.
double round_down(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  return (x >= 5.0 * power ? 5.0 : x >= 2.0 * power ? 2.0 : 1.0) * power;
}
/// The smallest of 1, 2, 5, 10, ... at least x.
double round_up(double x) {
  const double below = round_down(x);
  if (below >= x)
    return below;
  const double power = std::pow(10.0, std::floor(std::log10(below) + 1e-9));
  return below < 1.5 * power   ? 2.0 * power
         : below < 3.0 * power ? 5.0 * power
                               : 10.0 * power;
}

std::string path_of(const geometry::Polygon& outline) {
  std::string path;
  for (const Vec2& corner : outline)
    path += fmt::format("{}{},{}", path.empty() ? "M" : " ", shortest(corner.x()),
                        shortest(corner.y()));
  return path + "Z";
}

}  // namespace

double default_scale(const std::vector<BlockRecord>& blocks, double unit_in_m) {
  const Vec2 size = frame_of(blocks).size();
  const double mm = 1000.0 * unit_in_m;
  return round_up(
      std::max(size.x() * mm / (page_width_mm - 2.0 * margin_mm),
               size.y() * mm / (page_height_mm - 2.0 * margin_mm - bar_space_mm)));
}

std::string write_svg(const std::vector<BlockRecord>& blocks, const SvgScale& scale,
                      const std::function<std::string(int)>& joint_colour) {
  const Frame frame = frame_of(blocks);
  const double per_mm = scale.scale / (1000.0 * scale.unit_in_m);  // [L] per mm
  const Vec2 page = frame.size() + Vec2::Constant(2.0 * margin_mm * per_mm) +
                    Vec2(0.0, bar_space_mm * per_mm);
  const double left = frame.low.x() - margin_mm * per_mm;
  const double top = -frame.high.y() - margin_mm * per_mm;  // y points down in SVG
  std::string svg =
      fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.6g}mm\" "
                  "height=\"{:.6g}mm\" viewBox=\"{} {} {} {}\">\n",
                  page.x() / per_mm, page.y() / per_mm, shortest(left), shortest(top),
                  shortest(page.x()), shortest(page.y()));
  svg +=
      fmt::format("<title>{} blocks, 1:{:.9g}</title>\n", blocks.size(), scale.scale);
  svg += fmt::format("<g transform=\"scale(1,-1)\" stroke-linejoin=\"round\" "
                     "stroke-linecap=\"round\" stroke-width=\"{:.4g}\">\n",
                     0.18 * per_mm);
  svg += "<g id=\"blocks\" stroke=\"#444\">\n";
  for (const BlockRecord& block : blocks)
    svg += fmt::format("<path id=\"block-{}\" class=\"material-{}\" fill=\"{}\" "
                       "d=\"{}\"/>\n",
                       block.number, block.material,
                       block.fixed ? "#c9c9cf" : "#eeece6", path_of(block.outline));
  svg += "</g>\n";
  for (const auto& [id, lines] : joint_lines(blocks)) {
    svg += fmt::format("<path id=\"joint-{}\" fill=\"none\" stroke=\"{}\" "
                       "stroke-width=\"{:.4g}\" d=\"",
                       id, joint_colour(id), 0.35 * per_mm);
    for (const JointLine& line : lines)
      svg +=
          fmt::format("M{},{} {},{}", shortest(line.from.x()), shortest(line.from.y()),
                      shortest(line.to.x()), shortest(line.to.y()));
    svg += "\"/>\n";
  }
  svg += "</g>\n";
  const double bar = round_down(std::max(frame.size().x() / 3.0, 20.0 * per_mm));
  const double x = frame.low.x(), y = -frame.low.y() + 5.0 * per_mm;
  svg += fmt::format(
      "<g id=\"scale\"><path fill=\"none\" stroke=\"#222\" stroke-width=\"{0:.4g}\" "
      "d=\"M{1},{2}v{3:.6g}h{4:.9g}v-{3:.6g}\"/>",
      0.35 * per_mm, shortest(x), shortest(y), 1.5 * per_mm, bar);
  svg += fmt::format("<text x=\"{:.9g}\" y=\"{:.9g}\" font-family=\"DejaVu Sans, "
                     "sans-serif\" font-size=\"{:.4g}\" fill=\"#222\">{:.9g}{} "
                     "&#160; 1:{:.9g}</text></g>\n</svg>\n",
                     x + bar + 2.0 * per_mm, y + 2.0 * per_mm, 3.2 * per_mm, bar,
                     scale.unit.empty() ? "" : " " + text::escaped(scale.unit),
                     scale.scale);
  return svg;
}

}  // namespace blocks::exchange
