#include "exchange/ring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace blocks::exchange {
namespace {

/// Returns the nearest double, or nothing if the text is not a number or is beyond the
/// range of doubles.
std::optional<double> value_of(std::string_view text) {
  if (text.starts_with('+'))
    text.remove_prefix(1);
  double value = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

}  // namespace

void RingReader::error(std::size_t at, std::string text, std::string hint,
                       std::size_t length) {
  file_.messages.push_back({true, at, std::move(text), std::move(hint), length});
}

void RingReader::warning(std::size_t at, std::string text, std::string hint) {
  file_.messages.push_back({false, at, std::move(text), std::move(hint)});
}

void RingReader::refuse_holes(std::size_t holes, std::size_t at) {
  error(at,
        fmt::format("the polygon has {} hole{}; a block has one outline", holes,
                    holes == 1 ? "" : "s"),
        "cut the polygon in two through the hole");
}

void RingReader::saw_height(std::size_t at) {
  if (heights_++ == 0)
    first_height_ = at;
}

std::optional<int> RingReader::joint(const WrittenNumber& number,
                                     const std::string& hint) {
  const auto value = value_of(number.text);
  if (value && *value >= 0.0 && *value <= std::numeric_limits<int>::max() &&
      *value == std::floor(*value))
    return static_cast<int>(*value);
  error(number.at,
        fmt::format("joint id {} should be a whole number from 0 to {}",
                    number.text.substr(0, 40), std::numeric_limits<int>::max()),
        hint, number.text.size());
  return std::nullopt;
}

void RingReader::add(const std::vector<Position>& ring, RingData data, std::size_t at) {
  Outline outline;
  outline.material = data.material;
  outline.fixed = data.fixed;
  outline.joints = std::move(data.joints);
  outline.layer = std::move(data.layer);
  outline.at = at;
  for (const Position& position : ring) {
    std::array<double, 2> xy{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const WrittenNumber& number = position[axis];
      const auto value = value_of(number.text);
      if (!value) {
        error(number.at,
              fmt::format("{} is outside the range of numbers",
                          number.text.substr(0, 40)),
              {}, number.text.size());
        return;
      }
      xy[axis] = *value;
    }
    outline.corners.emplace_back(xy[0], xy[1]);
    outline.written.push_back(
        {std::string(position[0].text), std::string(position[1].text)});
  }
  if (ring.size() < 4) {
    error(at, fmt::format("a ring needs at least 4 positions, the last the same as the "
                          "first; found {}",
                          ring.size()));
    return;
  }
  if (outline.corners.front() != outline.corners.back()) {
    error(
        ring.back()[0].at,
        "the ring is not closed: its last position is not its "
        "first",
        "repeat the first position at the end, or check whether positions are missing");
    return;
  }
  outline.corners.pop_back();
  outline.written.pop_back();
  file_.outlines.push_back(std::move(outline));
}

bool RingReader::could_be_degrees() const {
  return std::all_of(
      file_.outlines.begin(), file_.outlines.end(), [](const Outline& outline) {
        return std::all_of(outline.corners.begin(), outline.corners.end(),
                           [](const geometry::Vec2& corner) {
                             return std::abs(corner.x()) <= 180.0 &&
                                    std::abs(corner.y()) <= 90.0;
                           });
      });
}

OutlineFile RingReader::finish(const std::string& found) {
  if (heights_ > 0)
    warning(first_height_,
            fmt::format("{} position{} more than x and y", heights_,
                        heights_ == 1 ? " has" : "s have"),
            "only x and y are read");
  if (file_.outlines.empty() && !has_errors(file_.messages))
    file_.messages.push_back({true, nowhere, "no polygons in the file", {}});
  file_.found = fmt::format("{}, {} polygon{}", found, file_.outlines.size(),
                            file_.outlines.size() == 1 ? "" : "s");
  return std::move(file_);
}

}  // namespace blocks::exchange
