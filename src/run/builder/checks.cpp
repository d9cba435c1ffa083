// Checks of the model before and between motions: the blocks, the time step, planes and
// overlaps.
#include "run/builder/builder.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "dynamics/preparation/time_step.hpp"
#include "model/equilibrium.hpp"
#include "model/safe_fraction.hpp"
#include "model/words/time_step_text.hpp"
#include "run/builder/history_card.hpp"
#include "run/plausibility/plane_check.hpp"
#include "run/support/contact_room.hpp"
#include "text/counted.hpp"

namespace blocks::run {

using deck::Command;

void Builder::check_plausibility(const Command& motion) {
  plausibility_.test(Moment::motion, plan({&motion, 1}), motion, diagnostics_);
  domain_blocks_ = model_.blocks.size();
}

void Builder::check_deck(std::span<const Command> cards, bool driven) {
  if (driven)
    plausibility_.leave_out("no-motion");
  if (!cards.empty())
    plausibility_.test(Moment::end, plan(cards), cards.back(), diagnostics_);
}

Plan Builder::plan(std::span<const Command> cards) const {
  return {model_, makers_, places_, domain_blocks_, cards, chosen_};
}

void Builder::check_before_motion(const Command& command, bool in_place) {
  const Blocks& blocks = model_.blocks;
  if (blocks.size() == 0) {
    diagnostics_.error(command.where, command.name, "there are no blocks to move",
                       "make some with CREATE, LAYER or READ9");
    return;
  }
  if (blocks.count_present() == 0) {
    diagnostics_.error(command.where, command.name,
                       "all blocks are removed, so there is nothing to move",
                       "remove fewer blocks, or make others");
    return;
  }
  check_fraction(command);
  check_steps(command);
  check_history_interval(command);
  if (!in_place)
    return;
  const auto is_free = [](Fixity fixity) { return fixity == Fixity::free; };
  if (blocks.count_present() < blocks.size() &&
      std::none_of(blocks.fixity.begin(), blocks.fixity.end(), is_free))
    diagnostics_.warning(command.where, command.name,
                         "all free blocks are removed, so nothing will move",
                         "FREE frees fixed blocks");
  check_planes();
  check_cracks();
  check_overlaps(command);
  check_memory(command);
  const bool is_new_step = model_.time_step.blocks != blocks.size();
  if (!model_.settings.rigid && is_new_step) {
    const TimeStep chosen = dynamics::choose_time_step(model_);
    if (chosen.elastic)
      diagnostics_.warning(
          command.where, command.name,
          fmt::format("the time step is cut to {:.4g} by the stiffness of {}block {}",
                      chosen.dt, chosen.pieces ? "a piece of " : "", chosen.block + 1),
          "deformable blocks need dt < l sqrt(rho / C11); half of that is taken");
  }
  checked_blocks_ = moved_blocks_ = blocks.size();
}

void Builder::check_despite_errors(const Command& command) {
  if (model_.blocks.count_present() == 0 || max_missing(command.where.line) > 0)
    return;
  const auto is_unread = [&](const char* card) { return unread_.has(card); };
  constexpr const char* of_the_step[] = {"FRACTION", "DAMPING", "LOCDAMP", "KINDAMP"};
  if (std::none_of(std::begin(of_the_step), std::end(of_the_step), is_unread))
    check_fraction(command);
  check_planes();
}

void Builder::check_memory(const Command& command) {
  const double ctol = model_.settings.contact_tolerance, memory = physical_memory();
  const LikelyList list = likely_list(model_.blocks, 2.0 * ctol);
  if (list.bytes <= 0.8 * memory)  // leaves memory for the rest of the run
    return;
  constexpr double gigabyte = 1e9;
  diagnostics_.error(
      places_.tolerance.value_or(command.where),
      places_.tolerance ? "BOXES" : command.name,
      fmt::format("with ctol = {:g} about {:.2g} pairs of blocks are near each other",
                  ctol, list.pairs),
      fmt::format("their contacts need about {:.2g} GB, and this machine has {:.2g} GB "
                  "for the whole run; reduce ctol to a small part of a block",
                  list.bytes / gigabyte, memory / gigabyte));
}

void Builder::check_without_motion(const Command& last) {
  if (model_.blocks.count_present() == 0)
    return;
  if (model_.blocks.size() != checked_blocks_)
    check_planes();
  check_overlaps(last);
}

void Builder::error_no_block(const Command& command, const deck::Int& number) {
  const int count = model_.blocks.size();
  // OUTPUT and HISTORY may name the blocks of later cards.
  const bool anywhere = std::holds_alternative<deck::Output>(command.card) ||
                        std::holds_alternative<deck::History>(command.card);
  const long max = count + max_missing(anywhere ? std::numeric_limits<int>::max()
                                                : command.where.line);
  if (number.value > count && number.value <= max)
    return;
  diagnostics_.error(
      number.where, command.name, fmt::format("there is no block {}", number.value),
      max == 0      ? "no block has been created so far"
      : max > count ? fmt::format("at most {} {} here", counted(max, "block"),
                                  max == 1 ? "exists" : "exist")
      : count == 1  ? std::string("only block 1 exists here")
                    : fmt::format("blocks 1 to {} exist here", count));
}

void Builder::check_output_blocks() {
  for (const Command& command : std::exchange(histories_, {}))
    check_history_blocks(command);
  if (!output_)
    return;
  for (const auto& [number, selector] : std::get<deck::Output>(output_->card).blocks)
    if (selector)
      continue;
    else if (is_unsure(number.value))
      error_unsure(*output_, number);
    else if (number.value < 1 || number.value > last_number())
      error_no_block(*output_, number);
  output_.reset();
}

void Builder::check_history_blocks(const Command& command) {
  const Blocks& blocks = model_.blocks;
  const quantities::MaterialNumbers numbers = material_numbers(model_.settings);
  deck::Diagnostics card_faults("",
                                "");  // faults of the card itself are reported before
  for (const auto& [curve, where] : named_curves(command, card_faults)) {
    if (const quantities::OtherKind* kind = quantities::find_other(curve.quantity);
        model_.settings.joint_laws.empty() && !unread_.may_define_joint(0) &&
        ((kind != nullptr && kind->of_laws) || curve.joint > 0)) {
      diagnostics_.error(where, command.name,
                         curve.name() + " needs a joint with a law",
                         "JOINT defines a law, JPAIR gives it to materials");
    } else if (curve.joint > 0 && !model_.settings.joint_laws.contains(curve.joint) &&
               !unread_.may_define_joint(curve.joint)) {
      diagnostics_.error(where, command.name,
                         fmt::format("no JOINT card above has the id {}", curve.joint),
                         "name a joint that has a law");
    } else if (is_unsure(curve.last)) {
      error_unsure(command, {curve.last, where, true});
    } else if (curve.last > last_number()) {
      error_no_block(command, {curve.last, where, true});
    } else if (curve.corner > 0 && curve.corner > corners_of(curve.first)) {
      diagnostics_.error(
          where, command.name,
          fmt::format("block {} has no corner {}", curve.first, curve.corner),
          fmt::format("it has corners 1 to {}", corners_of(curve.first)));
    } else if (const int material =
                   quantities::material_number(curve.material, numbers);
               model_.settings.materials.contains(material) &&
               std::count(blocks.material.begin(), blocks.material.end(), material) ==
                   0 &&
               max_missing(std::numeric_limits<int>::max()) == 0) {
      diagnostics_.error(where, command.name,
                         "no block is of material " + curve.material,
                         "name a material of blocks, or create blocks of this one");
    }
  }
}

int Builder::corners_of(long number) const {
  const auto b = static_cast<int>(missing_.index_of(number));
  return b >= 0 && b < certain_blocks_ ? model_.blocks.corners_of(b)
                                       : std::numeric_limits<int>::max();
}

void Builder::check_history_interval(const Command& motion) {
  const double interval = model_.history.interval;
  constexpr double max_per_step = 1000.0;
  if (interval == 0.0)
    return;
  const double dt = dynamics::choose_time_step(model_).dt;
  if (dt / interval > max_per_step)
    diagnostics_.error(
        histories_.empty() ? motion.where : histories_.back().where,
        histories_.empty() ? motion.name : "HISTORY",
        fmt::format("an interval of {:g} is less than a thousandth of the time step, "
                    "{:.4g}",
                    interval, dt),
        "values between two steps are interpolated; give about a time step or more");
}

void Builder::check_fraction(const Command& command) {
  const Settings& settings = model_.settings;
  const double safe = safe_fraction(settings);
  const Command& to_blame = fraction_by_ ? *fraction_by_ : command;
  if (settings.fraction > safe &&
      (warned_fraction_ == 0.0 || safe < warned_fraction_)) {
    const std::string given = fmt::format("FRACTION {:g} with {}", settings.fraction,
                                          damping_in_words(settings));
    const std::string hint = fmt::format(
        "for 8 contacts per block the largest safe FRACTION is {:.2g}; if it is blank, "
        "the program counts the contacts (docs/theory.md, time step)",
        safe);
    // Without damping, such a step is unstable even for a single contact.
    constexpr double refused = 3.0;
    const auto& fixity = model_.blocks.fixity;
    const bool may_be_packed =
        std::count(fixity.begin(), fixity.end(), Fixity::free) > 1;
    if (settings.fraction > refused * safe && may_be_packed)
      diagnostics_.error(to_blame.where, to_blame.name,
                         given + " is unstable: packed blocks would fly apart", hint);
    else
      diagnostics_.warning(to_blame.where, to_blame.name,
                           given + " may never let packed blocks come to rest", hint);
  }
  warned_fraction_ = safe;
}

void Builder::check_damping(const Command& solve) {
  const Settings& settings = model_.settings;
  if (settings.mass_scaling && !model_.loads.quiet_sides.empty())
    diagnostics_.warning(solve.where, solve.name,
                         "MSCALE does not act, because the model has quiet sides",
                         "their dashpots belong to the true masses; put QUIET after "
                         "SOLVE");
  if (settings.damping > 0.0 || is_damped_to_rest(settings) || unread_.has("RESTART"))
    return;
  diagnostics_.warning(solve.where, solve.name,
                       "nothing damps the motion, so the blocks may never come to rest",
                       "put LOCDAMP, KINDAMP or DAMPING before it (docs/rest.md)");
}

void Builder::check_steps(const Command& command) {
  const auto* motion = std::get_if<deck::Motion>(&command.card);
  if (motion == nullptr)
    return;
  constexpr double max = 1e15;
  const double dt = dynamics::choose_time_step(model_).dt;
  if (!(motion->dt.value / dt <= max))
    diagnostics_.error(motion->dt.where, command.name,
                       fmt::format("{:g} would take more than {:g} steps of {:g}",
                                   motion->dt.value, max, dt),
                       "give a shorter time");
  else if (motion->dt.value <= 1e-9 * dt)
    diagnostics_.warning(motion->dt.where, command.name,
                         fmt::format("{:g} is too short for a time step of {:.4g}",
                                     motion->dt.value, dt),
                         "no time passes; CYCLE, 1 makes one step");
}

void Builder::check_planes() {
  for (const Command& command : planes_) {
    const auto& card = std::get<deck::Splane>(command.card);
    const Vec2 a(card.x1.value, card.y1.value), b(card.x2.value, card.y2.value);
    const double rounding =
        0x1p-52 * std::max(a.lpNorm<Eigen::Infinity>(), b.lpNorm<Eigen::Infinity>());
    if (rounding > 1e-3 * model_.settings.contact_tolerance)
      diagnostics_.error(
          command.where, command.name,
          fmt::format(
              "the points are too far away: overlaps would be rounded to {:.2g}",
              rounding),
          "give two points of the plane near the blocks");
    if (are_all_behind(model_.blocks, {a, b}))
      diagnostics_.error(command.where, command.name,
                         "all blocks are on the wrong side of the plane",
                         "blocks must be on the left when looking from point 1 to "
                         "point 2: swap the points");
  }
  planes_.clear();
}

void Builder::check_overlaps(const Command& command) {
  if (certificate_ && certificate_->blocks == model_.blocks.size())
    return;
  AssemblyCertificate before;
  before.overlaps = certificate_ ? certificate_->overlaps : options_.overlaps;
  AssemblyCertificate found =
      certify_assembly(model_.blocks, moved_blocks_, before, options_.check_progress);
  if (options_.check_progress)
    options_.check_progress("", 1.0);
  found.joints.t_junctions = std::vector<geometry::TJunction>();  // number suffices
  certificate_ = std::make_shared<const AssemblyCertificate>(std::move(found));
  std::vector<geometry::BlockOverlap> pairs = certificate_->overlaps;
  std::erase_if(pairs,
                [this](const auto& pair) { return pair.second < checked_blocks_; });
  constexpr std::size_t shown = 10;
  for (std::size_t i = 0; i < std::min(pairs.size(), shown); ++i)
    warn_of_overlap(pairs[i], command,
                    i + 1 == shown && pairs.size() > shown
                        ? "and " + counted(pairs.size() - shown, "more pair") + "; "
                        : "");
}

void Builder::warn_of_overlap(const geometry::BlockOverlap& pair, const Command& motion,
                              std::string hint) {
  const BlockMakers::Maker* first = makers_.of(pair.first);
  const BlockMakers::Maker* second = makers_.of(pair.second);
  if (first != nullptr && first != second)
    hint += fmt::format("block {} is made by {}; ", pair.first + 1, first->text());
  hint += "an overlap at the start carries no force";
  diagnostics_.warning(
      second ? second->where : motion.where, second ? second->name : motion.name,
      fmt::format("blocks {} and {} overlap by an area of {} near ({:.6g}, {:.6g})",
                  pair.first + 1, pair.second + 1,
                  geometry::positive_text(pair.area, 3), pair.place.x(),
                  pair.place.y()),
      hint);
}

}  // namespace blocks::run
