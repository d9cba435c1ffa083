#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "post/line_chart.hpp"

namespace blocks::bench {
namespace {

std::string number(double value) {
  return fmt::format("{:.{}f}", value, value < 10 ? 2 : value < 100 ? 1 : 0);
}

std::string in_words(const std::optional<Ratio>& ratio) {
  if (!ratio)
    return "";
  if (ratio->least == ratio->most)
    return number(ratio->middle);
  return fmt::format("{} ({} to {})", number(ratio->middle), number(ratio->least),
                     number(ratio->most));
}

std::string legend(const Row& row) {
  return row.threads == 1 ? row.code
                          : fmt::format("{}, {} threads", row.code, row.threads);
}

void add_point(post::ChartPanel& panel, const Row& row, double y) {
  const std::string name = legend(row);
  auto line = std::find_if(panel.lines.begin(), panel.lines.end(),
                           [&](const auto& one) { return one.legend == name; });
  if (line == panel.lines.end())
    line = panel.lines.insert(line, {name, {}, {}});
  line->x.push_back(std::log10(row.blocks));
  line->y.push_back(y);
}

}  // namespace

const Row* Report::find(const std::string& part, const std::string& scene,
                        const std::string& code) const {
  for (const Row& row : rows)
    if (row.part == part && row.scene == scene && row.code == code)
      return &row;
  return nullptr;
}

std::string grouped(long number) {
  std::string text = fmt::format("{}", number);
  for (int i = static_cast<int>(text.size()) - 3; i > 0; i -= 3)
    text.insert(static_cast<std::size_t>(i), ",");
  return text;
}

std::string table_of(const Report& report, const std::string& part) {
  std::string text =
      fmt::format("\n## {}\n\n| scene | code | threads | ns | of one | million a "
                  "second | cost over "
                  "that of | ratio (range) |\n|---|---|---|---|---|---|---|---|\n",
                  part);
  for (const Row& row : report.rows)
    if (row.part == part)
      text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |\n", row.scene,
                          row.code, row.threads, number(row.cost), row.unit,
                          number(1e3 / row.cost), row.against, in_words(row.ratio));
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
        "| {} | {}{} | {} {}{} | {} |\n", one.what, number(one.measured), one.unit,
        one.at_least ? "at least" : "at most", one.limit, one.unit,
        one.met() ? "met" : fmt::format("missed by a factor of {}", number(missing)));
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
    if (row.ratio)
      one["ratio"] = {{"over", row.against},
                      {"median", row.ratio->middle},
                      {"least", row.ratio->least},
                      {"most", row.ratio->most}};
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

bool draw(const Report& report, const std::string& path) {
  post::Chart chart{
      "Cost of a wall of bricks",
      "one step of one block; Box2D: one of the eight iterations of a step",
      "blocks, as a power of ten",
      {{"nanoseconds", {}}, {"cost over that of blocks", {}}}};
  for (const Row& row : report.rows)
    if (row.part == "wall") {
      add_point(chart.panels[0], row, row.cost);
      add_point(chart.panels[1], row,
                row.ratio && (row.against == "blocks" || row.threads > 1)
                    ? row.ratio->middle
                    : 1.0);
    }
  if (chart.panels[0].lines.empty() || chart.panels[0].lines.front().x.size() < 2)
    return false;
  post::draw_chart(path, chart, 1200);
  return true;
}

}  // namespace blocks::bench
