// Reads any bytes as a mesh of READ9. The result is a mesh with finite outlines, and
// one joint id for each side or none, or MeshError.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "deck/mesh/mesh_readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto mesh = blocks::deck::parse_mesh(
        "fuzz", std::string_view(reinterpret_cast<const char*>(data), size));
    for (const auto& block : mesh.blocks) {
      for (const auto& corner : block.outline)
        if (!corner.allFinite())
          std::abort();
      if (!block.joints.empty() && block.joints.size() != block.outline.size())
        std::abort();
      for (const int joint : block.joints)
        if (joint < 0)
          std::abort();
    }
  } catch (const blocks::deck::MeshError&) {
  }
  return 0;
}
