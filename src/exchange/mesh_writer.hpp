// Writes the text form of READ9 (docs/mesh-formats.md).
#pragma once

#include <string>
#include <vector>

#include "exchange/outlines.hpp"

namespace blocks::exchange {

/// Returns the outlines in the form that READ9 reads. Numbers are as written if known,
/// otherwise the shortest decimals. Corners have joint ids if the outline has an id
/// other than 0. Every outline must have a material. comment: placed
/// at the head of the file.
std::string write_mesh(const std::vector<Outline>& outlines,
                       const std::string& comment);

/// Returns the comment without characters that would end it.
std::string one_line(std::string text);

}  // namespace blocks::exchange
