// Formats a study as a table for the terminal, as CSV and as JSON.
#pragma once

#include <string>
#include <vector>

#include "study/study.hpp"

namespace blocks::study {

struct ReportHead {
  int frames = 0;
  std::uint64_t seed = 0;
};

/// Returns the table for the terminal. Below it, notes say which variants did not run
/// and why.
std::string text(const Study& study);

/// Returns a header and one line for each scene and variant. Shares range from 0 to 1.
/// Fields are empty if they were not measured, and 0 frames mean that the variant did
/// not run.
std::string csv(const std::vector<Study>& studies);

/// Returns the same values, with the numbers of the frames that hung or fell through.
std::string json(const std::vector<Study>& studies, const ReportHead& head);

/// The lists of `--list`, one line for each variant or scene.
std::string list_of_variants();
std::string list_of_scenes();

}  // namespace blocks::study
