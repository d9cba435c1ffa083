#include "run/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <variant>

#include "dynamics/preparation/mass_scaling.hpp"
#include "files/file_error.hpp"
#include "quantities/quantity.hpp"
#include "run/cutting/joint_files.hpp"
#include "run/executor/executor.hpp"
#include "run/executor/saved_state.hpp"
#include "run/support/cut_progress.hpp"
#include "run/support/deck_file.hpp"

namespace blocks::run {
namespace {

std::string folder_of(const RunOptions& options) {
  return options.text ? std::string() : deck_folder(options.deck);
}

}  // namespace

Job::Job(const RunOptions& given)
    : options(given), text(given.text ? *given.text : read_deck(given.deck)),
      diagnostics(given.deck == "-" ? "<standard input>" : given.deck, text),
      deck(deck::parse(given.deck, text, diagnostics, given.overrides)),
      files(file_sums(deck, folder_of(given), given.tape9)),
      name(output_name(given.deck, given.output)) {
  read_outline_files(deck, folder_of(given), diagnostics);
  auto& commands = deck.commands;
  end = commands.size();
  if (!commands.empty() && std::holds_alternative<deck::Stop>(commands.back().card))
    --end;
  if (!options.last_card.empty())
    add_last_card();
  if (!options.until)
    return;
  const auto where =
      diagnostics.from_command_line(fmt::format("--until {}", *options.until));
  // The run ends at the time of --until, so this interval is always long enough.
  commands.insert(commands.begin() + static_cast<std::ptrdiff_t>(end),
                  {where, "MOTION", deck::Motion{{*options.until, where, true}}});
}

void Job::add_last_card() {
  const auto where = diagnostics.from_command_line(options.last_card);
  deck::Diagnostics card_faults("", options.last_card);
  for (deck::Command& card :
       deck::parse_further("", options.last_card, card_faults).commands) {
    card.where = where;
    const auto same =
        std::find_if(deck.commands.begin(), deck.commands.end(),
                     [&](const deck::Command& own) { return own.name == card.name; });
    if (same != deck.commands.end())
      diagnostics.error(
          where, card.name,
          fmt::format("the deck has this card in line {}", same->where.line),
          "give its fields there, and use blocks run");
    deck.commands.insert(deck.commands.begin() + static_cast<std::ptrdiff_t>(end),
                         card);
    ++end;
  }
  for (const deck::Diagnostic& one : card_faults.all())
    diagnostics.error(where, one.card, one.message, one.hint);
}

bool Job::passes_time_from(std::size_t command) const {
  for (std::size_t i = command; i < end; ++i)
    if (deck::passes_time(deck.commands[i]))
      return true;
  return false;
}

long Job::motions_before(std::size_t command) const {
  return std::count_if(deck.commands.begin(),
                       deck.commands.begin() + static_cast<std::ptrdiff_t>(command),
                       deck::passes_time);
}

bool Job::asks_for_equilibrium() const {
  return std::any_of(
      deck.commands.begin(), deck.commands.end(), [](const deck::Command& command) {
        const auto* history = std::get_if<deck::History>(&command.card);
        return std::holds_alternative<deck::Solve>(command.card) ||
               std::holds_alternative<deck::Fos>(command.card) ||
               std::holds_alternative<deck::Locdamp>(command.card) ||
               std::holds_alternative<deck::Kindamp>(command.card) ||
               (history != nullptr &&
                std::any_of(history->quantities.begin(), history->quantities.end(),
                            [](const deck::Word& word) {
                              return quantities::is_of_equilibrium(
                                  word.value.substr(0, word.value.find(':')));
                            }));
      });
}

std::optional<bool> Job::solved_before(std::size_t command) const {
  std::optional<bool> solved;
  for (std::size_t i = 0; i < deck.commands.size(); ++i)
    if (std::holds_alternative<deck::Solve>(deck.commands[i].card))
      solved = i < command;
  return solved;
}

bool Job::was_extended() const {
  const output::Progress& at = from.progress;
  return at.card > static_cast<long>(own_commands()) ||
         (at.card == static_cast<long>(end) && at.steps_left > 0);
}

/// Moves a checkpoint at the end of the deck to the card of --until. The steps to that
/// time are the rest of the card if an earlier run has begun it.
void Job::place_at_end(const Model& model) {
  output::Progress& at = from.progress;
  const long last = static_cast<long>(end), own = static_cast<long>(own_commands());
  if (options.until && at.card >= last) {
    at.steps_left =
        was_extended()
            ? std::max(0L, steps_for(*options.until - model.time, model.time_step.dt))
            : 0;
    at.card = last;
  } else if (at.finished && at.card == own + 1) {
    at.card = own;
  }
}

BuildOptions Job::build_options() const {
  BuildOptions built;
  built.seed = options.seed;
  built.tape9 = options.tape9;
  built.folder = folder_of(options);
  built.unread = deck.unread;
  built.overlaps = from.progress.overlaps;
  built.cut_progress = CutProgress(options.quiet);
  return built;
}

bool Job::continues() const {
  return !deck.commands.empty() &&
         std::holds_alternative<deck::Restart>(deck.commands.front().card);
}

std::string Job::checkpoint() const {
  if (options.restart)
    return *options.restart;
  const auto& card = std::get<deck::Restart>(deck.commands.front().card);
  return card.file.given ? checkpoint_named("", card.file.value, name)
                         : name + ".ckpt.h5";
}

/// The --set options, one per line.
std::string Job::overrides() const {
  std::string lines;
  for (const deck::Override& set : options.overrides)
    lines += fmt::format("{}.{}={}\n", set.card, set.field, set.value);
  if (!options.last_card.empty())
    lines += options.last_card + '\n';
  return lines;
}

output::RunIdentity Job::identity(const Model& model) const {
  return {diagnostics.file(),   text,
          model.settings.title, BLOCKS_VERSION,
          model.settings.seed,  overrides() + files};
}

/// Whether the position at which the checkpoint's run stopped exists in this deck. A
/// card with remaining steps must be a MOTION, or a CYCLE with at least that many
/// steps.
bool Job::is_in_deck() const {
  if (first_command() > deck.commands.size())
    return false;
  if (from.progress.steps_left == 0)
    return true;
  if (first_command() == deck.commands.size())
    return false;
  const deck::Command& command = deck.commands[first_command()];
  const auto* cycle = std::get_if<deck::Cycle>(&command.card);
  const auto* solve = std::get_if<deck::Solve>(&command.card);
  return deck::passes_time(command) &&
         (cycle == nullptr || from.progress.steps_left <= cycle->ncycle.value) &&
         (solve == nullptr || from.progress.steps_left <= solve->nmax.value);
}

Model Job::load() {
  const std::string path = checkpoint();
  Model model = output::read_checkpoint(path, from);
  resumes = options.restart && from.deck_text == text &&
            !(continues() && from.progress.finished && !options.until);
  const auto refuse = [&](const std::string& reason) {
    throw files::FileError(
        fmt::format("cannot continue {} from {}: {}", options.deck, path, reason));
  };
  const std::filesystem::path own(diagnostics.file()), its(from.deck_file);
  if (!resumes && !continues() && own.filename() == its.filename())
    refuse(fmt::format("the deck has changed since then, or another deck has the same "
                       "name; they first differ in line {}",
                       first_difference(from.deck_text, text)));
  if (!resumes && !continues())
    refuse(fmt::format("the checkpoint belongs to another deck, {} '{}'; use that "
                       "deck, or one that begins with RESTART",
                       from.deck_file, model.settings.title));
  if (!resumes) {
    dynamics::end_mass_scaling(model);  // of a SOLVE that was not finished
    return model;
  }
  const std::string sets = overrides();
  if (from.overrides != sets + files && from.overrides.starts_with(sets) &&
      holds_file_sums(from.overrides.substr(sets.size())))
    refuse("a file that READ9, OUTLINE, TRACES or VORONOI reads has changed");
  if (from.overrides != sets + files)
    refuse(from.overrides.empty()
               ? "it was written without --set options"
               : "it was written with other --set options, one a line:\n" +
                     from.overrides.substr(0, from.overrides.size() - 1));
  if (options.seed && *options.seed != model.settings.seed)
    refuse(fmt::format("its seed is {}", model.settings.seed));
  if (!options.until && was_extended() && !from.progress.finished)
    refuse("it was stopped on the way to the time of --until; give --until TIME again");
  place_at_end(model);
  if (!is_in_deck())
    refuse("no run writes such a state: the place in the deck where it stopped");
  return model;
}

}  // namespace blocks::run
