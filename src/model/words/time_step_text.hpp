// The time step in words, for the listing and for `check`.
#pragma once

#include <string>

#include "model/model.hpp"

namespace blocks {

/// Returns what limits the time step, in words: "contact", "its stiffness", or "the
/// stiffness of a piece of it" if a crack may make that piece. `elasticity` is the word
/// for the limit by the deformation of the block.
std::string limit_in_words(const TimeStep& step,
                           const std::string& elasticity = "stiffness");

/// Returns what limits a time step: limit_in_words(), and the damping for which it is
/// safe if the program chose it.
std::string limit_in_words(const TimeStep& step, const Settings& settings);

/// Returns "DAMPING 0.5", with LOCDAMP if it acts.
std::string damping_in_words(const Settings& settings);

}  // namespace blocks
