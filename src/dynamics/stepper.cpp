#include "dynamics/stepper.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

#include "dynamics/cracks/cracking.hpp"
#include "dynamics/kept_state.hpp"

namespace blocks::dynamics {
namespace {

/// Adds the new pieces of the last cracks to the blocks of OUTPUT, if it names the
/// blocks that have split.
void print_pieces(Model& model, int cracks) {
  std::vector<int>& printed = model.output_blocks;
  for (auto crack = model.cracks.end() - cracks; crack != model.cracks.end(); ++crack)
    if (std::find(printed.begin(), printed.end(), crack->parent) != printed.end())
      printed.push_back(crack->child);
}

}  // namespace

void Stepper::changed() {
  if (is_in_order_)
    throw std::logic_error("a model was changed that is not up to date");
  inwards_ = {};
  work_.springs.list_changed();
}

StepResult Stepper::advance(bool readings, double alarm) {
  enter_order();
  const std::size_t exits_before = model_.exits.size();
  StepResult moved = dynamics::advance(
      model_, work_, readings || needs_contact_forces(model_.settings), alarm);
  if (moved.block >= 0)
    moved.block = number_in_deck(model_.order, moved.block);
  // All new exits have the same time, so they are sorted by block.
  const auto exits = std::span(model_.exits).subspan(exits_before);
  for (DomainExit& exit : exits)
    exit.block = number_in_deck(model_.order, exit.block);
  std::ranges::sort(exits, {}, &DomainExit::block);
  return moved;
}

int Stepper::crack() {
  if (!may_crack(model_.settings))
    return 0;
  enter_order();
  const int cracks = crack_blocks(model_, work_, model_.order, [&] {
    if (!before_split)
      return;
    leave_order();
    before_split();
    enter_order();
  });
  if (cracks == 0)
    return 0;
  extend_order();
  leave_order();
  print_pieces(model_, cracks);
  return cracks;
}

void Stepper::enter_order() {
  if (is_in_order_ || model_.order.empty())
    return;
  if (inwards_.blocks().size() == 0)
    inwards_ = Numbering(model_.blocks, model_.order);
  inwards_.renumber(model_);
  is_in_order_ = true;
}

void Stepper::leave_order() {
  if (!is_in_order_)
    return;
  inwards_.reverse().renumber(model_);
  is_in_order_ = false;
}

void Stepper::extend_order() {
  if (!is_in_order_)
    return;
  for (int b = static_cast<int>(model_.order.size()); b < model_.blocks.size(); ++b)
    model_.order.push_back(b);
  inwards_ = Numbering::of_renumbered(model_.blocks, model_.order);
}

const Model& Stepper::up_to_date() {
  catch_up(model_, work_);
  leave_order();
  return model_;
}

const Model& Stepper::complete() {
  up_to_date();
  if (work_.springs.arrays_are_current() || work_.springs.arrays_lack_pieces())
    model_.kept = kept_decisions(work_);
  return model_;  // otherwise no step has been made, and the decisions are still there
}

std::vector<std::pair<int, int>> Stepper::listed_pairs() const {
  std::vector<std::pair<int, int>> listed;
  for (const NearPair& pair : work_.index.pairs)
    listed.push_back(std::minmax({number_in_deck(model_.order, pair.low),
                                  number_in_deck(model_.order, pair.high)}));
  std::sort(listed.begin(), listed.end());
  return listed;
}

}  // namespace blocks::dynamics
