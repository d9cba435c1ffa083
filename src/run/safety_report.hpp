// What a run tells about the factor of safety.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "model/safety_factor.hpp"

namespace blocks::run {

/// Returns "FOS trial with strength / 1.25: stable after 840 steps, ...".
std::string trial_line(const SafetyTrial& trial);

/// Returns the result: the bracket, the number of trials and all their steps.
std::string safety_line(const SafetyFactor& card, std::span<const SafetyTrial> trials);

/// Returns a warning if blocks have left the domain before the card, so that only what
/// remains is judged; otherwise empty.
std::string lost_blocks_warning(const SafetyFactor& card, std::size_t exits);

/// Returns why the bracket has no end, or is wider than wanted; empty if it is as
/// wanted.
std::string safety_warning(const SafetyFactor& card,
                           std::span<const SafetyTrial> trials);

}  // namespace blocks::run
