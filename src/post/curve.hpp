// What a history follows: QUANTITY or QUANTITY:WHERE, as the user writes it.
#pragma once

#include <string>

namespace blocks::post {

/// What is followed: "speed:9" of block 9, "x:9.2" of its corner 2, "speed:max" over
/// all blocks, "kinetic_energy" of the model.
struct Curve {
  enum class Of { model, block, corner, largest, smallest, mean, sum };
  std::string quantity;  ///< a name of quantity.hpp, or of the contacts and the model
  Of of = Of::model;
  int block = 0, corner = 0;  ///< from 1

  std::string name() const;  ///< as the user writes it
};

/// Reads QUANTITY or QUANTITY:WHERE. Throws std::runtime_error naming what there is.
Curve parse_curve(const std::string& text);

/// All that parse_curve takes, for help and messages.
std::string history_help();

}  // namespace blocks::post
