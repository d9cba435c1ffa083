#include "run/builder/builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "model/safe_fraction.hpp"
#include "run/builder/cards.hpp"
#include "run/builder/checks.hpp"
#include "run/builder/deck_outlines.hpp"

namespace blocks::run {

using deck::Command;

BuilderState::BuilderState(const Model& model, const std::vector<Command>& cards,
                           BuildOptions build_options)
    : options(std::move(build_options)), unread(options.unread),
      numbers(options.unread, model.blocks.size()), makers(model.blocks.size()),
      corners(shared_corners(cards)), known_blocks(model.blocks.size()),
      checked_blocks(known_blocks), moved_blocks(model.steps > 0 ? known_blocks : 0),
      domain_blocks(known_blocks) {
  std::size_t moved = 0;
  for (const geometry::SharedCorners& shared : corners)
    moved += shared.moved();
  if (moved > 0)
    notes.push_back(fmt::format("corners on a slanted side of another outline, rounded "
                                "so that they do not overlap it: {}",
                                moved));
}

void Context::note(const std::string& text) const {
  state.notes.push_back(
      fmt::format("{} in line {}{}: {}", command.name, command.where.line,
                  state.in_place ? fmt::format(" at time {:g}", model.time)
                                 : std::string(", if nothing moves before"),
                  text));
}

Builder::Builder(Model& model, deck::Diagnostics& diagnostics, BuilderState state)
    : model_(model), diagnostics_(diagnostics), state_(std::move(state)) {
  if (state_.options.seed)
    model_.settings.seed = *state_.options.seed;
}

void Builder::apply(const Command& command) {
  take_in_pieces();
  const int line = command.where.line, before = model_.blocks.size();
  state_.numbers.count(line, before);
  state_.chosen.clear();
  std::visit([&](const auto& card) { act(context(command), card); }, command.card);
  state_.plausibility.test(Moment::card, plan({&command, 1}), command, diagnostics_);
  const int now = model_.blocks.size();
  if (now == before)
    state_.numbers.add_failed(command, before);
  state_.numbers.count(line, now);
  state_.makers.record(command, now);
  state_.known_blocks = now;
  if (deck::passes_time(command))
    state_.motion = command;
}

void Builder::take_in_pieces() {
  const int now = model_.blocks.size();
  if (now == state_.known_blocks)
    return;
  if (state_.motion)
    state_.makers.record(*state_.motion, now);
  if (state_.certificate) {
    AssemblyCertificate with_pieces = *state_.certificate;
    with_pieces.blocks = with_pieces.moved = now;
    state_.certificate =
        std::make_shared<const AssemblyCertificate>(std::move(with_pieces));
  }
  state_.known_blocks = state_.checked_blocks = state_.moved_blocks =
      state_.domain_blocks = now;
}

void Builder::go_on(const std::vector<Command>& cards, std::size_t next,
                    const std::vector<geometry::BlockOverlap>& overlaps) {
  const auto done = std::span(cards).first(next);
  state_.section = static_cast<std::size_t>(
      std::count_if(done.begin(), done.end(), deck::passes_time));
  state_.balanced = std::any_of(done.begin(), done.end(), [](const Command& command) {
    return std::holds_alternative<deck::Solve>(command.card) ||
           std::holds_alternative<deck::Insitu>(command.card);
  });
  AssemblyCertificate certificate;
  certificate.blocks = certificate.moved = model_.blocks.size();
  certificate.removed = certificate.blocks - model_.blocks.count_present();
  certificate.overlaps = overlaps;
  state_.certificate =
      std::make_shared<const AssemblyCertificate>(std::move(certificate));
  state_.warned_fraction = safe_fraction(model_.settings);
  state_.known_blocks = state_.checked_blocks = state_.moved_blocks =
      model_.blocks.size();
}

void Builder::begin_to_move() {
  state_.moves = state_.in_place = true;
  state_.numbers.forget_splits();
  state_.notes.clear();
  // An interrupt ends a run between steps, not in the middle of a card.
  state_.options.cut_progress = {};
  state_.options.check_progress = {};
}

void Builder::check_before_motion(const Command& command, bool in_place) {
  run::check_before_motion(context(command), in_place);
}

void Builder::check_despite_errors(const Command& command) {
  const Context motion = context(command);
  if (model_.blocks.count_present() == 0 || motion.max_missing() > 0)
    return;
  const auto is_unread = [&](const char* card) { return state_.unread.has(card); };
  constexpr const char* of_the_step[] = {"FRACTION", "DAMPING", "LOCDAMP", "KINDAMP"};
  if (std::none_of(std::begin(of_the_step), std::end(of_the_step), is_unread))
    check_fraction(motion);
  check_planes(motion);
}

void Builder::check_without_motion(const Command& last) {
  if (model_.blocks.count_present() == 0)
    return;
  if (model_.blocks.size() != state_.checked_blocks)
    check_planes(context(last));
  check_overlaps(context(last));
}

void Builder::check_output_blocks() {
  for (const Command& history : std::exchange(state_.histories, {}))
    check_history(context(history));
  if (const auto output = std::exchange(state_.output, {}))
    check_output(context(*output));
}

void Builder::check_plausibility(const Command& motion) {
  state_.plausibility.test(Moment::motion, plan({&motion, 1}), motion, diagnostics_);
  state_.domain_blocks = model_.blocks.size();
}

void Builder::check_deck(std::span<const Command> cards, bool driven) {
  if (driven)
    state_.plausibility.leave_out("no-motion");
  if (!cards.empty())
    state_.plausibility.test(Moment::end, plan(cards), cards.back(), diagnostics_);
}

Plan Builder::plan(std::span<const Command> cards) const {
  return {model_, state_.makers, state_.places, state_.domain_blocks,
          cards,  state_.chosen};
}

}  // namespace blocks::run
