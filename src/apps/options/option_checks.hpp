// Checks of option values that several commands share.
#pragma once

#include <CLI/App.hpp>
#include <cstdint>
#include <string>

namespace blocks::apps {

/// Accepts digits only. CLI11's own conversion would wrap negative numbers and read 010
/// as octal. The help shows `name`, or the range if it is empty.
CLI::Validator whole_between(std::uint64_t low, std::uint64_t high,
                             const std::string& name = {});

/// Checks the range of the SEED card.
CLI::Validator seed_number();

/// Accepts numbers from `low` to `high`. CLI::Range accepts NaN and prints thirty
/// digits.
CLI::Validator number_between(double low, double high);

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
