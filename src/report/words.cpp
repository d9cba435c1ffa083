// What was swept and how the runs ended, in words.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "report/tables.hpp"

namespace blocks::report {
namespace {

namespace fs = std::filesystem;

/// Returns "1 to 20" or "1, 3, 5 to 9" of ascending numbers.
std::string ranges(const std::set<std::uint64_t>& numbers) {
  constexpr int max_ranges = 6;
  std::string text;
  int count = 0;
  for (auto at = numbers.begin(); at != numbers.end();) {
    const std::uint64_t first = *at;
    std::uint64_t last = first;
    while (++at != numbers.end() && *at == last + 1)
      last = *at;
    if (++count > max_ranges)
      return text + fmt::format(" ... {}", *numbers.rbegin());
    text += text.empty() ? "" : ", ";
    text +=
        last == first ? fmt::format("{}", first) : fmt::format("{} to {}", first, last);
  }
  return text;
}

void remove_all(std::string& text, const std::string& part) {
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at))
    text.erase(at, part.size());
}

std::string absolute(const std::string& path) {
  return fs::absolute(path).lexically_normal().string();
}

std::string counted(const std::map<State, std::size_t>& counts) {
  std::string words;
  for (const auto& [state, count] : counts)
    if (count > 0)
      words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, name_of(state));
  return words;
}

}  // namespace

std::string portable_message(const Ensemble& ensemble, const RunRow& row) {
  std::string message = row.message;
  const Member& member = ensemble.members[row.member];
  const std::string run = ensemble.folder_of(row);
  for (const std::string& folder : {run, absolute(run), absolute(member.folder),
                                    fs::path(member.plan.deck).parent_path().string()})
    if (folder.size() > 1)
      remove_all(message, folder + (folder.ends_with('/') ? "" : "/"));
  return message;
}

std::string sweep_words(const Ensemble& ensemble) {
  std::size_t runs = 0;
  std::set<std::uint64_t> seeds;
  std::vector<std::string> decks;
  for (const Member& member : ensemble.members) {
    runs += member.plan.runs.size();
    for (const sweep::Variation& run : member.plan.runs)
      if (run.seed)
        seeds.insert(*run.seed);
    const std::string deck = member.plan.deck.empty()
                                 ? member.plan.name
                                 : fs::path(member.plan.deck).filename().string();
    if (std::find(decks.begin(), decks.end(), deck) == decks.end())
      decks.push_back(deck);
  }
  const bool study = ensemble.kind() == sweep::Kind::study;
  const char* what = ensemble.kind() == sweep::Kind::check ? "generated models"
                     : study                               ? "frames"
                     : runs == 1                           ? "run"
                                                           : "runs";
  std::string words = fmt::format("{} {}", runs, what);
  if (!study)
    words += fmt::format(" of {}", fmt::join(decks, ", "));
  std::vector<std::string> axes;
  if (!seeds.empty())
    axes.push_back(fmt::format("{}{} {}", study ? "frame" : "seed",
                               seeds.size() == 1 ? "" : "s", ranges(seeds)));
  for (const Member& member : ensemble.members)
    if (member.plan.sobol)
      axes.push_back(fmt::format("Sobol design of {} rows, {}", member.plan.sobol->rows,
                                 sweep::words_of(*member.plan.sobol)));
  for (std::size_t p = 0; p < ensemble.parameters.size(); ++p) {
    constexpr std::size_t max_values = 8;
    std::vector<std::string> values;
    for (const Group& group : ensemble.groups)
      if (std::find(values.begin(), values.end(), group.values[p]) == values.end())
        values.push_back(group.values[p]);
    if (values.size() > max_values)
      axes.push_back(fmt::format("{} = {} ... {} ({} values)", ensemble.parameters[p],
                                 values.front(), values.back(), values.size()));
    else
      axes.push_back(
          fmt::format("{} = {}", ensemble.parameters[p], fmt::join(values, ", ")));
  }
  return axes.empty() ? words : words + ": " + fmt::format("{}", fmt::join(axes, "; "));
}

std::string outcome_words(const GroupStatistics& group) {
  std::map<State, std::size_t> counts;
  for (const OutcomeCount& one : group.outcomes)
    counts[one.state] = one.count;
  return counted(counts);
}

std::string outcome_words(const Ensemble& ensemble) {
  std::map<State, std::size_t> counts;
  for (const RunRow& row : ensemble.rows)
    ++counts[row.state];
  return counted(counts);
}

}  // namespace blocks::report
