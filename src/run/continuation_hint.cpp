#include "run/continuation_hint.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace blocks::run {

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
