#include "sweep/make_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <variant>

#include "deck/free_field.hpp"
#include "files/file_error.hpp"
#include "run/run.hpp"
#include "run/support/deck_file.hpp"

namespace blocks::sweep {
namespace {

namespace fs = std::filesystem;

/// Reads a file that the command line names. Throws files::FileError with a hint.
std::string read(const std::string& path) {
  try {
    return run::read_deck(path);
  } catch (const files::FileError& fault) {
    throw files::FileError(
        fmt::format("{}\n  hint: name a file that exists; the path is relative to {}",
                    fault.what(), fs::current_path().string()));
  }
}

/// The plan is JSON, so its texts have to be UTF-8. Throws AxisFault.
void expect_utf8(const std::string& what, const std::string& text) {
  if (!deck::is_utf8(text))
    throw AxisFault(what + " is not in UTF-8", "convert it, for example with iconv");
}

std::vector<Variation> runs_of(const Request& request) {
  std::vector<Variation> rows;
  if (!request.table.empty()) {
    const std::string table = read(request.table);
    expect_utf8("the table of parameters", table);
    rows = parse_table(table);
  }
  std::vector<Axis> axes;
  for (const std::string& set : request.sets) {
    expect_utf8("the text of --set", set);
    axes.push_back(parse_axis(set));
  }
  const auto seeds =
      request.seeds.empty() ? std::vector<std::uint64_t>{} : parse_seeds(request.seeds);
  return combine(rows, axes, seeds);
}

/// Returns what all runs of a Sobol design have. Throws AxisFault if runs are to differ
/// by anything else.
Variation common_of(const Request& request) {
  if (!request.table.empty())
    throw AxisFault("--table and --sobol are two ways to choose the runs",
                    "give one of them");
  Request others = request;
  others.sobol.clear();
  const std::vector<Variation> runs = runs_of(others);
  if (runs.size() > 1)
    throw AxisFault("with --sobol, --set and --seeds take one value each",
                    "name further parameters in --sobol, or make a sweep for each "
                    "value");
  return runs.front();
}

SobolDesign design_of(const Request& request, const Variation& common) {
  SobolDesign design;
  expect_utf8("the text of --sobol", request.sobol);
  design.ranges = parse_sobol(request.sobol);
  if (request.rows < 2)
    throw AxisFault(request.rows == 0 ? "--sobol needs the number of its rows, -n"
                                      : "one row is too few for Sobol indices",
                    "for example -n 256; a power of 2 is best");
  design.rows = request.rows;
  design.seed = common.seed.value_or(0);
  return design;
}

/// Sets the runs, and returns those with which the deck is to be parsed first.
std::vector<Variation> choose_runs(const Request& request, Plan& plan) {
  if (request.sobol.empty()) {
    plan.runs = runs_of(request);
    return plan.runs;
  }
  const Variation common = common_of(request);
  plan.sobol = design_of(request, common);
  plan.runs = sobol_runs(*plan.sobol, common);
  return sobol_corners(*plan.sobol, common);
}

/// Parses the deck once with each value that some run sets, and prints the errors of
/// the first one that has any. Returns whether there were none.
bool can_set_all(const Plan& plan, const std::string& text,
                 const std::vector<Variation>& runs) {
  std::set<std::string> known;
  for (const Variation& run : runs) {
    std::vector<std::string> fresh;
    std::copy_if(run.sets.begin(), run.sets.end(), std::back_inserter(fresh),
                 [&](const std::string& set) { return !known.contains(set); });
    if (fresh.empty())
      continue;
    deck::Diagnostics diagnostics(plan.deck, text);
    deck::parse(plan.deck, text, diagnostics, overrides_of(run));
    if (diagnostics.has_errors()) {
      fmt::print(stderr, "{}", diagnostics.format_all());
      return false;
    }
    known.insert(fresh.begin(), fresh.end());
  }
  return true;
}

/// Whether the joints of a group depend on the seed.
bool has_random_joints(const deck::Cut& cut) {
  const auto is_random = [](const auto& card) {
    if constexpr (std::is_same_v<std::decay_t<decltype(card)>, deck::Jset>)
      return card.law.value != "UNIFORM" || card.trace.value.value() > 0.0 ||
             card.ddev.value.value() > 0.0 || card.sdev.value.value() > 0.0;
    else if constexpr (std::is_same_v<std::decay_t<decltype(card)>, deck::Voronoi>)
      return !card.file.given;
    else
      return false;
  };
  return std::any_of(cut.joints.begin(), cut.joints.end(),
                     [&](const auto& card) { return std::visit(is_random, card); });
}

/// Whether seeds make runs differ.
bool has_random_blocks(const std::string& path, const std::string& text) {
  deck::Diagnostics ignored(path, text);
  const deck::Deck deck = deck::parse(path, text, ignored);
  return std::any_of(deck.commands.begin(), deck.commands.end(),
                     [](const auto& command) {
                       const auto* layer = std::get_if<deck::Layer>(&command.card);
                       const auto* cut = std::get_if<deck::Cut>(&command.card);
                       return (layer != nullptr && layer->rcommand.given) ||
                              (cut != nullptr && has_random_joints(*cut));
                     });
}

int check_first_run(const Plan& plan) {
  run::RunOptions options;
  options.deck = plan.deck;
  options.seed = plan.runs.front().seed;
  options.overrides = overrides_of(plan.runs.front());
  options.until = plan.until;
  return run::build_checked(options).code;
}

}  // namespace

Plan make_plan(const Request& request, int& code) {
  code = run::done;
  if (request.deck == "-")
    throw files::FileError(
        "a sweep reads its deck again in every run, so it cannot be standard input\n  "
        "hint: write the deck to a file");
  Plan plan;
  plan.kind = request.kind;
  const std::string text = read(request.deck);
  plan.deck = fs::canonical(request.deck).string();
  expect_utf8("the path of the deck", plan.deck);
  plan.deck_hash = hash_of_deck(plan.deck);
  plan.name = fs::path(plan.deck).stem().string();
  plan.version = BLOCKS_VERSION;
  plan.numerics = numerics();
  plan.until = request.until;
  plan.audit_every = request.audit_every;
  const std::vector<Variation> tried = choose_runs(request, plan);
  plan.axes = axes_of(plan.runs.front());
  if (!can_set_all(plan, text, tried)) {
    code = run::deck_error;
    return plan;
  }
  code = check_first_run(plan);
  const bool many_seeds =
      std::any_of(plan.runs.begin(), plan.runs.end(),
                  [&](const auto& run) { return run.seed != plan.runs.front().seed; });
  if (code == run::done && many_seeds && !has_random_blocks(plan.deck, text))
    fmt::print(stderr,
               "blocks: warning: the deck has no random blocks, so all seeds give the "
               "same run\n  hint: RANDOM on a LAYER card makes its widths random\n");
  return plan;
}

}  // namespace blocks::sweep
