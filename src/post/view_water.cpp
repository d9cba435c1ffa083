#include "post/view_water.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blocks::post {

void ViewWater::add_frame(const Frame& now, const ViewShapes& shapes) {
  auto& frame = frames_.emplace_back();
  for (std::size_t b = 0; b < now.water.size(); ++b) {
    if (now.fixed[b] != 0)
      continue;  // as in face_sides.cpp
    for (std::size_t k = 0; k < now.water[b].size(); ++k) {
      const Eigen::Vector2d& pressures = now.water[b][k];
      if (!pressures.any())
        continue;
      const int corner =
          shapes.corner_index(static_cast<int>(b) + 1, static_cast<int>(k) + 1);
      const auto [found, is_new] =
          sides_.try_emplace(corner, static_cast<std::uint32_t>(sides_.size()));
      frame.push_back(
          {found->second, four_digits(pressures[0]), four_digits(pressures[1])});
    }
  }
  lines_.push_back(now.water_line);
}

void ViewWater::store(ViewStore& store) const {
  std::vector<std::uint32_t> corners(sides_.size());
  for (const auto& [corner, side] : sides_)
    corners[side] = static_cast<std::uint32_t>(corner);
  DigitColumn column{2 * sides_.size(), {}, {}};
  for (const auto& frame : frames_) {
    std::vector<double> values(column.rows, std::numeric_limits<double>::quiet_NaN());
    for (const Pressed& pressed : frame) {
      values[2 * pressed.side] = pressed.first;
      values[2 * pressed.side + 1] = pressed.second;
    }
    for (const double value : values)
      column.add(value);
  }
  store.add("water_side", "u32", corners);
  store.add_digits("water_pressure", column);
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
