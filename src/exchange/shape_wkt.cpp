#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "exchange/shape_collector.hpp"
#include "exchange/wkt_scanner.hpp"

namespace blocks::exchange {
namespace {

class WktShapes {
 public:
  WktShapes(WktScanner scan, ShapeCollector& shapes) : scan_(scan), shapes_(shapes) {}

  void read() {
    for (scan_.skip(";"); !scan_.is_at_end(); scan_.skip(";"))
      geometry(0);
  }

 private:
  WktScanner scan_;
  ShapeCollector& shapes_;

  void geometry(int depth);
  void other(std::size_t begin, const std::string& kind);
  void line();
  void point();
  Position position();
};

void WktShapes::geometry(int depth) {
  const std::size_t begin = scan_.skip();
  const std::string kind = scan_.word();
  if (kind == "SRID") {
    scan_.take_srid();
    shapes_.warning(begin, "SRID is ignored: coordinates are taken as lengths");
    return;
  }
  const bool lines = shapes_.wanted() == Shapes::lines;
  const bool is_known = kind == "GEOMETRYCOLLECTION" ||
                        kind == (lines ? "LINESTRING" : "POINT") ||
                        kind == (lines ? "MULTILINESTRING" : "MULTIPOINT");
  if (!is_known) {
    other(begin, kind);
    return;
  }
  scan_.take_dimensions();  // reported with the first position that has a third number
  if (scan_.take_empty())
    shapes_.warning(begin, kind + " EMPTY is skipped");
  else if (kind == "LINESTRING")
    line();
  else if (kind == "MULTILINESTRING")
    scan_.list([&] { line(); });
  else if (kind == "POINT")
    scan_.list([&] { point(); });
  else if (kind == "MULTIPOINT")
    scan_.list([&] {
      if (scan_.is_next('('))
        scan_.list([&] { point(); });
      else
        point();
    });
  else if (depth == deepest_collection)
    throw SyntaxFault{begin, fmt::format("nested deeper than {}", depth), 1};
  else
    scan_.list([&] { geometry(depth + 1); });
}

/// Refuses a geometry that is not wanted, and skips it with its brackets.
void WktShapes::other(std::size_t begin, const std::string& kind) {
  constexpr std::array known{"POINT",           "MULTIPOINT",   "LINESTRING",
                             "MULTILINESTRING", "POLYGON",      "MULTIPOLYGON",
                             "CURVEPOLYGON",    "MULTISURFACE", "POLYHEDRALSURFACE",
                             "TRIANGLE",        "TIN"};
  if (std::find(known.begin(), known.end(), kind) == known.end()) {
    scan_.move_to(begin);
    scan_.fail(shapes_.wanted() == Shapes::lines
                   ? "LINESTRING, MULTILINESTRING or GEOMETRYCOLLECTION"
                   : "POINT, MULTIPOINT or GEOMETRYCOLLECTION");
  }
  shapes_.refuse(begin, kind);
  scan_.take_dimensions();
  if (scan_.take_empty())
    return;
  scan_.need('(', "'('");
  for (std::size_t open = 1; open > 0;) {
    if (scan_.take('('))
      ++open;
    else if (scan_.take(')'))
      --open;
    else if (scan_.is_at_end())
      scan_.fail("')'");
    else if (!scan_.take(',') && !scan_.take(';'))
      scan_.token();
  }
}

void WktShapes::line() {
  const std::size_t begin = scan_.skip();
  if (scan_.take_empty()) {
    shapes_.warning(begin, "LINESTRING EMPTY is skipped");
    return;
  }
  std::vector<Position> positions;
  scan_.list([&] { positions.push_back(position()); });
  shapes_.add_line(positions, {}, begin);
}

void WktShapes::point() {
  const std::size_t begin = scan_.skip();
  if (scan_.take_empty())
    shapes_.warning(begin, "POINT EMPTY is skipped");
  else
    shapes_.add_point(position());
}

Position WktShapes::position() {
  const auto token = [&](const char* what) {
    const WrittenNumber found = scan_.token();
    if (found.text.empty())
      scan_.fail(what);
    return found;
  };
  const WrittenNumber x = token("a number, x"), y = token("a number, y");
  if (scan_.has_more()) {
    shapes_.saw_height(x.at);
    scan_.take_more_numbers();
  }
  return {x, y};
}

}  // namespace

void collect_wkt(std::string_view text, std::size_t begin, ShapeCollector& shapes) {
  try {
    WktShapes(WktScanner(text, begin), shapes).read();
  } catch (const SyntaxFault& fault) {
    shapes.error(fault.at, fault.message, {}, fault.length);
  }
}

}  // namespace blocks::exchange
