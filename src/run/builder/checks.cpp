#include "run/builder/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "dynamics/preparation/time_step.hpp"
#include "run/support/contact_memory.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

void check_memory(const Context& motion) {
  const double ctol = motion.settings.contact_tolerance, memory = physical_memory();
  const LikelyList list = likely_list(motion.blocks, 2.0 * ctol);
  if (list.bytes <= 0.8 * memory)  // leaves memory for the rest of the run
    return;
  constexpr double gigabyte = 1e9;
  const auto& tolerance = motion.state.places.tolerance;
  motion.diagnostics.error(
      tolerance.value_or(motion.command.where),
      tolerance ? "BOXES" : motion.command.name,
      fmt::format("with ctol = {:g} about {:.2g} pairs of blocks are near each other",
                  ctol, list.pairs),
      fmt::format("their contacts need about {:.2g} GB, and this machine has {:.2g} GB "
                  "for the whole run; reduce ctol to a small part of a block",
                  list.bytes / gigabyte, memory / gigabyte));
}

/// Tells that the stiffness of blocks determines the time step.
void check_elastic_step(const Context& motion) {
  if (motion.settings.rigid || motion.model.time_step.blocks == motion.blocks.size())
    return;
  const TimeStep chosen = dynamics::choose_time_step(motion.model);
  if (chosen.elastic)
    motion.warning(
        fmt::format("the time step is cut to {:.4g} by the stiffness of {}block {}",
                    chosen.dt, chosen.pieces ? "a piece of " : "", chosen.block + 1),
        "deformable blocks need dt < l sqrt(rho / C11); half of that is taken");
}

/// Warns at the card that made the second block. `hint` goes before the usual hint.
void warn_of_overlap(const Context& motion, const geometry::BlockOverlap& pair,
                     std::string hint) {
  const BlockMakers::Maker* first = motion.state.makers.of(pair.first);
  const BlockMakers::Maker* second = motion.state.makers.of(pair.second);
  if (first != nullptr && first != second)
    hint += fmt::format("block {} is made by {}; ", pair.first + 1, first->text());
  hint += "an overlap at the start carries no force";
  const deck::Command& command = motion.command;
  motion.diagnostics.warning(
      second ? second->where : command.where, second ? second->name : command.name,
      fmt::format("blocks {} and {} overlap by an area of {} near ({:.6g}, {:.6g})",
                  pair.first + 1, pair.second + 1,
                  geometry::positive_text(pair.area, 3), pair.place.x(),
                  pair.place.y()),
      hint);
}

}  // namespace

void check_before_motion(const Context& motion, bool in_place) {
  const Blocks& blocks = motion.blocks;
  if (blocks.size() == 0) {
    motion.error("there are no blocks to move",
                 "make some with CREATE, LAYER or READ9");
    return;
  }
  if (blocks.count_present() == 0) {
    motion.error("all blocks are removed, so there is nothing to move",
                 "remove fewer blocks, or make others");
    return;
  }
  check_fraction(motion);
  check_steps(motion);
  check_history_interval(motion);
  if (!in_place)
    return;
  const auto is_free = [](Fixity fixity) { return fixity == Fixity::free; };
  if (blocks.count_present() < blocks.size() &&
      std::none_of(blocks.fixity.begin(), blocks.fixity.end(), is_free))
    motion.warning("all free blocks are removed, so nothing will move",
                   "FREE frees fixed blocks");
  check_planes(motion);
  check_cracks(motion);
  check_overlaps(motion);
  check_memory(motion);
  check_elastic_step(motion);
  motion.state.checked_blocks = motion.state.moved_blocks = blocks.size();
}

void check_overlaps(const Context& motion) {
  BuilderState& state = motion.state;
  if (state.certificate && state.certificate->blocks == motion.blocks.size())
    return;
  const geometry::ProgressFunction& progress = state.options.check_progress;
  AssemblyCertificate before;
  before.overlaps =
      state.certificate ? state.certificate->overlaps : state.options.overlaps;
  AssemblyCertificate found =
      certify_assembly(motion.blocks, state.moved_blocks, before, progress);
  if (progress)
    progress("", 1.0);
  found.joints.t_junctions = std::vector<geometry::TJunction>();  // number suffices
  state.certificate = std::make_shared<const AssemblyCertificate>(std::move(found));
  std::vector<geometry::BlockOverlap> pairs = state.certificate->overlaps;
  std::erase_if(pairs,
                [&](const auto& pair) { return pair.second < state.checked_blocks; });
  constexpr std::size_t shown = 10;
  for (std::size_t i = 0; i < std::min(pairs.size(), shown); ++i)
    warn_of_overlap(motion, pairs[i],
                    i + 1 == shown && pairs.size() > shown
                        ? "and " + counted(pairs.size() - shown, "more pair") + "; "
                        : "");
}

}  // namespace blocks::run
