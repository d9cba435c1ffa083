// The command line of BLOCKS. Each command calls one function, and does no work here.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "apps/help/help_page.hpp"
#include "apps/help/wrong_word.hpp"
#include "apps/options/option_checks.hpp"
#include "bundled_fonts.hpp"
#include "cards_command.hpp"
#include "check_command.hpp"
#include "cracks_command.hpp"
#include "dynamics/kernels/kernels.hpp"
#include "export_command.hpp"
#include "files/file_access_guard.hpp"
#include "files/file_error.hpp"
#include "fos_command.hpp"
#include "geometry/numeric_environment.hpp"
#include "history_command.hpp"
#include "import_command.hpp"
#include "joints_command.hpp"
#include "manual_command.hpp"
#include "plot_command.hpp"
#include "report_command.hpp"
#include "run/run.hpp"
#include "standard_streams.hpp"
#include "study_command.hpp"
#include "sweep_command.hpp"
#include "view_command.hpp"
#include "why_command.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define BLOCKS_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define BLOCKS_SANITIZED
#endif
#endif

namespace blocks::apps {
namespace {

using run::RunOptions;

/// Reads an option --set.
deck::Override override_of(const std::string& text) {
  if (const auto override = deck::parse_override(text))
    return *override;
  throw CLI::ValidationError(
      "--set",
      "expected CARD.field=value or CARD[2].field=value, found '" + text + "'");
}

void add_set_option(CLI::App& command, std::vector<std::string>& sets) {
  command.add_option(
      "--set", sets,
      "CARD.field=value: replace a field of every such card, or "
      "CARD[2].field=value: of the second one; 'blocks cards --set DECK' "
      "lists what can be replaced");
}

void add_deck_options(CLI::App& command, RunOptions& options,
                      std::vector<std::string>& sets) {
  command.add_option("DECK", options.deck, "the deck, or - for standard input")
      ->required();
  command
      .add_option("--seed", options.seed,
                  "seed of the random layers; replaces that of the SEED card")
      ->check(seed_number());
  command.add_option("--tape9", options.tape9,
                     "mesh file for a READ9 card that names none");
  command.add_option("--restart", options.restart,
                     "continue from this checkpoint: this deck was stopped, or it "
                     "begins with RESTART");
  add_set_option(command, sets);
  command.add_flag("-q,--quiet", options.quiet, "print errors and warnings only");
  command.add_flag("-v,--verbose", options.verbose,
                   "print details of blocks and layers");
}

/// Returns the number 5 of `blocks run --audit 5 DECK`, which should be --audit=5.
/// Returns an empty text if there is no such number.
std::string astray_from_audit(const CLI::App& app) {
  const CLI::App* run = app.get_subcommand("run");
  if (!run->parsed() || run->count("--audit") == 0)
    return {};
  std::vector<std::string> words = run->remaining();
  if (run->count("DECK") > 0)
    words.push_back(run->get_option("DECK")->results().front());
  const auto number =
      std::find_if(words.begin(), words.end(), [](const std::string& word) {
        return word.find_first_not_of("0123456789") == std::string::npos;
      });
  return number == words.end() ? std::string() : *number;
}

/// Returns the message for an error of the command line, in the form of all other
/// messages.
std::string tell_usage_fault(const CLI::App* app, const CLI::Error& error) {
  std::string command = "blocks";
  for (auto named = app->get_subcommands(); !named.empty();
       named = named.front()->get_subcommands())
    command += ' ' + named.front()->get_name();
  if (const std::string every = astray_from_audit(*app); !every.empty())
    return fmt::format(
        "blocks: error: {0}\n  hint: write --audit={1} to audit every {1} steps\n",
        error.what(), every);
  return fmt::format("blocks: error: {}\n  hint: {} --help shows what is possible\n",
                     error.what(), command);
}

/// The options of run and fos.
void add_run_options(CLI::App& command, RunOptions& options,
                     std::vector<std::string>& sets) {
  add_deck_options(command, options, sets);
  command
      .add_option("-o,--output", options.output,
                  "output NAME, or FOLDER/; a missing folder is created (default: the "
                  "deck's name without extension, in this folder)")
      ->type_name("NAME");
  command
      .add_option("--time-limit", options.time_limit,
                  "stop after this many seconds, exit 75")
      ->check(positive_number());
  command
      .add_option("--stop-after", options.stop_after,
                  "stop after this many steps, exit 75")
      ->check(CLI::Range(1L, std::numeric_limits<long>::max()));
  command
      .add_option("--checkpoint-every", options.checkpoint_every,
                  "seconds between checkpoints (default: 600)")
      ->check(positive_number());
  command
      .add_option("-j,--threads", options.threads,
                  "number of threads (default: all cores); does not change results")
      ->check(CLI::Range(1, 1024));
  command
      .add_option("--trials", options.trials_at_once,
                  "trials of FOS that run at once (default: as many as threads); does "
                  "not change results")
      ->check(CLI::Range(1, 1024));
  command.add_flag("--profile", options.profile,
                   "print at the end how long each part of the program took");
  command.add_flag("--json", options.json,
                   "print the summary as JSON instead of the table");
}

/// Returns the words of the command line, with -.5 as -0.5, which is no option.
std::vector<std::string> words_of(int argc, char** argv) {
  std::vector<std::string> words(argv, argv + argc);
  for (std::string& word : words)
    if (word.size() > 2 && word.starts_with("-.") && word[2] >= '0' && word[2] <= '9')
      word.insert(1, "0");
  return words;
}

/// The commands whose options nothing else needs, and what each of them does.
class Commands {
 public:
  /// Adds a command to the program or to another command. If it is given, perform()
  /// calls act(options) with the options that add_options() adds.
  template <class Options, class Act>
  CLI::App& add(CLI::App& parent, const char* name, const char* description,
                void (*add_options)(CLI::App&, Options&), const Act& act) {
    CLI::App& command = *parent.add_subcommand(name, description);
    const auto options = std::make_shared<Options>();
    add_options(command, *options);
    all_.push_back({&command, [options, act] { return act(*options); }});
    return command;
  }
  /// Performs the command that is given, and returns its exit code; nullopt if none of
  /// these is given.
  std::optional<int> perform() const {
    for (const auto& [command, act] : all_)
      if (command->parsed())
        return act();
    return std::nullopt;
  }

