#include "bash_completion.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>

#include "apps/manual_command.hpp"
#include "deck/cards/card_table.hpp"
#include "option_text.hpp"
#include "quantities/energy.hpp"
#include "quantities/model_quantity.hpp"
#include "quantities/quantity.hpp"
#include "study/scene.hpp"

namespace blocks::apps {
namespace {

const char* const functions =
    R"bash(# Bash completion of blocks(1), made by `blocks manual bash`.

_blocks_words() {  # offers these words
  COMPREPLY=($(compgen -W "$*" -- "$word"))
}

_blocks_files() {  # offers folders, and files with these endings or any
  compopt -o filenames 2>/dev/null
  local pattern='*' IFS=$'\n'
  [ $# -gt 0 ] && pattern="*.@($(IFS='|'; echo "$*"))"
  COMPREPLY=($(compgen -d -- "$word"; shopt -s extglob; compgen -f -X "!$pattern" -- "$word"))
}

)bash";

/// Converts a list "a, b, c" to words separated by blanks, as bash needs them.
std::string blanks(std::string list) {
  std::erase(list, ',');
  return list;
}

template <class Names> std::string joined(const Names& names) {
  std::string all;
  for (const auto& name : names)
    all += (all.empty() ? "" : " ") + std::string(name);
  return all;
}

/// Returns the names of the quantities of the model and of contacts. Entries of the
/// energy account are left out: bash divides words at their colons.
std::string quantities_of_model() {
  std::string all;
  for (const auto& [name, kind] : quantities::other_kinds())
    if (!name.starts_with(quantities::energy_prefix))
      all += (all.empty() ? "" : " ") + name;
  return all;
}

/// Returns the bash command that completes the value of an option.
std::string completion_of(const CLI::Option& option) {
  static const std::map<std::string, std::string> known = {
      {"--restart", "_blocks_files h5"},
      {"--colour",
       "_blocks_words material joint " + blanks(quantities::block_quantity_names())},
      {"--table", "_blocks_files csv"},
      {"--output", "_blocks_files"},
      {"--profile-quantity", "_blocks_words " + blanks(quantities::quantity_names())},
      {"--quantity", "_blocks_words " + blanks(quantities::quantity_names()) + " " +
                         quantities_of_model()}};
  if (const auto names = choices(option); !names.empty())
    return "_blocks_words " + joined(names);
  if (value_name(option) == "DECK")
    return "_blocks_files deck";
  for (const std::string& name : option.get_lnames())
    if (const auto found = known.find("--" + name); found != known.end())
      return found->second;
  return value_name(option) == "FILE" ? "_blocks_files" : ":";
}

/// Returns the bash command that completes the operands of a command.
std::string operands_of(const LeafCommand& command) {
  static const std::map<std::string, std::string> known = {
      {"run", "_blocks_files deck"},
      {"fos", "_blocks_files deck"},
      {"check", "_blocks_files deck"},
      {"plot", "_blocks_files vtkhdf"},
      {"history", "_blocks_files vtkhdf"},
      {"cracks", "_blocks_files vtkhdf"},
      {"view", "_blocks_files vtkhdf"},
      {"why", "_blocks_files vtkhdf h5"},
      {"export", "_blocks_files deck vtkhdf"},
      {"import", "_blocks_files"},
      {"joints statistics", "_blocks_files"},
      {"joints fit", "_blocks_files"},
      {"report", "_blocks_files"},
      {"cards", "_blocks_words " + joined(deck::card_names())},
      {"sweep", "_blocks_files deck"},
      {"study contacts", "_blocks_words all decks " + joined(study::scene_names())}};
  for (const CLI::Option* option : command.app->get_options({}))
    if (const auto names = choices(*option); option->get_positional() && !names.empty())
      return "_blocks_words " + joined(names);
  const auto found = known.find(command.words);
  return found == known.end() ? ":" : found->second;
}

std::string case_of(const LeafCommand& command) {
  std::string all, values;
  for (const CLI::Option* option : command.app->get_options({})) {
    if (option->get_positional())
      continue;
    std::string pattern;
    for (const std::string& name : option->get_snames())
      pattern += (pattern.empty() ? "-" : "|-") + name;
    for (const std::string& name : option->get_lnames()) {
      pattern += (pattern.empty() ? "--" : "|--") + name;
      all += (all.empty() ? "--" : " --") + name;
    }
    if (!value_name(*option).empty() && option->get_expected_min() > 0)
      values +=
          fmt::format("        {}) {}; return ;;\n", pattern, completion_of(*option));
  }
  return fmt::format("    '{}')\n      options='{}'\n"
                     "      case $before in\n{}      esac\n"
                     "      operands='{}' ;;\n",
                     command.words, all, values, operands_of(command));
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
  std::string out = functions, first, nested, cases;
  for (const CLI::App* command : program.get_subcommands({})) {
    first += (first.empty() ? "" : " ") + command->get_name();
    std::string below;
    for (const CLI::App* part : command->get_subcommands({}))
      below += (below.empty() ? "" : " ") + part->get_name();
    if (!below.empty())
      nested += fmt::format(
          "  if [ \"$command\" = {0} ]; then\n"
          "    if [ \"$COMP_CWORD\" = 2 ]; then _blocks_words {1}; return; fi\n"
          "    command=\"{0} ${{COMP_WORDS[2]}}\"\n  fi\n",
          command->get_name(), below);
  }
  for (const LeafCommand& command : leaf_commands(program))
    cases += case_of(command);
  return out + fmt::format("_blocks() {{\n"
                           "  local word=${{COMP_WORDS[COMP_CWORD]}} "
                           "before=${{COMP_WORDS[COMP_CWORD-1]}}\n"
                           "  local command=${{COMP_WORDS[1]}} options='' operands=:\n"
                           "  COMPREPLY=()\n"
                           "  if [ \"$COMP_CWORD\" = 1 ]; then\n"
                           "    _blocks_words {} --help --version\n    return\n  fi\n"
                           "{}"
                           "  case $command in\n{}  esac\n"
                           "  case $word in\n"
                           "    -*) _blocks_words $options ;;\n"
                           "    *) $operands ;;\n"
                           "  esac\n}}\n"
                           "complete -F _blocks blocks\n",
                           first, nested, cases);
}

}  // namespace blocks::apps
