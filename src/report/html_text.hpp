// Texts of HTML pages: escaped words, and numbers as people write them.
#pragma once

#include <string>

#include "report/statistics.hpp"

namespace blocks::report {

/// Returns the text with &, <, > and quotes escaped.
std::string escaped(const std::string& text);

/// Returns the text as part of a URL of a file: everything except letters, digits and
/// "-_.~/" is written as %XX.
std::string url_of(const std::string& path);

/// Returns a number with four digits: "−0.1230", "1.235×10⁶"; whole numbers, and those
/// from 1,000 to 100,000, without decimals; "–" if it is not finite.
std::string number_text(double value);

/// Returns "low to high"; "–" if there is no interval. An end that does not exist is
/// written as "…".
std::string interval_text(const Interval& interval);

/// Returns "mean ± half width", both with the decimals that two digits of the half
/// width need; the mean alone if there is no interval.
std::string mean_text(double mean, const Interval& interval);

/// Returns a share in percent with one decimal: "95 %", "0.4 %"; at least 0.1 % unless
/// it is 0.
std::string percent_text(double share);

/// Returns bytes as base64 (RFC 4648).
std::string base64(const std::string& bytes);

}  // namespace blocks::report
