#include "run/executor/continuation_hint.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "run/support/shell_word.hpp"

namespace blocks::run {

std::string continuation_command(const RunOptions& options,
                                 const std::string& checkpoint, bool with_until) {
  std::string command = (options.last_card.empty() ? "blocks run " : "blocks fos ") +
                        shell_word(options.deck) + " --restart " +
                        shell_word(checkpoint);
  if (!options.output.empty())
    command += " -o " + shell_word(options.output);
  for (const deck::Override& set : options.overrides)
    command +=
        " --set " + shell_word(fmt::format("{}.{}={}", set.card, set.field, set.value));
  command += options.last_card_options;
  if (options.seed)
    command += fmt::format(" --seed {}", *options.seed);
  if (options.tape9 != RunOptions().tape9)
    command += " --tape9 " + shell_word(options.tape9);
  if (options.until && with_until)
    command += fmt::format(" --until {}", *options.until);
  return command;
}

std::string continuation_hint(const std::string& checkpoint, double time) {
  // A name on a card is relative to the folder of the deck, which is not known here.
  const auto name = std::filesystem::path(checkpoint).filename().string();
  const double more = time > 0.0 ? time : 1.0;
  return fmt::format(
      "the run of {} is finished; nothing remains to be done\n"
      "  hint: --until {:g} continues it to that time; for new cards, run "
      "a deck of these lines in its folder\n"
      "    RESTART, {}\n    MOTION, {:g}\n    STOP",
      checkpoint, time + more, name, more);
}

}  // namespace blocks::run
