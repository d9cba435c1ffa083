// Numbers in the texts of figures and messages.
#pragma once

#include <cstddef>
#include <string>

namespace blocks::draw {

/// Returns the words with true minus signs in front of numbers: "−0.5", "1e−05".
std::string with_minus_signs(const std::string& words);

/// Returns a power as superscript: "⁶", "⁻¹²".
std::string superscript(int number);

/// Returns a count with its noun: "1 picture", "3 pictures".
std::string counted(std::size_t n, const std::string& thing);

}  // namespace blocks::draw
