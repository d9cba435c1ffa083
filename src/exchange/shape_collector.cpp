#include "exchange/shape_collector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "text/counted.hpp"

namespace blocks::exchange {
namespace {

bool is_same(const geometry::Decimal& a, const geometry::Decimal& b) {
  return a.digits() == b.digits() && a.exponent() == b.exponent();
}

bool is_same(const geometry::DecimalPoint& a, const geometry::DecimalPoint& b) {
  return is_same(a.x, b.x) && is_same(a.y, b.y);
}

}  // namespace

void ShapeCollector::error(std::size_t at, std::string text, std::string hint,
                           std::size_t length) {
  messages_.push_back({true, at, std::move(text), std::move(hint), length});
}

void ShapeCollector::warning(std::size_t at, std::string text, std::string hint) {
  messages_.push_back({false, at, std::move(text), std::move(hint)});
}

void ShapeCollector::refuse(std::size_t at, const std::string& kind) {
  if (wanted_ == Shapes::points)
    error(at, kind + " cannot be a point of a cell",
          "use Point, MultiPoint or collections of them");
  else if (kind.size() >= 7 && (kind.ends_with("olygon") || kind.ends_with("OLYGON")))
    error(at, kind + " cannot be a trace",
          "give the rings of the polygon as LineString, each closed by its first "
          "position");
  else
    error(at, kind + " cannot be a trace",
          "use LineString, MultiLineString or collections of them");
}

void ShapeCollector::saw_height(std::size_t at) {
  if (heights_++ == 0)
    first_height_ = at;
}

std::optional<geometry::Decimal> ShapeCollector::number(const WrittenNumber& number) {
  // The exponent letter D of Fortran, which Decimal accepts, is in none of the forms.
  if (number.text.find_first_of("dD") == number.text.npos)
    if (auto value = geometry::Decimal::parse(number.text))
      return value;
  const std::string shown(number.text.substr(0, 40));
  const bool has_digits =
      number.text.find_first_not_of("+-.eE0123456789") == number.text.npos &&
      number.text.find_first_of("0123456789") != number.text.npos;
  if (has_digits)
    error(number.at, fmt::format("{} is outside the range of numbers", shown),
          "numbers are written as 1.5 or 1.5e-3, with exponents from -400 to 308",
          number.text.size());
  else
    error(number.at, fmt::format("expected a number, found '{}'", shown),
          "write finite numbers with a decimal point, as 1.5 or 1.5e-3",
          std::max<std::size_t>(number.text.size(), 1));
  return std::nullopt;
}

std::optional<geometry::DecimalPoint> ShapeCollector::point(const Position& position) {
  const auto x = number(position[0]), y = number(position[1]);
  if (!x || !y)
    return std::nullopt;
  return geometry::DecimalPoint{*x, *y};
}

void ShapeCollector::add_point(const Position& position) {
  if (const auto read = point(position))
    points_.push_back(*read);
}

void ShapeCollector::add_line(const std::vector<Position>& positions,
                              std::optional<int> joint, std::size_t at,
                              const std::string& layer) {
  Trace trace;
  trace.joint = joint;
  bool is_complete = true;
  std::size_t repeated = 0, first_repeated = 0;
  for (const Position& position : positions) {
    const auto read = point(position);
    if (!read) {
      is_complete = false;
    } else if (!trace.points.empty() && is_same(trace.points.back(), *read)) {
      if (repeated++ == 0)
        first_repeated = position[0].at;
    } else {
      trace.points.push_back(*read);
    }
  }
  if (!is_complete)
    return;
  if (trace.points.size() < 2) {
    error(at,
          positions.size() < 2 ? "the polyline has fewer than two points"
                               : "all points of the polyline are the same",
          "give at least two different points, or remove the polyline");
    return;
  }
  if (repeated > 0 && repeated_ == 0)
    first_repeated_ = first_repeated;
  repeated_ += repeated;
  if (!layer.empty()) {
    const auto [number, is_new] =
        layer_numbers_.emplace(layer, static_cast<int>(layers_.size()));
    if (is_new)
      layers_.push_back(layer);
    trace.layer = number->second;
  }
  trace.points.shrink_to_fit();
  traces_.push_back(std::move(trace));
  begins_.push_back(at);
}

std::optional<int> ShapeCollector::joint(const WrittenNumber& number) {
  // The digits have no zeros at the end, so whole numbers have no negative exponent.
  if (const auto value = geometry::Decimal::parse(number.text);
      value && value->value() >= 0 && value->exponent() >= 0 &&
      value->value() <= std::numeric_limits<int>::max())
    return static_cast<int>(value->value());
  error(number.at,
        fmt::format("the joint id '{}' is not a whole number from 0 to {}",
                    number.text.substr(0, 40), std::numeric_limits<int>::max()),
        "leave the id out to use the id of the card",
        std::max<std::size_t>(number.text.size(), 1));
  return std::nullopt;
}

void ShapeCollector::report_counts() {
  if (heights_ > 0)
    warning(first_height_,
            fmt::format("{} position{} more than x and y", heights_,
                        heights_ == 1 ? " has" : "s have"),
            "only x and y are read");
  if (repeated_ > 0)
    warning(first_repeated_,
            fmt::format("{} the point before and {} dropped",
                        repeated_ == 1 ? "1 point repeats"
                                       : fmt::format("{} points repeat", repeated_),
                        repeated_ == 1 ? "is" : "are"));
  const bool is_empty = wanted_ == Shapes::lines ? traces_.empty() : points_.empty();
  if (is_empty && !has_errors(messages_))
    error(nowhere,
          wanted_ == Shapes::lines ? "no polylines in the file"
                                   : "no points in the file",
          wanted_ == Shapes::lines
              ? "give LineString (GeoJSON), LINESTRING (WKT), x1, y1, x2, y2 (CSV) or "
                "lines (DXF)"
              : "give Point (GeoJSON), POINT (WKT) or x, y (CSV)");
}

ShapeCollector::Degrees ShapeCollector::degrees() const {
  double low[] = {HUGE_VAL, HUGE_VAL}, high[] = {-HUGE_VAL, -HUGE_VAL};
  const auto add = [&](const geometry::DecimalPoint& point) {
    const double place[] = {point.x.value(), point.y.value()};
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], place[k]);
      high[k] = std::max(high[k], place[k]);
    }
  };
  for (const Trace& trace : traces_)
    std::for_each(trace.points.begin(), trace.points.end(), add);
  std::for_each(points_.begin(), points_.end(), add);
  if (low[0] < -180 || high[0] > 180 || low[1] < -90 || high[1] > 90)
    return Degrees::impossible;
  const double size = std::max(high[0] - low[0], high[1] - low[1]);
  return size > 0 && size < 1 && 100 * size < std::hypot(low[0], low[1])
             ? Degrees::likely
             : Degrees::possible;
}

