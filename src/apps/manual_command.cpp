#include "manual_command.hpp"

#include <CLI/CLI.hpp>
#include <iostream>

#include "apps/help/bash_completion.hpp"
#include "apps/help/program_manual.hpp"
#include "deck/cards/cards_manual.hpp"
#include "files/file_tools.hpp"
#include "run/run.hpp"

namespace blocks::apps {

void add_manual_options(CLI::App& command, ManualOptions& options) {
  command.add_option("PAGE", options.page, "program, deck or bash")
      ->required()
      ->check(CLI::IsMember({"program", "deck", "bash"}));
  command.add_option("-o,--output", options.output,
                     "file (default: print to the terminal)");
}

int manual(const CLI::App& program, const ManualOptions& options) {
  const std::string text = options.page == "deck"
                               ? deck::card_reference_man(BLOCKS_VERSION)
                           : options.page == "bash" ? bash_completion(program)
                                                    : program_manual(program);
  if (options.output.empty())
    std::cout << text;
  else
    files::replace_file_keeping_older(options.output, text);
  return run::done;
}

std::vector<LeafCommand> leaf_commands(const CLI::App& program) {
  std::vector<LeafCommand> leaves;
  for (const CLI::App* command : program.get_subcommands({})) {
    const auto below = leaf_commands(*command);
    if (below.empty())
      leaves.push_back({command->get_name(), command});
    for (const LeafCommand& leaf : below)
      leaves.push_back({command->get_name() + ' ' + leaf.words, leaf.app});
  }
  return leaves;
}

}  // namespace blocks::apps
