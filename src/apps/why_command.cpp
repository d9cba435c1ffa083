#include "why_command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <map>

#include "run/run.hpp"
#include "why_report.hpp"

namespace blocks::apps {
namespace {

int refuse(const std::string& message, const std::string& hint) {
  fmt::print(stderr, "blocks: error: {}\n  hint: {}\n", message, hint);
  return run::usage_error;
}

constexpr std::size_t most_named = 12;

/// "0, 0.5, 1, ... and 7 more".
template <class List, class Name> std::string some(const List& list, Name name) {
  std::string text;
  std::size_t named = 0;
  for (const auto& one : list) {
    if (named == most_named)
      return text + fmt::format(" and {} more", list.size() - named);
    text += (named++ == 0 ? "" : ", ") + name(one);
  }
  return text;
}

/// Blocks with a corner near this one, or near its corners, and whether they touch it.
std::string neighbours(const audit::ExactRules& rules, int block) {
  const Blocks& blocks = rules.blocks();
  std::map<int, bool> touching;
  for (int c = 0; c < blocks.corners(); ++c)
    for (const int b : rules.near(c)) {
      const int own = blocks.corner_block[c];
      if (own != block && b != block)
        continue;
      bool& touches = touching[own == block ? b : own];
      touches = touches || rules.decide(c, b).acting >= 0;
    }
  if (touching.empty())
    return fmt::format("no block is near block {}", block + 1);
  return fmt::format(
      "near block {}: {}", block + 1, some(touching, [](const auto& one) {
        return fmt::format("{}{}", one.first + 1, one.second ? " (in contact)" : "");
      }));
}

}  // namespace

void add_why_options(CLI::App& command, WhyOptions& options) {
  command
      .add_option("FILE", options.file,
                  "results, NAME.vtkhdf, or a checkpoint, NAME.ckpt.h5")
      ->required();
  command.add_option("-t,--time", options.time,
                     "time of the frame, the nearest one is taken (default: the last)");
  command
      .add_option("-b,--block", options.blocks,
                  "number of a block; give it twice, once for each")
      ->allow_extra_args(false);
  command.add_flag("--json", options.json, "the answer as one JSON object");
}

int why(const WhyOptions& options) {
  const WhyScene scene = read_scene(options.file, options.time);
  const Blocks& blocks = scene.blocks;
  const auto [first, last] =
      std::minmax_element(scene.times.begin(), scene.times.end());
  if (const double grace = 1e-9 * std::abs(*last);  // as times are printed
      options.time &&
      !(*options.time >= *first - grace && *options.time <= *last + grace))
    return refuse(
        fmt::format("time {:g} is outside of {}", *options.time, options.file),
        scene.times.size() == 1
            ? fmt::format("it holds the state at time {:.9g} only", *first)
            : fmt::format(
                  "it holds {} frames from time {:.9g} to {:.9g}: {}",
                  scene.times.size(), *first, *last,
                  some(scene.times, [](double t) { return fmt::format("{:g}", t); })));
  for (const int block : options.blocks)
    if (block < 1 || block > blocks.size())
      return refuse(fmt::format("there is no block {} in {} at time {:g}", block,
                                options.file, scene.time),
                    fmt::format("its blocks are 1 to {}", blocks.size()));

  double reach = scene.reach;
  if (reach == 0.0)  // a tenth of the size of the smaller of the two
    for (const int block : options.blocks) {
      const double size = 0.1 * std::sqrt(blocks.area[block - 1]);
      reach = reach == 0.0 ? size : std::min(reach, size);
    }
  const audit::ExactRules rules(blocks, reach);
  if (options.blocks.size() != 2 || options.blocks[0] == options.blocks[1]) {
    const std::string what = "a contact has two blocks: --block I --block J";
    return refuse(what, options.blocks.empty()
                            ? fmt::format("the blocks of {} are 1 to {}", options.file,
                                          blocks.size())
                            : neighbours(rules, options.blocks[0] - 1));
  }
  const int i = options.blocks[0] - 1, j = options.blocks[1] - 1;
  WhyReport report = why(scene, rules, i, j);
  report.file = options.file;
  report.asked = options.time;
  if (report.decisions.empty()) {
    if (!blocks.is_free(i) && !blocks.is_free(j))
      return refuse(fmt::format("blocks {} and {} are both fixed: there is no contact "
                                "between them",
                                i + 1, j + 1),
                    neighbours(rules, i) + "; " + neighbours(rules, j));
    return refuse(
        fmt::format("blocks {} and {} have no corner near each other at time {:g}{}",
                    i + 1, j + 1, scene.time,
                    report.overlap ? fmt::format(", though they overlap by {:.6g}",
                                                 report.overlap->depth)
                                   : std::string()),
        neighbours(rules, i) + "; " + neighbours(rules, j));
  }
  fmt::print("{}",
             options.json ? json(report, scene, rules) : text(report, scene, rules));
  return run::done;
}

}  // namespace blocks::apps
