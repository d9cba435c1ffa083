// Parts shared by the readers of READ9's four forms: messages, lines of fields, Fortran
// records, and the collector that turns elements into clockwise outlines. Private to
// src/deck/mesh; independent of cards.
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

#include "deck/mesh/mesh_readers.hpp"

namespace blocks::deck::mesh {

/// A location in a mesh file: a line of a text file or a record of a binary file. If
/// both are 0, it is the file as a whole.
struct Place {
  std::string_view file;
  int line = 0;
  int record = 0;
};

/// Throws MeshError "file:line: message", "file: record N: message" or "file: message".
/// hint: what to do; may be empty.
[[noreturn]] void fail(const Place& place, const std::string& message,
                       const std::string& hint = {});

/// Fails unless `material` is a valid material number: 1 to 2147483647.
void check_material(long material, const std::string& name, const Place& place);

/// Returns the id without its sign, by which QMESH and Gmsh mark other properties. The
/// smallest long has no positive counterpart; it is unchanged and rejected later.
inline long magnitude(long id) {
  return id < 0 && id != std::numeric_limits<long>::min() ? -id : id;
}

/// Collects nodes by id, and the triangles and quadrilaterals made of them.
class Elements {
 public:
  /// Throws if a coordinate is not finite or the id already exists with another
  /// position.
  void add_node(long id, double x, double y, const Place& place, double z = 0);

  /// Adds an element as a block. corners: node ids in order, clockwise or
  /// anticlockwise. A node repeated directly after itself counts once, so a
  /// quadrilateral with a repeated last node is a triangle. The outline becomes
  /// clockwise, and its first corner stays first (LXK and GENESIS are anticlockwise).
  /// name: "element 7", for messages. Throws if a node is unknown, there are fewer than
  /// three corners, the area is zero or the material is invalid. It also throws for a
  /// second element on the same corners, or one off the plane z = constant of the
  /// others.
  void add(std::span<const long> corners, long material, const std::string& name,
           const Place& place);

  /// Returns a block with these node ids as its corners, which are clockwise; if they
  /// are not, it becomes clockwise as in add(). Throws if a node is unknown or off the
  /// plane of the others, or if the material is invalid.
  MeshBlock ring(std::span<const long> corners, std::vector<int> joints, long material,
                 const std::string& name, const Place& place);

  /// Returns "12 quadrilaterals, 3 triangles".
  std::string found() const;

  std::vector<MeshBlock> blocks;

 private:
  geometry::Polygon outline_of(std::span<const long> corners, const std::string& name,
                               const Place& place);

  struct Node {
    geometry::Vec2 position;
    double z = 0;
  };
  std::unordered_map<long, Node> nodes_;
  std::optional<double> level_;  ///< z of the first element
  /// Sorted corners; a missing 4th is the smallest long.
  std::set<std::array<long, 4>> taken_;
  std::size_t triangles_ = 0, quadrilaterals_ = 0;
};

/// Makes the outline of the block clockwise; its first corner stays first, and each
/// side keeps its joint id. Returns false if it has no area and hence no orientation.
bool turn_clockwise(MeshBlock& block);

/// The lines of a text without blank ones, split into fields.
class Lines {
 public:
  /// comments: characters that start a comment; empty for none. commas: whether commas
  /// separate fields, as in a deck.
  Lines(std::string_view file, std::string_view text, std::string_view comments,
        bool commas);

  /// Advances to the next line that is not blank; returns false at the end.
  bool next();
  /// Like next(), but the end is an error whose message says what was expected.
  void need(const std::string& expected);

  const std::vector<std::string_view>& fields() const { return fields_; }
  Place place() const { return {file_, line_, 0}; }
  std::size_t bytes_left() const { return text_.size() - position_; }

  /// Return field i as a number. what: its name in messages. Throw if the field is
  /// missing, is not a number or is out of range.
  long integer(std::size_t i, const std::string& what) const;
  double real(std::size_t i, const std::string& what) const;
  /// Returns field i as a joint id. Throws, with a hint, unless it is a whole number
  /// from 0.
  int joint(std::size_t i, const std::string& what) const;
  /// Returns field i as a count of items that follow, each at least two bytes long. It
  /// is checked against the rest of the file before anything is allocated.
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

/// Reads the present line as a block of the section $Blocks: its material, fixed (0 or
/// 1) and number of corners; then, for each corner, its node and the joint id of the
/// side that begins there. name: "block 7", for messages.
MeshBlock read_ring(const Lines& lines, Elements& elements, const std::string& name);

/// A Fortran unformatted sequential file with 4-byte record markers, either endianness.
class Records {
 public:
  /// Tells whether the first record has one of the lengths with which a GENESIS or
  /// region file starts.
  static bool recognise(std::string_view data);

  /// Finds all records. Throws if their markers do not fit the file.
  Records(std::string_view file, std::string_view data);

  std::size_t size() const { return records_.size(); }
  bool big_endian() const { return big_endian_; }
  /// Returns the length of record i in bytes; i counts from 0. what: the expected
  /// content, for the message if the record is missing.
  std::size_t length(std::size_t i, const std::string& what) const;
  /// Return the number of `width` bytes (4 or 8) at byte `offset` of record i.
  long integer(std::size_t i, std::size_t offset, std::size_t width) const;
  double real(std::size_t i, std::size_t offset, std::size_t width) const;

  Place place(std::size_t i) const { return {file_, 0, static_cast<int>(i) + 1}; }

 private:
  std::string_view file_, data_;
  bool big_endian_ = false;
  std::vector<std::string_view> records_;

  std::uint64_t bits(std::string_view bytes) const;
};

/// Returns "little-endian, 4-byte integers, 8-byte reals".
std::string describe(const Records& records, std::size_t integer_width,
                     std::size_t real_width);

MeshFile read_text(std::string_view file, std::string_view text);
MeshFile read_gmsh(std::string_view file, std::string_view text);
MeshFile read_genesis(const Records& records);
MeshFile read_regions(const Records& records);

}  // namespace blocks::deck::mesh
