#include "run/safety/safety_search.hpp"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace blocks::run {
namespace {

int last_search(const Model& model) {
  return static_cast<int>(model.safety_factors.size()) - 1;
}

}  // namespace

SafetyFactor begin_search(const deck::Fos& card, int line) {
  return {.line = line,
          .width = card.width.value,
          .lower = card.lower.given ? card.lower.value : 0.0,
          .upper = card.upper.given ? card.upper.value : 0.0};
}

bool set_limits(SafetyFactor& record, const Model& base, const deck::Fos& card,
                int threads, const GiveUp& give_up) {
  constexpr long responses = 500, fewest = 2000;
  const long max = card.max_steps();
  const long response = response_steps(base, max, threads, give_up);
  if (give_up())
    return false;
  record.response = response;
  record.max_steps =
      card.ncycle.given ? max : std::clamp(responses * record.response, fewest, max);
  return true;
}

void record_trial(Model& model, SafetyTrial trial) {
  trial.search = last_search(model);
  model.safety_trials.push_back(trial);
}

std::vector<SafetyTrial> trials_of_last(const Model& model) {
  return trials_of(model.safety_trials, last_search(model));
}

void forget_last_search(Model& model) {
  std::erase_if(model.safety_trials, [last = last_search(model)](const auto& trial) {
    return trial.search == last;
  });
  model.safety_factors.pop_back();
}

Model state_before_last(const Model& model) {
  Model base = model;
  forget_last_search(base);
  return base;
}

SafetySearch::SafetySearch(const Model& base, const SafetyFactor& card,
                           const deck::Solve& wanted, int threads, int at_once,
                           GiveUp give_up)
    : base_(base), card_(card), wanted_(wanted),
      threads_(std::max(1, threads / std::max(1, at_once))),
      at_once_(static_cast<std::size_t>(std::max(1, at_once))),
      give_up_(std::move(give_up)) {}

SafetySearch::~SafetySearch() {
  for (auto& [factor, running] : running_)
    *running.unneeded = true;
}

void SafetySearch::start(double factor) {
  auto unneeded = std::make_shared<std::atomic<bool>>(false);
  auto run = [this, factor, unneeded] {
    return run_trial(base_, factor, card_, wanted_, threads_,
                     [this, unneeded] { return *unneeded || give_up_(); });
  };
  running_.emplace(factor, Running{unneeded, std::async(std::launch::async, run)});
}

std::optional<TrialResult> SafetySearch::next(std::span<const SafetyTrial> trials,
                                              const std::function<void()>& idle) {
  const std::vector<double> needed = possible_factors(card_, trials, at_once_);
  if (needed.empty())
    return std::nullopt;
  for (auto& [factor, running] : running_)
    if (std::find(needed.begin(), needed.end(), factor) == needed.end())
      *running.unneeded = true;
  // The destructor of a future waits for the thread, which gives up at its next test.
  std::erase_if(running_,
                [](const auto& entry) { return entry.second.unneeded->load(); });
  for (const double factor : needed)
    if (!running_.contains(factor))
      start(factor);
  auto first = running_.extract(needed.front());
  Running& running = first.mapped();
  constexpr std::chrono::milliseconds now_and_then(50);
  try {
    while (idle && running.result.wait_for(now_and_then) != std::future_status::ready)
      idle();
  } catch (...) {
    *running.unneeded = true;
    throw;
  }
  return running.result.get();
}

}  // namespace blocks::run
