// Sums of energies over contacts and blocks, which do not depend on the threads.
#pragma once

#include <algorithm>
#include <vector>

#include "dynamics/kernels/contact_work.hpp"
#include "dynamics/support/workers.hpp"

namespace blocks::dynamics {

/// Sums of energies over some contacts.
struct ContactTally : ContactWork<double> {
  ContactTally() : ContactWork{} {}
  void include(const ContactWork<double>& other) {
    each_work([](double& sum, double x) { sum += x; }, *this, other);
  }
};
/// Sums of energies over some blocks.
struct BlockTally {
  double gravity = 0.0, drives = 0.0, artificial = 0.0;
  double water = 0.0;         ///< power, [F L/T]
  double kinetic = 0.0;       ///< of the velocities before and after the step
  double next_kinetic = 0.0;  ///< of the velocities after the step
  /// The error of the step: half the velocities after the step times their change, less
  /// the energy of the change.
  double error = 0.0;
  double next_strain = 0.0, strain_work = 0.0;

  void include(const BlockTally& other) {
    gravity += other.gravity;
    drives += other.drives;
    artificial += other.artificial;
    water += other.water;
    kinetic += other.kinetic;
    next_kinetic += other.next_kinetic;
    error += other.error;
    next_strain += other.next_strain;
    strain_work += other.strain_work;
  }
};

inline constexpr int items_of_chunk = 64;
/// Adds up all items: calls visit(i, tally) for each of them. Items are added in chunks
/// of a fixed size, and chunks in their order, so the sum does not depend on the
/// threads. tallies: working memory.
template <class Tally, class Visit>
Tally tally_all(int count, std::vector<Tally>& tallies, Workers& workers,
                const Visit& visit) {
  constexpr int chunk = items_of_chunk, chunks_per_thread = 16;
  const int chunks = (count + chunk - 1) / chunk;
  tallies.assign(static_cast<std::size_t>(chunks), {});
  workers.each_evenly(chunks, chunks_per_thread, [&](int, int begin, int end) {
    for (int k = begin; k < end; ++k)
      for (int i = k * chunk; i < std::min(count, (k + 1) * chunk); ++i)
        visit(i, tallies[static_cast<std::size_t>(k)]);
  });
  Tally sum;
  for (const Tally& tally : tallies)
    sum.include(tally);
  return sum;
}

}  // namespace blocks::dynamics
