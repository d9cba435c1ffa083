#include "option_checks.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace blocks::apps {
namespace {

/// Accepts a whole number above 0. `expected` says what the option needs.
CLI::Validator whole(const std::string& expected, const std::string& name) {
  return {[expected](std::string& text) {
            const bool fits = !text.empty() && text.size() <= 15 &&
                              text.front() != '0' &&
                              text.find_first_not_of("0123456789") == std::string::npos;
            return fits ? std::string()
                        : "expected " + expected + ", 1 or more, found '" + text + "'";
          },
          name};
}

}  // namespace

CLI::Validator whole_between(std::uint64_t low, std::uint64_t high,
                             const std::string& name) {
  return {[=](std::string& text) {
            const bool digits =
                !text.empty() && text.size() <= 16 &&
                text.find_first_not_of("0123456789") == std::string::npos;
            if (!digits || std::stoull(text) < low || std::stoull(text) > high)
              return fmt::format("expected a whole number from {} to {}, found '{}'",
                                 low, high, text);
            text = std::to_string(std::stoull(text));  // 010 becomes 10
            return std::string();
          },
          name.empty() ? fmt::format("{} to {}", low, high) : name};
}

CLI::Validator seed_number() {
  return whole_between(0, 9007199254740991ULL, "0 TO 2^53-1");
}

CLI::Validator number_between(double low, double high) {
  return {[=](const std::string& text) {
            double value = 0.0;
            return CLI::detail::lexical_cast(text, value) && low <= value &&
                           value <= high
                       ? std::string()
                       : fmt::format("expected a number from {} to {}, found '{}'", low,
                                     high, text);
          },
          fmt::format("{:g} to {:g}", low, high)};
}

CLI::Validator positive_number() {
  return {[](std::string& text) {
            double value = 0.0;
            return CLI::detail::lexical_cast(text, value) && value > 0.0
                       ? std::string()
                       : "expected a number above 0, found '" + text + "'";
          },
          "POSITIVE"};
}

CLI::Validator length_from_zero() {
  return {[](std::string& text) {
            double value = 0.0;
            return CLI::detail::lexical_cast(text, value) && value >= 0.0 &&
                           std::isfinite(value)
                       ? std::string()
                       : "expected a length of 0 or more, found '" + text + "'";
          },
          "NONNEGATIVE"};
}

CLI::Validator whole_steps() { return whole("a number of steps", "STEPS"); }

CLI::Validator whole_count() { return whole("a whole number", "COUNT"); }

}  // namespace blocks::apps
