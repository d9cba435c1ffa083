// The steps of the fuzz targets for GeoJSON and WKT after reading a file. They show the
// messages, examine the outlines, write the mesh and read it.
#pragma once

#include <algorithm>
#include <cstdlib>

#include "deck/mesh/mesh_readers.hpp"
#include "exchange/mesh_writer.hpp"
#include "exchange/soundness_text.hpp"

namespace blocks::exchange {

inline void use(OutlineFile file, std::string_view text) {
  format(file.messages, "fuzz", "form", text);
  if (has_errors(file.messages))
    return;
  std::vector<geometry::Polygon> corners;
  for (Outline& outline : file.outlines) {
    outline.material = 1;
    corners.push_back(outline.corners);
  }
  const Soundness soundness = examine(corners);
  faults(soundness, file.outlines, false);
  describe(soundness, file.outlines);
  if (!soundness.bad.empty())
    return;
  for (const int b : soundness.turned)
    reverse(file.outlines[b]);
  const auto mesh = deck::parse_mesh("mesh", write_mesh(file.outlines, "fuzz"));
  const auto ids = [](const std::vector<int>& joints, std::size_t sides) {
    return joints.empty() ? std::vector<int>(sides, 0) : joints;
  };
  for (std::size_t b = 0; b < file.outlines.size(); ++b) {
    const Outline& written = file.outlines[b];
    const deck::MeshBlock& read = mesh.blocks.at(b);
    std::vector<int> joints = ids(read.joints, read.outline.size());
    // Nearly flat outlines may have the other sense after reading. READ9 corrects it
    // exactly.
    if (read.outline != written.corners) {
      if (geometry::reversed(read.outline) != written.corners)
        std::abort();
      std::reverse(joints.begin(), joints.end());
    }
    if (joints != ids(written.joints, written.corners.size()))
      std::abort();
  }
}

}  // namespace blocks::exchange
