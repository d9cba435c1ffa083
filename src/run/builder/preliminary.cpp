// START to END: the preliminary cards, without FUNCTION and FRACTION; and FRICTN.
#include <fmt/format.h>

#include <algorithm>

#include "quantities/units.hpp"
#include "run/builder/cards.hpp"

namespace blocks::run {
namespace {

/// Warns of a unit that cannot be converted, or that is one of another dimension.
void check_unit(const Context& context, const deck::Word& unit,
                const quantities::KnownUnits& wanted) {
  const std::string& name = unit.value;
  if (wanted.size_of(name))
    return;
  std::string message =
      fmt::format("{} is no known unit, so --units cannot convert it", name);
  for (const quantities::KnownUnits* other :
       {&quantities::known_lengths(), &quantities::known_masses(),
        &quantities::known_times()})
    if (other->size_of(name))
      message = fmt::format("{} is a unit of {}, not of {}", name, other->dimension,
                            wanted.dimension);
  context.warning(
      unit.where, message,
      fmt::format("known units of {}: {}", wanted.dimension, wanted.names()));
}

void check_elastic(const Context& context, const deck::Material& card) {
  const double e = card.e.value, g = card.g.value;
  const char* const hint = "or make the blocks rigid with a RIGID card";
  if (!(e > 0.0))
    context.error(card.e.where, "deformable blocks need E > 0", hint);
  else if (!(g > 0.0))
    context.error(card.g.where, "deformable blocks need G > 0", hint);
  else if (!(g > e / 3.0))
    context.error(
        card.g.where,
        fmt::format("deformable blocks need G > E/3 = {:.9g} (Poisson's ratio < 0.5)",
                    e / 3.0),
        hint);
}

}  // namespace

void act(const Context& context, const deck::Start& card) {
  constexpr long max = 1'000'000'000;
  Settings& settings = context.settings;
  settings.title = card.title;
  settings.max_blocks = static_cast<int>(std::min(card.nblok.value, max));
  settings.max_corners = static_cast<int>(std::min(card.ncmx.value, max));
}

void act(const Context& context, const deck::XLimits& card) {
  context.settings.lower.x() = card.xmin.value;
  context.settings.upper.x() = card.xmax.value;
  context.state.places.x_limits = context.command.where;
}

void act(const Context& context, const deck::YLimits& card) {
  context.settings.lower.y() = card.ymin.value;
  context.settings.upper.y() = card.ymax.value;
  context.state.places.y_limits = context.command.where;
}

void act(const Context& context, const deck::Boxes& card) {
  constexpr long max = 100'000'000;  // 400 MB of box pointers
  if (card.iboxes.value > max || card.jboxes.value > max / card.iboxes.value) {
    context.error(card.iboxes.where, "too many boxes",
                  fmt::format("iboxes times jboxes may be {} at most", max));
    return;
  }
  context.settings.boxes_x = static_cast<int>(card.iboxes.value);
  context.settings.boxes_y = static_cast<int>(card.jboxes.value);
  context.settings.contact_tolerance = card.ctol.value;
  context.state.places.tolerance = card.ctol.where;
}

void act(const Context& context, const deck::Stiff& card) {
  context.settings.normal_stiffness = card.stifn.value;
  context.settings.shear_stiffness = card.stifs.value;
  context.state.places.stiffness = card.stifn.where;
}

void act(const Context& context, const deck::Frictn& card) {
  context.settings.friction = card.fric.value;
}

void act(const Context& context, const deck::Material& card) {
  const auto number = static_cast<int>(card.mat.value);
  context.settings.materials[number] = {card.e.value, card.g.value, card.rho.value,
                                        card.name.value};
  context.state.materials.push_back(context.command);
  context.state.places.modulus[number] = card.e.where;
}

void act(const Context& context, const deck::Rigid&) { context.settings.rigid = true; }

void act(const Context& context, const deck::Seed& card) {
  if (!context.state.options.seed)
    context.settings.seed = static_cast<std::uint64_t>(card.seed.value);
}

void act(const Context& context, const deck::Units& card) {
  check_unit(context, card.length, quantities::known_lengths());
  check_unit(context, card.mass, quantities::known_masses());
  check_unit(context, card.time, quantities::known_times());
  context.settings.units = {card.length.value, card.mass.value, card.time.value};
}

void act(const Context& context, const deck::End&) {
  if (context.settings.rigid || context.state.unread.has("RIGID"))
    return;
  for (const deck::Command& material : context.state.materials)
    check_elastic(context.of(material), std::get<deck::Material>(material.card));
}

}  // namespace blocks::run
