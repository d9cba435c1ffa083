// What the proofs take for granted of the processor's arithmetic.
#pragma once

#include <string>

namespace blocks::geometry {

/// Empty when doubles round to nearest and subnormals are kept; else what is wrong.
std::string check_numeric_environment();

}  // namespace blocks::geometry
