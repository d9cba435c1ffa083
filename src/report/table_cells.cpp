#include "report/table_cells.hpp"

#include <fmt/format.h>

#include <cmath>

namespace blocks::report {

std::string cell(double value) {
  return std::isfinite(value) ? fmt::format("{}", value + 0.0) : "";
}

std::string short_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value + 0.0) : "-";
}

std::string short_interval(const Interval& interval) {
  return std::isfinite(interval.low)
             ? short_number(interval.low) + " to " + short_number(interval.high)
             : "-";
}

}  // namespace blocks::report
