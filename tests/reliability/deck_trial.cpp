#include "reliability/deck_trial.hpp"

#include <algorithm>
#include <stdexcept>

#include "deck/parser.hpp"
#include "dynamics/step.hpp"
#include "run/builder/builder.hpp"

namespace blocks::testing {
namespace {

Verdict refused(const deck::Diagnostics& told) {
  if (told.format_all().find(": error: ") == std::string::npos)
    throw std::logic_error("an error without a message");
  return Verdict::refused;
}

}  // namespace

Verdict try_deck(const std::string& text, const std::string& folder, int steps) {
  deck::Diagnostics told("deck", text);
  const deck::Deck cards = deck::parse("deck", text, told, {});
  if (told.has_errors())
    return refused(told);
  if (cards.commands.empty() ||
      std::holds_alternative<deck::Restart>(cards.commands.front().card))
    return Verdict::refused;  // A restart needs a checkpoint, which is missing.
  Model model;
  run::Builder builder(model, told, {model, cards.commands, {.folder = folder}});
  dynamics::Workspace work;
  for (const deck::Command& command : cards.commands) {
    builder.apply(command);
    if (told.has_errors())
      return refused(told);
    if (!deck::passes_time(command))
      continue;
    builder.check_before_motion(command, true);
    if (told.has_errors())
      return refused(told);
    builder.begin_to_move();
    dynamics::prepare(model);
    for (int i = 0; i < steps; ++i)
      if (!dynamics::step(model, work).finite)
        return Verdict::unsound;
  }
  builder.check_output_blocks();
  if (told.has_errors())
    return refused(told);
  if (!model.blocks.corner.allFinite() || !model.blocks.velocity.allFinite())
    throw std::logic_error("a state that is not finite was taken for a sound one");
  return Verdict::ran;
}

}  // namespace blocks::testing
