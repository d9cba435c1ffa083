// The command line of BLOCKS, thin: each command calls one function of src/run or
// src/post.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

#include "check_command.hpp"
#include "command_pages.hpp"
#include "deck/cards_text.hpp"
#include "dynamics/kernels/kernels.hpp"
#include "export_command.hpp"
#include "geometry/numeric_environment.hpp"
#include "history_command.hpp"
#include "import_command.hpp"
#include "manual_command.hpp"
#include "output/file_in_hand.hpp"
#include "output/results.hpp"
#include "plot_command.hpp"
#include "run/run.hpp"
#include "standard_streams.hpp"
#include "study_command.hpp"
#include "view_command.hpp"
#include "why_command.hpp"

#if defined(__SANITIZE_ADDRESS__)
#define BLOCKS_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define BLOCKS_SANITIZED
#endif
#endif

namespace {

using blocks::run::RunOptions;

/// The range of the SEED card; whole numbers alone would wrap and take 010 for 8.
CLI::Validator seed_number() {
  return {[](std::string& text) {
            const bool digits =
                !text.empty() && text.size() <= 16 &&
                text.find_first_not_of("0123456789") == std::string::npos;
            if (!digits || std::stoull(text) > 9007199254740991ULL)
              return "expected a whole number from 0 to 9007199254740991, found '" +
                     text + "'";
            text = std::to_string(std::stoull(text));  // 010 is ten
            return std::string();
          },
          "0 TO 2^53-1"};
}

/// CLI::PositiveNumber lets NaN pass.
CLI::Validator positive_number() {
  return {[](std::string& text) {
            double value = 0.0;
            return CLI::detail::lexical_cast(text, value) && value > 0.0
                       ? std::string()
                       : "expected a number above 0, found '" + text + "'";
          },
          "POSITIVE"};
}

/// A number of steps: CLI::PositiveNumber takes fractions too, and names its range.
CLI::Validator whole_steps() {
  return {
      [](std::string& text) {
        const bool sound = !text.empty() && text.size() <= 15 && text.front() != '0' &&
                           text.find_first_not_of("0123456789") == std::string::npos;
        return sound ? std::string()
                     : "expected a whole number of steps from 1, found '" + text + "'";
      },
      "STEPS"};
}

/// CARD.field=value
blocks::deck::Override parse_override(const std::string& text) {
  const auto dot = text.find('.'), equals = text.find('=');
  if (dot == std::string::npos || equals == std::string::npos || dot > equals)
    throw CLI::ValidationError("--set",
                               "expected CARD.field=value, found '" + text + "'");
  return {text.substr(0, dot), text.substr(dot + 1, equals - dot - 1),
          text.substr(equals + 1)};
}

void add_deck_options(CLI::App& command, RunOptions& options,
                      std::vector<std::string>& sets) {
  command.add_option("DECK", options.deck, "the deck, or - for standard input")
      ->required();
  command
      .add_option("--seed", options.seed, "seed of the random layers, wins over SEED")
      ->check(seed_number());
  command.add_option("--tape9", options.tape9,
                     "mesh file of a READ9 card without a name");
  command.add_option("--restart", options.restart,
                     "go on from this checkpoint: of this very deck, or of a deck "
                     "that begins with RESTART");
  command.add_option("--set", sets, "CARD.field=value: replace a field of the deck");
  command.add_flag("-q,--quiet", options.quiet, "print errors and warnings only");
  command.add_flag("-v,--verbose", options.verbose, "say what every layer became");
}

/// The page of the command named on the command line opens with an example and says
/// more than its line in the list of commands.
void open_help_with_example(CLI::App& app, int argc, char** argv) {
  if (argc < 2)
    return;
  const auto page = blocks::apps::command_pages().find(argv[1]);
  if (page == blocks::apps::command_pages().end())
    return;
  const std::string head = blocks::apps::help_head(page->second);
  CLI::App* command = app.get_subcommand(page->first);
  command->description(head);
  for (CLI::App* part : command->get_subcommands({}))  // blocks study contacts --help
    part->description(head);
}

/// Of `blocks run --audit 5 DECK` the number, which was meant for the flag; empty: no
/// such thing.
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

/// A fault of the command line, told like every other.
std::string tell_usage_fault(const CLI::App* app, const CLI::Error& error) {
  std::string command = "blocks";
  for (auto named = app->get_subcommands(); !named.empty();
       named = named.front()->get_subcommands())
    command += ' ' + named.front()->get_name();
  if (const std::string every = astray_from_audit(*app); !every.empty())
    return fmt::format("blocks: error: {0}\n  hint: {1} is not read as the number of "
                       "--audit; every {1} steps is --audit={1}\n",
                       error.what(), every);
  return fmt::format("blocks: error: {}\n  hint: {} --help says what there is\n",
                     error.what(), command);
}

int cards(const std::string& name, bool markdown) {
  if (markdown) {
    std::cout << blocks::deck::card_reference_markdown();
    return blocks::run::done;
  }
  if (name.empty()) {
    std::cout << blocks::deck::all_cards();
    return blocks::run::done;
  }
  if (const auto page = blocks::deck::card_page(name)) {
    std::cout << *page;
    return blocks::run::done;
  }
  fmt::print(stderr, "blocks: error: there is no card {}\n{}", name,
             blocks::deck::all_cards());
  return blocks::run::usage_error;
}

int dispatch(int argc, char** argv) {
  CLI::App app("Example: blocks run decks/stack/stack.deck\n\n"
               "BLOCKS: a 2D block motion code for jointed rock.\n"
               "Exit codes: 0 done, 1 internal, 2 usage, 3 deck or geometry, 4 run "
               "unsound, 5 file,\n"
               "75 stopped at a limit of time or steps, 130 interrupted.");
  app.set_version_flag("--version", "blocks " BLOCKS_VERSION);
  app.require_subcommand(1);

  RunOptions options;
  std::vector<std::string> sets;
  auto* run = app.add_subcommand("run", "run a deck");
  add_deck_options(*run, options, sets);
  run->add_option("-o,--output", options.output,
                  "output NAME, or FOLDER/ (default: the deck's stem, here)");
  run->add_option("--time-limit", options.time_limit,
                  "stop after so many seconds, exit 75")
      ->check(positive_number());
  run->add_option("--stop-after", options.stop_after,
                  "stop after so many steps, exit 75")
      ->check(CLI::Range(1L, std::numeric_limits<long>::max()));
  run->add_option("--checkpoint-every", options.checkpoint_every,
                  "seconds between checkpoints (default: 600)")
      ->check(positive_number());
  run->add_option("-j,--threads", options.threads,
                  "threads (default: all cores); results do not change")
      ->check(CLI::Range(1, 1024));
  run->add_flag("--profile", options.profile, "tell at the end where the time went");
  run->add_flag("--audit{100}", options.audit_every,
                "every 100 steps, or every N with --audit=N, judge the contacts by "
                "exact brute force; exit 4 on a wrong decision")
      ->check(whole_steps());
  run->add_flag("--json", options.json,
                "print the summary as JSON instead of the table");

  auto* check = app.add_subcommand("check", "parse, build and certify; no time step");
  add_deck_options(*check, options, sets);
  check->add_option("-o,--output", options.output, "output NAME (finds NAME.ckpt.h5)");
  blocks::apps::GeometryOptions geometry_options;
  blocks::apps::add_geometry_options(*check, geometry_options);

  std::string card;
  bool markdown = false;
  auto* reference = app.add_subcommand("cards", "the card reference");
  reference->add_option("NAME", card, "the card");
  reference->add_flag("--markdown", markdown, "the whole reference as Markdown");

  blocks::apps::PlotOptions plot_options;
  auto* plot = app.add_subcommand("plot", "figures and movies of a run");
  blocks::apps::add_plot_options(*plot, plot_options);

  blocks::apps::HistoryOptions history_options;
  auto* in_time = app.add_subcommand("history", "quantities against time or place");
  blocks::apps::add_history_options(*in_time, history_options);

  blocks::apps::ViewOptions view_options;
  auto* page = app.add_subcommand("view", "a page to play a run in the browser");
  blocks::apps::add_view_options(*page, view_options);

  blocks::apps::ImportOptions import_options;
  auto* import = app.add_subcommand("import", "outlines of other programs, for READ9");
  blocks::apps::add_import_options(*import, import_options);

  blocks::apps::ExportOptions export_options;
  auto* to_others =
      app.add_subcommand("export", "blocks and results for other programs");
  blocks::apps::add_export_options(*to_others, export_options);

  blocks::apps::StudyOptions study_options;
  auto* study = app.add_subcommand("study", "how robust is contact detection?");
  auto* contacts =
      study->add_subcommand("contacts", "variants of the contact rules side by side");
  blocks::apps::add_study_options(*contacts, study_options);
  blocks::apps::WhyOptions why_options;
  auto* why = app.add_subcommand("why", "why two blocks touch, or do not, at one time");
  blocks::apps::add_why_options(*why, why_options);

  blocks::apps::ManualOptions manual_options;
  auto* manual = app.add_subcommand("manual", "man pages and bash completion, as text");
  blocks::apps::add_manual_options(*manual, manual_options);

  study->allow_extras();
  app.failure_message(tell_usage_fault);
  app.name("blocks");
  open_help_with_example(app, argc, argv);
  try {
    app.parse(argc, argv);
    if (std::find(argv, argv + argc, std::string("--audit=")) != argv + argc)
      throw CLI::ValidationError("--audit: a number of steps is missing after =");
    for (const std::string& text : sets)
      options.overrides.push_back(parse_override(text));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? blocks::run::done : blocks::run::usage_error;
  }

  if (*run) {
    // Who reads the table may leave (| head); the run goes on.
    std::signal(SIGPIPE, SIG_IGN);
    return blocks::run::run_deck(options);
  }
  if (*check)
    return blocks::apps::check(options, geometry_options);
  if (*reference)
    return cards(card, markdown);
  if (*in_time)
    return blocks::apps::history(history_options);
  if (*page)
    return blocks::apps::view(view_options);
  if (*import)
    return blocks::apps::import_blocks(import_options);
  if (*to_others)
    return blocks::apps::export_blocks(export_options);
  if (*contacts)
    return blocks::apps::study_contacts(study_options);
  if (*study) {
    const auto extras = study->remaining();
    fmt::print(stderr,
               "blocks: error: {}\n  hint: blocks study contacts SCENE; "
               "blocks study contacts --list\n",
               extras.empty()
                   ? "study what?"
                   : "there is no study '" + extras.front() + "', there is contacts");
    return blocks::run::usage_error;
  }
  if (*manual)
    return blocks::apps::manual(app, manual_options);
  if (*why)
    return blocks::apps::why(why_options);
  return blocks::apps::plot(plot_options);
}

/// Not fmt::print, which throws when standard error cannot be written.
void tell(const char* kind, const char* what) {
  std::fprintf(stderr, "blocks: %s: %s\n", kind, what);
}

int tell_no_memory() {
  tell("error", "there is not enough memory for this problem");
  return blocks::run::internal_error;
}

/// Memory that fails while something is being put away; files are whole all the same.
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
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file size is an error like a full disk
#if !defined(BLOCKS_SANITIZED)    // a sanitizer tells more
  blocks::output::tell_crashes_of_files(blocks::run::file_error);
#endif
  try {
    blocks::dynamics::kernels();
  } catch (const std::invalid_argument& error) {
    tell("error", error.what());
    return blocks::run::usage_error;
  }
  try {
    return end_standard_output(dispatch(argc, argv));
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
         ("cannot write what is to be printed: " + error.code().message()).c_str());
    return blocks::run::file_error;
  } catch (const std::exception& error) {
    tell("internal error", error.what());
    return blocks::run::internal_error;
  }
}
