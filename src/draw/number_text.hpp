// Numbers in the texts of figures and messages.
#pragma once

#include <cstddef>
#include <string>

namespace blocks::draw {

/// Returns the words with true minus signs in front of numbers: "−0.5", "1e−05".
std::string with_minus_signs(const std::string& words);

/// Returns a power as superscript: "⁶", "⁻¹²".
std::string superscript(int number);

/// Returns a label with its unit: "speed [m/s]"; the label alone without a unit.
std::string with_unit(const std::string& label, const std::string& unit);

}  // namespace blocks::draw
