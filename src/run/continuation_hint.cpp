#include "run/continuation_hint.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace blocks::run {

std::string continuation_hint(const std::string& checkpoint, double time) {
  // A name on a card is relative to the folder of the deck, which is not known here.
  const auto name = std::filesystem::path(checkpoint).filename().string();
  return fmt::format("the run of {} is finished; nothing remains to be done\n"
                     "  hint: to continue it, run a deck of these lines in its folder\n"
                     "    RESTART, {}\n    MOTION, {:g}\n    STOP",
                     checkpoint, name, time > 0.0 ? time : 1.0);
}

}  // namespace blocks::run