void ShapeCollector::number_lines() {
  std::vector<std::size_t> ends;  // offsets of the ends of lines
  for (auto end = text_.find('\n'); end != text_.npos; end = text_.find('\n', end + 1))
    ends.push_back(end);
  for (std::size_t i = 0; i < traces_.size(); ++i)
    traces_[i].line =
        1 + static_cast<std::size_t>(
                std::lower_bound(ends.begin(), ends.end(), begins_[i]) - ends.begin());
}

TraceFile ShapeCollector::finish_traces(const std::string& form) {
  report_counts();
  number_lines();
  std::size_t segments = 0;
  for (const Trace& trace : traces_)
    segments += trace.points.size() - 1;
  std::string found =
      fmt::format("{}, {}, {}", form, counted(traces_.size(), "polyline"),
                  counted(segments, "segment"));
  if (!curves_.empty())
    found += "; " + curves_;
  return {form,
          std::move(found),
          std::move(traces_),
          std::move(layers_),
          std::move(unit_),
          std::move(messages_)};
}

PointFile ShapeCollector::finish_points(const std::string& form) {
  report_counts();
  return {form, fmt::format("{}, {}", form, counted(points_.size(), "point")),
          std::move(points_), std::move(messages_)};
}

}  // namespace blocks::exchange
