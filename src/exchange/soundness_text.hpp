// Describes the result of the check of outlines in words.
#pragma once

#include <string>
#include <vector>

#include "exchange/outlines.hpp"
#include "exchange/soundness.hpp"

namespace blocks::exchange {

/// Returns an error for each outline with a fault and for the ten pairs with the
/// largest overlaps; further pairs are counted. Overlaps are only warnings if they are
/// to be kept.
std::vector<Message> faults(const Soundness& soundness,
                            const std::vector<Outline>& outlines, bool keep_overlaps);

/// Returns lines for the user: overall size, concave blocks, T-junctions and gaps.
std::string describe(const Soundness& soundness, const std::vector<Outline>& outlines);

}  // namespace blocks::exchange
