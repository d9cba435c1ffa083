#include "run/plausibility/card_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/points.hpp"
#include "dynamics/preparation/time_step.hpp"
#include "geometry/overlap.hpp"
#include "geometry/polygon.hpp"
#include "quantities/units.hpp"
#include "run/support/number_ranges.hpp"
#include "text/counted.hpp"

namespace blocks::run {
namespace {

/// Returns the blocks that are partly inside the outline and partly outside it. Blocks
/// that were removed before the card do not count; `chosen` are those of the card.
std::vector<int> crossed_blocks(const Blocks& blocks, const deck::Selection& named,
                                std::span<const int> chosen) {
  geometry::Polygon outline =
      geometry::place_outline(deck::points_of(named.x, named.y), {}, 0);
  const geometry::OutlineCheck check = geometry::check_outline(outline);
  if (check.fault != geometry::OutlineFault::none)
    return {};
  if (check.anticlockwise)
    outline = geometry::reversed(outline);
  constexpr double rounding = 1e-9;  // part of the block, as in geometry/region.hpp
  std::vector<int> crossed;
  for (int b = 0; b < blocks.size(); ++b) {
    if (blocks.is_removed(b) && !std::binary_search(chosen.begin(), chosen.end(), b))
      continue;
    const auto overlaps = geometry::overlapping_pairs({outline, blocks.outline(b)}, {},
                                                      geometry::Figures::quick);
    const double share = overlaps.empty() ? 0.0 : overlaps[0].area / blocks.area[b];
    if (rounding < share && share < 1.0 - rounding)
      crossed.push_back(b);
  }
  return crossed;
}

/// Whether a BOND card bonds faces of this joint id.
bool is_bonded(std::span<const deck::Command> cards, long id) {
  return std::any_of(cards.begin(), cards.end(), [&](const deck::Command& command) {
    const auto* bond = std::get_if<deck::Bond>(&command.card);
    return bond != nullptr && (bond->id.value == 0 || bond->id.value == id);
  });
}

}  // namespace

std::vector<Doubt> doubt_friction(const Plan& plan) {
  constexpr double greatest = 5.0;  // tan 79 degrees
  const deck::Command& command = plan.cards.back();
  const auto* frictn = std::get_if<deck::Frictn>(&command.card);
  const auto* joint = std::get_if<deck::Joint>(&command.card);
  const deck::Real* fric = frictn ? &frictn->fric : joint ? &joint->fric : nullptr;
  if (fric == nullptr || !(fric->value > greatest))
    return {};
  return {{fmt::format("the friction coefficient {:g} is very large", fric->value),
           "fric is the tangent of the friction angle, not an angle in degrees",
           fric->where, command.name}};
}

std::vector<Doubt> doubt_outline(const Plan& plan) {
  const deck::Command& command = plan.cards.back();
  const auto* remove = std::get_if<deck::Remove>(&command.card);
  const auto* free = std::get_if<deck::Free>(&command.card);
  const deck::Selection* named = remove ? &remove->blocks
                                 : free ? &free->blocks
                                        : nullptr;
  if (named == nullptr || !named->nc.given)
    return {};
  const std::vector<int> crossed =
      crossed_blocks(plan.model.blocks, *named, plan.chosen);
  if (crossed.empty())
    return {};
  std::string message =
      fmt::format("{} {} the outline", counted(crossed.size(), "block"),
                  crossed.size() == 1 ? "crosses" : "cross");
  if (!named->is_by_centroid())
    return {
        {message + ": " + number_ranges(crossed),
         command.name +
             " acts only on blocks that are entirely inside; draw the outline wider "
             "or narrower, along joints",
         named->nc.where, command.name}};
  std::vector<int> act, stay;
  for (const int b : crossed)
    (std::binary_search(plan.chosen.begin(), plan.chosen.end(), b) ? act : stay)
        .push_back(b);
  const char* done = remove != nullptr ? "removed" : "freed";
  if (!act.empty())
    message += fmt::format("; {}: {}", done, number_ranges(act));
  if (!stay.empty())
    message += fmt::format("; not {}: {}", done, number_ranges(stay));
  return {{message,
           "with CENTROID the centroid decides; a cut along the outline makes "
           "blocks that do not cross it",
           named->nc.where, command.name}};
}

std::vector<Doubt> doubt_water(const Plan& plan) {
  const deck::Command& command = plan.cards.back();
  const auto* water = std::get_if<deck::Water>(&command.card);
  if (water == nullptr || water->n.value == 0)
    return {};
  const Settings& settings = plan.model.settings;
  const double gravity = settings.gravity.norm();
  const deck::SourceLocation where = water->gamma.where;
  if (gravity == 0.0)
    return {{"water has weight, but no GRAVITY card above gives blocks theirs",
             "put GRAVITY before WATER", where, command.name}};
  const double density = water->gamma.value / gravity;
  const Units& units = settings.units;
  const auto length = quantities::known_lengths().size_of(units.length),
             mass = quantities::known_masses().size_of(units.mass);
  constexpr double in_si = 1000.0, many = 2.0;  // kg/m3
  if (length && mass) {
    const double known = density * *mass / std::pow(*length, 3);
    if (known < in_si / many || known > in_si * many)
      return {
          {fmt::format("gamma over gravity is a density of {:.3g} kg/m3, and that of "
                       "water is 1000",
                       known),
           "gamma is the density of water times the size of gravity, in the units "
           "of the deck",
           where, command.name}};
  }
  const bool floats =
      std::all_of(settings.materials.begin(), settings.materials.end(),
                  [&](const auto& one) { return one.second.density < density; });
  if (floats && !settings.materials.empty())
    return {{fmt::format("water of density {:g} is heavier than every material, so all "
                         "blocks float",
                         density),
             "gamma is the density of water times the size of gravity, in the units of "
             "the deck",
             where, command.name}};
  return {};
}

std::vector<Doubt> doubt_strength(const Plan& plan) {
  if (std::holds_alternative<deck::Restart>(plan.cards.front().card))
    return {};
  std::vector<Doubt> doubts;
  for (const deck::Command& command : plan.cards) {
    const auto* joint = std::get_if<deck::Joint>(&command.card);
    if (joint == nullptr || is_bonded(plan.cards, joint->id.value))
      continue;
    const bool cohesive = joint->coh.value > joint->cohr.value;
    if (!cohesive && !(joint->ten.value > joint->tenr.value))
      continue;
    const deck::Real& peak = cohesive ? joint->coh : joint->ten;
    const deck::Real& rest = cohesive ? joint->cohr : joint->tenr;
    doubts.push_back(
        {fmt::format("{} = {:g} does not act, because no BOND card bonds joint id {}",
                     cohesive ? "coh" : "ten", peak.value, joint->id.value),
         fmt::format("contacts that are not bonded have the residual value, {} = "
                     "{:g}{}; put BOND, {} after the cards that make the blocks",
                     cohesive ? "cohr" : "tenr", rest.value,
                     rest.given ? "" : " if blank", joint->id.value),
         peak.where, command.name});
  }
  return doubts;
}

std::vector<Doubt> doubt_ramp(const Plan& plan) {
  std::vector<Doubt> doubts;
  for (auto card = plan.cards.begin(); card != plan.cards.end(); ++card) {
    const auto* gravity = std::get_if<deck::Gravity>(&card->card);
    const auto* water = std::get_if<deck::Water>(&card->card);
    const deck::Real* ramp = gravity ? &gravity->tramp
                             : water ? &water->tramp
                                     : nullptr;
    if (ramp == nullptr || !(ramp->value > 0.0))
      continue;
    double left = 0.0;
    bool passes = false, solves = false, replaced = false;
    for (auto next = card + 1; next != plan.cards.end() && !replaced; ++next) {
      passes = passes || deck::passes_time(*next);
      replaced = next->card.index() == card->card.index();
      solves = solves || std::holds_alternative<deck::Solve>(next->card) ||
               std::holds_alternative<deck::Fos>(next->card);
      if (const auto* motion = std::get_if<deck::Motion>(&next->card))
        left += motion->dt.value;
      else if (const auto* cycle = std::get_if<deck::Cycle>(&next->card))
        left += static_cast<double>(cycle->ncycle.value) *
                dynamics::choose_time_step(plan.model).dt;
    }
    if (!passes || solves || replaced || left >= ramp->value)
      continue;
    doubts.push_back(
        {fmt::format("{} changes during {:g}, and the deck ends {:g} after this card",
                     gravity ? "gravity" : "the water table", ramp->value, left),
         gravity ? "a decimal comma makes two values of one: write 9.81, not 9,81; or "
                   "let the deck last longer"
                 : "let the deck last longer, or shorten tramp",
         ramp->where, card->name});
  }
  return doubts;
}

std::vector<Doubt> doubt_scaling(const Plan& plan) {
  std::vector<Doubt> doubts;
  for (auto card = plan.cards.begin(); card != plan.cards.end(); ++card) {
    const auto* scaling = std::get_if<deck::Mscale>(&card->card);
    if (scaling == nullptr || scaling->on.value == 0)
      continue;
    const bool acts = std::any_of(card, plan.cards.end(), [](const auto& next) {
      return std::holds_alternative<deck::Solve>(next.card) ||
             std::holds_alternative<deck::Fos>(next.card);
    });
    if (!acts)
      doubts.push_back({"masses are scaled only during SOLVE and FOS, and none follows",
                        "time has no meaning with scaled masses, so MOTION and CYCLE "
                        "never scale them",
                        card->where, card->name});
  }
  return doubts;
}

std::vector<Doubt> doubt_motion(const Plan& plan) {
  if (std::holds_alternative<deck::Restart>(plan.cards.front().card) ||
      std::any_of(plan.cards.begin(), plan.cards.end(), deck::passes_time))
    return {};
  return {{"the deck has no MOTION, CYCLE or SOLVE, so a run makes no step",
           "MOTION, dt passes a time, CYCLE, ncycle makes a number of steps, and SOLVE "
           "makes steps until the forces are balanced"}};
}

}  // namespace blocks::run
