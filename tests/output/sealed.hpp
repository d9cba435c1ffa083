// Checkpoints with a valid checksum after a change of their bytes.
#pragma once

#include <fmt/format.h>

#include <string>

#include "files/fnv1a.hpp"
#include "output/checkpoint/checkpoint.hpp"

namespace blocks::samples {

/// Returns the checkpoint with the header and checksum that fit its bytes.
inline std::string sealed(std::string bytes) {
  constexpr std::size_t seal_size = 512;
  bytes.resize(std::max(bytes.size(), seal_size));
  files::Fnv1a hash;
  hash.add(bytes.data() + seal_size, bytes.size() - seal_size);
  std::string seal =
      fmt::format("BLOCKS checkpoint\nformat {}\nbytes {}\nfnv1a {}\n",
                  output::checkpoint_format, bytes.size() - seal_size, hash.text());
  seal.resize(seal_size, '\0');
  return bytes.replace(0, seal_size, seal);
}

}  // namespace blocks::samples
