#include "why_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string_view>

#include "apps/help/option_text.hpp"
#include "audit/make_exact_rule.hpp"
#include "run/run.hpp"
#include "text/number.hpp"
#include "why/report.hpp"

namespace blocks::apps {
namespace {

/// Prints the error and the lines of the hint, which are broken at 100 columns.
int refuse(const std::string& message, const std::string& hint) {
  constexpr std::size_t columns = 100;
  constexpr std::string_view first = "  hint: ", later = "        ";
  fmt::print(stderr, "blocks: error: {}\n", message);
  std::istringstream parts(hint);
  std::string_view before = first;
  for (std::string part; std::getline(parts, part);) {
    std::istringstream lines(wrapped(part, columns - first.size()));
    for (std::string line; std::getline(lines, line); before = later)
      fmt::print(stderr, "{}{}\n", before, line);
  }
  return run::usage_error;
}

constexpr std::size_t max_named = 12;

/// Lists the first names and counts the rest: "0, 0.5, 1 and 7 more".
template <class List, class Name> std::string some(const List& list, Name name) {
  std::string text;
  std::size_t named = 0;
  for (const auto& one : list) {
    if (named == max_named)
      return text + fmt::format(" and {} more", list.size() - named);
    text += (named++ == 0 ? "" : ", ") + name(one);
  }
  return text;
}

/// Lists the neighbours of a block by bounding boxes: "near block 3: 1 (in contact),
/// 2".
std::string neighbours(const audit::ExactPairRule& rule, int block) {
  const std::vector<int>& near = rule.neighbours(block);
  if (near.empty())
    return fmt::format("no block is near block {}", block + 1);
  return fmt::format("near block {}: {}", block + 1, some(near, [&](int other) {
                       const bool touches = !rule.decide(block, other).contacts.empty();
                       return fmt::format("{}{}", other + 1,
                                          touches ? " (in contact)" : "");
                     }));
}

}  // namespace

void add_why_options(CLI::App& command, WhyOptions& options) {
  command
      .add_option("FILE", options.file,
                  "results, NAME.vtkhdf, or a checkpoint, NAME.ckpt.h5")
      ->required();
  command.add_option("-t,--time", options.time,
                     "time; the nearest frame is used (default: the last frame)");
  command
      .add_option("-b,--block", options.blocks,
                  "number of a block; give it twice, once for each")
      ->allow_extra_args(false);
  command.add_flag("--json", options.json, "print the answer as one JSON object");
}

namespace {

std::string times_held(const why::Scene& scene) {
  const auto [first, last] =
      std::minmax_element(scene.times.begin(), scene.times.end());
  if (scene.times.size() == 1)
    return fmt::format("it holds the state at time {:.9g} only", *first);
  return fmt::format(
      "it holds {} frames from time {:.9g} to {:.9g}: {}", scene.times.size(), *first,
      *last, some(scene.times, [](double t) { return fmt::format("{:g}", t); }));
}

bool within(const why::Scene& scene, double time) {
  const auto [first, last] =
      std::minmax_element(scene.times.begin(), scene.times.end());
  const double grace = 1e-9 * std::abs(*last);  // times are printed with few digits
  return *first - grace <= time && time <= *last + grace;
}

/// Reports that the block does not exist, which blocks do, and when it will.
int refuse_block(const WhyOptions& options, const why::Scene& scene,
                 const std::string& name) {
  const int count = scene.blocks.size();
  const std::string there = count == 0 ? "it has no blocks at that time"
                                       : fmt::format("its blocks are 1 to {}", count);
  const std::optional<int> block = text::number_of<int>(name);
  if (!block)
    return refuse(
        fmt::format("'{}' is not the number of a block of {}", name, options.file),
        there);
  const auto begins = *block > count ? why::first_time_with(options.file, *block)
                                     : std::optional<double>();
  return refuse(fmt::format("there is no block {} in {} at time {:g}", *block,
                            options.file, scene.time),
                begins ? fmt::format("it exists from time {:.9g} on; before that, {}",
                                     *begins, there)
                       : there);
}

}  // namespace

int why(const WhyOptions& options) {
  const std::optional<double> time =
      options.time ? text::number_of<double>(*options.time) : std::optional<double>();
  const why::Scene scene = why::read_scene(options.file, time);
  if (options.time && !(time && within(scene, *time)))
    return refuse(time ? fmt::format("time {:g} is outside of {}", *time, options.file)
                       : fmt::format("'{}' is not a time", *options.time),
                  times_held(scene));
  const Blocks& blocks = scene.blocks;
  std::vector<int> chosen;
  for (const std::string& name : options.blocks) {
    const std::optional<int> block = text::number_of<int>(name);
    if (!block || *block < 1 || *block > blocks.size())
      return refuse_block(options, scene, name);
    if (blocks.is_removed(*block - 1))
      return refuse(
          fmt::format("block {} is removed at time {:g}, so it has no contacts", *block,
                      scene.time),
          why::removal_text(options.file, *block - 1));
    chosen.push_back(*block);
  }

  // Blocks are near if they are within a tenth of the size of the smaller block.
  double reach = std::numeric_limits<double>::infinity();
  for (const int block : chosen)
    reach = std::min(reach, 0.1 * std::sqrt(blocks.area[block - 1]));
  const bool two = chosen.size() == 2 && chosen[0] != chosen[1];
  const std::string what = "a contact has two blocks: --block I --block J";
  if (chosen.empty())
    return refuse(
        what, fmt::format("the blocks of {} are 1 to {}", options.file, blocks.size()));
  const audit::ExactPairRule rule = audit::make_exact_rule(blocks, reach, scene.order);
  if (!two)
    return refuse(what, neighbours(rule, chosen[0] - 1));
  const int i = chosen[0] - 1, j = chosen[1] - 1;
  const std::string beside = neighbours(rule, i) + "; " + neighbours(rule, j);
  if (!blocks.may_touch(i, j))
    return refuse(
        fmt::format("blocks {} and {} are both fixed: there is no contact between them",
                    i + 1, j + 1),
        beside);
  const std::vector<int>& near = rule.neighbours(i);
  const bool touched =
      std::any_of(scene.contacts.begin(), scene.contacts.end(),
                  [&](const why::RememberedContact& one) {
                    return std::minmax({blocks.corner_block[one.corner],
                                        blocks.corner_block[one.edge]}) ==
                           std::pair(std::min(i, j), std::max(i, j));
                  });  // a bond may reach farther
  if (!touched && std::find(near.begin(), near.end(), j) == near.end())
    return refuse(fmt::format("blocks {} and {} are not near each other at time {:g}",
                              i + 1, j + 1, scene.time),
                  fmt::format("{}\ntheir bounding boxes are more than {:.6g} apart",
                              beside, reach));
  why::Report report = why::explain(rule, std::min(i, j), std::max(i, j));
  report.file = options.file;
  report.requested = time;
  fmt::print("{}", options.json ? why::json(report, scene, rule)
                                : why::text(report, scene, rule));
  return run::done;
}

}  // namespace blocks::apps
