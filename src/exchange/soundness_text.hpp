// What the check of outlines found, in words.
#pragma once

#include <string>
#include <vector>

#include "exchange/outlines.hpp"
#include "exchange/soundness.hpp"

namespace blocks::exchange {

/// An error for each bad outline and for the ten pairs that overlap most, the rest of
/// the pairs counted; overlaps become warnings when they are to be kept.
std::vector<Message> faults(const Soundness& soundness,
                            const std::vector<Outline>& outlines, bool keep_overlaps);

/// Lines for the user: size of the whole, concave blocks, T-junctions, near misses.
std::string describe(const Soundness& soundness, const std::vector<Outline>& outlines);

}  // namespace blocks::exchange
