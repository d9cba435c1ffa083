// The numbers that a run wrote into outcome.json.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "report/measure.hpp"
#include "sweep/outcome.hpp"

namespace blocks::report {

/// The name of the part of a measured value that is no variant.
inline const std::string no_variant;

/// Returns the variants of a study in the order of the outcome; one empty name if it
/// has none.
std::vector<std::string> measured_variants(const sweep::Outcome& outcome);

/// Returns the names of all numbers, also of those that were not measured in this run:
/// "p21", and "aspect:max" for a part of a distribution.
std::set<std::string> measured_names(const sweep::Outcome& outcome);

/// Returns the names whose mean is a share of the runs: their values are true or false,
/// or a flag stored as 0 or 1, such as "hung", whether a frame of the study hung.
std::set<std::string> measured_shares(const sweep::Outcome& outcome);

/// Returns the number with this name; 1 or 0 for true or false. NaN if there is none.
double measured_value(const sweep::Outcome& outcome, const std::string& variant,
                      const std::string& name);

/// Returns the value of a measure of outcomes. `scale` converts the number to the units
/// of the report. NaN if the outcome has no such number.
double value_of(const Measure& measure, const sweep::Outcome& outcome,
                const std::string& variant, double scale);

/// Returns the names that a report shows unless others are named: the most telling
/// ones, or all of them if none of these is there.
std::vector<std::string> usual_names(const std::set<std::string>& names, bool study);

}  // namespace blocks::report
