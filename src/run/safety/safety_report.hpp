// What a run tells about the factor of safety.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "model/safety_factor.hpp"

namespace blocks::run {

/// Returns "FOS trial with strength / 1.25: stable after 840 steps, ...".
std::string trial_line(const SafetyTrial& trial);

/// Returns the result: the bracket, the number of trials and all their steps.
std::string safety_line(const SafetyFactor& card, std::span<const SafetyTrial> trials);

/// Returns warnings about the state before the card: blocks have left the domain, so
/// that only what remains is judged, or blocks move, so that trials do not start from
/// rest.
std::vector<std::string> state_warnings(const SafetyFactor& card, std::size_t exits,
                                        bool moves);

/// Returns why the bracket has no end, or is wider than wanted; empty if it is as
/// wanted.
std::string safety_warning(const SafetyFactor& card,
                           std::span<const SafetyTrial> trials);

}  // namespace blocks::run
