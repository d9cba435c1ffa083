#include "exchange/wkt_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "exchange/ring.hpp"
#include "exchange/wkt_scanner.hpp"

namespace blocks::exchange {
namespace {

class Reader {
 public:
  explicit Reader(std::string_view text) : scan_(text) {}

  OutlineFile read() {
    try {
      for (scan_.skip(";"); !scan_.is_at_end(); scan_.skip(";"))
        geometry(0);
    } catch (const SyntaxFault& fault) {
      rings_.error(fault.at, fault.message, fault.hint, fault.length);
    }
    return rings_.finish("WKT");
  }

 private:
  WktScanner scan_;
  RingReader rings_;

  /// A ring with the joint ids of its sides; without ids if it has none.
  struct Ring {
    std::vector<Position> positions;
    std::vector<int> joints;
  };

  void geometry(int depth);
  void polygon(std::size_t begin, bool measured);
  Ring ring(bool measured);
  void measure(Ring& ring);
};

void Reader::geometry(int depth) {
  const std::size_t begin = scan_.skip();
  const std::string kind = scan_.word();
  if (kind == "SRID") {
    scan_.take_srid();
    rings_.warning(begin, "SRID is ignored: coordinates are taken as lengths");
    return;
  }
  // Heights are reported with the first position that has one.
  const bool measured = scan_.take_dimensions() == "M";
  if (kind != "POLYGON" && kind != "MULTIPOLYGON" && kind != "GEOMETRYCOLLECTION") {
    scan_.move_to(begin);
    scan_.fail("POLYGON, MULTIPOLYGON or GEOMETRYCOLLECTION");
  }
  if (scan_.take_empty()) {
    rings_.warning(begin, kind + " EMPTY is skipped");
  } else if (kind == "POLYGON") {
    polygon(begin, measured);
  } else if (kind == "MULTIPOLYGON") {
    scan_.list([&] {
      const std::size_t one = scan_.skip();
      if (scan_.take_empty())
        rings_.warning(one, "POLYGON EMPTY is skipped");
      else
        polygon(one, measured);
    });
  } else if (depth == deepest_collection) {
    throw SyntaxFault{begin, fmt::format("nested deeper than {}", deepest_collection),
                      1};
  } else {
    scan_.list([&] { geometry(depth + 1); });
  }
}

void Reader::polygon(std::size_t begin, bool measured) {
  Ring outer;
  std::size_t rings = 0;
  scan_.list([&] {
    Ring next = ring(measured);
    if (rings++ == 0)
      outer = std::move(next);
  });
  if (rings > 1)
    rings_.refuse_holes(rings - 1, begin);
  else
    rings_.add(outer.positions, {0, false, std::move(outer.joints)}, begin);
}

/// Reads m of a position, which is a joint id. The last position has that of the first.
void Reader::measure(Ring& ring) {
  static const std::string hint =
      "m is the id of the side that begins here; write POLYGON without M if m means "
      "something else";
  const WrittenNumber m = scan_.number("a number, m (the joint id)", hint);
  const auto id = rings_.joint(m, hint);
  ring.joints.push_back(id.value_or(0));
  if (scan_.is_next(')') && id && ring.joints.front() != *id)
    rings_.error(m.at,
                 fmt::format("the last position has the joint id {}, the first {}", *id,
                             ring.joints.front()),
                 "both are the same point: give both the id of the first side",
                 m.text.size());
}

Reader::Ring Reader::ring(bool measured) {
  Ring ring;
  scan_.list([&] {
    const WrittenNumber x = scan_.number("a number, x"),
                        y = scan_.number("a number, y");
    ring.positions.push_back({x, y});
    if (measured) {
      measure(ring);
      return;
    }
    if (scan_.has_more()) {
      rings_.saw_height(x.at);
      scan_.take_more_numbers();
    }
  });
  if (measured)
    ring.joints.pop_back();
  return ring;
}

}  // namespace

OutlineFile read_wkt(std::string_view text) { return Reader(text).read(); }

bool looks_like_wkt(std::string_view text) {
  const std::string first = WktScanner(text).word();
  constexpr std::array words{
      "POLYGON",    "MULTIPOLYGON", "GEOMETRYCOLLECTION", "POINT",
      "LINESTRING", "MULTIPOINT",   "MULTILINESTRING",    "POLYHEDRALSURFACE",
      "TRIANGLE",   "TIN",          "CURVEPOLYGON",       "MULTISURFACE",
      "SRID"};
  return std::find(words.begin(), words.end(), first) != words.end();
}

}  // namespace blocks::exchange
