// A study as a table for the terminal, as CSV and as JSON.
#pragma once

#include <string>
#include <vector>

#include "study/study.hpp"

namespace blocks::study {

struct ReportHead {
  int frames = 0;
  std::uint64_t seed = 0;
};

/// Columns as wide as their figures; below the table what did not run, and why.
std::string text(const Study& study);

/// A header and one line for each scene and variant; shares from 0 to 1, empty where
/// nothing was asked; 0 frames: the variant did not run.
std::string csv(const std::vector<Study>& studies);

/// The same figures, with the numbers of the frames that hung or fell through.
std::string json(const std::vector<Study>& studies, const ReportHead& head);

/// One line for each scene and variant: `--list`.
std::string list_of_variants();
std::string list_of_scenes();

}  // namespace blocks::study
