#include "run/builder/units_check.hpp"

#include <fmt/format.h>

#include "quantities/units.hpp"

namespace blocks::run {
namespace {

using quantities::KnownUnits;

void check_unit(const deck::Word& unit, const KnownUnits& wanted,
                deck::Diagnostics& diagnostics) {
  const std::string& name = unit.value;
  if (wanted.size_of(name))
    return;
  std::string message =
      fmt::format("{} is no known unit, so --units cannot convert it", name);
  for (const KnownUnits* other :
       {&quantities::known_lengths(), &quantities::known_masses(),
        &quantities::known_times()})
    if (other->size_of(name))
      message = fmt::format("{} is a unit of {}, not of {}", name, other->dimension,
                            wanted.dimension);
  diagnostics.warning(
      unit.where, "UNITS", message,
      fmt::format("known units of {}: {}", wanted.dimension, wanted.names()));
}

}  // namespace

void check_units(const deck::Units& card, deck::Diagnostics& diagnostics) {
  check_unit(card.length, quantities::known_lengths(), diagnostics);
  check_unit(card.mass, quantities::known_masses(), diagnostics);
  check_unit(card.time, quantities::known_times(), diagnostics);
}

}  // namespace blocks::run
