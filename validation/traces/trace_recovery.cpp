// The program of `./go validate traces`: fits joint sets to maps that known sets made,
// and counts how often the intervals cover the known numbers.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "validation/traces/recovery.hpp"

namespace {

using namespace blocks::validation;

constexpr const char* introduction =
    R"(# Joint sets recovered from their maps

Written by `./go validate traces`; do not edit. Two joint sets make a map in a window of 40 by 30,
and `blocks joints fit` fits sets to it ([how](../../docs/joint-statistics.md)). The tables show the
mean of the estimates and the percentage of maps whose 95 % interval covers the given number. Maps
with another number of families are not counted. Fields that are 0 by definition are left out.
)";

std::string table(const RecoveryCase& one, const Recovery& found) {
  std::string text = fmt::format(
      "\n## {}\n\n{} maps, of which {} have two families; {} of {} laws of spacing are "
      "found.\n\n| set | field | given | mean of the estimates | covered [%] |\n"
      "|---|---|---|---|---|\n",
      one.name, found.maps, found.right, found.laws, 2 * found.right);
  for (const RecoveredField& field : found.fields)
    if (field.given != 0.0)
      text +=
          fmt::format("| {} | {} | {:g} | {:.4g} | {:.1f} |\n", field.set, field.name,
                      field.given, field.mean, 100.0 * field.covered / found.right);
  return text;
}

/// Whether all intervals cover often enough.
bool holds(const Recovery& found) {
  constexpr double min = 0.9, min_right = 0.97;
  for (const RecoveredField& field : found.fields)
    if (field.covered < min * found.right)
      return false;
  return found.right >= min_right * found.maps;
}

}  // namespace

int main(int argc, char** argv) {
  const int maps = argc > 1 ? std::atoi(argv[1]) : 0;
  if (maps < 1) {
    std::fputs("usage: trace_recovery MAPS [REPORT.md]\n", stderr);
    return 2;
  }
  std::string report = introduction;
  bool all_hold = true;
  for (const RecoveryCase& one : recovery_cases()) {
    const Recovery found = recover(one, maps);
    report += table(one, found);
    all_hold = all_hold && holds(found);
  }
  fmt::print("{}", report);
  if (argc > 2)
    std::ofstream(argv[2]) << report;
  return all_hold ? 0 : 4;
}
