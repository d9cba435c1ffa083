// Collects the polylines or points of one text, with its messages, and checks their
// numbers. Filled by one function per form. Private to src/exchange.
#pragma once

#include <map>

#include "exchange/ring.hpp"
#include "exchange/trace_reader.hpp"

namespace blocks::exchange {

enum class Shapes { lines, points };

class ShapeCollector {
 public:
  /// wanted: the geometry to read; others are refused.
  ShapeCollector(std::string_view text, Shapes wanted) : text_(text), wanted_(wanted) {}

  Shapes wanted() const { return wanted_; }

  /// Adds a polyline, or reports why it is none. at: its offset in the text. layer: its
  /// name; empty: none.
  void add_line(const std::vector<Position>& positions, std::optional<int> joint,
                std::size_t at, const std::string& layer = {});
  void add_point(const Position& position);

  /// Returns the joint id, or reports an error and returns nothing.
  std::optional<int> joint(const WrittenNumber& number);

  void add(Message message) { messages_.push_back(std::move(message)); }
  void error(std::size_t at, std::string text, std::string hint = {},
             std::size_t length = 1);
  void warning(std::size_t at, std::string text, std::string hint = {});
  /// Reports a geometry that is not wanted. kind: "Polygon", "POLYGON".
  void refuse(std::size_t at, const std::string& kind);
  /// Registers a position with more than two numbers; all are reported once.
  void saw_height(std::size_t at);

  /// Registers the unit of length of a drawing, and a description of its curves.
  void note_drawing(std::string unit, std::string curves) {
    unit_ = std::move(unit);
    curves_ = std::move(curves);
  }
  /// What the coordinates so far tell of their unit. likely: all are in the range of
  /// longitude and latitude, and they are less than 1, and less than a hundredth of
  /// their distance from the origin, apart. possible: they are only in this range.
  enum class Degrees { impossible, possible, likely };
  Degrees degrees() const;

  TraceFile finish_traces(const std::string& form);
  PointFile finish_points(const std::string& form);

 private:
  std::string_view text_;
  Shapes wanted_;
  std::vector<Trace> traces_;
  std::vector<std::size_t> begins_;  // offset of each trace
  std::vector<geometry::DecimalPoint> points_;
  std::vector<Message> messages_;
  std::size_t heights_ = 0, first_height_ = 0;
  std::size_t repeated_ = 0, first_repeated_ = 0;
  std::vector<std::string> layers_;
  std::map<std::string, int> layer_numbers_;
  std::string unit_, curves_;

  std::optional<geometry::Decimal> number(const WrittenNumber& number);
  std::optional<geometry::DecimalPoint> point(const Position& position);
  void report_counts();
  void number_lines();
};

/// Each reads the text from offset `begin` into the collector.
void collect_geojson(std::string_view text, ShapeCollector& shapes);
void collect_wkt(std::string_view text, std::size_t begin, ShapeCollector& shapes);
void collect_dxf(std::string_view text, ShapeCollector& shapes);
void collect_csv(std::string_view text, std::size_t begin, ShapeCollector& shapes);

}  // namespace blocks::exchange
