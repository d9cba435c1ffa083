#include "dynamics/stepper.hpp"

#include <algorithm>
#include <iterator>

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

StepResult Stepper::advance(bool readings, double alarm) {
  readings = readings || needs_contact_forces(model_.settings);
  if (model_.order.empty())
    return dynamics::advance(model_, work_, readings, alarm);
  if (!inside_current_)
    bring_in();
  StepResult moved = dynamics::advance(inside_, work_, readings, alarm);
  if (moved.block >= 0)
    moved.block = outwards_.blocks().new_of[moved.block];
  outside_current_ = false;
  model_.kept = {};  // they were those of the moment before
  bring_out_time();
  return moved;
}

void Stepper::take_velocities_and_loads() {
  work_.decisions.expire_exact();
  model_.kept = {};
  if (model_.order.empty() || !inside_current_)
    return;
  inside_.blocks.velocity =
      model_.blocks.velocity(Eigen::all, inwards_.blocks().old_of);
  inside_.blocks.spin = model_.blocks.spin(inwards_.blocks().old_of);
  inside_.loads = inwards_.renumbered(model_.loads);
}

int Stepper::crack() {
  if (!may_crack(model_.settings))
    return 0;
  if (model_.order.empty()) {
    const int cracks = crack_blocks(model_, work_, {}, before_split);
    print_pieces(model_, cracks);
    return cracks;
  }
  const int cracks = crack_blocks(inside_, work_, model_.order);
  model_.crack_refusals = inside_.crack_refusals;
  if (cracks > 0) {
    if (before_split)
      before_split();
    adopt_pieces();
  }
  print_pieces(model_, cracks);
  return cracks;
}

void Stepper::adopt_pieces() {
  // New blocks have the same numbers inside and outside.
  for (int b = static_cast<int>(model_.order.size()); b < inside_.blocks.size(); ++b)
    model_.order.push_back(b);
  NewNumbers numbers{model_.order, std::vector<int>(model_.order.size())};
  for (int b = 0; b < numbers.size(); ++b)
    numbers
        .new_of[static_cast<std::size_t>(model_.order[static_cast<std::size_t>(b)])] =
        b;
  outwards_ = Numbering(inside_.blocks, numbers.new_of);
  inwards_ = outwards_.reverse();
  model_.cracks.insert(model_.cracks.end(), inside_.cracks.begin(),
                       inside_.cracks.end());
  inside_.cracks.clear();
  model_.loads = outwards_.renumbered(inside_.loads);
  model_.time_step = inside_.time_step;
  model_.search = inside_.search;
  model_.energy = inside_.energy;
  bring_out();
}

const Model& Stepper::up_to_date() {
  if (model_.order.empty()) {
    catch_up(model_, work_);
  } else if (!outside_current_) {
    catch_up(inside_, work_);
    bring_out();
  }
  return model_;
}

const Model& Stepper::complete() {
  up_to_date();
  if (work_.springs.arrays_are_current() || work_.springs.arrays_lack_pieces())
    model_.kept = kept_decisions(work_);
  return model_;  // otherwise no step has been made, and the decisions are still there
}

std::vector<std::pair<int, int>> Stepper::listed_pairs() const {
  const auto outside = [&](int b) {
    return model_.order.empty() ? b : model_.order[b];
  };
  std::vector<std::pair<int, int>> listed;
  for (const NearPair& pair : work_.index.pairs)
    listed.push_back(std::minmax({outside(pair.low), outside(pair.high)}));
  std::sort(listed.begin(), listed.end());
  return listed;
}

void Stepper::bring_in() {
  if (inwards_.blocks().old_of != model_.order) {
    inwards_ = Numbering(model_.blocks, model_.order);
    outwards_ = inwards_.reverse();
  }
  inwards_.renumber(model_.blocks, inside_.blocks);
  inside_.plane_contacts = inwards_.renumbered(model_.plane_contacts);
  inwards_.renumber(model_.contacts, model_.law_states, inside_.blocks,
                    inside_.contacts, inside_.law_states);
  inside_.loads = inwards_.renumbered(model_.loads);
  inside_.drives = inwards_.renumbered(model_.drives);
  inside_.servos = inwards_.renumbered(model_.servos);
  inside_.settings = model_.settings;
  inside_.crack_refusals = model_.crack_refusals;
  inside_.time_step = model_.time_step;
  inside_.search = model_.search;
  inside_.steps = model_.steps, inside_.step_origin = model_.step_origin;
  inside_.time = model_.time, inside_.time_origin = model_.time_origin;
  inside_.worst_overlap = model_.worst_overlap;
  inside_.energy = model_.energy;
  inside_.kept = std::move(model_.kept);
  model_.kept = {};
  inside_.last_kinetic_energy = model_.last_kinetic_energy;
  work_.springs.list_changed();
  inside_current_ = true;
}

void Stepper::bring_out() {
  outwards_.renumber(inside_.blocks, model_.blocks);
  model_.plane_contacts = outwards_.renumbered(inside_.plane_contacts);
  outwards_.renumber(inside_.contacts, inside_.law_states, model_.blocks,
                     model_.contacts, model_.law_states);
  outside_current_ = true;
}

void Stepper::bring_out_time() {
  model_.search = inside_.search;
  model_.steps = inside_.steps;
  model_.time = inside_.time;
  model_.worst_overlap = inside_.worst_overlap;
  // Servos change the velocities of drives. A driven block may have left the domain.
  if (!model_.servos.empty() || inside_.drives.size() != model_.drives.size()) {
    model_.drives = outwards_.renumbered(inside_.drives);
    model_.servos = outwards_.renumbered(inside_.servos);
  }
  model_.energy = inside_.energy;
  model_.last_kinetic_energy = inside_.last_kinetic_energy;
  // All new exits have the same time, so they are sorted by block.
  const auto reported = static_cast<std::ptrdiff_t>(model_.exits.size());
  for (const DomainExit& exit : inside_.exits)
    model_.exits.push_back({outwards_.blocks().new_of[exit.block], exit.time});
  inside_.exits.clear();
  std::sort(model_.exits.begin() + reported, model_.exits.end(),
            [](const DomainExit& l, const DomainExit& r) { return l.block < r.block; });
}

}  // namespace blocks::dynamics
