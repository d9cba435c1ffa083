#include "dynamics/energy_tally.hpp"

#include <cstddef>

namespace blocks::dynamics {

void ContactTally::add(const ContactWork& work) {
  const auto add_to = [&](EnergyEntry entry, double amount) {
    entries[static_cast<std::size_t>(entry)] += amount;
  };
  add_to(EnergyEntry::friction, work.friction);
  add_to(EnergyEntry::dashpots, work.dashpots);
  add_to(EnergyEntry::breaking, work.breaking);
  add_to(EnergyEntry::hysteresis, work.hysteresis);
  add_to(EnergyEntry::dilation, work.dilation);
  add_to(EnergyEntry::integration, work.integration);
}

void ContactTally::include(const ContactTally& other) {
  for (std::size_t i = 0; i < entries.size(); ++i)
    entries[i] += other.entries[i];
  before += other.before;
  after += other.after;
}

void BlockTally::include(const BlockTally& other) {
  gravity += other.gravity;
  drives += other.drives;
  artificial += other.artificial;
  kinetic += other.kinetic;
  next_kinetic += other.next_kinetic;
  error += other.error;
  next_strain += other.next_strain;
  strain_work += other.strain_work;
}

}  // namespace blocks::dynamics
