// READ9: blocks from a mesh file in one of four forms, found by its content
// (docs/mesh-formats.md).
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/vec2.hpp"

namespace blocks::deck {

enum class MeshForm { text, gmsh, genesis, regions };

struct MeshBlock {
  geometry::Polygon outline;  ///< clockwise, [L]; outline checks are the model's
  long material = 0;          ///< block id, physical or region id
  int line = 0;               ///< where it stands in a text file, else 0
};

struct MeshFile {
  MeshForm form = MeshForm::text;
  std::string found;  ///< what was found, in words: "Gmsh 4.1 ASCII, 12 quadrilaterals"
  std::vector<MeshBlock> blocks;
};

class MeshError : public std::runtime_error {
  using std::runtime_error::runtime_error;  // "mesh.txt:12: expected 4 coordinates,
                                            // found 3"
};

/// A file in none of the four forms.
class UnknownMesh : public MeshError {
  using MeshError::MeshError;
};

/// Reads the file. Throws MeshError with file, line (or record) and reason.
MeshFile read_mesh(const std::string& path);

/// The same for a file already in memory; name: as shown in messages. Allocates no more
/// than a small multiple of the data, whatever counts it announces.
MeshFile parse_mesh(const std::string& name, std::string_view data);

}  // namespace blocks::deck
