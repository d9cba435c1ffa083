// Builds models of the example decks.
#pragma once

#include <string>

#include "model/model.hpp"

namespace blocks::bench {

/// Returns the path of an example deck, such as "crater".
std::string deck_path(const std::string& name);

/// Returns the model of an example deck before its first step. Throws
/// std::runtime_error if the deck has errors.
Model deck_model(const std::string& name);

}  // namespace blocks::bench
