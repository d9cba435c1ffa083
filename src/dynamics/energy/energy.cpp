#include "dynamics/energy/energy.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "dynamics/energy/spring_energy.hpp"
#include "dynamics/loads/loads.hpp"
#include "dynamics/loads/quiet_sides.hpp"
#include "dynamics/loads/symmetry_planes.hpp"

namespace blocks::dynamics {
namespace {

/// Adds up what the contacts of all pairs do, in the order of the pairs. Two fixed
/// blocks, such as those that have left the domain, are left out.
ContactTally tally_contacts(const Blocks& blocks, const ContactArrays& arrays,
                            Workers& workers, EnergyMemory& memory) {
  const ContactBatches& batches = arrays.batches;
  const auto visit = [&](int b, ContactTally& tally) {
    arrays.lows.each(b, [&](int lane) {
      if (blocks.may_touch(b, batches.at(lane, &BatchPairs::high)))
        tally.include(batches.works[lane]);
    });
  };
  return tally_all(blocks.size(), memory.contact_tallies, workers, visit);
}

/// Returns the energy of a spring of a plane, [F L].
double plane_spring(const Settings& settings, double force) {
  return force * force / (2.0 * settings.normal_stiffness);
}

double plane_springs(const Model& model) {
  double sum = 0.0;
  for (const PlaneContact& contact : model.plane_contacts)
    if (contact.active &&
        model.blocks.is_free(model.blocks.corner_block[contact.corner]))
      sum += plane_spring(model.settings, contact.normal_elastic);
  return sum;
}

/// Returns the energy of the springs in the list of contacts. They are added up in the
/// order of tally_contacts, so that both sums have the same bits.
double listed_springs(const Model& model, const LawTable& laws) {
  const SpringEnergies springs(model.settings, laws);
  double sum = 0.0, of_chunk = 0.0, of_pair = 0.0;
  std::pair<int, int> last = {-1, -1};
  for (std::size_t i = 0; i < model.contacts.size(); ++i) {
    const auto [low, high] = pair_of(model.blocks, model.contacts[i]);
    if (!model.blocks.may_touch(low, high))
      continue;
    if (std::pair(low, high) != last)
      of_chunk += std::exchange(of_pair, 0.0);
    if (low / items_of_chunk != last.first / items_of_chunk)
      sum += std::exchange(of_chunk, 0.0);
    last = {low, high};
    const LawState* const state =
        model.law_states.empty() ? nullptr : &model.law_states[i];
    of_pair += springs.of(model.contacts[i], state).both();
  }
  return sum + (of_chunk + of_pair);
}

/// The kinetic and the strain energy of the present state.
BlockTally present_energy(const Model& model, Workers& workers, EnergyMemory& memory) {
  const auto visit = [&](int b, BlockTally& tally) {
    const BlockEnergy energy = energy_of(model, b);
    tally.next_kinetic += energy.kinetic;
    tally.next_strain += energy.strain;
  };
  return tally_all(model.blocks.size(), memory.block_tallies, workers, visit);
}

/// Takes what has changed since the last step by other causes than steps.
void count_changes(Model& model, EnergyEntry entry, const LawTable& laws,
                   Workers& workers, EnergyMemory& memory) {
  EnergyAccount& account = model.energy;
  const BlockTally blocks = present_energy(model, workers, memory);
  const double elastic = listed_springs(model, laws) + plane_springs(model);
  account.add(entry, account.next_kinetic - blocks.next_kinetic);
  account.add(entry, account.next_strain - blocks.next_strain);
  account.add(entry, account.elastic - elastic);
  account.kinetic -= account.next_kinetic - blocks.next_kinetic;
  account.next_kinetic = blocks.next_kinetic;
  account.next_strain = blocks.next_strain;
  account.elastic = elastic;
}

/// Adds up the contacts with planes. A plane has a normal spring and no friction.
ContactTally tally_planes(const Model& model) {
  ContactTally tally;
  const double dt = model.time_step.dt;
  for (const PlaneContact& contact : model.plane_contacts) {
    const PlaneForce force = plane_force(model.blocks, contact, model.settings, dt);
    if (!force.acts)
      continue;
    ContactStep<double> step{};
    step.normal_before = contact.normal_elastic;
    step.normal = force.spring;
    step.normal_force = force.normal;
    step.closing = force.closing * dt;
    step.share = 1.0;
    step.normal_energy_before = plane_spring(model.settings, step.normal_before);
    step.normal_energy = plane_spring(model.settings, step.normal);
    step.normal_energy_acting = step.normal_energy;
    tally.include(work_of(step));
    tally.integration += dt * (force.normal * force.lag);
  }
  return tally;
}

/// Returns the work of the water.
double work_of_water(const Model& model, Workers& workers, EnergyMemory& memory) {
  const Blocks& blocks = model.blocks;
  if (model.loads.water.none())
    return 0.0;
  const auto visit = [&](int b, BlockTally& tally) {
    if (blocks.is_removed(b))
      return;
    const BlockWater sum = WaterNow(model.loads.water, model.time).on_block(blocks, b);
    tally.water +=
        sum.force.dot(Vec2(blocks.velocity.col(b))) + sum.moment * blocks.spin[b];
    for (int i = 0; i < 4; ++i)
      tally.water += sum.sums[i] * blocks.strain_rate(i, b);
  };
  const double power =
      tally_all(blocks.size(), memory.block_tallies, workers, visit).water;
  return power * model.time_step.dt;
}

/// Keeps the motion of the blocks before the step. Returns the work of their stresses.
double keep_motion(const Model& model, EnergyMemory& memory) {
  const Blocks& blocks = model.blocks;
  const auto n = static_cast<std::size_t>(blocks.size());
  memory.before.resize(n);
  memory.masses.resize(n);
  memory.damped.assign(n, 0.0);
  double work = 0.0;
  for (int b = 0; b < blocks.size(); ++b) {
    const auto i = static_cast<std::size_t>(b);
    memory.before[i] = motion_of(blocks, b);
    memory.masses[i] = masses_of(blocks, b, model.settings.rigid);
    if (!model.settings.rigid && blocks.is_free(b))
      work += stress_work(blocks, b, model.time_step.dt);
  }
  return work;
}

}  // namespace

void begin_energy(Model& model) {
  EnergyAccount& account = model.energy;
  const std::vector<std::string>& quantities = model.history.quantities;
  const bool needed =
      std::any_of(quantities.begin(), quantities.end(),
                  [](const std::string& name) { return name.starts_with("energy:"); });
  if (!needed || account.kept)
    return;
  Workers workers;
  EnergyMemory memory;
  LawTable laws;
  laws.make(model.settings, model.blocks);
  const BlockTally blocks = present_energy(model, workers, memory);
  account.kept = true;
  account.sums.assign(energy_entries, 0.0);
  account.errors.assign(energy_entries, 0.0);
  account.kinetic = account.next_kinetic = blocks.next_kinetic;
  account.strain = account.next_strain = blocks.next_strain;
  account.elastic = listed_springs(model, laws) + plane_springs(model);
  account.start = account.kinetic + account.strain + account.elastic;
}

void count_forces(Model& model, const ContactArrays& arrays, bool list_is_current,
                  Workers& workers, EnergyMemory& memory) {
  EnergyAccount& account = model.energy;
  if (list_is_current)
    count_changes(model, EnergyEntry::removed, arrays.laws, workers, memory);
  ContactTally contacts = tally_contacts(model.blocks, arrays, workers, memory);
  contacts.include(tally_planes(model));
  account.add(EnergyEntry::dilation, contacts.dilation);
  account.add(EnergyEntry::friction, contacts.friction);
  account.add(EnergyEntry::dashpots, contacts.dashpots);
  account.add(EnergyEntry::breaking, contacts.breaking);
  account.add(EnergyEntry::hysteresis, contacts.hysteresis);
  account.add(EnergyEntry::integration, contacts.integration);
  account.add(EnergyEntry::transfer, account.elastic - contacts.before);
  account.elastic = contacts.after;
  account.add(EnergyEntry::loads, power_of_loads(model) * model.time_step.dt);
  account.add(EnergyEntry::water, work_of_water(model, workers, memory));
  if (!model.loads.quiet_sides.empty()) {
    const QuietPower power = power_of_quiet_sides(model);
    account.add(EnergyEntry::loads, power.constant * model.time_step.dt);
    account.add(EnergyEntry::quiet, -power.dashpots * model.time_step.dt);
  }
  account.add(EnergyEntry::integration,
              keep_motion(model, memory) - account.strain_work);
  account.strain = account.next_strain;
}

void count_cracks(Model& model, Workers& workers, EnergyMemory& memory) {
  LawTable laws;
  laws.make(model.settings, model.blocks);
  const double before = model.energy.next_strain;
  count_changes(model, EnergyEntry::cracks, laws, workers, memory);
  model.energy.strain -= before - model.energy.next_strain;
}

namespace {

/// Compares the motion before and after the step. If the step has stopped the blocks,
/// it took the kinetic energy that they had at the positions of the forces.
BlockTally tally_motion(const Model& model, const Vec2& gravity, Workers& workers,
                        EnergyMemory& memory) {
  const Blocks& blocks = model.blocks;
  const bool rigid = model.settings.rigid;
  const double dt = model.time_step.dt;
  const auto visit = [&](int b, BlockTally& tally) {
    const BlockMotion& before = memory.before[static_cast<std::size_t>(b)];
    tally.next_strain += strain_energy(model, b);
    if (!blocks.is_free(b)) {
      // No force changes the velocity of a driven block.
      tally.drives -= dt * (blocks.force.col(b).dot(before.velocity) +
                            blocks.moment[b] * before.spin);
      return;
    }
    const BlockMasses& masses = memory.masses[static_cast<std::size_t>(b)];
    const BlockMotion now = motion_of(blocks, b);
    const BlockMotion after = rigid ? now : turned_back(now, dt);
    BlockMotion change = after;
    change.velocity -= before.velocity;
    change.spin -= before.spin;
    for (int i = 0; i < 3; ++i)
      change.rate[i] -= before.rate[i];
    const double both = kinetic_energy(masses, before, after);
    if (memory.stopped) {
      // Half a step of the forces has made `after`.
      tally.artificial += kinetic_energy(masses, before, before) + 2.0 * both;
      tally.error += 2.0 * both;
    } else {
      tally.kinetic += both;
      tally.error += kinetic_energy(masses, before, change);
    }
    tally.next_kinetic += kinetic_energy(masses_of(blocks, b, rigid), now, now);
    tally.artificial += memory.damped[static_cast<std::size_t>(b)];
    tally.gravity += dt * blocks.mass[b] * gravity.dot(before.velocity);
    if (!rigid)
      tally.strain_work += last_stress_work(model, b);
  };
  return tally_all(blocks.size(), memory.block_tallies, workers, visit);
}

}  // namespace

void count_motion(Model& model, const Vec2& gravity, bool stopped, Workers& workers,
                  EnergyMemory& memory) {
  EnergyAccount& account = model.energy;
  memory.stopped = stopped;
  const BlockTally blocks = tally_motion(model, gravity, workers, memory);
  account.add(EnergyEntry::gravity, blocks.gravity);
  account.add(EnergyEntry::drives, blocks.drives);
  account.add(EnergyEntry::artificial, blocks.artificial);
  account.add(EnergyEntry::integration, blocks.error);
  account.add(EnergyEntry::integration, account.kinetic - account.next_kinetic);
  account.kinetic = blocks.kinetic;
  account.next_kinetic = blocks.next_kinetic;
  account.next_strain = blocks.next_strain;
  account.strain_work = blocks.strain_work;
}

void count_fixed(Model& model, const ContactArrays& arrays, Workers& workers,
                 EnergyMemory& memory) {
  EnergyAccount& account = model.energy;
  const BlockTally blocks = tally_motion(model, {0, 0}, workers, memory);
  account.add(EnergyEntry::removed, account.kinetic - blocks.kinetic);
  account.kinetic = blocks.kinetic;
  account.next_kinetic = blocks.next_kinetic;
  const double elastic = tally_contacts(model.blocks, arrays, workers, memory).after +
                         plane_springs(model);
  account.add(EnergyEntry::removed, account.elastic - elastic);
  account.elastic = elastic;
}

}  // namespace blocks::dynamics
