// The command line of BLOCKS. Each command calls one function, and does no work here.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "bundled_fonts.hpp"
#include "cards_command.hpp"
#include "check_command.hpp"
#include "cracks_command.hpp"
#include "dynamics/kernels/kernels.hpp"
#include "export_command.hpp"
#include "fos_command.hpp"
#include "geometry/numeric_environment.hpp"
#include "help_page.hpp"
#include "history_command.hpp"
#include "import_command.hpp"
#include "joints_command.hpp"
#include "manual_command.hpp"
#include "option_checks.hpp"
#include "output/file_access_guard.hpp"
#include "output/results.hpp"
#include "plot_command.hpp"
#include "report_command.hpp"
#include "run/run.hpp"
#include "standard_streams.hpp"
#include "study_command.hpp"
#include "sweep_command.hpp"
#include "view_command.hpp"
#include "why_command.hpp"
#include "wrong_word.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define BLOCKS_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define BLOCKS_SANITIZED
#endif
#endif

namespace {

using blocks::run::RunOptions;

/// Reads an option --set.
blocks::deck::Override override_of(const std::string& text) {
  if (const auto override = blocks::deck::parse_override(text))
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
      ->check(blocks::apps::seed_number());
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
      ->check(blocks::apps::positive_number());
  command
      .add_option("--stop-after", options.stop_after,
                  "stop after this many steps, exit 75")
      ->check(CLI::Range(1L, std::numeric_limits<long>::max()));
  command
      .add_option("--checkpoint-every", options.checkpoint_every,
                  "seconds between checkpoints (default: 600)")
      ->check(blocks::apps::positive_number());
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

int dispatch(std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words)
    pointers.push_back(word.data());
  const int argc = static_cast<int>(pointers.size());
  char** const argv = pointers.data();
  CLI::App app("BLOCKS computes how jointed rock moves, as polygonal blocks in two "
               "dimensions. A deck of cards describes the problem.");
  app.formatter(std::make_shared<blocks::apps::HelpPage>());
  app.set_version_flag("--version", "blocks " BLOCKS_VERSION);
  app.require_subcommand(1);

  RunOptions options;
  std::vector<std::string> sets;
  auto* run = app.add_subcommand("run", "run a deck");
  add_run_options(*run, options, sets);
  run->add_option("--until", options.until,
                  "end the run at this time of the deck; with --restart, continue a "
                  "finished or stopped run to this later time")
      ->check(blocks::apps::positive_number());
  run->add_flag("--audit{100}", options.audit_every,
                "check the contacts by exact brute force, every 100 steps or, with "
                "--audit=N, every N; exit 4 if a decision is wrong")
      ->check(blocks::apps::whole_steps());

  blocks::apps::FosOptions fos_options;
  auto* fos = app.add_subcommand("fos", "find the factor of safety of a deck");
  add_run_options(*fos, options, sets);
  blocks::apps::add_fos_options(*fos, fos_options);

  auto* check =
      app.add_subcommand("check", "check a deck and its blocks without running it");
  add_deck_options(*check, options, sets);
  check->add_option("-o,--output", options.output, "output NAME, to find NAME.ckpt.h5")
      ->type_name("NAME");
  blocks::apps::GeometryOptions geometry_options;
  blocks::apps::add_geometry_options(*check, geometry_options);

  blocks::apps::CardsOptions cards_options;
  auto* reference = app.add_subcommand("cards", "describe the cards of a deck");
  blocks::apps::add_cards_options(*reference, cards_options);

  blocks::apps::PlotOptions plot_options;
  auto* plot = app.add_subcommand("plot", "draw figures and movies of a run");
  blocks::apps::add_plot_options(*plot, plot_options);

  blocks::apps::HistoryOptions history_options;
  auto* in_time =
      app.add_subcommand("history", "plot quantities against time or position");
  blocks::apps::add_history_options(*in_time, history_options);

  blocks::apps::CracksOptions cracks_options;
  auto* record = app.add_subcommand("cracks", "list the blocks that have split");
  blocks::apps::add_cracks_options(*record, cracks_options);

  blocks::apps::ViewOptions view_options;
  auto* page =
      app.add_subcommand("view", "write a page that plays a run in the browser");
  blocks::apps::add_view_options(*page, view_options);

  blocks::apps::ReportOptions report_options;
  auto* statistics =
      app.add_subcommand("report", "write the statistics of a sweep as a page");
  blocks::apps::add_report_options(*statistics, report_options);

  blocks::apps::ImportOptions import_options;
  auto* import =
      app.add_subcommand("import", "convert outlines of other programs for READ9");
  blocks::apps::add_import_options(*import, import_options);

  blocks::apps::ExportOptions export_options;
  auto* to_others =
      app.add_subcommand("export", "write blocks and results for other programs");
  blocks::apps::add_export_options(*to_others, export_options);
  add_set_option(*to_others, sets);

  blocks::apps::JointsOptions joints_options;
  auto* joints = app.add_subcommand("joints", "describe maps of fracture traces");
  joints->require_subcommand(1);
  auto* joint_numbers =
      joints->add_subcommand("statistics", "measure maps of fracture traces");
  blocks::apps::add_joint_statistics_options(*joint_numbers, joints_options);
  add_set_option(*joint_numbers, sets);
  auto* joint_fit =
      joints->add_subcommand("fit", "propose joint sets for a map, as a deck");
  blocks::apps::add_joint_fit_options(*joint_fit, joints_options);
  add_set_option(*joint_fit, sets);

  blocks::apps::StudyOptions study_options;
  auto* study = app.add_subcommand("study", "measure how robust contact detection is");
  auto* contacts =
      study->add_subcommand("contacts", "compare variants of the contact rules");
  blocks::apps::add_study_options(*contacts, study_options);
  blocks::apps::WhyOptions why_options;
  auto* why = app.add_subcommand("why", "explain why two blocks touch or do not");
  blocks::apps::add_why_options(*why, why_options);

  blocks::apps::SweepOptions sweep_options;
  auto* many = app.add_subcommand("sweep", "run a deck many times");
  blocks::apps::add_sweep_options(*many, sweep_options);

  blocks::apps::ManualOptions manual_options;
  auto* manual = app.add_subcommand("manual", "print man pages and bash completion");
  blocks::apps::add_manual_options(*manual, manual_options);

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
    export_options.input.overrides = options.overrides;
    joints_options.input.overrides = options.overrides;
  } catch (const CLI::ParseError& error) {
    const bool is_fault = error.get_exit_code() != 0;
    if (is_fault && astray_from_audit(app).empty())
      if (const std::string fault = blocks::apps::tell_wrong_word(app, argc, argv);
          !fault.empty()) {
        std::cerr << fault << std::flush;
        return blocks::run::usage_error;
      }
    return app.exit(error) == 0 ? blocks::run::done : blocks::run::usage_error;
  }

