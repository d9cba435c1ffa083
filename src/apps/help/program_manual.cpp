#include "program_manual.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>

#include "apps/manual_command.hpp"
#include "command_pages.hpp"
#include "option_text.hpp"
#include "run/run.hpp"
#include "text/roff.hpp"

namespace blocks::apps {
namespace {

namespace roff = text::roff;

/// Returns the names and the value of an option, such as "-o, --output FILE".
std::string option_term(const CLI::Option& option) {
  std::string term;
  for (const std::string& name : option.get_snames())
    term += (term.empty() ? "" : ", ") + roff::bold("-" + name);
  for (const std::string& name : option.get_lnames())
    term += (term.empty() ? "" : ", ") + roff::bold("--" + name);
  if (const std::string value = value_name(option); !value.empty())
    term += ' ' + roff::italic(value) + (option.get_expected_max() > 1 ? " ..." : "");
  return term;
}

std::string synopsis(const LeafCommand& command) {
  std::string line =
      roff::bold("blocks " + command.words) + " [" + roff::italic("options") + "]";
  for (const CLI::Option* option : command.app->get_options({}))
    if (option->get_positional()) {
      const std::string name = roff::italic(option->get_name()) +
                               (option->get_expected_max() > 1 ? " ..." : "");
      line += option->get_required() ? " " + name : " [" + name + "]";
    }
  return line;
}

std::string command_section(const LeafCommand& command) {
  const auto page =
      command_pages().find(command.words.substr(0, command.words.find(' ')));
  std::string out =
      roff::subsection("blocks " + command.words) + synopsis(command) + "\n";
  if (page != command_pages().end())
    out += roff::paragraph(page->second.description);
  for (const bool positional : {true, false})
    for (const CLI::Option* option : command.app->get_options({}))
      if (option->get_positional() == positional && option->get_name() != "--help")
        out += roff::item(positional ? roff::italic(option->get_name())
                                     : option_term(*option),
                          option_meaning(*option));
  if (const std::string footer = command.app->get_footer(); !footer.empty())
    out += roff::paragraph(footer);
  if (page == command_pages().end())
    return out;
  const std::string before =
      page->second.beforehand.empty() ? "" : page->second.beforehand + "\n";
  return out + roff::paragraph("Example:") +
         roff::example(before + page->second.example);
}

}  // namespace

std::string program_manual(const CLI::App& program) {
  const std::vector<LeafCommand> commands = leaf_commands(program);
  std::string out = roff::head("blocks", 1, BLOCKS_VERSION, "User commands",
                               "2D block motion code for jointed rock");
  out += roff::section("Synopsis");
  for (std::size_t i = 0; i < commands.size(); ++i)
    out += (i == 0 ? "" : ".br\n") + synopsis(commands[i]) + "\n";
  out +=
      roff::section("Description") +
      "Simulates rock as an assembly of polygonal blocks, rigid or simply deformable. "
      "The blocks move under gravity, pressure and impact, collide corner to edge, and "
      "slide with friction. A deck of cards describes the problem; see " +
      roff::bold("blocks-deck") + "(5).\n" + roff::section("Commands");
  for (const LeafCommand& command : commands)
    out += command_section(command);
  out += roff::section("Exit status");
  const std::pair<int, const char*> codes[] = {
      {run::done, "done"},
      {run::internal_error, "internal error, or not enough memory"},
      {run::usage_error, "error in the command line"},
      {run::deck_error, "error in the deck or the geometry"},
      {run::unsound_run, "the run became unsound: a value is not a number, an overlap "
                         "is too deep, or the audit found a wrong decision"},
      {run::file_error, "a file cannot be read or written"},
      {run::time_limit, "stopped at a limit of time or steps, after a checkpoint"},
      {run::interrupted, "interrupted, after a checkpoint"},
      {128 + SIGPIPE,
       "the reader of standard output has ended (| head); the files of a "
       "run are complete"}};
  for (const auto& [code, meaning] : codes)
    out += roff::item(roff::bold(std::to_string(code)), meaning);
  out += roff::section("Files");
  out += roff::item(roff::italic("NAME.out"),
                    "the listing: deck, input echo, OUTPUT tables, DUMP");
  out += roff::item(roff::italic("NAME.vtkhdf"),
                    "results for plot, history, view, why, export and ParaView 5.13");
  out += roff::item(roff::italic("NAME.ckpt.h5"),
                    "checkpoint for --restart and for a deck that begins with RESTART");
  out += roff::item(roff::italic("NAME.summary.json"),
                    "for scripts: steps, time step, energies, worst overlap, hashes");
  out += roff::section("Environment");
  out += roff::item(
      roff::bold("BLOCKS_SIMD"),
      "the instruction set of the contact loop: baseline, avx2 or avx512 (default: the "
      "widest that the processor has); does not change results");
  return out + roff::section("See also") + roff::bold("blocks-deck") + "(5)\n";
}

}  // namespace blocks::apps
