// Checks of option values that several commands share.
#pragma once

#include <CLI/App.hpp>

namespace blocks::apps {

/// Checks the range of the SEED card. CLI11's own conversion would wrap negative
/// numbers and read 010 as octal.
CLI::Validator seed_number();

/// Accepts numbers above 0; CLI::PositiveNumber also accepts NaN.
CLI::Validator positive_number();

/// Accepts finite numbers from 0 on.
CLI::Validator length_from_zero();

/// Accepts a number of steps; CLI::PositiveNumber also accepts fractions, and its
/// message gives a range of doubles.
CLI::Validator whole_steps();

/// Accepts a whole number from 1.
CLI::Validator whole_count();

}  // namespace blocks::apps
