// The text form of READ9 (docs/mesh-formats.md).
#pragma once

#include <string>
#include <vector>

#include "exchange/outlines.hpp"

namespace blocks::exchange {

/// Outlines as READ9 reads them, numbers as written where they are known, the shortest
/// decimals otherwise. Every outline has a material. comment: stands at the head.
std::string write_mesh(const std::vector<Outline>& outlines,
                       const std::string& comment);

/// The comment without characters that would end it.
std::string one_line(std::string text);

}  // namespace blocks::exchange