 private:
  std::vector<std::pair<const CLI::App*, std::function<int()>>> all_;
};

/// Tells that `blocks study` needs the name of a study. Returns the exit code.
int tell_no_study(const std::vector<std::string>& extras) {
  fmt::print(stderr,
             "blocks: error: {}\n  hint: blocks study contacts SCENE; "
             "blocks study contacts --list\n",
             extras.empty() ? "the name of the study is missing"
                            : "there is no study '" + extras.front() +
                                  "'; the only one is contacts");
  return run::usage_error;
}

int dispatch(std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  const int argc = static_cast<int>(pointers.size());
  char** const argv = pointers.data();
  CLI::App app("BLOCKS computes how jointed rock moves, as polygonal blocks in two "
               "dimensions. A deck of cards describes the problem.");
  app.formatter(std::make_shared<HelpPage>());
  app.set_version_flag("--version", "blocks " BLOCKS_VERSION);
  app.require_subcommand(1);

  RunOptions options;
  std::vector<std::string> sets;
  auto* run = app.add_subcommand("run", "run a deck");
  add_run_options(*run, options, sets);
  run->add_option("--until", options.until,
                  "end the run at this time of the deck; with --restart, continue a "
                  "finished or stopped run to this later time")
      ->check(positive_number());
  run->add_flag("--audit{100}", options.audit_every,
                "check the contacts by exact brute force, every 100 steps or, with "
                "--audit=N, every N; exit 4 if a decision is wrong")
      ->check(whole_steps());

  auto* fos = app.add_subcommand("fos", "find the factor of safety of a deck");
  add_run_options(*fos, options, sets);
  FosOptions fos_options;
  add_fos_options(*fos, fos_options);

  auto* check_deck =
      app.add_subcommand("check", "check a deck and its blocks without running it");
  add_deck_options(*check_deck, options, sets);
  check_deck
      ->add_option("-o,--output", options.output, "output NAME, to find NAME.ckpt.h5")
      ->type_name("NAME");
  GeometryOptions geometry_options;
  add_geometry_options(*check_deck, geometry_options);

  Commands commands;
  commands.add(app, "cards", "describe the cards of a deck", add_cards_options, cards);
  commands.add(app, "plot", "draw figures and movies of a run", add_plot_options, plot);
  commands.add(app, "history", "plot quantities against time or position",
               add_history_options, history);
  commands.add(app, "cracks", "list the blocks that have split", add_cracks_options,
               cracks);
  commands.add(app, "view", "write a page that plays a run in the browser",
               add_view_options, view);
  commands.add(app, "report", "write the statistics of a sweep as a page",
               add_report_options, report);
  commands.add(app, "import", "convert outlines of other programs for READ9",
               add_import_options, import_blocks);
  // Calls a command whose input is a deck or a map, with the options --set.
  const auto with_overrides = [&options](auto act) {
    return [&options, act](auto& given) {
      given.input.overrides = options.overrides;
      return act(given);
    };
  };
  add_set_option(commands.add(app, "export",
                              "write blocks and results for other programs",
                              add_export_options, with_overrides(export_blocks)),
                 sets);
  auto* joints = app.add_subcommand("joints", "describe maps of fracture traces");
  joints->require_subcommand(1);
  add_set_option(commands.add(*joints, "statistics", "measure maps of fracture traces",
                              add_joint_statistics_options,
                              with_overrides(joint_statistics)),
                 sets);
  add_set_option(commands.add(*joints, "fit", "propose joint sets for a map, as a deck",
                              add_joint_fit_options, with_overrides(fit_joints)),
                 sets);
  auto* study = app.add_subcommand("study", "measure how robust contact detection is");
  commands.add(*study, "contacts", "compare variants of the contact rules",
               add_study_options, study_contacts);
  commands.add(app, "why", "explain why two blocks touch or do not", add_why_options,
               why);
  commands.add(app, "sweep", "run a deck many times", add_sweep_options, sweep);
  commands.add(app, "manual", "print man pages and bash completion", add_manual_options,
               [&app](const ManualOptions& given) { return manual(app, given); });

  // Commands inherit the footer that the program has when they are added.
  app.footer("Exit codes: 0 done, 1 internal error, 2 usage error, 3 deck or geometry "
             "error, 4 unsound run, 5 file error, 75 stopped at a limit of time or "
             "steps, 130 interrupted.");
  study->allow_extras();
  app.failure_message(tell_usage_fault);
  app.name("blocks");
  try {
    app.parse(argc, argv);
    if (std::find(argv, argv + argc, std::string("--audit=")) != argv + argc)
      throw CLI::ValidationError("--audit: a number of steps is missing after =");
    for (const std::string& text : sets)
      options.overrides.push_back(override_of(text));
  } catch (const CLI::ParseError& error) {
    const bool is_fault = error.get_exit_code() != 0;
    if (is_fault && astray_from_audit(app).empty())
      if (const std::string fault = tell_wrong_word(app, argc, argv); !fault.empty()) {
        std::cerr << fault << std::flush;
        return run::usage_error;
      }
    return app.exit(error) == 0 ? run::done : run::usage_error;
  }

  if (*run) {
    outlive_broken_pipes();
    options.ends_process = true;
    return run::run_deck(options);
  }
  if (*fos) {
    outlive_broken_pipes();
    return find_factor_of_safety(options, fos_options);
  }
  if (*check_deck)
    return check(options, geometry_options);
  const std::optional<int> code = commands.perform();
  return code ? *code : tell_no_study(study->remaining());
}

/// Does not use fmt::print, which throws if standard error cannot be written.
void tell(const char* kind, const char* what) {
  std::fprintf(stderr, "blocks: %s: %s\n", kind, what);
}

int tell_no_memory() {
  tell("error", "there is not enough memory for this problem");
  return run::internal_error;
}

/// Handles std::terminate. Memory can run out in a destructor; the files are complete
/// even then.
[[noreturn]] void end_at_once() {
  try {
    if (const auto thrown = std::current_exception())
      std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    std::_Exit(tell_no_memory());
  } catch (...) {
  }
  std::abort();
}

}  // namespace
}  // namespace blocks::apps

int main(int argc, char** argv) {
  using namespace blocks;
  using namespace blocks::apps;
  hold_standard_streams();
  if (const std::string fault = geometry::check_numeric_environment(); !fault.empty()) {
    tell("error", fault.c_str());
    return run::internal_error;
  }
  std::set_terminate(end_at_once);
  use_bundled_fonts();
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file size is an error like a full disk
#if !defined(BLOCKS_SANITIZED)    // a sanitizer reports more
  files::tell_crashes_of_files(run::file_error);
#endif
  try {
    dynamics::kernels();
  } catch (const std::invalid_argument& error) {
    tell("error", error.what());
    return run::usage_error;
  }
  try {
    return end_standard_output(dispatch(words_of(argc, argv)));
  } catch (const files::FileError& error) {
    tell("error", error.what());
    return run::file_error;
  } catch (const std::bad_alloc&) {
    return tell_no_memory();
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) == 0 && std::ferror(stderr) == 0) {
      tell("internal error", error.what());
      return run::internal_error;
    }
    tell("error",
         ("cannot write to the terminal or pipe: " + error.code().message()).c_str());
    return run::file_error;
  } catch (const std::exception& error) {
    tell("internal error", error.what());
    return run::internal_error;
  }
}
