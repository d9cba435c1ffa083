// The example decks as models.
#pragma once

#include <string>

#include "model/model.hpp"

namespace blocks::bench {

/// The path of an example deck: "crater".
std::string deck_path(const std::string& name);

/// The model of an example deck before its first step. Throws std::runtime_error when
/// the deck has faults.
Model deck_model(const std::string& name);

}  // namespace blocks::bench
