#include "post/page/view_water.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blocks::post {

void ViewWater::add_frame(const Frame& now, const ViewShapes& shapes) {
  auto& frame = frames_.emplace_back();
  int before = -1, number = 0;
  for (const WetSide& side : now.wet_sides) {
    if (now.fixed[static_cast<std::size_t>(side.block)] != 0)
      continue;  // as in sides.cpp
    const int corner = shapes.corner_index(side.block + 1, side.side + 1);
    number = corner == before ? number + 1 : 0;
    before = corner;
    const auto [found, is_new] = parts_.try_emplace(
        std::pair(corner, number), static_cast<std::uint32_t>(parts_.size()));
    frame.push_back({found->second,
                     side.share,
                     {four_digits(side.pressure[0]), four_digits(side.pressure[1])}});
  }
  lines_.push_back(now.water_line);
}

void ViewWater::store(ViewStore& store) const {
  std::vector<std::uint32_t> corners(parts_.size());
  for (const auto& [place, part] : parts_)
    corners[part] = static_cast<std::uint32_t>(place.first);
  DigitColumn shares{2 * parts_.size(), {}, {}}, pressures = shares;
  for (const auto& frame : frames_) {
    std::vector<double> at(shares.rows, 0.0),
        values(shares.rows, std::numeric_limits<double>::quiet_NaN());
    for (const Pressed& pressed : frame)
      for (std::size_t end = 0; end < 2; ++end) {
        at[2 * pressed.part + end] = pressed.share[static_cast<Eigen::Index>(end)];
        values[2 * pressed.part + end] = pressed.value[end];
      }
    for (std::size_t row = 0; row < shares.rows; ++row) {
      shares.add(at[row]);
      pressures.add(values[row]);
    }
  }
  store.add("water_side", "u32", corners);
  store.add_digits("water_part", shares);
  store.add_digits("water_pressure", pressures);
}

nlohmann::ordered_json ViewWater::lines() const {
  if (std::all_of(lines_.begin(), lines_.end(),
                  [](const auto& line) { return line.empty(); }))
    return {};
  auto json = nlohmann::ordered_json::array();
  for (const auto& line : lines_) {
    auto flat = nlohmann::ordered_json::array();
    for (const Eigen::Vector2d& at : line)
      flat.insert(flat.end(), {at.x(), at.y()});
    json.push_back(std::move(flat));
  }
  return json;
}

}  // namespace blocks::post
