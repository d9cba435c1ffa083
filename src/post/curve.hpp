// A curve of a history, which the user writes as QUANTITY or QUANTITY:WHERE.
#pragma once

#include <string>

namespace blocks::post {

/// A quantity and its place: "speed:9" for block 9, "x:9.2" for its corner 2,
/// "speed:max" for the maximum over all blocks, "kinetic_energy" for the model.
struct Curve {
  enum class Of { model, block, corner, largest, smallest, mean, sum };
  std::string quantity;  ///< a name of quantity.hpp, or of the contacts and the model
  Of of = Of::model;
  int block = 0, corner = 0;  ///< from 1

  std::string name() const;  ///< as the user writes it
};

/// Reads QUANTITY or QUANTITY:WHERE. Throws std::runtime_error that lists the possible
/// values.
Curve parse_curve(const std::string& text);

/// Lists all that parse_curve accepts, for help and messages.
std::string history_help();

}  // namespace blocks::post
