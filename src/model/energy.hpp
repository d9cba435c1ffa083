// The energy account of a run: what has been put into the blocks, what they have, and
// what has taken the rest (docs/laws.md#energy).
#pragma once

#include <vector>

namespace blocks {

/// Energy that has passed since the account began. The first five put energy into the
/// blocks, the others take it.
enum class EnergyEntry : int {
  gravity,   ///< work of gravity
  loads,     ///< work of PRESSBC, FORCE and the constant forces of QUIET
  water,     ///< work of the water of WATER and JWATER
  drives,    ///< work of the cards DRIVE
  dilation,  ///< work of the dilation of joints against their normal force
  friction,
  dashpots,
  breaking,    ///< springs and work lost in the steps in which contacts fail
  hysteresis,  ///< work lost in Walton's normal spring
  /// springs that ended with their contacts, less those that others took over
  transfer,
  /// kinetic energy and springs of blocks that were fixed or removed, or that left the
  /// domain; negative if cards have added energy
  removed,
  artificial,   ///< taken by LOCDAMP, KINDAMP and MDAMP
  quiet,        ///< carried off through the dashpots of QUIET
  cracks,       ///< strain and kinetic energy released when blocks split
  integration,  ///< error of the integration in time, which vanishes with the time step
};
inline constexpr int energy_entries = 15;
inline constexpr int first_taken_entry = static_cast<int>(EnergyEntry::friction);

/// The account. Energies are in [F L]. Those of the state belong to the positions at
/// which the last step evaluated the forces, one step before the present ones.
struct EnergyAccount {
  bool kept = false;  ///< whether steps keep the account
  /// kinetic, elastic and strain energy when the account began
  double start = 0.0;
  double kinetic =
      0.0;  ///< mass times the velocities before and after the step, halved
  double elastic = 0.0;  ///< of the springs of contacts and planes
  double strain = 0.0;   ///< of the stresses of deformable blocks
  // What the next step needs.
  double next_kinetic = 0.0;  ///< of the present velocities
  double next_strain = 0.0;   ///< of the present stresses
  double strain_work = 0.0;   ///< work that changed `strain` to `next_strain`
  /// (energy_entries) sums of the entries and their rounding errors; empty if no
  /// account is kept
  std::vector<double> sums, errors;

  /// Adds to an entry, and keeps what rounding loses.
  void add(EnergyEntry entry, double amount);
  /// Returns an entry; 0 if no account is kept.
  double of(EnergyEntry entry) const;
  /// Returns what was put in minus what is there and what was taken. It is 0 except
  /// for rounding.
  double residual() const;
  /// Returns the energy that has passed through the model: half the sum of the
  /// magnitudes of all terms of the residual.
  double at_play() const;
};

}  // namespace blocks
