#include "sweep/status.hpp"

#include <fmt/format.h>

#include "run/run.hpp"
#include "run/support/shell_word.hpp"
#include "sweep/outcome.hpp"

namespace blocks::sweep {
namespace {

/// Calls see(id, outcome) for every run.
template <class See>
void each_outcome(const std::string& folder, const Range& runs, See&& see) {
  for (std::size_t id = runs.first; id <= runs.last; ++id)
    see(id, read_outcome_or_damage(run_folder(folder, id)));
}

std::string status_of(const std::optional<Outcome>& outcome) {
  return outcome ? outcome->status : "open";
}

}  // namespace

std::string words_of(const Counts& counts) {
  std::string words;
  const auto add = [&](const std::string& status, std::size_t number) {
    words += fmt::format("{}{} {}", words.empty() ? "" : ", ", number, status);
  };
  if (const auto done = counts.find("done"); done != counts.end())
    add("done", done->second);
  for (const auto& [status, number] : counts)
    if (status != "done" && status != "open")
      add(status, number);
  if (const auto open = counts.find("open"); open != counts.end())
    add("open", open->second);
  return words.empty() ? "no runs" : words;
}

Counts count_runs(const std::string& folder, const Range& runs) {
  Counts counts;
  each_outcome(folder, runs, [&](std::size_t, const std::optional<Outcome>& outcome) {
    ++counts[status_of(outcome)];
  });
  return counts;
}

std::vector<std::size_t> open_runs(const std::string& folder, const Range& runs) {
  std::vector<std::size_t> ids;
  for (std::size_t id = runs.first; id <= runs.last; ++id)
    if (!has_outcome(run_folder(folder, id)))
      ids.push_back(id);
  return ids;
}

void reopen_failed_runs(const std::string& folder, const Range& runs) {
  each_outcome(folder, runs,
               [&](std::size_t id, const std::optional<Outcome>& outcome) {
                 if (outcome && outcome->code != run::done)
                   remove_outcome(run_folder(folder, id));
               });
}

std::string status_text(const std::string& folder, const Plan& plan) {
  constexpr std::size_t max_named = 10;
  Counts counts;
  std::string failed;
  std::size_t number = 0;
  each_outcome(folder, {1, plan.runs.size()},
               [&](std::size_t id, const std::optional<Outcome>& outcome) {
                 ++counts[status_of(outcome)];
                 if (!outcome || outcome->code == run::done || ++number > max_named)
                   return;
                 const Variation& run = plan.runs[id - 1];
                 failed += fmt::format("  run {}{}{}: {}, exit code {}{}{}\n", id,
                                       words_of(run).empty() ? "" : ", ", words_of(run),
                                       outcome->status, outcome->code,
                                       outcome->message.empty() ? "" : ": ",
                                       outcome->message);
               });
  std::string text =
      fmt::format("{} runs of {}\n{}\n", plan.runs.size(),
                  plan.deck.empty() ? "scenes" : plan.deck, words_of(counts));
  text += failed;
  if (number > max_named)
    text += fmt::format("  and {} more; blocks report {} lists all\n",
                        number - max_named, run::shell_path(folder));
  if (counts.contains("open"))
    text += fmt::format("blocks sweep {} goes on with the open runs\n",
                        run::shell_path(folder));
  return text;
}

}  // namespace blocks::sweep
