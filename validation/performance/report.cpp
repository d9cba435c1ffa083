#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

namespace blocks::bench {
const Row* Report::find(const std::string& scene, const std::string& state,
                        const std::string& code, int threads) const {
  for (const Row& row : rows)
    if (row.scene == scene && row.state == state && row.code == code &&
        row.threads == threads)
      return &row;
  return nullptr;
}

void Report::note(const std::string& text) {
  if (std::find(notes.begin(), notes.end(), text) == notes.end())
    notes.push_back(text);
}

std::string grouped(long number) {
  std::string text = fmt::format("{}", number);
  for (int i = static_cast<int>(text.size()) - 3; i > 0; i -= 3)
    text.insert(static_cast<std::size_t>(i), ",");
  return text;
}

std::string short_number(double value) {
  return fmt::format("{:.{}f}", value, value < 10 ? 2 : value < 100 ? 1 : 0);
}

std::string in_words(const std::optional<Ratio>& ratio) {
  if (!ratio)
    return "";
  if (ratio->min == ratio->max)
    return short_number(ratio->middle);
  return fmt::format("{} ({} to {})", short_number(ratio->middle),
                     short_number(ratio->min), short_number(ratio->max));
}

std::string table_of(const Report& report, const std::string& part) {
  std::string text =
      fmt::format("\n## {}\n\n| scene | code | threads | ns | of one | million a "
                  "second | cost over "
                  "that of | ratio (range) |\n|---|---|---|---|---|---|---|---|\n",
                  part);
  for (const Row& row : report.rows)
    if (row.part == part)
      text +=
          fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.scene,
                      row.code, row.threads, short_number(row.cost), row.unit,
                      short_number(1e3 / row.cost), row.against, in_words(row.ratio));
  return text;
}

std::string table_of_targets(const Report& report) {
  if (report.targets.empty())
    return "";
  std::string text =
      "\n## targets\n\n| what | measured | target | |\n|---|---|---|---|\n";
  for (const Target& one : report.targets) {
    const double missing =
        one.at_least ? one.limit / one.measured : one.measured / one.limit;
    text += fmt::format(
        "| {} | {}{} | {} {}{} | {} |\n", one.what, short_number(one.measured),
        one.unit, one.at_least ? "at least" : "at most", one.limit, one.unit,
        one.met() ? "met"
                  : fmt::format("missed by a factor of {}", short_number(missing)));
  }
  return text;
}

nlohmann::json to_json(const Report& report) {
  nlohmann::json rows = nlohmann::json::array(), targets = nlohmann::json::array();
  for (const Row& row : report.rows) {
    nlohmann::json one = {{"part", row.part},       {"scene", row.scene},
                          {"code", row.code},       {"threads", row.threads},
                          {"blocks", row.blocks},   {"unit", row.unit},
                          {"nanoseconds", row.cost}};
    if (!row.state.empty())
      one["state"] = row.state;
    if (row.phases)
      one["phases"] = {{"decisions", row.phases->decisions},
                       {"forces", row.phases->forces},
                       {"motion", row.phases->motion},
                       {"search", row.phases->search}};
    if (row.ratio)
      one["ratio"] = {{"over", row.against},
                      {"median", row.ratio->middle},
                      {"least", row.ratio->min},
                      {"most", row.ratio->max}};
    rows.push_back(one);
  }
  for (const Target& one : report.targets)
    targets.push_back({{"what", one.what},
                       {"measured", one.measured},
                       {"limit", one.limit},
                       {"unit", one.unit},
                       {"at_least", one.at_least},
                       {"met", one.met()}});
  return {{"version", BLOCKS_VERSION},
          {"quick", report.quick},
          {"rounds", report.rounds},
          {"cores", std::thread::hardware_concurrency()},
          {"rows", rows},
          {"targets", targets},
          {"notes", report.notes}};
}

}  // namespace blocks::bench
