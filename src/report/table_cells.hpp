// Numbers in tables: exact for CSV, and short for the terminal.
#pragma once

#include <string>

#include "report/statistics.hpp"

namespace blocks::report {

/// Returns the number so that it can be read back exactly; empty if it is not finite.
std::string cell(double value);

/// Returns the number with four digits; "-" if it is not finite.
std::string short_number(double value);

/// Returns "0.1 to 0.2"; "-" if there is no lower end.
std::string short_interval(const Interval& interval);

}  // namespace blocks::report
