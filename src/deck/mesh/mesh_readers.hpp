// READ9: reads blocks from a mesh file in one of four forms, which is recognised by its
// content (docs/mesh-formats.md).
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::deck {

enum class MeshForm { text, gmsh, genesis, regions };

struct MeshBlock {
  geometry::Polygon outline;  ///< clockwise, [L]; the model checks it
  long material = 0;          ///< block id, physical or region id
  int line = 0;               ///< line in a text file, otherwise 0
  /// Joint id of the side that begins at each corner, >= 0; empty: 0 for all sides.
  std::vector<int> joints = {};
  bool fixed = false;  ///< only $Blocks of a Gmsh file can say so
};

struct MeshFile {
  MeshForm form = MeshForm::text;
  std::string found;  ///< summary: "Gmsh 4.1 ASCII, 12 quadrilaterals"
  std::vector<MeshBlock> blocks;
  std::map<long, std::string> names = {};  ///< of materials: Gmsh's physical groups
};

class MeshError : public std::runtime_error {
 public:
  /// message: "mesh.txt:12: expected 4 coordinates, found 3". hint: what to do; may be
  /// empty.
  explicit MeshError(const std::string& message, std::string hint = {})
      : std::runtime_error(message), hint_(std::move(hint)) {}
  const std::string& hint() const { return hint_; }

 private:
  std::string hint_;
};

/// Thrown if the file has none of the four forms.
class UnknownMesh : public MeshError {
  using MeshError::MeshError;
};

/// Reads the file. Throws MeshError with file, line (or record) and reason.
MeshFile read_mesh(const std::string& path);

/// Reads a file that is already in memory. name: file name for messages. Allocates no
/// more than a small multiple of the data, whatever counts the file announces.
MeshFile parse_mesh(const std::string& name, std::string_view data);

}  // namespace blocks::deck