  if (*run) {
    blocks::apps::outlive_broken_pipes();
    options.ends_process = true;
    return blocks::run::run_deck(options);
  }
  if (*fos) {
    blocks::apps::outlive_broken_pipes();
    return blocks::apps::find_factor_of_safety(options, fos_options);
  }
  if (*check)
    return blocks::apps::check(options, geometry_options);
  if (*reference)
    return blocks::apps::cards(cards_options);
  if (*in_time)
    return blocks::apps::history(history_options);
  if (*record)
    return blocks::apps::cracks(cracks_options);
  if (*page)
    return blocks::apps::view(view_options);
  if (*statistics)
    return blocks::apps::report(report_options);
  if (*import)
    return blocks::apps::import_blocks(import_options);
  if (*to_others)
    return blocks::apps::export_blocks(export_options);
  if (*joint_numbers)
    return blocks::apps::joint_statistics(joints_options);
  if (*joint_fit)
    return blocks::apps::fit_joints(joints_options);
  if (*contacts)
    return blocks::apps::study_contacts(study_options);
  if (*study) {
    const auto extras = study->remaining();
    fmt::print(stderr,
               "blocks: error: {}\n  hint: blocks study contacts SCENE; "
               "blocks study contacts --list\n",
               extras.empty() ? "the name of the study is missing"
                              : "there is no study '" + extras.front() +
                                    "'; the only one is contacts");
    return blocks::run::usage_error;
  }
  if (*many)
    return blocks::apps::sweep(sweep_options);
  if (*manual)
    return blocks::apps::manual(app, manual_options);
  if (*why)
    return blocks::apps::why(why_options);
  return blocks::apps::plot(plot_options);
}

/// Does not use fmt::print, which throws if standard error cannot be written.
void tell(const char* kind, const char* what) {
  std::fprintf(stderr, "blocks: %s: %s\n", kind, what);
}

int tell_no_memory() {
  tell("error", "there is not enough memory for this problem");
  return blocks::run::internal_error;
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

int main(int argc, char** argv) {
  using blocks::apps::end_standard_output;
  blocks::apps::hold_standard_streams();
  if (const std::string fault = blocks::geometry::check_numeric_environment();
      !fault.empty()) {
    tell("error", fault.c_str());
    return blocks::run::internal_error;
  }
  std::set_terminate(end_at_once);
  blocks::apps::use_bundled_fonts();
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file size is an error like a full disk
#if !defined(BLOCKS_SANITIZED)    // a sanitizer reports more
  blocks::output::tell_crashes_of_files(blocks::run::file_error);
#endif
  try {
    blocks::dynamics::kernels();
  } catch (const std::invalid_argument& error) {
    tell("error", error.what());
    return blocks::run::usage_error;
  }
  try {
    return end_standard_output(dispatch(words_of(argc, argv)));
  } catch (const blocks::output::FileError& error) {
    tell("error", error.what());
    return blocks::run::file_error;
  } catch (const std::bad_alloc&) {
    return tell_no_memory();
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) == 0 && std::ferror(stderr) == 0) {
      tell("internal error", error.what());
      return blocks::run::internal_error;
    }
    tell("error",
         ("cannot write to the terminal or pipe: " + error.code().message()).c_str());
    return blocks::run::file_error;
  } catch (const std::exception& error) {
    tell("internal error", error.what());
    return blocks::run::internal_error;
  }
}
