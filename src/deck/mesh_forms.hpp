// What the readers of READ9's four forms share: messages, the collector that turns
// elements into clockwise outlines, lines of fields, Fortran records. Private to
// src/deck/mesh_*.cpp; knows no cards.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "deck/mesh_readers.hpp"

namespace blocks::deck::mesh {

/// A place in a mesh file: a line of a text, or a record of a binary file; both 0 means
/// the file as a whole.
struct Place {
  std::string_view file;
  int line = 0;
  int record = 0;
};

/// Throws MeshError "file:line: message", "file: record N: message" or "file: message".
[[noreturn]] void fail(const Place& place, const std::string& message);

/// Fails unless it is a material number: 1 to 2147483647.
void check_material(long material, const std::string& name, const Place& place);

/// "1 triangle", "12 quadrilaterals".
std::string counted(std::size_t n, const std::string& noun);

/// The id without the sign by which QMESH and Gmsh mark other things. The least long,
/// which has no positive twin, stays as it is and is found wrong later.
inline long magnitude(long id) {
  return id < 0 && id != std::numeric_limits<long>::min() ? -id : id;
}

/// Nodes by id, and the triangles and quadrilaterals made of them.
class Elements {
 public:
  /// Throws when a coordinate is not finite or the id already stands elsewhere.
  void add_node(long id, double x, double y, const Place& place, double z = 0);

  /// corners: node ids in order, either way round. Corners repeated one after the other
  /// count once, so that a quadrilateral with a repeated last node is a triangle. The
  /// outline comes out clockwise with the first corner kept first (LXK and GENESIS are
  /// anticlockwise). name: "element 7", for messages. Throws for an unknown
  /// node, fewer than three corners, no area, material < 1, a second element on the
  /// same corners, or one off the plane z = constant of the others.
  void add(std::span<const long> corners, long material, const std::string& name,
           const Place& place);

  /// "12 quadrilaterals, 3 triangles"
  std::string found() const;

  std::vector<MeshBlock> blocks;

 private:
  struct Node {
    geometry::Vec2 position;
    double z = 0;
  };
  std::unordered_map<long, Node> nodes_;
  std::optional<double> level_;  ///< z of the first element
  std::set<std::array<long, 4>>
      taken_;  ///< sorted corners; 4th is the least long if none
  std::size_t triangles_ = 0, quadrilaterals_ = 0;
};

/// Turns the outline clockwise, first corner kept; false when it has no area to tell
/// by.
bool turn_clockwise(geometry::Polygon& outline);

/// The lines of a text, blank ones left out, cut into fields.
class Lines {
 public:
  /// comments: characters that end a line; empty for none. commas: a comma parts
  /// fields, as in a deck.
  Lines(std::string_view file, std::string_view text, std::string_view comments,
        bool commas);

  /// Advances to the next line that holds something; false at the end.
  bool next();
  /// Same, but the end is an error that says what was expected.
  void need(const std::string& expected);

  const std::vector<std::string_view>& fields() const { return fields_; }
  Place place() const { return {file_, line_, 0}; }
  std::size_t bytes_left() const { return text_.size() - position_; }

  /// Field i as a number; what: its name in messages. Throws when it is missing, is no
  /// number, or is out of range.
  long integer(std::size_t i, const std::string& what) const;
  double real(std::size_t i, const std::string& what) const;
  /// A count of things still to come, each at least two bytes long: checked against
  /// what is left of the file before anybody allocates.
  std::size_t count(std::size_t i, const std::string& what) const;

 private:
  std::string_view file_, text_, comments_;
  bool commas_;
  std::size_t position_ = 0;
  int line_ = 0;
  std::vector<std::string_view> fields_;

  void split(std::string_view line);
  std::string_view field(std::size_t i, const std::string& what) const;
};

/// A Fortran unformatted sequential file with 4-byte record markers, either endianness.
class Records {
 public:
  /// True when the first record has one of the lengths that open a GENESIS or region
  /// file.
  static bool recognise(std::string_view data);

  /// Finds all records; throws when their markers do not fit the file.
  Records(std::string_view file, std::string_view data);

  std::size_t size() const { return records_.size(); }
  bool big_endian() const { return big_endian_; }
  /// Bytes of record i, counted from 0; the message of a missing record says what it
  /// would have been.
  std::size_t length(std::size_t i, const std::string& what) const;
  /// Number of `width` bytes (4 or 8) at byte `offset` of record i.
  long integer(std::size_t i, std::size_t offset, std::size_t width) const;
  double real(std::size_t i, std::size_t offset, std::size_t width) const;

  Place place(std::size_t i) const { return {file_, 0, static_cast<int>(i) + 1}; }

 private:
  std::string_view file_, data_;
  bool big_endian_ = false;
  std::vector<std::string_view> records_;

  std::uint64_t bits(std::string_view bytes) const;
};

/// "little-endian, 4-byte integers, 8-byte reals"
std::string describe(const Records& records, std::size_t integer_width,
                     std::size_t real_width);

MeshFile read_text(std::string_view file, std::string_view text);
MeshFile read_gmsh(std::string_view file, std::string_view text);
MeshFile read_genesis(const Records& records);
MeshFile read_regions(const Records& records);

}  // namespace blocks::deck::mesh
